//! RecentWindow: the last rewards of all parts together.

use std::collections::VecDeque;

use super::largest::Largest;
use super::{Estimator, mean_of};
use crate::exact_sum::ExactSum;

/// The mean of each part's rewards among the last `size` rewards of all of them.
///
/// The estimator of SW-UCB (Garivier and Moulines 2008, "On Upper-Confidence Bound Policies for
/// Non-Stationary Bandit Problems"). A part that was not chosen for `size` steps counts as never
/// tried.
#[derive(Debug)]
pub(super) struct RecentWindow {
    size: usize,
    /// Whose each reward is, the oldest first.
    rewards: VecDeque<(usize, f64)>,
    sums: Vec<ExactSum>,
    means: Vec<f64>,
    counts: Vec<f64>,
    largest: Largest,
}

impl RecentWindow {
    pub fn new(size: usize, parts: usize, largest: f64) -> Self {
        Self {
            size,
            rewards: VecDeque::new(),
            sums: vec![ExactSum::default(); parts],
            means: vec![0.0; parts],
            counts: vec![0.0; parts],
            largest: Largest::new(largest),
        }
    }

    /// Takes the oldest reward out of a full window.
    fn make_room(&mut self) {
        if self.rewards.len() == self.size
            && let Some((part, reward)) = self.rewards.pop_front()
        {
            self.sums[part].subtract(reward);
            self.counts[part] -= 1.0;
            self.update(part);
        }
    }

    /// Recomputes the mean of a part whose rewards have changed.
    fn update(&mut self, part: usize) {
        self.means[part] = mean_of(self.sums[part].value(), self.counts[part]);
    }
}

impl Estimator for RecentWindow {
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
        self.make_room();
        self.rewards.push_back((part, reward));
        self.sums[part].add(reward);
        self.counts[part] += 1.0;
        self.update(part);
        self.largest.see(reward);
    }
}
