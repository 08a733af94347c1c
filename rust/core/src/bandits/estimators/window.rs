//! Window: the last rewards of each part, as in the paper.

use std::collections::VecDeque;

use super::largest::Largest;
use super::{Estimator, mean_of};
use crate::exact_sum::ExactSum;

/// The mean of each part's last `size` rewards, whenever it earned them.
///
/// A mean is recomputed when its part's window changes, and at no other time.
#[derive(Debug)]
pub(super) struct Window {
    windows: Vec<GainWindow>,
    means: Vec<f64>,
    counts: Vec<f64>,
    largest: Largest,
}

impl Window {
    pub fn new(size: usize, head_start: usize, parts: usize, largest: f64) -> Self {
        let window = GainWindow::new(size, largest, head_start);
        Self {
            means: vec![window.mean(); parts],
            counts: vec![window.len() as f64; parts],
            windows: vec![window; parts],
            largest: Largest::new(largest),
        }
    }
}

impl Estimator for Window {
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
        let window = &mut self.windows[part];
        window.add(reward);
        self.means[part] = window.mean();
        self.counts[part] = window.len() as f64;
        self.largest.see(reward);
    }
}

/// The gains of the last `size` effects that a strategy produced.
///
/// A head start of `count` fictitious gains comes first. The oldest gains leave a full window, so
/// that of one fictitious gain nothing is left when `size` real ones have followed.
///
/// Gains may be negative, but must be finite. The sum of those in the window is kept exactly, so
/// that a gain costs the same in windows of any size, and memory only what is in there.
///
/// ```
/// use divbandit_core::bandits::GainWindow;
///
/// let mut window = GainWindow::new(3, 6.0, 1);
/// assert_eq!(window.mean(), 6.0);
/// for gain in [0.0, 3.0, 3.0] {
///     window.add(gain);
/// }
/// assert_eq!(window.mean(), 2.0);
/// ```
#[derive(Debug, Clone)]
pub struct GainWindow {
    size: usize,
    /// The oldest first.
    gains: VecDeque<f64>,
    sum: ExactSum,
}

impl GainWindow {
    /// A window of `size` gains that begins with `count` gains of `head_start`, or `size` of them
    /// if that is less. One of no gains at all stays empty.
    #[must_use]
    pub fn new(size: usize, head_start: f64, count: usize) -> Self {
        let mut window = Self { size, gains: VecDeque::new(), sum: ExactSum::default() };
        for _ in 0..count.min(size) {
            window.add(head_start);
        }
        window
    }

    /// Adds the newest gain; the oldest leaves a full window.
    #[inline]
    pub fn add(&mut self, gain: f64) {
        if self.gains.len() == self.size {
            let Some(oldest) = self.gains.pop_front() else { return };
            self.sum.subtract(oldest);
        }
        self.gains.push_back(gain);
        self.sum.add(gain);
    }

    /// The mean gain, the strategy's diversity; 0 for an empty window.
    ///
    /// The sum is exact before it is rounded once: it depends on nothing but the gains, and
    /// never drifts. It is infinite where it is more than the largest number, even though
    /// the mean would not be.
    #[inline]
    #[must_use]
    pub fn mean(&self) -> f64 {
        mean_of(self.sum.value(), self.gains.len() as f64)
    }

    /// How many gains are in the window.
    #[must_use]
    pub fn len(&self) -> usize {
        self.gains.len()
    }

    /// Whether none is.
    #[must_use]
    pub fn is_empty(&self) -> bool {
        self.gains.is_empty()
    }
}
