//! What can be wrong with an argument, with the values needed to say so.

use std::fmt::{self, Display};

/// An argument that a kernel cannot work with. Nothing has changed when one is returned.
#[derive(Debug, Clone, PartialEq)]
pub enum Error {
    /// A number outside of what it must be.
    Number {
        /// The argument's name.
        name: &'static str,
        /// What it must be, after "must be".
        must_be: &'static str,
        /// What it was.
        got: f64,
    },
    /// A count outside of what it must be.
    Count {
        /// The argument's name.
        name: &'static str,
        /// What it must be, after "must be".
        must_be: String,
        /// What it was.
        got: usize,
    },
    /// An element of an array outside of what it must be.
    Element {
        /// The argument's name.
        name: &'static str,
        /// Where: `[3]` or `[7, 3]`.
        at: String,
        /// What it must be, after "must be".
        must_be: String,
        /// What it was.
        got: f64,
    },
    /// A coordinate so many cells away from a grid's origin that no f64 can count them.
    TooFar {
        /// The argument's name.
        name: &'static str,
        /// Where: `[3]` or `[7, 3]`.
        at: String,
        /// The origin's coordinate.
        origin: f64,
        /// What it was.
        got: f64,
        /// The edge of a cell.
        cell: f64,
    },
    /// An array of the wrong length.
    Length {
        /// The argument's name.
        name: &'static str,
        /// The length that it must have.
        must_be: usize,
        /// The length that it had.
        got: usize,
    },
    /// Something that is no number, and not what it must be.
    Unfit {
        /// The argument's name.
        name: String,
        /// What it must be, after "must be".
        must_be: &'static str,
        /// What it was.
        got: String,
    },
    /// Something was asked of an empty collection.
    Empty {
        /// What was empty.
        name: &'static str,
    },
}

impl fmt::Display for Error {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Error::Number { name, must_be, got } => {
                write!(f, "{name} must be {must_be}, got {got:?}")
            }
            Error::Count { name, must_be, got } => write!(f, "{name} must be {must_be}, got {got}"),
            Error::Element { name, at, must_be, got } => {
                write!(f, "{name}{at} must be {must_be}, got {got:?}")
            }
            Error::TooFar { name, at, origin, got, cell } => write!(
                f,
                "{name}{at} must be within 1.7e308 cells of {origin:?}, got {got:?} with cell {cell:?}"
            ),
            Error::Length { name, must_be, got } => {
                write!(f, "{name} must have length {must_be}, got {got}")
            }
            Error::Unfit { name, must_be, got } => write!(f, "{name} must be {must_be}, got {got}"),
            Error::Empty { name } => write!(f, "{name} must not be empty"),
        }
    }
}

impl std::error::Error for Error {}

/// Checks that `values`, rows of length `row` (a single row: `values.len() == row`), are finite.
///
/// # Errors
/// [`Error::Element`] at the first that is not.
pub fn check_finite(name: &'static str, values: &[f64], row: usize) -> Result<(), Error> {
    check_each(name, values, row, "finite", |value| value.is_finite())
}

/// Checks that each of `values`, rows as in [`check_finite`], is what it must be.
pub(crate) fn check_each(
    name: &'static str,
    values: &[f64],
    row: usize,
    must_be: impl Display,
    fits: impl Fn(f64) -> bool,
) -> Result<(), Error> {
    match values.iter().position(|&value| !fits(value)) {
        None => Ok(()),
        Some(index) => Err(Error::Element {
            name,
            at: place(index, row, values.len()),
            must_be: must_be.to_string(),
            got: values[index],
        }),
    }
}

/// Checks that `values` has the length that it must have.
///
/// # Errors
/// [`Error::Length`] if it has another.
pub fn check_length(name: &'static str, values: &[f64], must_be: usize) -> Result<(), Error> {
    if values.len() == must_be {
        Ok(())
    } else {
        Err(Error::Length { name, must_be, got: values.len() })
    }
}

/// Checks that a number `fits` what it must be.
///
/// # Errors
/// [`Error::Number`] if it does not.
pub fn check_number(
    name: &'static str,
    got: f64,
    fits: bool,
    must_be: &'static str,
) -> Result<(), Error> {
    if fits { Ok(()) } else { Err(Error::Number { name, must_be, got }) }
}

/// Checks that a number is positive and finite.
pub(crate) fn check_positive(name: &'static str, got: f64) -> Result<(), Error> {
    check_number(name, got, got > 0.0 && got.is_finite(), "positive and finite")
}

/// Checks that a number is a share of something, of which all or nothing counts, too.
pub(crate) fn check_share(name: &'static str, got: f64) -> Result<(), Error> {
    check_number(name, got, (0.0..=1.0).contains(&got), "in [0, 1]")
}

/// Checks that `name` counts something.
pub(crate) fn check_count(name: &'static str, got: usize) -> Result<(), Error> {
    if got > 0 {
        return Ok(());
    }
    Err(Error::Count { name, must_be: "at least 1".into(), got })
}

/// Checks that a flat array holds whole rows of length `row`.
///
/// # Errors
/// [`Error::Count`] if a row is cut short.
pub fn check_rows(name: &'static str, values: &[f64], row: usize) -> Result<(), Error> {
    if values.len().is_multiple_of(row) {
        Ok(())
    } else {
        Err(Error::Count {
            name,
            must_be: format!("whole rows of {row} numbers"),
            got: values.len(),
        })
    }
}

/// Makes room for `n` more rows of `width`, what `n` steps leave.
///
/// # Errors
/// [`Error::Count`] if there is no memory for them; nothing has changed then.
pub(crate) fn reserve<T>(rows: &mut Vec<T>, n: usize, width: usize) -> Result<(), Error> {
    match n.checked_mul(width).map(|more| rows.try_reserve(more)) {
        Some(Ok(())) => Ok(()),
        _ => Err(Error::Count {
            name: "n",
            must_be: "so few that there is memory for what they leave".to_owned(),
            got: n,
        }),
    }
}

/// Where in an array of rows the flat `index` stands; in a single row, `[index]` alone.
pub(crate) fn place(index: usize, row: usize, len: usize) -> String {
    if len == row { format!("[{index}]") } else { format!("[{}, {}]", index / row, index % row) }
}
