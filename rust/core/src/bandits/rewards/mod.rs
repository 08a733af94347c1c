//! Rewards: what a bandit pays the strategy that produced an effect.
//!
//! - [`RewardKind::Gain`]: what the effect adds to a measure of diversity, as in the paper;
//! - [`RewardKind::CompetenceProgress`]: by how much it came nearer to the trial's goal.

mod competence_progress;
mod gain;

use std::fmt;

use crate::error::Error;
use crate::history::History;
use crate::measures::MeasureKind;
use competence_progress::CompetenceProgress;
use gain::Gain;

/// A running reward: it follows from the history alone, so that bandits may share one.
pub trait Reward: fmt::Debug + Send + Sync {
    /// The reward of the newest effect of the history, whose trial had this goal.
    ///
    /// # Errors
    /// If that effect cannot be rewarded, or the history is not the one of the calls before.
    fn newest(&mut self, history: &History, goal: Option<&[f64]>) -> Result<f64, Error>;
}

/// The effects of the history after the first `seen`.
fn unseen(history: &History, seen: usize, dim: usize) -> Result<&[f64], Error> {
    let got = match history.effect_dim() {
        Some(got) if !history.is_empty() => got,
        _ => return Err(Error::Empty { name: "history" }),
    };
    if got != dim {
        return Err(Error::Length { name: "effect", must_be: dim, got });
    }
    history.effects().get(seen * dim..).ok_or_else(|| {
        let must_be = format!("the one seen before, of at least {seen} effects");
        Error::Count { name: "history", must_be, got: history.len() }
    })
}

/// Which reward it is.
#[derive(Debug, Clone, PartialEq)]
pub enum RewardKind {
    /// The gain of an effect by this measure.
    Gain(MeasureKind),
    /// By how much the effect nearest to the goal has come nearer.
    CompetenceProgress,
}

impl RewardKind {
    /// Upper bound of the rewards of effects of `dim` dimensions; 0 if there is none.
    ///
    /// # Errors
    /// If effects of that dimension cannot be rewarded.
    pub fn largest(&self, dim: usize) -> Result<f64, Error> {
        match self {
            Self::Gain(measure) => Ok(measure.start(dim)?.largest_gain()),
            Self::CompetenceProgress => Ok(0.0),
        }
    }

    /// Starts with a history of effects of `dim` dimensions.
    ///
    /// # Errors
    /// If effects of that dimension cannot be rewarded.
    pub fn start(&self, dim: usize) -> Result<Box<dyn Reward>, Error> {
        Ok(match self {
            Self::Gain(measure) => Box::new(Gain::new(measure.start(dim)?)),
            Self::CompetenceProgress => Box::new(CompetenceProgress::new(dim)?),
        })
    }
}
