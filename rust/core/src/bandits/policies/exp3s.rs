//! Exp3.S: Exp3 that adapts when another part becomes the best.

use std::f64::consts::E;

use super::exp3::mix_with_uniform;
use super::shares::{Shares, growth};
use super::{Choice, Estimates, Policy};
use crate::bounds::UniformStream;
use crate::elementary::exp;
use crate::strategies::{proportionally, total_of};

/// As Exp3, but no weight falls far behind.
///
/// Auer, Cesa-Bianchi, Freund and Schapire (2002, "The Nonstochastic Multiarmed Bandit Problem",
/// SIAM Journal on Computing 32(1), 48-77, figure 4). Of K parts, part j is chosen with probability
/// p_j = (1 - gamma) w_j / (sum of w) + gamma / K. Whenever one that had been chosen with
/// probability p has earned x, its weight is multiplied by exp(gamma (x / p) / K), and then all
/// weights grow by e alpha / K times the sum of those before. x is the reward as a share of the
/// largest. One draw a choice.
#[derive(Debug)]
pub(super) struct Exp3S {
    gamma: f64,
    alpha: f64,
    shares: Shares,
    /// Their sum is 1 but for rounding: none overflows, and the share alpha keeps all above 0.
    weights: Vec<f64>,
    /// The probability of each part in the next choice.
    probabilities: Vec<f64>,
}

impl Exp3S {
    /// All parts begin with equal weights.
    pub fn new(gamma: f64, alpha: f64, parts: usize, largest: f64) -> Self {
        let (shares, weights) = (Shares::new(largest), vec![1.0 / parts as f64; parts]);
        let mut begun = Self { gamma, alpha, shares, probabilities: weights.clone(), weights };
        begun.update();
        begun
    }

    /// Computes the probabilities that belong to the weights.
    fn update(&mut self) {
        self.probabilities.copy_from_slice(&self.weights);
        mix_with_uniform(self.gamma, &mut self.probabilities);
    }
}

impl Policy for Exp3S {
    fn choose(&mut self, _estimates: &Estimates<'_>, draws: &mut dyn UniformStream) -> Choice {
        let part = proportionally(self.probabilities.iter().copied(), draws.next());
        Choice::with(part, self.probabilities[part])
    }

    fn learn(&mut self, part: usize, reward: f64, probability: Option<f64>) {
        let parts = self.weights.len();
        let probability = probability.unwrap_or(self.probabilities[part]);
        let grown = growth(self.gamma, self.shares.of(reward), probability, parts);
        let more = E * self.alpha / parts as f64 * total_of(self.weights.iter().copied());
        self.weights[part] *= exp(grown.min(700.0));
        for weight in &mut self.weights {
            *weight += more;
        }
        let total = total_of(self.weights.iter().copied());
        for weight in &mut self.weights {
            *weight /= total;
        }
        self.update();
    }
}
