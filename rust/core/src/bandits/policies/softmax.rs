//! Softmax: each part in proportion to the exponential of its mean reward.

use super::{Choice, Estimates, Policy};
use crate::bounds::UniformStream;
use crate::elementary;
use crate::strategies::{share_of, total_of};

/// Part j with probability proportional to exp(m_j / (temperature B)), of mean reward m_j.
///
/// Boltzmann exploration (Sutton and Barto 2018, "Reinforcement Learning: An Introduction",
/// section 2.8, with means in place of preferences). B is the largest reward, or 1 if not
/// `scaled`; while no reward was larger than 0, all are equal. One draw a choice.
#[derive(Debug)]
pub(super) struct Softmax {
    temperature: f64,
    scaled: bool,
    weights: Vec<f64>,
}

impl Softmax {
    pub fn new(temperature: f64, scaled: bool, parts: usize) -> Self {
        Self { temperature, scaled, weights: Vec::with_capacity(parts) }
    }
}

impl Policy for Softmax {
    fn choose(&mut self, estimates: &Estimates<'_>, draws: &mut dyn UniformStream) -> Choice {
        let means = estimates.means;
        let unit = if self.scaled { estimates.largest } else { 1.0 };
        self.weights.clear();
        if unit <= 0.0 {
            self.weights.resize(means.len(), 1.0);
        } else {
            // Relative to the best, whose exponential is 1.
            let top = means.iter().copied().fold(f64::NEG_INFINITY, f64::max);
            let below = means.iter().map(|mean| (mean - top) / unit / self.temperature);
            self.weights.extend(below.map(exp));
        }
        let weights = self.weights.iter().copied();
        let total = total_of(weights.clone());
        let part = share_of(weights, total, draws.next());
        Choice::with(part, self.weights[part] / total)
    }
}

/// The exponential; what is too small to matter is 0.
fn exp(x: f64) -> f64 {
    if x > -1e3 { elementary::exp(x) } else { 0.0 }
}
