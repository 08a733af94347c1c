//! Rewards: computed once for all bandits of equal rewards.

use crate::bandits::rewards::{Reward, RewardKind};
use crate::error::Error;
use crate::history::History;

/// A reward beyond this could not be summed up.
const MOST: f64 = 1e300;

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
    ///
    /// # Errors
    /// If that effect cannot be rewarded.
    pub fn newest(
        &mut self,
        place: usize,
        history: &History,
        goal: Option<&[f64]>,
    ) -> Result<f64, Error> {
        let Some(started) = self.started.get_mut(place) else {
            return Err(Error::Empty { name: "rewards" });
        };
        let reward = started.newest(history, goal)?;
        if (-MOST..=MOST).contains(&reward) {
            return Ok(reward);
        }
        let must_be = "a finite number in [-1e+300, 1e+300]";
        Err(Error::Number { name: "reward", must_be, got: reward })
    }
}
