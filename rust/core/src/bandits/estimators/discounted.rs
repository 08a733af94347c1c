//! Discounted: all rewards, of which older ones weigh less.

use super::Memory;

/// The mean of each part's rewards, one that is k rewards old weighing gamma^k: the counts are the
/// weights of each part's rewards, summed up.
///
/// The estimator of D-UCB (Kocsis and Szepesvari 2006, "Discounted UCB"; Garivier and Moulines
/// 2008, "On Upper-Confidence Bound Policies for Non-Stationary Bandit Problems"). Time is counted
/// in rewards of all parts together, so a part that is not chosen loses weight; its mean stays.
#[derive(Debug)]
pub(super) struct Discounted {
    pub gamma: f64,
}

impl Memory for Discounted {
    fn add(&mut self, part: usize, reward: f64, means: &mut [f64], counts: &mut [f64]) {
        for count in &mut *counts {
            *count *= self.gamma;
        }
        let (mean, count) = (&mut means[part], &mut counts[part]);
        *count += 1.0;
        // In this form a mean stays as it is while its weight fades, down to nothing at all.
        *mean += (reward - *mean) / *count;
    }
}
