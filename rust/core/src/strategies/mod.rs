//! The strategies, as the engine runs them: what proposes the next motor command.
//!
//! A [`Strategy`] proposes by itself; a [`Composite`] lets one of several parts propose. Each has
//! its counterpart in the Python class of the same name, to which a test holds it equal bit by bit.

mod goal_babbling;
mod mixture;
mod motor_babbling;
mod proportionally;
mod schedule;

use std::fmt;

use crate::bandits::policies::Choice;
use crate::bandits::rewards::RewardKind;
use crate::bounds::{Bounds, UniformStream};
use crate::error::Error;
use crate::history::History;

pub use goal_babbling::GoalBabbling;
pub use mixture::Mixture;
pub use motor_babbling::MotorBabbling;
pub use proportionally::{proportionally, share_of, total_of};
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

    /// The goal of the command proposed last, if it has one.
    fn goal(&self) -> Option<&[f64]> {
        None
    }

    /// Whether it looks at the commands of the history; if not, they need not be kept.
    fn needs_commands(&self) -> bool;

    /// Refuses what it cannot explore, before an exploration begins: effects of a dimension that it
    /// has no goals for (None if it is not known yet), or a missing box of goals.
    ///
    /// # Errors
    /// If it cannot explore these.
    fn check(
        &self,
        effect_dim: Option<usize>,
        sensory_space: Option<&Bounds>,
    ) -> Result<(), Error> {
        let _ = (effect_dim, sensory_space);
        Ok(())
    }
}

/// A strategy that at each step lets one of several others, its parts, propose.
pub trait Composite: fmt::Debug + Send + Sync {
    /// How many parts it chooses among: at least one.
    fn parts(&self) -> usize;

    /// The part that proposes next, less than [`parts`](Self::parts), and the probability with
    /// which it was chosen, if known.
    fn choose(&mut self, draws: &mut dyn UniformStream) -> Choice;

    /// What it rewards its parts for, if it does.
    fn reward(&self) -> Option<&RewardKind> {
        None
    }

    /// Learns the dimension of the effects, before each reward.
    ///
    /// # Errors
    /// If effects of that dimension cannot be rewarded.
    fn begin(&mut self, effect_dim: usize) -> Result<(), Error> {
        let _ = effect_dim;
        Ok(())
    }

    /// Learns the reward of the newest effect, proposed by part `choice.part`. Called only if there
    /// is a [`reward`](Self::reward).
    fn learn(&mut self, choice: Choice, reward: f64) {
        let _ = (choice, reward);
    }

    /// Learns that a trial of part `choice.part` has failed.
    fn fail(&mut self, choice: Choice) {
        let _ = choice;
    }

    /// A bandit's estimates of its parts, one for each; None for other composites.
    fn estimates(&self) -> Option<&[f64]> {
        None
    }
}
