//! Binding of the diversity measure: the kernel that `divbandit.Coverage` is made of.

use divbandit_core::Error;
use divbandit_core::coverage::{BoundaryArc, Coverage, Estimated, Sampling};
use divbandit_core::error::check_finite;
use numpy::IntoPyArray;
use pyo3::IntoPyObjectExt;
use pyo3::exceptions::{PyIndexError, PyValueError};
use pyo3::prelude::*;

use crate::arrays::{
    Any, Array1, Array2, Floats, count, flag, locked, number, read_only, rows, rows_of,
};
use crate::errors::Result;

/// The union of balls that `divbandit.Coverage` is made of.
#[pyclass(module = "divbandit._core", name = "Coverage", subclass)]
#[derive(Clone)]
pub(crate) struct PyCoverage(pub Coverage);

#[pymethods]
impl PyCoverage {
    #[new]
    fn new(tau: &Any<'_>, dim: &Any<'_>, accuracy: &Any<'_>, key: u64) -> Result<Self> {
        let (tau, dim) = (number("tau", tau)?, count("dim", dim)?);
        let sampling = Sampling { accuracy: number("accuracy", accuracy)?, key };
        Ok(Self(Coverage::sampled(tau, dim, sampling)?))
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
    fn effects<'py>(&self, py: Python<'py>) -> PyResult<Array2<'py>> {
        locked(rows(py, self.0.effects().to_vec(), self.0.dim())?)
    }

    /// The gain of each effect when it was added: shape (n,), read-only.
    #[getter]
    fn gains<'py>(&self, py: Python<'py>) -> PyResult<Array1<'py>> {
        read_only(py, self.0.gains())
    }

    /// The standard error of each of `gains`: shape (n,), read-only; zeros where they are exact.
    #[getter]
    fn standard_errors<'py>(&self, py: Python<'py>) -> PyResult<Array1<'py>> {
        let mut errors = self.0.standard_errors().to_vec();
        errors.resize(self.0.len(), 0.0);
        read_only(py, &errors)
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
    fn add(&mut self, effect: &Any<'_>) -> Result<f64> {
        let effect = Floats::point("effect", effect, Some(self.0.dim()))?;
        Ok(self.0.add(effect.copied()?)?)
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
    fn extend<'py>(&mut self, effects: &Any<'py>) -> Result<Array1<'py>> {
        let (py, dim) = (effects.py(), self.0.dim());
        let effects = self.checked("effects", &Floats::points("effects", effects, dim)?)?;
        let mut gains = Vec::with_capacity(effects.len() / dim);
        some_at_once(py, &effects, dim, |effect| {
            gains.push(self.0.add(effect)?);
            Ok(())
        })?;
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
        effect: &Any<'py>,
        #[pyo3(from_py_with = with_error)] with_error: bool,
    ) -> Result<Any<'py>> {
        let (py, dim) = (effect.py(), self.0.dim());
        let points = Floats::either("effect", effect, dim)?;
        let effects = self.checked("effect", &points)?;
        if !points.is_batch() {
            return Ok(one(py, self.0.estimate(effects)?, with_error)?);
        }
        let (mut gains, mut errors) = (Vec::new(), Vec::new());
        some_at_once(py, &effects, dim, |effect| {
            let found = self.0.estimate(effect)?;
            gains.push(found.gain);
            errors.push(found.standard_error);
            Ok(())
        })?;
        let gains = gains.into_pyarray(py);
        if with_error {
            return Ok((gains, errors.into_pyarray(py)).into_bound_py_any(py)?);
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
        index: &Any<'py>,
        #[pyo3(from_py_with = with_error)] with_error: bool,
    ) -> Result<Any<'py>> {
        let (py, place) = (index.py(), place(index, self.0.len())?);
        let found = py.detach(|| self.0.contribution(place))?;
        Ok(one(py, found, with_error)?)
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
    fn contains<'py>(&mut self, points: &Any<'py>) -> Result<Any<'py>> {
        let (py, dim) = (points.py(), self.0.dim());
        let read = Floats::either("points", points, dim)?;
        let points = self.checked("points", &read)?;
        if !read.is_batch() {
            return Ok(self.0.contains(points)?.into_bound_py_any(py)?);
        }
        let mut inside = Vec::with_capacity(points.len() / dim);
        some_at_once(py, &points, dim, |point| {
            inside.push(self.0.contains(point)?);
            Ok(())
        })?;
        Ok(inside.into_pyarray(py).into_any())
    }

    /// The union's boundary, loop by loop, in the plane: for each an array of shape (k, 4) with
    /// the arcs' centre x, centre y, start and end angle; None in other dimensions.
    fn _boundary<'py>(&self, py: Python<'py>) -> PyResult<Option<Vec<Array2<'py>>>> {
        let Some(loops) = py.detach(|| self.0.boundary()) else { return Ok(None) };
        let row = |arc: &BoundaryArc| [arc.x, arc.y, arc.from, arc.to];
        loops
            .iter()
            .map(|arcs| rows_of(py, arcs.iter().map(row)))
            .collect::<PyResult<_>>()
            .map(Some)
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
        effects: &Any<'_>,
        gains: &Any<'_>,
        standard_errors: &Any<'_>,
    ) -> Result<()> {
        let (py, dim) = (effects.py(), self.0.dim());
        let effects = self.checked("effects", &Floats::points("effects", effects, dim)?)?;
        let gains = Floats::point("gains", gains, None)?.copied()?;
        let errors = Floats::point("standard_errors", standard_errors, None)?.copied()?;
        let (tau, sampling) = (self.0.tau(), self.0.sampling());
        self.0 = py.detach(|| Coverage::restored(tau, dim, sampling, &effects, &gains, &errors))?;
        Ok(())
    }
}

impl PyCoverage {
    /// A copy of finite points.
    fn checked(&self, name: &'static str, points: &Floats<'_>) -> Result<Vec<f64>> {
        let points = points.copied()?;
        check_finite(name, &points, self.0.dim())?;
        Ok(points)
    }
}

/// Lets `each` see points of this dimension, detached from Python but for a look for Ctrl-C every
/// few milliseconds.
pub(crate) fn some_at_once(
    py: Python<'_>,
    points: &[f64],
    dim: usize,
    mut each: impl FnMut(&[f64]) -> Result<(), Error> + Send,
) -> Result<()> {
    let some = match dim {
        1 | 2 => 1000,
        3 => 100,
        _ => 4,
    };
    for some in points.chunks(some * dim) {
        py.detach(|| some.chunks_exact(dim).try_for_each(&mut each))?;
        py.check_signals()?;
    }
    Ok(())
}

/// Reads the argument of this name.
fn with_error(value: &Any<'_>) -> PyResult<bool> {
    flag("with_error", value)
}

/// A gain alone, or with its standard error.
fn one(py: Python<'_>, found: Estimated, with_error: bool) -> PyResult<Any<'_>> {
    if with_error {
        return (found.gain, found.standard_error).into_bound_py_any(py);
    }
    found.gain.into_bound_py_any(py)
}

/// The place of one of `len` effects, from the end if the index is negative.
fn place(index: &Any<'_>, len: usize) -> PyResult<usize> {
    let negative = index.lt(0).unwrap_or(false);
    let number = if negative { count("index", &index.neg()?) } else { count("index", index) };
    let place = match number {
        Ok(from_end) if negative => len.checked_sub(from_end),
        Ok(place) => Some(place),
        // Whole, but more than any place.
        Err(error) if error.is_instance_of::<PyValueError>(index.py()) => None,
        Err(error) => return Err(error),
    };
    place.filter(|&place| place < len).ok_or_else(|| {
        let must_be = format!("index must be that of one of {len} effects");
        PyIndexError::new_err(format!("{must_be}, got {index}"))
    })
}
