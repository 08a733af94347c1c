//! How many cells of a grid are occupied: the coverage of the literature on quality diversity.
//!
//! The behaviour space is divided into bins, and filled ones are counted (Pugh, Soros and Stanley
//! 2016, "Quality Diversity: A New Frontier for Evolutionary Computation", Frontiers in Robotics
//! and AI 3:40). An effect in a new cell gains 1, another 0.

use super::Measure;
use super::cells::{Cells, PerCoordinate};
use crate::error::Error;

/// The cells in which effects lie.
#[derive(Debug)]
pub(super) struct Grid {
    cells: Cells,
    len: usize,
}

impl Grid {
    pub fn new(cell: &PerCoordinate, origin: &PerCoordinate, dim: usize) -> Result<Self, Error> {
        Ok(Self { cells: Cells::new(cell, origin, dim)?, len: 0 })
    }
}

impl Measure for Grid {
    fn dim(&self) -> usize {
        self.cells.dim()
    }

    fn len(&self) -> usize {
        self.len
    }

    fn largest_gain(&self) -> f64 {
        1.0
    }

    fn measure(&self) -> f64 {
        self.cells.len() as f64
    }

    fn check(&self, name: &'static str, effects: &[f64]) -> Result<(), Error> {
        self.cells.check(name, effects)
    }

    fn gain(&mut self, effect: &[f64]) -> f64 {
        if self.cells.find(effect).is_some() { 0.0 } else { 1.0 }
    }

    fn add(&mut self, effect: &[f64]) -> f64 {
        self.len += 1;
        let (_, is_new) = self.cells.occupy(effect);
        if is_new { 1.0 } else { 0.0 }
    }
}
