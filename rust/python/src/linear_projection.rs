//! Binding of the linear projection.

use divbandit_core::LinearProjection;
use divbandit_core::linear_projection::FOLD;
use numpy::IntoPyArray;
use pyo3::prelude::*;

use crate::arrays::{Any, Floats, count, rows};
use crate::errors::Result;

/// Sums of the two halves of a command.
///
/// Parameters
/// ----------
/// dim : int
///     Number of coordinates of a command; even.
#[pyclass(module = "divbandit._core", name = "LinearProjection", frozen)]
pub(crate) struct PyLinearProjection(pub LinearProjection);

#[pymethods]
impl PyLinearProjection {
    /// Where a coordinate folds back.
    #[classattr]
    const FOLD: f64 = FOLD;

    #[new]
    fn new(dim: &Any<'_>) -> Result<Self> {
        Ok(Self(LinearProjection::new(count("dim", dim)?)?))
    }

    /// The effects: (dim,) -> (2,), or (n, dim) -> (n, 2).
    fn effect<'py>(&self, command: &Any<'py>) -> Result<Any<'py>> {
        let (py, m) = (command.py(), self.0.dim());
        let command = Floats::either("command", command, m)?;
        let numbers = command.copied()?;
        let each = || numbers.chunks_exact(m).map(|each| self.0.effect(each));
        let effects = py.detach(|| each().collect::<std::result::Result<Vec<_>, _>>())?.concat();
        if command.is_batch() {
            return Ok(rows(py, effects, 2)?.into_any());
        }
        Ok(effects.into_pyarray(py).into_any())
    }
}
