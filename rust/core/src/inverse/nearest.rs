//! Inverse_d, the paper's inverse model: the command of the observed effect
//! nearest to the goal, perturbed.

use super::InverseModel;
use crate::bounds::UniformStream;
use crate::error::{Error, check_share};
use crate::history::History;

/// The command of the nearest effect, perturbed by up to the share d of each motor range.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Nearest {
    d: f64,
}

impl Nearest {
    /// Perturbed by `d`.
    ///
    /// # Errors
    /// If `d` is not in [0, 1].
    pub fn new(d: f64) -> Result<Self, Error> {
        check_share("d", d)?;
        Ok(Self { d })
    }
}

impl InverseModel for Nearest {
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
        observed.motor_space.perturb_into(command, observed.command(index), self.d, draws);
        Ok(())
    }
}
