//! Binding of the diversity measure: the kernel that `divbandit.Coverage` is made of.

use divbandit_core::coverage::{BoundaryArc, Coverage, Estimated, Sampling};
use divbandit_core::error::check_finite;
use numpy::{IntoPyArray, PyArray1, PyArray2, PyArrayMethods};
use pyo3::exceptions::{PyIndexError, PyValueError};
use pyo3::prelude::*;
use pyo3::types::PyBool;

use crate::arrays::{Floats, count, flag, number, read_only};
use crate::errors::value_error;

/// The union of balls that `divbandit.Coverage` is made of.
#[pyclass(module = "divbandit._core", name = "Coverage", subclass)]
#[derive(Clone)]
pub(crate) struct PyCoverage(pub Coverage);

#[pymethods]
impl PyCoverage {
    #[new]
    fn new(
        tau: &Bound<'_, PyAny>,
        dim: &Bound<'_, PyAny>,
        accuracy: &Bound<'_, PyAny>,
        key: u64,
    ) -> PyResult<Self> {
        let (tau, dim) = (number("tau", tau)?, count("dim", dim)?);
        let sampling = Sampling { accuracy: number("accuracy", accuracy)?, key };
        Coverage::sampled(tau, dim, sampling).map(Self).map_err(value_error)
    }

    /// Radius of the balls, in the units of the effects.
    #[getter]
    fn tau(&self) -> f64 {
        self.0.tau()
    }

    /// Dimension of the effects.
    #[getter]
    fn dim(&self) -> usize {
        self.0.dim()
    }

    /// Whether gains are exact, which they are up to dimension 3, or estimated.
    #[getter]
    fn exact(&self) -> bool {
        self.0.is_exact()
    }

    /// Upper limit on the standard error of an estimated gain, as a share of a ball's measure.
    #[getter]
    fn accuracy(&self) -> f64 {
        self.0.sampling().accuracy
    }

    /// The key of the random numbers of estimates.
    #[getter]
    fn _key(&self) -> u64 {
        self.0.sampling().key
    }

    /// The measure of the union: the diversity of all effects together.
    #[getter]
    fn measure(&self) -> f64 {
        self.0.measure()
    }

    /// The standard error of `measure`; 0.0 where it is exact.
    #[getter]
    fn standard_error(&self) -> f64 {
        self.0.standard_error()
    }

    /// The measure of one ball, which no gain exceeds.
    #[getter]
    fn largest_gain(&self) -> f64 {
        self.0.ball()
    }

    /// All effects in order: shape (n, dim), read-only.
    #[getter]
    fn effects<'py>(&self, py: Python<'py>) -> PyResult<Bound<'py, PyArray2<f64>>> {
        let flat = PyArray1::from_slice(py, self.0.effects());
        let rows = flat.reshape([self.0.len(), self.0.dim()])?;
        rows.try_readwrite()?.make_nonwriteable();
        Ok(rows)
    }

    /// The gain of each effect when it was added: shape (n,), read-only.
    #[getter]
    fn gains<'py>(&self, py: Python<'py>) -> PyResult<Bound<'py, PyArray1<f64>>> {
        read_only(py, self.0.gains())
    }

    /// The standard error of each of `gains`: shape (n,), read-only; zeros where they are exact.
    #[getter]
    fn standard_errors<'py>(&self, py: Python<'py>) -> PyResult<Bound<'py, PyArray1<f64>>> {
        if self.0.is_exact() {
            return read_only(py, &vec![0.0; self.0.len()]);
        }
        read_only(py, self.0.standard_errors())
    }

    /// Add an effect and return its gain, div_tau(effect, E): the measure that it adds.
    ///
    /// Parameters
    /// ----------
    /// effect : array_like, shape (dim,)
    ///
    /// Returns
    /// -------
    /// float
    ///     In [0, measure of one ball].
    ///
    /// Raises
    /// ------
    /// TypeError, ValueError
    ///     If it is not a finite point of this dimension; nothing is added then.
    ///
    /// Examples
    /// --------
    /// >>> import divbandit as db
    /// >>> cov = db.Coverage(0.02)
    /// >>> round(cov.add([0.1, 0.2]), 9)
    /// 0.001256637
    fn add(&mut self, effect: &Bound<'_, PyAny>) -> PyResult<f64> {
        let effect = Floats::point("effect", effect, Some(self.0.dim()))?;
        self.0.add(effect.copied()?).map_err(value_error)
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
    ///
    /// Raises
    /// ------
    /// TypeError, ValueError
    ///     If one is not a finite point of this dimension; nothing is added then.
    /// KeyboardInterrupt
    ///     On Ctrl-C; the first so many effects are added then.
    ///
    /// Examples
    /// --------
    /// >>> import divbandit as db
    /// >>> db.Coverage(1.0).extend([[0, 0], [0, 0], [9, 9]])
    /// array([3.14159265, 0.        , 3.14159265])
    fn extend<'py>(
        &mut self,
        py: Python<'py>,
        effects: &Bound<'py, PyAny>,
    ) -> PyResult<Bound<'py, PyArray1<f64>>> {
        let effects = self.points("effects", effects)?;
        let mut gains = vec![0.0; effects.len() / self.0.dim()];
        let some = at_once(self.0.dim());
        for (effects, gains) in effects.chunks(some * self.0.dim()).zip(gains.chunks_mut(some)) {
            py.detach(|| self.0.extend(effects, gains)).map_err(value_error)?;
            py.check_signals()?;
        }
        Ok(gains.into_pyarray(py))
    }

    /// What `add(effect)` would return; nothing is added.
    ///
    /// Parameters
    /// ----------
    /// effect : array_like, shape (dim,) or (n, dim)
    /// with_error : bool
    ///     Whether to return the standard error as well.
    ///
    /// Returns
    /// -------
    /// gain : float, or numpy.ndarray of float64, shape (n,)
    ///     For many effects the gain of each by itself, as if the others were not there.
    /// standard_error : float, or numpy.ndarray of float64, shape (n,)
    ///     Only if asked for: 0.0 where the gain is exact.
    ///
    /// Raises
    /// ------
    /// TypeError, ValueError
    ///     If one is not a finite point of this dimension.
    ///
    /// Examples
    /// --------
    /// >>> import divbandit as db
    /// >>> cov = db.Coverage(1.0)
    /// >>> cov.gain([0, 0]), cov.measure
    /// (3.141592653589793, 0.0)
    /// >>> _ = cov.add([0, 0])
    /// >>> cov.gain([[0, 0], [2, 0]])
    /// array([0.        , 3.14159265])
    #[pyo3(signature = (effect, *, with_error=false))]
    fn gain<'py>(
        &mut self,
        py: Python<'py>,
        effect: &Bound<'py, PyAny>,
        #[pyo3(from_py_with = with_error)] with_error: bool,
    ) -> PyResult<Bound<'py, PyAny>> {
        let points = Floats::either("effect", effect, self.0.dim())?;
        if !points.is_batch() {
            let found = self.0.estimate(points.copied()?).map_err(value_error)?;
            return one(py, found, with_error);
        }
        let effects = self.points("effect", effect)?;
        let (mut gains, mut errors) = (Vec::new(), Vec::new());
        for some in effects.chunks(at_once(self.0.dim()) * self.0.dim()) {
            py.detach(|| {
                for effect in some.chunks_exact(self.0.dim()) {
                    let found = self.0.estimate(effect)?;
                    gains.push(found.gain);
                    errors.push(found.standard_error);
                }
                Ok(())
            })
            .map_err(value_error)?;
            py.check_signals()?;
        }
        let gains = gains.into_pyarray(py);
        if with_error {
            return Ok((gains, errors.into_pyarray(py)).into_pyobject(py)?.into_any());
        }
        Ok(gains.into_any())
    }

    /// What would be lost without an effect: the measure of the part of its ball that lies in
    /// no other effect's.
    ///
    /// It takes as long as adding all effects within 2 tau again.
    ///
    /// Parameters
    /// ----------
    /// index : int
    ///     The effect's place in the order in which they were added; from the end if negative.
    /// with_error : bool
    ///     Whether to return the standard error as well.
    ///
    /// Returns
    /// -------
    /// contribution : float
    /// standard_error : float
    ///     Only if asked for: 0.0 where the contribution is exact.
    ///
    /// Raises
    /// ------
    /// TypeError
    ///     If `index` is not a whole number.
    /// IndexError
    ///     If there is no such effect.
    ///
    /// Examples
    /// --------
    /// >>> import divbandit as db
    /// >>> cov = db.Coverage(1.0, dim=1)
    /// >>> cov.extend([[0], [1], [1.5]])
    /// array([2. , 1. , 0.5])
    /// >>> cov.contribution(0), cov.contribution(1), cov.contribution(-1)
    /// (1.0, 0.0, 0.5)
    #[pyo3(signature = (index, *, with_error=false))]
    fn contribution<'py>(
        &mut self,
        py: Python<'py>,
        index: &Bound<'py, PyAny>,
        #[pyo3(from_py_with = with_error)] with_error: bool,
    ) -> PyResult<Bound<'py, PyAny>> {
        let place = match place("index", index, self.0.len())? {
            Some(place) => place,
            None => {
                return Err(PyIndexError::new_err(format!(
                    "index must be that of one of {} effects, got {index}",
                    self.0.len()
                )));
            }
        };
        let found = py.detach(|| self.0.contribution(place)).map_err(value_error)?;
        one(py, found, with_error)
    }

    /// Whether points lie in the union: no farther than tau from some effect.
    ///
    /// Parameters
    /// ----------
    /// points : array_like, shape (dim,) or (n, dim)
    ///
    /// Returns
    /// -------
    /// bool, or numpy.ndarray of bool, shape (n,)
    ///
    /// Raises
    /// ------
    /// TypeError, ValueError
    ///     If one is not a finite point of this dimension.
    ///
    /// Examples
    /// --------
    /// >>> import divbandit as db
    /// >>> cov = db.Coverage(1.0)
    /// >>> _ = cov.add([0, 0])
    /// >>> cov.contains([1, 0]), cov.contains([[0.5, 0.5], [1, 1]])
    /// (True, array([ True, False]))
    fn contains<'py>(
        &mut self,
        py: Python<'py>,
        points: &Bound<'py, PyAny>,
    ) -> PyResult<Bound<'py, PyAny>> {
        let borrowed = Floats::either("points", points, self.0.dim())?;
        if !borrowed.is_batch() {
            let point = borrowed.copied()?;
            check_finite("points", &point, self.0.dim()).map_err(value_error)?;
            let inside = self.0.contains(point).map_err(value_error)?;
            return Ok(PyBool::new(py, inside).to_owned().into_any());
        }
        let points = self.points("points", points)?;
        let inside: Result<Vec<bool>, _> = py.detach(|| {
            points.chunks_exact(self.0.dim()).map(|point| self.0.contains(point)).collect()
        });
        Ok(inside.map_err(value_error)?.into_pyarray(py).into_any())
    }

    /// The union's boundary, loop by loop, in the plane: for each an array of shape (k, 4) with
    /// the arcs' centre x, centre y, start and end angle; None in other dimensions.
    fn _boundary<'py>(&self, py: Python<'py>) -> PyResult<Option<Vec<Bound<'py, PyArray2<f64>>>>> {
        let Some(loops) = py.detach(|| self.0.boundary()) else { return Ok(None) };
        let array = |arcs: &Vec<BoundaryArc>| {
            let rows = arcs.iter().flat_map(|arc| [arc.x, arc.y, arc.from, arc.to]);
            PyArray1::from_vec(py, rows.collect()).reshape([arcs.len(), 4])
        };
        loops.iter().map(array).collect::<PyResult<_>>().map(Some)
    }

    fn __len__(&self) -> usize {
        self.0.len()
    }

    /// Becomes an independent copy of `other`.
    fn _become(&mut self, other: &Self) {
        self.0 = other.0.clone();
    }

    /// Becomes what effects, gains and standard errors were logged of.
    fn _restore(
        &mut self,
        py: Python<'_>,
        effects: &Bound<'_, PyAny>,
        gains: &Bound<'_, PyAny>,
        standard_errors: &Bound<'_, PyAny>,
    ) -> PyResult<()> {
        let effects = self.points("effects", effects)?;
        let gains = Floats::point("gains", gains, None)?.copied()?;
        let errors = Floats::point("standard_errors", standard_errors, None)?.copied()?;
        let (tau, dim, sampling) = (self.0.tau(), self.0.dim(), self.0.sampling());
        let restored =
            py.detach(|| Coverage::restored(tau, dim, sampling, &effects, &gains, &errors));
        self.0 = restored.map_err(value_error)?;
        Ok(())
    }
}

impl PyCoverage {
    /// A copy of many points, checked.
    fn points(&self, name: &'static str, points: &Bound<'_, PyAny>) -> PyResult<Vec<f64>> {
        let points = Floats::points(name, points, self.0.dim())?.copied()?;
        check_finite(name, &points, self.0.dim()).map_err(value_error)?;
        Ok(points)
    }
}

/// How many effects of this dimension to process between checks for Ctrl-C: some milliseconds.
pub(crate) fn at_once(dim: usize) -> usize {
    match dim {
        1 | 2 => 1000,
        3 => 100,
        _ => 4,
    }
}

/// Reads the argument of this name.
fn with_error(value: &Bound<'_, PyAny>) -> PyResult<bool> {
    flag("with_error", value)
}

/// A gain alone, or with its standard error.
fn one(py: Python<'_>, found: Estimated, with_error: bool) -> PyResult<Bound<'_, PyAny>> {
    if with_error {
        return Ok((found.gain, found.standard_error).into_pyobject(py)?.into_any());
    }
    Ok(found.gain.into_pyobject(py)?.into_any())
}

/// The place that an index into `len` things means, from the end if negative; None if there is
/// no such place.
fn place(name: &str, index: &Bound<'_, PyAny>, len: usize) -> PyResult<Option<usize>> {
    let negative = index.lt(0).unwrap_or(false);
    let from = if negative { count(name, &index.neg()?) } else { count(name, index) };
    match from {
        Ok(from_end) if negative => Ok(len.checked_sub(from_end)),
        Ok(place) => Ok(Some(place).filter(|&place| place < len)),
        // Whole, but more than any place.
        Err(error) if error.is_instance_of::<PyValueError>(index.py()) => Ok(None),
        Err(error) => Err(error),
    }
}
