//! Measures of diversity: of a growing set of effects, and what one more adds.
//!
//! A [`MeasureKind`] says which, and [`start`](MeasureKind::start) makes an empty [`Measure`] of
//! it for effects of some dimension: the volume of balls around the effects (`balls`), the number
//! of cells that they occupy (`grid`), the share of a box's cells (`share`), how evenly they fill
//! cells (`entropy`), or how far each is from those before it (`sparseness`).
//!
//! ```
//! use divbandit_core::measures::{MeasureKind, PerCoordinate};
//!
//! let cell = PerCoordinate::All(0.5);
//! let kind = MeasureKind::Grid { cell, origin: PerCoordinate::All(0.0) };
//! let mut grid = kind.start(2).unwrap();
//! grid.check("effect", &[0.1, 0.2]).unwrap();
//! assert_eq!(grid.gain(&[0.1, 0.2]), 1.0);
//! assert_eq!(grid.add(&[0.1, 0.2]), 1.0);
//! assert_eq!(grid.add(&[0.2, 0.1]), 0.0);
//! assert_eq!((grid.measure(), grid.len()), (1.0, 2));
//! ```

mod balls;
mod cells;
mod entropy;
mod grid;
mod share;
mod sparseness;

use std::fmt::Debug;

use crate::bounds::Bounds;
use crate::error::Error;
use crate::shape::Shape;
use balls::Balls;
pub use balls::KEY;
pub use cells::PerCoordinate;
use entropy::Entropy;
use grid::Grid;
use share::Share;
use sparseness::Sparseness;

/// Upper limit on the dimension; more coordinates are taken for a mistake.
const HIGHEST: usize = 1_000_000;

/// The diversity of a growing set of effects.
pub trait Measure: Debug + Send + Sync {
    /// The dimension of the effects.
    fn dim(&self) -> usize;

    /// How many effects have been added.
    fn len(&self) -> usize;

    /// Whether none has.
    fn is_empty(&self) -> bool {
        self.len() == 0
    }

    /// Upper bound of the gains; 0 if there is none.
    fn largest_gain(&self) -> f64;

    /// The diversity of all effects together: 0 for none.
    fn measure(&self) -> f64;

    /// Refuses effects, finite rows of `dim` numbers, that it cannot place; `name` is what an
    /// error calls them.
    ///
    /// # Errors
    /// If one of them lies too far away.
    fn check(&self, name: &'static str, effects: &[f64]) -> Result<(), Error>;

    /// What [`add`](Self::add) would return; nothing is added. The effect has passed
    /// [`check`](Self::check).
    fn gain(&mut self, effect: &[f64]) -> f64;

    /// Adds an effect that has passed [`check`](Self::check), and returns its gain: by how much
    /// the measure changes.
    fn add(&mut self, effect: &[f64]) -> f64;
}

/// Which measure it is.
#[derive(Debug, Clone, PartialEq)]
pub enum MeasureKind {
    /// The volume of the union of balls around the effects.
    Balls {
        /// The radius of the balls.
        tau: f64,
        /// From dimension 4 on: the standard error of a gain, as a share of a ball's measure.
        accuracy: f64,
    },
    /// The number of cells of a grid that effects lie in.
    Grid {
        /// The edge of a cell.
        cell: PerCoordinate,
        /// A corner of the grid.
        origin: PerCoordinate,
    },
    /// The share of the cells of a box that effects lie in.
    Share {
        /// How many there are along each coordinate.
        cells: Shape,
        /// What is cut into cells.
        space: Bounds,
    },
    /// The sum of the mean distances of each effect to the nearest before it.
    Sparseness {
        /// How many of the nearest.
        k: usize,
    },
    /// The entropy of the histogram over a grid's cells.
    Entropy {
        /// The edge of a cell.
        cell: PerCoordinate,
        /// A corner of the grid.
        origin: PerCoordinate,
    },
}

impl MeasureKind {
    /// The measure of no effects, of those in `dim` dimensions.
    ///
    /// # Errors
    /// If `dim` is not one that it takes, or a field is out of range.
    pub fn start(&self, dim: usize) -> Result<Box<dyn Measure>, Error> {
        Ok(match self {
            Self::Balls { tau, accuracy } => Box::new(Balls::new(*tau, *accuracy, dim)?),
            Self::Grid { cell, origin } => Box::new(Grid::new(cell, origin, dim)?),
            Self::Share { cells, space } => Box::new(Share::new(cells, space, dim)?),
            Self::Sparseness { k } => Box::new(Sparseness::new(*k, dim)?),
            Self::Entropy { cell, origin } => Box::new(Entropy::new(cell, origin, dim)?),
        })
    }
}

/// Refuses a dimension that effects are not taken to have.
fn check_dim(dim: usize) -> Result<(), Error> {
    if (1..=HIGHEST).contains(&dim) {
        return Ok(());
    }
    Err(Error::Count { name: "dim", must_be: format!("from 1 to {HIGHEST}"), got: dim })
}
