//! Rewards: computed once for all bandits of equal rewards.

use crate::bandits::rewards::{Reward, RewardKind};
use crate::error::Error;
use crate::history::History;

/// The rewards that bandits ask for, each started when the dimension of the effects is known.
#[derive(Debug, Default)]
pub(super) struct Rewards {
    kinds: Vec<RewardKind>,
    started: Vec<Box<dyn Reward>>,
}

impl Rewards {
    /// The place of a reward: equal ones share it.
    pub fn place_of(&mut self, kind: &RewardKind) -> usize {
        self.kinds.iter().position(|known| known == kind).unwrap_or_else(|| {
            self.kinds.push(kind.clone());
            self.kinds.len() - 1
        })
    }

    /// Starts all of them with effects of this dimension.
    pub fn start(&mut self, effect_dim: usize) -> Result<(), Error> {
        self.started =
            self.kinds.iter().map(|kind| kind.start(effect_dim)).collect::<Result<_, _>>()?;
        Ok(())
    }

    /// The reward of the newest effect of the history, whose trial had this goal.
    pub fn newest(
        &mut self,
        place: usize,
        history: &History,
        goal: Option<&[f64]>,
    ) -> Result<f64, Error> {
        self.started[place].newest(history, goal)
    }
}
