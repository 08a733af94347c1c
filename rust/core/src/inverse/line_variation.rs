//! A command on the line through those of two effects, perturbed.

use super::InverseModel;
use crate::bounds::UniformStream;
use crate::error::{Error, check_number, check_share};
use crate::history::History;

/// The command of the nearest effect, moved along the line through it and another's, perturbed.
///
/// The other effect is any of those observed, the step a normal number of their difference. Draws:
/// the other effect, the step, and one a motor coordinate.
#[derive(Debug, Clone)]
pub struct LineVariation {
    d: f64,
    along: f64,
    moved: Vec<f64>,
}

impl LineVariation {
    /// Perturbed by up to the share `d` of each motor range; steps have the standard deviation
    /// `along`, a share of the difference between the two commands.
    ///
    /// # Errors
    /// If `d` is not in [0, 1], or `along` is negative or not finite.
    pub fn new(d: f64, along: f64) -> Result<Self, Error> {
        check_share("d", d)?;
        let is_right = along >= 0.0 && along.is_finite();
        check_number("along", along, is_right, "not negative, finite")?;
        Ok(Self { d, along, moved: Vec::new() })
    }
}

impl InverseModel for LineVariation {
    fn command(
        &mut self,
        goal: &[f64],
        history: &mut History,
        draws: &mut dyn UniformStream,
        command: &mut [f64],
    ) -> Result<(), Error> {
        let observed = history.observed()?;
        observed.check(goal, command)?;
        let (_, index) = observed.effects.nearest_squared(goal)?;
        let other = draws.below(observed.effects.len());
        let step = self.along * draws.normal();
        let (parent, other) = (observed.command(index), observed.command(other));
        self.moved.clear();
        self.moved.extend(parent.iter().zip(other).map(|(x, y)| x + step * (y - x)));
        observed.motor_space.clip(&mut self.moved);
        observed.motor_space.perturb_into(command, &self.moved, self.d, draws);
        Ok(())
    }
}
