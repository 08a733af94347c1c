//! The built-in strategies, as the engine runs them: who proposes the next motor command.
//!
//! A [`Strategy`] proposes by itself; a [`Composite`] lets one of several parts propose. Each has
//! its specification in the Python class of the same name, to which a test holds it equal bit
//! by bit.

mod goal_babbling;
mod mixture;
mod motor_babbling;
mod schedule;

use std::fmt;

use crate::bounds::UniformStream;
use crate::coverage::Coverage;
use crate::error::Error;
use crate::history::History;

pub use goal_babbling::GoalBabbling;
pub use mixture::Mixture;
pub(crate) use mixture::proportionally;
pub use motor_babbling::MotorBabbling;
pub use schedule::Schedule;

/// A strategy that proposes by itself.
pub trait Strategy: fmt::Debug + Send + Sync {
    /// Writes the next motor command, a point of `history.motor_space()`; all randomness comes
    /// from `draws`.
    ///
    /// # Errors
    /// If it cannot explore what [`check`](Self::check) refuses.
    fn propose(
        &mut self,
        history: &mut History,
        draws: &mut dyn UniformStream,
        command: &mut [f64],
    ) -> Result<(), Error>;

    /// Whether it looks at the commands of the history; if not, they need not be kept.
    fn needs_commands(&self) -> bool;

    /// Refuses what it cannot explore, before an exploration begins.
    ///
    /// # Errors
    /// If it cannot explore with such a history.
    fn check(&self, history: &History) -> Result<(), Error> {
        let _ = history;
        Ok(())
    }
}

/// A strategy that at each step lets one of several others, its parts, propose.
pub trait Composite: fmt::Debug + Send + Sync {
    /// How many parts it chooses among: at least one.
    fn parts(&self) -> usize;

    /// The part that is to propose next, less than [`parts`](Self::parts).
    fn choose(&mut self, draws: &mut dyn UniformStream) -> usize;

    /// The empty union of balls by which it wants to be told of gains; None if it does not.
    fn measure(&self) -> Option<&Coverage> {
        None
    }

    /// Learns what the newest effect, which came from `part`, gained. Asked only if there is a
    /// [`measure`](Self::measure).
    fn credit(&mut self, part: usize, gain: f64) {
        let _ = (part, gain);
    }

    /// What a bandit believes of each of its parts, always as many numbers; None for all others.
    fn diversities(&self) -> Option<&[f64]> {
        None
    }
}
