//! Inverse models: from a goal to a command likely to bring about an effect near it.
//!
//! Each turns what was observed - effects, and the commands that produced them - into one command
//! inside the motor space, and then perturbs it by up to the share `d` of each motor range: one
//! draw a motor coordinate, in order.
//!
//! - [`inverse()`](inverse()): the command of the nearest effect, as in the paper;
//! - [`k_nearest`]: the weighted mean of the commands of the nearest effects;
//! - [`local_regression`]: the linear map from effects to commands around the goal;
//! - [`LocalJacobian`]: a short step in a linear map from commands to effects around one command;
//! - [`babble`]: goals and their commands, many at once.

mod babble;
mod k_nearest;
mod local_jacobian;
mod local_regression;
mod nearest;

pub use babble::babble;
pub use k_nearest::k_nearest;
pub use local_jacobian::LocalJacobian;
pub use local_regression::local_regression;
pub use nearest::inverse;

use crate::bounds::{Bounds, UniformStream};
use crate::error::{Error, check_finite, check_length};
use crate::kdtree::NearestNeighbors;

/// What was observed, as far as the inverse models look at it.
#[derive(Debug, Clone, Copy)]
pub struct Observed<'a> {
    /// The effects.
    pub effects: &'a NearestNeighbors,
    /// The motor commands that produced them, row by row in the same order.
    pub commands: &'a [f64],
    /// The box that the commands lie in.
    pub motor_space: &'a Bounds,
}

impl Observed<'_> {
    /// The command that produced effect `index`; empty if there is none.
    fn command(&self, index: usize) -> &[f64] {
        let m = self.motor_space.dim();
        self.commands.get(index * m..(index + 1) * m).unwrap_or_default()
    }

    /// The distances and indices of the effects nearest to `goal`: `k`, or all if there are fewer.
    ///
    /// # Errors
    /// If `k` is 0, the sizes do not fit, nothing was observed, or `goal` is no finite point.
    fn neighbours(&self, goal: &[f64], k: usize) -> Result<Vec<(f64, usize)>, Error> {
        check_length("goal", goal, self.effects.dim())?;
        check_finite("goal", goal, goal.len())?;
        check_length("commands", self.commands, self.effects.len() * self.motor_space.dim())?;
        if k == 0 {
            return Err(Error::Count { name: "k", must_be: "at least 1".into(), got: k });
        }
        if self.effects.is_empty() {
            return Err(Error::Empty { name: "the set of effects" });
        }
        self.effects.nearest_k(goal, k.min(self.effects.len()))
    }

    /// The sum of the neighbours' commands, each times its weight, brought back into the motor
    /// space and perturbed.
    ///
    /// The weights sum to 1; then the sum is taken around the nearest neighbour's command, which
    /// comes back exactly where all are the same.
    fn perturbed_mean(
        &self,
        found: &[(f64, usize)],
        weights: &[f64],
        d: f64,
        stream: &mut (impl UniformStream + ?Sized),
    ) -> Result<Vec<f64>, Error> {
        let first = self.command(found.first().map_or(0, |&(_, index)| index));
        let mut mean = first.to_vec();
        for (&(_, index), weight) in found.iter().zip(weights) {
            for ((sum, x), at) in mean.iter_mut().zip(self.command(index)).zip(first) {
                *sum += weight * (x - at);
            }
        }
        if mean.iter().any(|x| !x.is_finite()) {
            mean.copy_from_slice(first);
        }
        let corners = self.motor_space.low().iter().zip(self.motor_space.high());
        for (x, (&low, &high)) in mean.iter_mut().zip(corners) {
            *x = x.max(low).min(high);
        }
        self.motor_space.perturb(&mean, d, stream)
    }
}
