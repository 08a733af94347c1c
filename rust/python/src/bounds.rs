//! Binding of boxes and of the draws made in them.

use divbandit_core::Bounds;
use pyo3::prelude::*;

use crate::arrays::{Any, Array1, Array2, Floats, count, locked, number, read_only, rows};
use crate::errors::Result;
use crate::random::NumpyStream;

/// The corners of a box, checked once so that draws need not check them again.
///
/// Examples
/// --------
/// >>> import numpy as np
/// >>> from divbandit._core import Bounds
/// >>> Bounds([0, 0], [1, 10]).sample(np.random.default_rng(0))
/// array([0.63696169, 2.69786714])
#[pyclass(module = "divbandit._core", name = "Bounds", frozen)]
pub(crate) struct PyBounds(pub Bounds);

#[pymethods]
impl PyBounds {
    #[new]
    fn new(low: &Any<'_>, high: &Any<'_>) -> Result<Self> {
        let low = Floats::point("low", low, None)?.copied()?;
        let high = Floats::point("high", high, Some(low.len()))?.copied()?;
        Ok(Self(Bounds::new(low, high)?))
    }

    /// The lowest corner, read-only.
    #[getter]
    fn low<'py>(&self, py: Python<'py>) -> PyResult<Array1<'py>> {
        read_only(py, self.0.low())
    }

    /// The highest corner, read-only.
    #[getter]
    fn high<'py>(&self, py: Python<'py>) -> PyResult<Array1<'py>> {
        read_only(py, self.0.high())
    }

    /// A point uniform in the box: one draw of `rng` a coordinate, in order.
    fn sample<'py>(&self, rng: &Any<'py>) -> PyResult<Array1<'py>> {
        read_only(rng.py(), &self.0.sample(NumpyStream::lock(rng)?.draws()))
    }

    /// Points (n, dim) uniform in the box: the same as `n` calls of `sample`.
    fn sample_many<'py>(&self, n: &Any<'py>, rng: &Any<'py>) -> Result<Array2<'py>> {
        let points = self.0.sample_many(count("n", n)?, NumpyStream::lock(rng)?.draws())?;
        Ok(locked(rows(rng.py(), points, self.0.dim())?)?)
    }

    /// Perturb_d: `parent` moved by at most the share `d` of each range, inside the box.
    fn perturb<'py>(&self, parent: &Any<'py>, d: &Any<'py>, rng: &Any<'py>) -> Result<Array1<'py>> {
        let parent = Floats::point("parent", parent, Some(self.0.dim()))?.copied()?;
        let d = number("d", d)?;
        let command = self.0.perturb(&parent, d, NumpyStream::lock(rng)?.draws())?;
        Ok(read_only(rng.py(), &command)?)
    }

    /// A read-only copy of `command`, which must lie in the box.
    fn command<'py>(&self, command: &Any<'py>) -> Result<Array1<'py>> {
        let values = Floats::point("command", command, Some(self.0.dim()))?.copied()?;
        self.0.check("command", &values)?;
        Ok(read_only(command.py(), &values)?)
    }

    /// A read-only copy of one command (dim,) or of many (n, dim), all of them in the box.
    fn commands<'py>(&self, command: &Any<'py>) -> Result<Any<'py>> {
        let floats = Floats::either("command", command, self.0.dim())?;
        if !floats.is_batch() {
            return Ok(self.command(command)?.into_any());
        }
        let values = floats.copied()?;
        for row in values.chunks_exact(self.0.dim()) {
            self.0.check("command", row)?;
        }
        Ok(locked(rows(command.py(), values, self.0.dim())?)?.into_any())
    }

    fn __getnewargs__(&self) -> (Vec<f64>, Vec<f64>) {
        (self.0.low().to_vec(), self.0.high().to_vec())
    }
}
