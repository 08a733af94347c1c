//! Cells: a grid of equal boxes, in which of them an effect lies, and which are occupied.
//!
//! The cells are closed below and open above: cell 0 reaches from the origin to the edge. Which
//! cell it is follows from the rounded quotient (effect - origin) / edge, so that an effect within
//! a rounding error of a border may count on either side of it, always the same. The whole
//! numbers of a cell's place are kept as f64, which have no largest place but the last.

use std::hash::Hasher;

use hashbrown::HashTable;
use rustc_hash::FxHasher;

use super::check_dim;
use crate::error::{Error, check_finite, check_length, place};

/// A number for all coordinates, or one for each.
#[derive(Debug, Clone, PartialEq)]
pub enum PerCoordinate {
    /// The same for all.
    All(f64),
    /// One for each coordinate.
    Each(Vec<f64>),
}

impl PerCoordinate {
    /// One finite number for each of `dim` coordinates.
    fn each(&self, name: &'static str, dim: usize) -> Result<Vec<f64>, Error> {
        let numbers = match self {
            Self::All(number) if number.is_finite() => vec![*number; dim],
            Self::All(number) => {
                return Err(Error::Number { name, must_be: "a finite number", got: *number });
            }
            Self::Each(numbers) => numbers.clone(),
        };
        check_length(name, &numbers, dim)?;
        check_finite(name, &numbers, dim)?;
        Ok(numbers)
    }
}

/// The occupied cells of a grid, each with its number in the order of occupation.
#[derive(Debug)]
pub(super) struct Cells {
    edges: Vec<f64>,
    origin: Vec<f64>,
    /// The places of the occupied cells, as bits, coordinate by coordinate.
    occupied: Vec<u64>,
    /// Their numbers, by the hash of the place.
    numbers: HashTable<usize>,
    /// The place that was looked for last.
    sought: Vec<u64>,
}

impl Cells {
    /// A grid without an occupied cell.
    ///
    /// # Errors
    /// If `dim` is out of range, `cell` or `origin` has no finite number for each of `dim` coordinates, or an edge is
    /// not positive.
    pub fn new(cell: &PerCoordinate, origin: &PerCoordinate, dim: usize) -> Result<Self, Error> {
        check_dim(dim)?;
        let (edges, origin) = (cell.each("cell", dim)?, origin.each("origin", dim)?);
        if let Some(&got) = edges.iter().find(|&&edge| edge <= 0.0) {
            return Err(Error::Number { name: "cell", must_be: "positive", got });
        }
        let (occupied, sought) = (Vec::new(), vec![0; dim]);
        Ok(Self { edges, origin, occupied, numbers: HashTable::new(), sought })
    }

    /// The dimension of the effects.
    pub fn dim(&self) -> usize {
        self.edges.len()
    }

    /// How many cells are occupied.
    pub fn len(&self) -> usize {
        self.numbers.len()
    }

    /// Refuses finite effects so many cells away that no f64 can count them.
    ///
    /// # Errors
    /// [`Error::TooFar`] at the first of them.
    pub fn check(&self, name: &'static str, effects: &[f64]) -> Result<(), Error> {
        for (row, effect) in effects.chunks_exact(self.dim()).enumerate() {
            for (column, &got) in effect.iter().enumerate() {
                let (origin, cell) = (self.origin[column], self.edges[column]);
                if !((got - origin) / cell).is_finite() {
                    let at = place(row * self.dim() + column, self.dim(), effects.len());
                    return Err(Error::TooFar { name, at, origin, got, cell });
                }
            }
        }
        Ok(())
    }

    /// The number of the cell in which an effect lies, if that is occupied.
    pub fn find(&mut self, effect: &[f64]) -> Option<usize> {
        for (column, (bits, x)) in self.sought.iter_mut().zip(effect).enumerate() {
            // Of the two zeros the sum is the positive one.
            let at = ((x - self.origin[column]) / self.edges[column]).floor() + 0.0;
            *bits = at.to_bits();
        }
        let (occupied, sought) = (&self.occupied, &self.sought);
        let is_sought = |&number: &usize| row(occupied, number, sought.len()) == sought;
        self.numbers.find(hash(sought), is_sought).copied()
    }

    /// The number of the cell in which an effect lies, and whether it was occupied just now.
    pub fn occupy(&mut self, effect: &[f64]) -> (usize, bool) {
        if let Some(number) = self.find(effect) {
            return (number, false);
        }
        let (number, dim) = (self.len(), self.dim());
        self.occupied.extend_from_slice(&self.sought);
        let occupied = &self.occupied;
        let rehash = |&number: &usize| hash(row(occupied, number, dim));
        self.numbers.insert_unique(hash(&self.sought), number, rehash);
        (number, true)
    }
}

/// The place of the cell of this number.
fn row(occupied: &[u64], number: usize, dim: usize) -> &[u64] {
    &occupied[number * dim..][..dim]
}

/// The hash of a cell's place.
fn hash(place: &[u64]) -> u64 {
    let mut hasher = FxHasher::default();
    for bits in place {
        // As f64 small whole numbers differ in their high bits alone, and these would be lost:
        // the hasher multiplies, which hands bits upwards.
        hasher.write_u64(bits.rotate_left(32));
    }
    hasher.finish()
}
