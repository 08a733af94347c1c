//! Binding of the measures of diversity: from a value in Python to what runs.

use divbandit_core::error::check_finite;
use divbandit_core::measures::{Measure, MeasureKind, PerCoordinate};
use numpy::{IntoPyArray, PyArray1};
use pyo3::exceptions::PyTypeError;
use pyo3::prelude::*;

use crate::arrays::{Floats, count};
use crate::coverage::at_once;
use crate::errors::value_error;
use crate::parts::{class_of, field, library_class_of};

/// Which measure a part is; None for one that a user defined.
pub(crate) fn measure_of(part: &Bound<'_, PyAny>) -> PyResult<Option<MeasureKind>> {
    match class_of(part)? {
        Some(class) => kind_of(&class, part),
        None => Ok(None),
    }
}

/// Which measure a part of this class is; None if it is none of the library's.
fn kind_of(class: &str, part: &Bound<'_, PyAny>) -> PyResult<Option<MeasureKind>> {
    Ok(Some(match class {
        "BallCoverage" => {
            MeasureKind::Balls { tau: field(part, "tau")?, accuracy: field(part, "accuracy")? }
        }
        "GridCoverage" => MeasureKind::Grid {
            cell: per_coordinate(part, "cell")?,
            origin: per_coordinate(part, "origin")?,
        },
        "Sparseness" => MeasureKind::Sparseness { k: field(part, "k")? },
        "Entropy" => MeasureKind::Entropy {
            cell: per_coordinate(part, "cell")?,
            origin: per_coordinate(part, "origin")?,
        },
        _ => return Ok(None),
    }))
}

/// The field `name` of a part: a number, or a tuple of one for each coordinate.
fn per_coordinate(part: &Bound<'_, PyAny>, name: &str) -> PyResult<PerCoordinate> {
    let value = part.getattr(name)?;
    if let Ok(number) = value.extract() {
        return Ok(PerCoordinate::All(number));
    }
    value.extract().map(PerCoordinate::Each)
}

/// A running measure: the diversity of the effects that were added to it.
///
/// What `start` of the library's measures returns.
///
/// Parameters
/// ----------
/// value : BallCoverage, GridCoverage, Sparseness or Entropy
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
    fn new(value: Bound<'_, PyAny>, dim: &Bound<'_, PyAny>) -> PyResult<Self> {
        // A subclass of one of the library's starts the same.
        let kind = match library_class_of(&value)? {
            Some(class) => kind_of(&class, &value)?,
            None => None,
        };
        let Some(kind) = kind else {
            return Err(PyTypeError::new_err(format!(
                "value must be a measure of the library, got {}",
                value.get_type().name()?
            )));
        };
        let running = kind.start(count("dim", dim)?).map_err(value_error)?;
        Ok(Self { value: value.unbind(), running })
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
    fn add(&mut self, effect: &Bound<'_, PyAny>) -> PyResult<f64> {
        let effect = Floats::point("effect", effect, Some(self.running.dim()))?.copied()?;
        self.check("effect", &effect)?;
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
    fn extend<'py>(
        &mut self,
        py: Python<'py>,
        effects: &Bound<'py, PyAny>,
    ) -> PyResult<Bound<'py, PyArray1<f64>>> {
        let effects = Floats::points("effects", effects, self.running.dim())?.copied()?;
        self.check("effects", &effects)?;
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
    fn gain<'py>(
        &mut self,
        py: Python<'py>,
        effect: &Bound<'py, PyAny>,
    ) -> PyResult<Bound<'py, PyAny>> {
        let points = Floats::either("effect", effect, self.running.dim())?;
        let (is_batch, effects) = (points.is_batch(), points.copied()?);
        self.check("effect", &effects)?;
        if is_batch {
            return Ok(self.each(py, &effects, |running, effect| running.gain(effect))?.into_any());
        }
        Ok(self.running.gain(&effects).into_pyobject(py)?.into_any())
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
    /// Refuses rows of numbers that are no effects, or cannot be placed.
    fn check(&self, name: &'static str, effects: &[f64]) -> PyResult<()> {
        check_finite(name, effects, self.running.dim())
            .and_then(|()| self.running.check(name, effects))
            .map_err(value_error)
    }

    /// What `found` returns for each of many effects.
    fn each<'py>(
        &mut self,
        py: Python<'py>,
        effects: &[f64],
        found: impl Fn(&mut dyn Measure, &[f64]) -> f64 + Sync,
    ) -> PyResult<Bound<'py, PyArray1<f64>>> {
        let dim = self.running.dim();
        let mut gains = Vec::with_capacity(effects.len() / dim);
        for some in effects.chunks(at_once(dim) * dim) {
            let running = &mut *self.running;
            py.detach(|| {
                gains.extend(some.chunks_exact(dim).map(|effect| found(running, effect)));
            });
            py.check_signals()?;
        }
        Ok(gains.into_pyarray(py))
    }
}
