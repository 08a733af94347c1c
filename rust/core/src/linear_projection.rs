//! Linear projection: sums of the two halves of a command, which are hard to bring to their limits.
//!
//! The benchmark of CMA-ME (Fontaine, Togelius, Nikolaidis and Hoover 2020, GECCO): each coordinate
//! within 5.12 of 0 counts as it is, beyond that it folds back to 5.12 / x. Sums of many random
//! numbers are near 0; to come to a corner, all coordinates must be near 5.12, but not beyond.

use crate::environment::Environment;
use crate::error::{Error, check_length};

/// Where a coordinate folds back.
pub const FOLD: f64 = 5.12;

/// From R^m to the plane, for even m.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct LinearProjection {
    dim: usize,
}

impl LinearProjection {
    /// Of commands of `dim` coordinates.
    ///
    /// ```
    /// use divbandit_core::LinearProjection;
    ///
    /// let projection = LinearProjection::new(4).unwrap();
    /// assert_eq!(projection.effect(&[1.0, 2.0, -5.0, 10.24]).unwrap(), [3.0, -4.5]);
    /// ```
    ///
    /// # Errors
    /// If `dim` is 0 or odd.
    pub fn new(dim: usize) -> Result<Self, Error> {
        if dim == 0 || dim % 2 == 1 {
            let must_be = "an even number of at least 2".to_owned();
            return Err(Error::Count { name: "dim", must_be, got: dim });
        }
        Ok(Self { dim })
    }

    /// The number of coordinates of a command.
    #[must_use]
    pub fn dim(&self) -> usize {
        self.dim
    }

    /// The effect of one command.
    ///
    /// # Errors
    /// If it has not `dim` coordinates.
    pub fn effect(&self, command: &[f64]) -> Result<[f64; 2], Error> {
        check_length("command", command, self.dim)?;
        let (first, second) = command.split_at(self.dim / 2);
        Ok([first, second].map(|half| half.iter().fold(0.0, |sum, &x| sum + folded(x))))
    }
}

/// What a coordinate contributes.
fn folded(x: f64) -> f64 {
    if x.abs() <= FOLD { x } else { FOLD / x }
}

impl Environment for LinearProjection {
    fn motor_dim(&self) -> usize {
        self.dim
    }

    fn effect_dim(&self) -> usize {
        2
    }

    fn effect_into(&mut self, command: &[f64], effect: &mut [f64]) -> Result<(), Error> {
        effect.copy_from_slice(&self.effect(command)?);
        Ok(())
    }
}
