//! Binding of the measures of diversity: from a value in Python to what runs.

use divbandit_core::error::check_finite;
use divbandit_core::measures::{Measure, MeasureKind};
use divbandit_core::{Bounds, Error};
use numpy::IntoPyArray;
use pyo3::IntoPyObjectExt;
use pyo3::prelude::*;

use crate::arrays::{Any, Array1, Floats, count};
use crate::coverage::some_at_once;
use crate::errors::Result;
use crate::parts::{class_of, field, library_class_of, made_of, ours};

/// Which measure a part is; None for one that a user defined.
pub(crate) fn measure_of(part: &Any<'_>) -> Result<Option<MeasureKind>> {
    kind_of(class_of(part)?, part)
}

/// Which measure a part of this class is; None if it is none of the library's.
fn kind_of(class: Option<String>, part: &Any<'_>) -> Result<Option<MeasureKind>> {
    Ok(Some(match class.as_deref() {
        Some("BallCoverage") => made_of!(part, MeasureKind::Balls { tau, accuracy }),
        Some("GridCoverage") => made_of!(part, MeasureKind::Grid { cell, origin }),
        Some("CellCoverage") => {
            let space: Option<Bounds> = field(part, "box")?;
            let space = space.ok_or(Error::Empty { name: "box" })?;
            MeasureKind::Share { cells: field(part, "cells")?, space }
        }
        Some("Sparseness") => made_of!(part, MeasureKind::Sparseness { k }),
        Some("Entropy") => made_of!(part, MeasureKind::Entropy { cell, origin }),
        _ => return Ok(None),
    }))
}

/// A running measure: the diversity of the effects that were added to it.
///
/// What `start` of the library's measures returns.
///
/// Parameters
/// ----------
/// value : BallCoverage, CellCoverage, GridCoverage, Sparseness or Entropy
///     Which measure.
/// dim : int
///     Dimension of the effects.
///
/// Raises
/// ------
/// TypeError, ValueError
///     If `value` is none of these, or does not take effects of this dimension.
///
/// Examples
/// --------
/// >>> from divbandit.measures import GridCoverage
/// >>> grid = GridCoverage(0.1).start(2)
/// >>> grid.extend([[0.01, 0.02], [0.09, 0.08], [0.11, 0.08]])
/// array([1., 0., 1.])
/// >>> grid
/// <GridCoverage(0.1) of 3 effects in R^2, measure=2.0>
#[pyclass(module = "divbandit._core", name = "Measure")]
pub(crate) struct PyMeasure {
    value: Py<PyAny>,
    running: Box<dyn Measure>,
}

#[pymethods]
impl PyMeasure {
    #[new]
    fn new(value: Any<'_>, dim: &Any<'_>) -> Result<Self> {
        // A subclass of one of the library's starts the same.
        let kind = ours(kind_of(library_class_of(&value)?, &value)?, "a measure", &value)?;
        Ok(Self { value: value.unbind(), running: kind.start(count("dim", dim)?)? })
    }

    /// Dimension of the effects.
    #[getter]
    fn dim(&self) -> usize {
        self.running.dim()
    }

    /// The diversity of all effects together: 0.0 for none.
    #[getter]
    fn measure(&self) -> f64 {
        self.running.measure()
    }

    /// Upper bound of the gains; 0.0 if there is none.
    #[getter]
    fn largest_gain(&self) -> f64 {
        self.running.largest_gain()
    }

    /// Add an effect and return its gain: by how much the measure changes.
    ///
    /// Parameters
    /// ----------
    /// effect : array_like, shape (dim,)
    ///
    /// Returns
    /// -------
    /// float
    ///
    /// Raises
    /// ------
    /// TypeError, ValueError
    ///     If it is not a finite point of this dimension, or too far away for floats to tell where
    ///     it lies; nothing is added then.
    ///
    /// Examples
    /// --------
    /// >>> from divbandit.measures import GridCoverage
    /// >>> grid = GridCoverage(0.5).start(2)
    /// >>> grid.add([0.1, 0.2]), grid.add([0.2, 0.1])
    /// (1.0, 0.0)
    fn add(&mut self, effect: &Any<'_>) -> Result<f64> {
        let effect = Floats::point("effect", effect, Some(self.running.dim()))?;
        let effect = self.checked("effect", &effect)?;
        Ok(self.running.add(&effect))
    }

    /// Add effects in order and return the gain of each at its turn.
    ///
    /// Parameters
    /// ----------
    /// effects : array_like, shape (n, dim)
    ///
    /// Returns
    /// -------
    /// numpy.ndarray of float64, shape (n,)
    ///     The same numbers as from `n` calls of `add`.
    ///
    /// Raises
    /// ------
    /// TypeError, ValueError
    ///     If one is not what `add` takes; nothing is added then.
    /// KeyboardInterrupt
    ///     On Ctrl-C; the first so many effects are added then.
    ///
    /// Examples
    /// --------
    /// >>> from divbandit.measures import Entropy
    /// >>> Entropy(1.0).start(1).extend([[0], [5], [0]]).round(6)
    /// array([ 0.      ,  0.693147, -0.056633])
    fn extend<'py>(&mut self, effects: &Any<'py>) -> Result<Array1<'py>> {
        let (py, points) = (effects.py(), Floats::points("effects", effects, self.running.dim())?);
        let effects = self.checked("effects", &points)?;
        self.each(py, &effects, |running, effect| running.add(effect))
    }

    /// Return what `add` would return; nothing is added.
    ///
    /// Parameters
    /// ----------
    /// effect : array_like, shape (dim,) or (n, dim)
    ///
    /// Returns
    /// -------
    /// float, or numpy.ndarray of float64, shape (n,)
    ///     For many effects the gain of each by itself, as if the others were not there.
    ///
    /// Raises
    /// ------
    /// TypeError, ValueError
    ///     If one is not what `add` takes.
    ///
    /// Examples
    /// --------
    /// >>> from divbandit.measures import GridCoverage
    /// >>> grid = GridCoverage(0.5).start(2)
    /// >>> grid.gain([0.1, 0.2]), grid.gain([[0.1, 0.2], [0.2, 0.1]]), len(grid)
    /// (1.0, array([1., 1.]), 0)
    fn gain<'py>(&mut self, effect: &Any<'py>) -> Result<Any<'py>> {
        let (py, points) = (effect.py(), Floats::either("effect", effect, self.running.dim())?);
        let effects = self.checked("effect", &points)?;
        if points.is_batch() {
            return Ok(self.each(py, &effects, |running, effect| running.gain(effect))?.into_any());
        }
        Ok(self.running.gain(&effects).into_bound_py_any(py)?)
    }

    fn __len__(&self) -> usize {
        self.running.len()
    }

    fn __repr__(&self, py: Python<'_>) -> PyResult<String> {
        Ok(format!(
            "<{} of {} effects in R^{}, measure={:?}>",
            self.value.bind(py).repr()?,
            self.running.len(),
            self.running.dim(),
            self.running.measure()
        ))
    }
}

impl PyMeasure {
    /// Copies points, unless they are no effects or cannot be placed.
    fn checked(&self, name: &'static str, points: &Floats<'_>) -> Result<Vec<f64>> {
        let effects = points.copied()?;
        check_finite(name, &effects, self.running.dim())?;
        self.running.check(name, &effects)?;
        Ok(effects)
    }

    /// What `found` returns for each of many effects.
    fn each<'py>(
        &mut self,
        py: Python<'py>,
        effects: &[f64],
        found: impl Fn(&mut dyn Measure, &[f64]) -> f64 + Sync,
    ) -> Result<Array1<'py>> {
        let running = &mut *self.running;
        let mut gains = Vec::with_capacity(effects.len() / running.dim());
        some_at_once(py, effects, running.dim(), |effect| {
            gains.push(found(running, effect));
            Ok(())
        })?;
        Ok(gains.into_pyarray(py))
    }
}
