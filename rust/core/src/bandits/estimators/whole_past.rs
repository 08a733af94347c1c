//! WholePast: all rewards alike.

use super::largest::Largest;
use super::{Estimator, mean_of};
use crate::exact_sum::ExactSum;

/// The mean of all rewards that each part ever earned.
#[derive(Debug)]
pub(super) struct WholePast {
    sums: Vec<ExactSum>,
    means: Vec<f64>,
    counts: Vec<f64>,
    largest: Largest,
}

impl WholePast {
    pub fn new(parts: usize, largest: f64) -> Self {
        Self {
            sums: vec![ExactSum::default(); parts],
            means: vec![0.0; parts],
            counts: vec![0.0; parts],
            largest: Largest::new(largest),
        }
    }
}

impl Estimator for WholePast {
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
        self.sums[part].add(reward);
        self.counts[part] += 1.0;
        self.means[part] = mean_of(self.sums[part].value(), self.counts[part]);
        self.largest.see(reward);
    }
}
