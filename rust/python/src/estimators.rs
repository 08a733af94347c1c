//! Binding of the estimators: the mean rewards of a bandit's strategies.

use divbandit_core::Error;
use divbandit_core::bandits::estimators::{Estimator, EstimatorKind};
use pyo3::prelude::*;

use crate::arrays::{Any, count, number};
use crate::errors::Result;
use crate::parts::{class_of, made_of, ours};

/// Which estimator a value of the library is; None for a user's.
pub(crate) fn estimator_of(part: &Any<'_>) -> Result<Option<EstimatorKind>> {
    Ok(Some(match class_of(part)?.as_deref() {
        Some("Window") => made_of!(part, EstimatorKind::Window { size, head_start }),
        Some("RecentWindow") => made_of!(part, EstimatorKind::RecentWindow { size }),
        Some("Discounted") => made_of!(part, EstimatorKind::Discounted { gamma, head_start }),
        Some("WholePast") => EstimatorKind::WholePast,
        _ => return Ok(None),
    }))
}

/// A running estimator of the library: the mean reward of each strategy.
///
/// Parameters
/// ----------
/// value : estimator of the library
///     For instance ``db.bandits.Window(50)``.
/// parts : int
///     How many strategies there are.
/// largest : float
///     Upper bound of the rewards; 0.0 if there is none.
///
/// Raises
/// ------
/// TypeError, ValueError
///     If `value` is not an estimator of the library, there are no parts, or `largest` is negative
///     or not finite.
///
/// Examples
/// --------
/// >>> from divbandit.bandits import Window
/// >>> estimates = Window(3, head_start=1).start(2, 6.0)
/// >>> estimates.add(0, 3.0)
/// >>> estimates.means, estimates.counts, estimates.largest
/// ([4.5, 6.0], [2.0, 1.0], 6.0)
#[pyclass(module = "divbandit._core", name = "Estimator")]
pub(crate) struct PyEstimator(pub Box<dyn Estimator>);

#[pymethods]
impl PyEstimator {
    #[new]
    fn new(value: &Any<'_>, parts: &Any<'_>, largest: &Any<'_>) -> Result<Self> {
        let kind = ours(estimator_of(value)?, "an estimator", value)?;
        Ok(Self(kind.start(count("parts", parts)?, number("largest", largest)?)?))
    }

    /// The mean reward of each strategy; 0.0 where none is remembered.
    #[getter]
    fn means(&self) -> Vec<f64> {
        self.0.means().to_vec()
    }

    /// The number of rewards behind each mean, or their total weight.
    #[getter]
    fn counts(&self) -> Vec<f64> {
        self.0.counts().to_vec()
    }

    /// Upper bound of the rewards, or of those so far.
    #[getter]
    fn largest(&self) -> f64 {
        self.0.largest()
    }

    /// Remember a reward of a strategy.
    ///
    /// Parameters
    /// ----------
    /// part : int
    ///     Its index.
    /// reward : float
    ///
    /// Raises
    /// ------
    /// TypeError, ValueError
    ///     If there is no such strategy, or `reward` is not a finite number.
    ///
    /// Examples
    /// --------
    /// >>> from divbandit.bandits import WholePast
    /// >>> estimates = WholePast().start(2, 6.0)
    /// >>> estimates.add(1, 3.0)
    /// >>> estimates.means
    /// [0.0, 3.0]
    fn add(&mut self, part: &Any<'_>, reward: &Any<'_>) -> Result<()> {
        let part = part_of(part, self.0.means().len())?;
        self.0.add(part, finite("reward", reward)?);
        Ok(())
    }

    fn __repr__(&self) -> String {
        format!("<Estimator with means {:?}>", self.0.means())
    }
}

/// Reads the index of one of so many parts.
pub(crate) fn part_of(part: &Any<'_>, parts: usize) -> Result<usize> {
    let got = count("part", part)?;
    if got < parts {
        return Ok(got);
    }
    Err(Error::Count { name: "part", must_be: format!("from 0 to {}", parts - 1), got }.into())
}

/// Reads a finite number.
pub(crate) fn finite(name: &'static str, value: &Any<'_>) -> Result<f64> {
    let got = number(name, value)?;
    if got.is_finite() {
        return Ok(got);
    }
    Err(Error::Number { name, must_be: "finite", got }.into())
}
