//! Binding of boxes and of the draws made in them.

use divbandit_core::Bounds;
use numpy::{PyArray1, PyArray2, PyArrayMethods};
use pyo3::prelude::*;
use pyo3::types::PyList;

use crate::arrays::{Floats, count, number, read_only, read_only_rows};
use crate::errors::value_error;
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
    fn new(low: &Bound<'_, PyAny>, high: &Bound<'_, PyAny>) -> PyResult<Self> {
        let low = Floats::point("low", low, None)?.copied()?;
        let high = Floats::point("high", high, Some(low.len()))?.copied()?;
        Bounds::new(low, high).map(Self).map_err(value_error)
    }

    /// The lowest corner, read-only.
    #[getter]
    fn low<'py>(&self, py: Python<'py>) -> PyResult<Bound<'py, PyArray1<f64>>> {
        read_only(py, self.0.low())
    }

    /// The highest corner, read-only.
    #[getter]
    fn high<'py>(&self, py: Python<'py>) -> PyResult<Bound<'py, PyArray1<f64>>> {
        read_only(py, self.0.high())
    }

    /// A point uniform in the box: one draw of `rng` a coordinate, in order.
    fn sample<'py>(&self, rng: &Bound<'py, PyAny>) -> PyResult<Bound<'py, PyArray1<f64>>> {
        let point = self.0.sample(&mut NumpyStream::lock(rng)?);
        read_only(rng.py(), &point)
    }

    /// Points (n, dim) uniform in the box: the same as `n` calls of `sample`.
    fn sample_many<'py>(
        &self,
        n: &Bound<'py, PyAny>,
        rng: &Bound<'py, PyAny>,
    ) -> PyResult<Bound<'py, PyArray2<f64>>> {
        let n = count("n", n)?;
        let points = self.0.sample_many(n, &mut NumpyStream::lock(rng)?).map_err(value_error)?;
        read_only_rows(rng.py(), points, self.0.dim())
    }

    /// Perturb_d: `parent` moved by at most the share `d` of each range, inside the box.
    fn perturb<'py>(
        &self,
        parent: &Bound<'py, PyAny>,
        d: &Bound<'py, PyAny>,
        rng: &Bound<'py, PyAny>,
    ) -> PyResult<Bound<'py, PyArray1<f64>>> {
        let parent = Floats::point("parent", parent, Some(self.0.dim()))?;
        let d = number("d", d)?;
        let command = self
            .0
            .perturb(&parent.copied()?, d, &mut NumpyStream::lock(rng)?)
            .map_err(value_error)?;
        read_only(rng.py(), &command)
    }

    /// A read-only copy of one command (dim,) or of many (n, dim), all of them in the box.
    fn commands<'py>(&self, command: &Bound<'py, PyAny>) -> PyResult<Bound<'py, PyAny>> {
        let floats = Floats::either("command", command, self.0.dim())?;
        let values = floats.copied()?;
        for row in values.chunks_exact(self.0.dim()) {
            self.0.check("command", row).map_err(value_error)?;
        }
        let copy = read_only(command.py(), &values)?;
        if !floats.is_batch() {
            return Ok(copy.into_any());
        }
        Ok(copy.reshape([values.len() / self.0.dim(), self.0.dim()])?.into_any())
    }

    /// The commands of a list, each of them an array (dim,) of floats in the box, as the rows of one
    /// read-only array; None if there is anything else in it.
    fn gather<'py>(
        &self,
        commands: &Bound<'py, PyList>,
    ) -> PyResult<Option<Bound<'py, PyArray2<f64>>>> {
        let dim = self.0.dim();
        let mut values = Vec::with_capacity(commands.len() * dim);
        for command in commands {
            let Ok(array) = command.cast::<PyArray1<f64>>() else { return Ok(None) };
            let Ok(array) = array.try_readonly() else { return Ok(None) };
            let Ok(row) = array.as_slice() else { return Ok(None) };
            if self.0.check("command", row).is_err() {
                return Ok(None);
            }
            values.extend_from_slice(row);
        }
        let rows = read_only(commands.py(), &values)?.reshape([commands.len(), dim])?;
        Ok(Some(rows))
    }

    fn __getnewargs__(&self) -> (Vec<f64>, Vec<f64>) {
        (self.0.low().to_vec(), self.0.high().to_vec())
    }

    /// A read-only copy of `command`, which must lie in the box.
    fn command<'py>(&self, command: &Bound<'py, PyAny>) -> PyResult<Bound<'py, PyArray1<f64>>> {
        let floats = Floats::point("command", command, Some(self.0.dim()))?;
        let values = floats.copied()?;
        self.0.check("command", &values).map_err(value_error)?;
        read_only(command.py(), &values)
    }
}
