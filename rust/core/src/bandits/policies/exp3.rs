//! Exp3: weights that grow exponentially with rewards, for adversarial rewards.

use super::shares::{Shares, growth};
use super::{Choice, Estimates, Policy};
use crate::bounds::UniformStream;
use crate::elementary::exp;
use crate::strategies::{proportionally, total_of};

/// Part j of K with probability p_j = (1 - gamma) w_j / (sum of w) + gamma / K.
///
/// Auer, Cesa-Bianchi, Freund and Schapire (2002, "The Nonstochastic Multiarmed Bandit Problem",
/// SIAM Journal on Computing 32(1), 48-77, figure 1). A part that earned x, when it had been chosen
/// with probability p, has its weight multiplied by exp(gamma (x / p) / K). x is the reward as a
/// share of the largest. One draw a choice.
#[derive(Debug)]
pub(super) struct Exp3 {
    gamma: f64,
    shares: Shares,
    /// Logarithms of the weights, the largest 0: nothing overflows, and what has become too small
    /// to be drawn can still come back.
    logs: Vec<f64>,
    /// The probability of each part in the next choice.
    probabilities: Vec<f64>,
}

impl Exp3 {
    /// All parts begin with equal weights.
    pub fn new(gamma: f64, parts: usize, largest: f64) -> Self {
        let shares = Shares::new(largest);
        let mut begun =
            Self { gamma, shares, logs: vec![0.0; parts], probabilities: vec![0.0; parts] };
        begun.update();
        begun
    }

    /// Computes the probabilities that belong to the weights.
    fn update(&mut self) {
        for (probability, &log) in self.probabilities.iter_mut().zip(&self.logs) {
            *probability = exp(log);
        }
        mix_with_uniform(self.gamma, &mut self.probabilities);
    }
}

impl Policy for Exp3 {
    fn choose(&mut self, _estimates: &Estimates<'_>, draws: &mut dyn UniformStream) -> Choice {
        let part = proportionally(self.probabilities.iter().copied(), draws.next());
        Choice::with(part, self.probabilities[part])
    }

    fn learn(&mut self, part: usize, reward: f64, probability: Option<f64>) {
        let probability = probability.unwrap_or(self.probabilities[part]);
        let share = self.shares.of(reward);
        self.logs[part] += growth(self.gamma, share, probability, self.logs.len());
        let top = self.logs.iter().copied().fold(f64::NEG_INFINITY, f64::max);
        for log in &mut self.logs {
            *log -= top;
        }
        self.update();
    }
}

/// Turns weights into probabilities, of which a share gamma is uniform.
pub(super) fn mix_with_uniform(gamma: f64, weights: &mut [f64]) {
    let (total, equal) = (total_of(weights.iter().copied()), gamma / weights.len() as f64);
    for weight in weights {
        *weight = (1.0 - gamma) * *weight / total + equal;
    }
}
