//! Proportional: each part in proportion to its mean reward, as in the paper.

use super::{Choice, Estimates, Policy};
use crate::bounds::UniformStream;
use crate::elementary;
use crate::strategies::{share_of, total_of};

/// Of K parts with mean rewards m_j (a negative one counts as 0) part j with probability
/// alpha / K + (1 - alpha) m_j^power / (sum of m_i^power); with 1 / K where no mean is positive.
///
/// Benureau and Oudeyer 2015. Always two draws a choice.
#[derive(Debug)]
pub(super) struct Proportional {
    alpha: f64,
    power: f64,
    weights: Vec<f64>,
}

impl Proportional {
    pub fn new(alpha: f64, power: f64, parts: usize) -> Self {
        Self { alpha, power, weights: Vec::with_capacity(parts) }
    }
}

impl Policy for Proportional {
    fn choose(&mut self, estimates: &Estimates<'_>, draws: &mut dyn UniformStream) -> Choice {
        if self.power == 1.0 {
            return chosen(self.alpha, estimates.means.iter().map(|&mean| positive(mean)), draws);
        }
        powers(estimates.means, self.power, &mut self.weights);
        chosen(self.alpha, self.weights.iter().copied(), draws)
    }
}

/// A mean, a negative one as 0.
fn positive(mean: f64) -> f64 {
    if mean > 0.0 { mean } else { 0.0 }
}

/// A part: with probability alpha uniformly at random, otherwise in proportion to its weight.
fn chosen(
    alpha: f64,
    weights: impl ExactSizeIterator<Item = f64> + Clone,
    draws: &mut dyn UniformStream,
) -> Choice {
    let (count, total) = (weights.len() as f64, total_of(weights.clone()));
    let uniformly = draws.next() < alpha;
    let u = draws.next();
    let part = if uniformly { (u * count) as usize } else { share_of(weights.clone(), total, u) };
    let probability = if total <= 0.0 {
        1.0 / count
    } else {
        alpha / count + (1.0 - alpha) * weights.clone().nth(part).unwrap_or(0.0) / total
    };
    Choice::with(part, probability)
}

/// Writes the means' shares of the largest to a power; negative ones count as 0. As shares none
/// overflows, and not all vanish. Of the power 1 these are the means themselves.
///
/// ```
/// use divbandit_core::bandits::policies::powers;
///
/// let mut weights = Vec::new();
/// powers(&[-1.0, 1e200, 2e200], 2.0, &mut weights);
/// assert_eq!(weights, [0.0, 0.25, 1.0]);
/// powers(&[-1.0, 1e200, 2e200], 1.0, &mut weights);
/// assert_eq!(weights, [0.0, 1e200, 2e200]);
/// ```
pub fn powers(means: &[f64], power: f64, weights: &mut Vec<f64>) {
    weights.clear();
    weights.extend(means.iter().map(|&mean| positive(mean)));
    if power == 1.0 {
        return;
    }
    let top = weights.iter().copied().fold(0.0, f64::max);
    for weight in weights {
        if *weight > 0.0 {
            *weight = elementary::power(*weight / top, power);
        }
    }
}
