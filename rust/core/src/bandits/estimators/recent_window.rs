//! RecentWindow and WholePast: the last rewards of all parts together, or all of them.

use std::collections::VecDeque;

use super::{Memory, mean_of};
use crate::exact_sum::ExactSum;

/// The mean of each part's rewards among the last so many rewards of all of them, or among all.
///
/// The estimator of SW-UCB (Garivier and Moulines 2008, "On Upper-Confidence Bound Policies for
/// Non-Stationary Bandit Problems"). A part that was not chosen for `size` steps counts as never
/// tried.
#[derive(Debug)]
pub(super) struct RecentWindow {
    /// How many, and whose each reward is, the oldest first; None if no reward is forgotten.
    last: Option<(usize, VecDeque<(usize, f64)>)>,
    sums: Vec<ExactSum>,
}

impl RecentWindow {
    /// The last `size` rewards; all of them if that is None.
    pub fn new(size: Option<usize>, parts: usize) -> Self {
        let last = size.map(|size| (size, VecDeque::new()));
        Self { last, sums: vec![ExactSum::default(); parts] }
    }
}

impl Memory for RecentWindow {
    fn add(&mut self, part: usize, reward: f64, means: &mut [f64], counts: &mut [f64]) {
        if let Some((size, rewards)) = &mut self.last {
            if rewards.len() == *size
                && let Some((oldest, reward)) = rewards.pop_front()
            {
                self.sums[oldest].subtract(reward);
                counts[oldest] -= 1.0;
                means[oldest] = mean_of(&self.sums[oldest], counts[oldest]);
            }
            rewards.push_back((part, reward));
        }
        self.sums[part].add(reward);
        counts[part] += 1.0;
        means[part] = mean_of(&self.sums[part], counts[part]);
    }
}
