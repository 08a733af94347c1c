//! Window: the last rewards of each part, as in the paper.

use std::collections::VecDeque;

use super::{Memory, mean_of};
use crate::exact_sum::ExactSum;

/// The mean of each part's last `size` rewards, whenever it earned them.
///
/// A mean is recomputed when its part's window changes, and at no other time.
#[derive(Debug)]
pub(super) struct Window(Vec<Last>);

impl Window {
    pub fn new(size: usize, parts: usize) -> Self {
        Self(vec![Last::new(size); parts])
    }
}

impl Memory for Window {
    fn add(&mut self, part: usize, reward: f64, means: &mut [f64], counts: &mut [f64]) {
        let window = &mut self.0[part];
        window.add(reward);
        means[part] = window.mean();
        counts[part] = window.count();
    }
}

/// The last `size` rewards of one part; the oldest leave a full window.
///
/// Rewards may be negative, but must be finite. The sum of those in the window is kept exactly, so
/// that a reward costs the same in windows of any size, and memory only what is in there.
#[derive(Debug, Clone)]
struct Last {
    size: usize,
    /// The oldest first.
    rewards: VecDeque<f64>,
    sum: ExactSum,
}

impl Last {
    /// None yet, of at most `size`, which is positive.
    fn new(size: usize) -> Self {
        Self { size, rewards: VecDeque::new(), sum: ExactSum::default() }
    }

    /// Adds the newest reward.
    #[inline]
    fn add(&mut self, reward: f64) {
        if self.rewards.len() == self.size {
            let Some(oldest) = self.rewards.pop_front() else { return };
            self.sum.subtract(oldest);
        }
        self.rewards.push_back(reward);
        self.sum.add(reward);
    }

    /// How many rewards are in the window.
    fn count(&self) -> f64 {
        self.rewards.len() as f64
    }

    /// The mean reward; 0 for an empty window.
    ///
    /// The sum is exact before it is rounded once: it depends on nothing but the rewards, and
    /// never drifts. It is infinite where it is more than the largest number, even though
    /// the mean would not be.
    #[inline]
    fn mean(&self) -> f64 {
        mean_of(&self.sum, self.count())
    }
}

#[cfg(test)]
mod tests {
    use super::Last;

    /// Room for all of such a window could not be had.
    #[test]
    fn a_window_takes_room_for_what_is_in_it_only() {
        let mut last = Last::new(usize::MAX);
        last.add(1.0);
        last.add(2.0);
        assert_eq!((last.mean(), last.count()), (1.5, 2.0));
    }

    #[test]
    fn what_is_no_number_leaves_no_trace() {
        let mut last = Last::new(2);
        for reward in [f64::NAN, f64::INFINITY, 3.0, 4.0] {
            last.add(reward);
        }
        assert_eq!(last.mean(), 3.5);
    }
}
