//! Discounted: all rewards, of which older ones weigh less.

use super::Estimator;
use super::largest::Largest;

/// The mean of each part's rewards, one that is k rewards old weighing gamma^k.
///
/// The estimator of D-UCB (Kocsis and Szepesvari 2006, "Discounted UCB"; Garivier and Moulines
/// 2008, "On Upper-Confidence Bound Policies for Non-Stationary Bandit Problems"). Time is counted
/// in rewards of all parts together, so a part that is not chosen loses weight; its mean stays.
#[derive(Debug)]
pub(super) struct Discounted {
    gamma: f64,
    means: Vec<f64>,
    /// The weights of each part's rewards, summed up.
    counts: Vec<f64>,
    largest: Largest,
}

impl Discounted {
    /// The head starts come before all other rewards, in order, and fade like these.
    pub fn new(gamma: f64, head_start: usize, parts: usize, largest: f64) -> Self {
        let mut begun = Self {
            gamma,
            means: vec![0.0; parts],
            counts: vec![0.0; parts],
            largest: Largest::new(largest),
        };
        for _ in 0..head_start {
            for part in 0..parts {
                begun.add(part, largest);
            }
        }
        begun
    }
}

impl Estimator for Discounted {
    fn means(&self) -> &[f64] {
        &self.means
    }

    fn counts(&self) -> &[f64] {
        &self.counts
    }

    fn largest(&self) -> f64 {
        self.largest.value()
    }

    fn add(&mut self, part: usize, reward: f64) {
        for count in &mut self.counts {
            *count *= self.gamma;
        }
        let (mean, count) = (&mut self.means[part], &mut self.counts[part]);
        *count += 1.0;
        // In this form a mean stays as it is while its weight fades, down to nothing at all.
        *mean += (reward - *mean) / *count;
        self.largest.see(reward);
    }
}
