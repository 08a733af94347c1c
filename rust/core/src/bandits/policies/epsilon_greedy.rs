//! EpsilonGreedy: the part with the best mean reward, except for random choices.

use super::ties::{best, one_of};
use super::{Choice, Estimates, Policy};
use crate::bounds::UniformStream;

/// With probability epsilon uniformly at random, else the best mean reward.
///
/// Sutton and Barto (2018, "Reinforcement Learning: An Introduction", section 2.2). Ties are broken
/// uniformly. Always two draws a choice.
#[derive(Debug)]
pub(super) struct EpsilonGreedy {
    epsilon: f64,
    ties: Vec<usize>,
}

impl EpsilonGreedy {
    pub fn new(epsilon: f64, parts: usize) -> Self {
        Self { epsilon, ties: Vec::with_capacity(parts) }
    }
}

impl Policy for EpsilonGreedy {
    fn choose(&mut self, estimates: &Estimates<'_>, draws: &mut dyn UniformStream) -> Choice {
        let count = estimates.means.len() as f64;
        best(estimates.means, &mut self.ties);
        let uniformly = draws.next() < self.epsilon;
        let u = draws.next();
        let part = if uniformly { (u * count) as usize } else { one_of(&self.ties, u) };
        let mut probability = self.epsilon / count;
        if self.ties.contains(&part) {
            probability += (1.0 - self.epsilon) / self.ties.len() as f64;
        }
        Choice::with(part, probability)
    }
}
