//! Bandit: parts chosen by a policy, given an estimator's means of their rewards.

use super::estimators::{Estimator, EstimatorKind};
use super::policies::{Choice, Estimates, Policy, PolicyKind};
use super::rewards::RewardKind;
use crate::bounds::UniformStream;
use crate::error::{Error, check_count};
use crate::strategies::Composite;

/// The dimension that is assumed until the first effect.
const PLANE: usize = 2;

/// A bandit in three parts: reward, estimator and policy. A failed trial earns 0.
#[derive(Debug)]
pub struct Bandit {
    parts: usize,
    reward: RewardKind,
    estimator: EstimatorKind,
    policy: PolicyKind,
    /// Upper bound of the rewards; 0 if there is none.
    largest: f64,
    estimates: Box<dyn Estimator>,
    choosing: Box<dyn Policy>,
    /// The failures before the first reward, which restarts the estimator.
    failed: Vec<Choice>,
    dim_is_known: bool,
}

impl Bandit {
    /// Over so many `parts`; `effect_dim` is None if it is not known yet.
    ///
    /// # Errors
    /// If there are no parts, or one of the three cannot start with them.
    pub fn new(
        parts: usize,
        reward: RewardKind,
        estimator: EstimatorKind,
        policy: PolicyKind,
        effect_dim: Option<usize>,
    ) -> Result<Self, Error> {
        check_count("parts", parts)?;
        let largest = reward.largest(effect_dim.unwrap_or(PLANE)).or_else(|error| {
            // Raised with the first effect, when its dimension is known.
            if effect_dim.is_none() { Ok(0.0) } else { Err(error) }
        })?;
        Ok(Self {
            parts,
            estimates: estimator.start(parts, largest)?,
            choosing: policy.start(parts, largest)?,
            reward,
            estimator,
            policy,
            largest,
            failed: Vec::new(),
            dim_is_known: effect_dim.is_some(),
        })
    }
}

impl Composite for Bandit {
    fn parts(&self) -> usize {
        self.parts
    }

    fn choose(&mut self, draws: &mut dyn UniformStream) -> Choice {
        self.choosing.choose(&Estimates::of(&*self.estimates), draws)
    }

    fn reward(&self) -> Option<&RewardKind> {
        Some(&self.reward)
    }

    fn begin(&mut self, effect_dim: usize) -> Result<(), Error> {
        if self.dim_is_known {
            return Ok(());
        }
        let largest = self.reward.largest(effect_dim)?;
        let failed = std::mem::take(&mut self.failed);
        if largest != self.largest {
            self.estimates = self.estimator.start(self.parts, largest)?;
            self.choosing = self.policy.start(self.parts, largest)?;
            self.largest = largest;
            failed.into_iter().for_each(|choice| self.learn(choice, 0.0));
        }
        self.dim_is_known = true;
        Ok(())
    }

    fn learn(&mut self, choice: Choice, reward: f64) {
        self.estimates.add(choice.part, reward);
        self.choosing.learn(choice.part, reward, choice.probability);
    }

    fn fail(&mut self, choice: Choice) {
        if !self.dim_is_known {
            self.failed.push(choice);
        }
        self.learn(choice, 0.0);
    }

    fn estimates(&self) -> Option<&[f64]> {
        Some(self.estimates.means())
    }
}
