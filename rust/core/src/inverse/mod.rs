//! Inverse models: from a goal to a command likely to bring about an effect near it.
//!
//! Each turns what was observed - effects, and the commands that produced them - into one command
//! inside the motor space, and then perturbs it: one draw a motor coordinate, in order. The last two
//! draw before that.
//!
//! - [`Nearest`]: the command of the nearest effect, as in the paper;
//! - [`KNearest`]: the weighted mean of the commands of the nearest effects;
//! - [`LocalRegression`]: the linear map from effects to commands around the goal;
//! - [`LocalJacobian`]: a short step in a linear map from commands to effects around one command;
//! - [`LineVariation`]: a step along the line through two commands;
//! - [`Crossover`]: some coordinates of one command, the others of another.

mod crossover;
mod k_nearest;
mod line_variation;
mod local_jacobian;
mod local_regression;
mod mean;
mod nearest;

use std::fmt;

pub use crossover::Crossover;
pub use k_nearest::KNearest;
pub use line_variation::LineVariation;
pub use local_jacobian::LocalJacobian;
pub use local_regression::LocalRegression;
pub use nearest::Nearest;

use crate::bounds::{Bounds, UniformStream};
use crate::error::{Error, check_finite, check_length};
use crate::history::History;
use crate::kdtree::NearestNeighbors;

/// What turns goals into commands.
pub trait InverseModel: fmt::Debug + Send + Sync {
    /// Writes a command, a point of the motor space, likely to bring about an effect near `goal`.
    ///
    /// # Errors
    /// If nothing was observed yet, the commands are not kept, `goal` is not a finite point of the
    /// effects' dimension, or `command` has not the dimension of M; nothing is drawn then.
    fn command(
        &mut self,
        goal: &[f64],
        history: &mut History,
        draws: &mut dyn UniformStream,
        command: &mut [f64],
    ) -> Result<(), Error>;
}

/// What was observed: at least one effect.
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

    /// Checks that a command for `goal` can be made of this.
    fn check(&self, goal: &[f64], command: &[f64]) -> Result<(), Error> {
        check_length("goal", goal, self.effects.dim())?;
        check_finite("goal", goal, goal.len())?;
        check_length("command", command, self.motor_space.dim())?;
        check_length("commands", self.commands, self.effects.len() * self.motor_space.dim())
    }
}
