//! Environment: a black box f: M -> S, as the engine knows it.

use std::fmt;

use crate::error::Error;

/// A black box f: M -> S that turns a motor command into an effect.
pub trait Environment: fmt::Debug + Send + Sync {
    /// The dimension of M.
    fn motor_dim(&self) -> usize;

    /// The dimension of S.
    fn effect_dim(&self) -> usize;

    /// Writes the effect of `command`, finite numbers, to `effect`; both have the right length.
    ///
    /// # Errors
    /// If the command is none that this environment takes.
    fn effect_into(&mut self, command: &[f64], effect: &mut [f64]) -> Result<(), Error>;
}
