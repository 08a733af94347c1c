//! Shape: how many cells a grid has along each coordinate.

use crate::error::{Error, check_count};

/// Upper limit on the number of cells, which are stored one by one.
const MOST_CELLS: usize = 10_000_000;

/// How many cells a grid has along each coordinate.
#[derive(Debug, Clone, PartialEq, Eq)]
pub enum Shape {
    /// The same number along all.
    Alike(usize),
    /// One number for each.
    Each(Vec<usize>),
}

impl Shape {
    /// Checks that there is a number for each coordinate, and none is 0.
    pub(crate) fn check_counts(&self) -> Result<(), Error> {
        match self {
            Self::Alike(count) => check_count("cells", *count),
            Self::Each(counts) if counts.is_empty() => Err(Error::Empty { name: "cells" }),
            Self::Each(counts) => counts.iter().try_for_each(|&count| check_count("cells", count)),
        }
    }

    /// How many there are along each of `dim` coordinates.
    pub(crate) fn along(&self, dim: usize) -> impl Iterator<Item = usize> {
        let (alike, each) = match self {
            Self::Alike(count) => (Some(*count), &[][..]),
            Self::Each(counts) => (None, &counts[..]),
        };
        alike.into_iter().cycle().take(dim).chain(each.iter().copied())
    }

    /// Checks that they fit `dim` coordinates, and are not too many; returns how many they are.
    pub(crate) fn check(&self, dim: usize) -> Result<usize, Error> {
        if let Self::Each(counts) = self
            && counts.len() != dim
        {
            return Err(Error::Length { name: "cells", must_be: dim, got: counts.len() });
        }
        let total = self.along(dim).fold(1, usize::saturating_mul);
        if total > MOST_CELLS {
            let must_be = format!("at most {MOST_CELLS} altogether");
            return Err(Error::Count { name: "cells", must_be, got: total });
        }
        Ok(total)
    }
}
