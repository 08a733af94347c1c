//! The novelty of effects: how far each is from the nearest of those before it.
//!
//! The gain of an effect is its sparseness, the mean Euclidean distance to the k nearest effects
//! added before it, or to all while there are fewer; the first of all gains 0 (Lehman and Stanley
//! 2008, "Exploiting Open-Endedness to Solve Problems Through the Search for Novelty", ALIFE XI;
//! 2011, Evolutionary Computation 19(2), 189-223). The measure is the sum of these gains.

use super::{Measure, check_dim};
use crate::error::{Error, check_count, check_each};
use crate::exact_sum::ExactSum;
use crate::kdtree::NearestNeighbors;

/// Distances are found by their squares, which must not overflow.
const FARTHEST: f64 = 1e150;

/// The effects, and how far from each other they came.
#[derive(Debug)]
pub(super) struct Sparseness {
    k: usize,
    tree: NearestNeighbors,
    measure: ExactSum,
}

impl Sparseness {
    pub fn new(k: usize, dim: usize) -> Result<Self, Error> {
        check_dim(dim)?;
        check_count("k", k)?;
        Ok(Self { k, tree: NearestNeighbors::new(dim)?, measure: ExactSum::default() })
    }
}

impl Measure for Sparseness {
    fn dim(&self) -> usize {
        self.tree.dim()
    }

    fn len(&self) -> usize {
        self.tree.len()
    }

    /// No gain is the largest: 0.
    fn largest_gain(&self) -> f64 {
        0.0
    }

    fn measure(&self) -> f64 {
        self.measure.value()
    }

    fn check(&self, name: &'static str, effects: &[f64]) -> Result<(), Error> {
        check_each(name, effects, self.dim(), "within 1e150 of 0", |x| x.abs() <= FARTHEST)?;
        self.tree.check_room(effects.len() / self.dim())
    }

    fn gain(&mut self, effect: &[f64]) -> f64 {
        let k = self.k.min(self.tree.len());
        let Ok(nearest) = self.tree.nearest_k(effect, k) else {
            return 0.0; // there is nothing that it could be far from
        };
        let mut sum = ExactSum::default();
        for (distance, _) in nearest {
            sum.add(distance);
        }
        sum.value() / k as f64
    }

    fn add(&mut self, effect: &[f64]) -> f64 {
        let gain = self.gain(effect);
        self.measure.add(gain);
        self.tree.log(effect);
        self.tree.file_all();
        gain
    }
}
