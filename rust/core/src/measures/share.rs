//! The share of a grid's cells that are occupied: the coverage that quality-diversity archives
//! report.
//!
//! A box is cut into cells; an effect outside of it counts in the nearest of them, as in the grid
//! archive of pyribs (Tjanaka et al. 2023, GECCO). An effect in a new cell gains 1 over their number.

use super::Measure;
use crate::bounds::Bounds;
use crate::error::{Error, check_length};
use crate::shape::Shape;

/// The cells in which effects lie.
#[derive(Debug)]
pub(super) struct Share {
    space: Bounds,
    shape: Vec<usize>,
    occupied: Vec<bool>,
    count: usize,
    len: usize,
}

impl Share {
    pub fn new(cells: &Shape, space: &Bounds, dim: usize) -> Result<Self, Error> {
        check_length("box", space.low(), dim)?;
        let total = cells.check(dim)?;
        let shape = cells.along(dim).collect();
        Ok(Self { space: space.clone(), shape, occupied: vec![false; total], count: 0, len: 0 })
    }

    /// The cell of an effect.
    fn place(&self, effect: &[f64]) -> usize {
        let corners = self.space.low().iter().zip(self.space.high());
        let axes = effect.iter().zip(corners).zip(&self.shape);
        axes.fold(0, |cell, ((y, (low, high)), &count)| {
            // What is below, or not a number as the box has no width, counts in the first one.
            let column = ((y - low) / (high - low) * count as f64) as usize;
            cell * count + column.min(count - 1)
        })
    }

    /// What a new cell adds.
    fn one(&self) -> f64 {
        1.0 / self.occupied.len() as f64
    }
}

impl Measure for Share {
    fn dim(&self) -> usize {
        self.shape.len()
    }

    fn len(&self) -> usize {
        self.len
    }

    fn largest_gain(&self) -> f64 {
        self.one()
    }

    fn measure(&self) -> f64 {
        self.count as f64 / self.occupied.len() as f64
    }

    fn check(&self, _name: &'static str, _effects: &[f64]) -> Result<(), Error> {
        Ok(())
    }

    fn gain(&mut self, effect: &[f64]) -> f64 {
        if self.occupied[self.place(effect)] { 0.0 } else { self.one() }
    }

    fn add(&mut self, effect: &[f64]) -> f64 {
        self.len += 1;
        let place = self.place(effect);
        if std::mem::replace(&mut self.occupied[place], true) {
            return 0.0;
        }
        self.count += 1;
        self.one()
    }
}
