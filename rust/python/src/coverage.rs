//! Binding of the diversity measure.

use divbandit_core::Coverage;
use divbandit_core::error::check_finite;
use numpy::{IntoPyArray, PyArray1};
use pyo3::exceptions::PyValueError;
use pyo3::prelude::*;

use crate::arrays::{Floats, count, number};
use crate::errors::value_error;

/// The diversity C_tau of a growing set of effects: the measure of the union of the balls of
/// radius tau around them (Benureau and Oudeyer 2015).
///
/// In the plane it is the exact area of a union of discs: each gain is right to some 1e-14 of
/// a disc's area. The time of a gain grows with the number of effects within 2 tau that covered
/// something new when they came.
///
/// Parameters
/// ----------
/// tau : float
///     Radius of the balls, in the units of the effects; positive.
/// dim : int
///     Dimension of the effects. Only 2 is supported.
///
/// Raises
/// ------
/// TypeError, ValueError
///     If `tau` is not a positive number, or `dim` is not 2.
///
/// Examples
/// --------
/// >>> import divbandit as db
/// >>> cov = db.Coverage(1.0)
/// >>> cov.add([0, 0])
/// 3.141592653589793
/// >>> cov.add([5, 0]), cov.add([0, 0])
/// (3.141592653589793, 0.0)
/// >>> cov.measure
/// 6.283185307179586
#[pyclass(module = "divbandit", name = "Coverage")]
#[derive(Clone)]
pub(crate) struct PyCoverage(Coverage);

#[pymethods]
impl PyCoverage {
    #[new]
    #[pyo3(signature = (tau, *, dim=None), text_signature = "(tau, *, dim=2)")]
    fn new(tau: &Bound<'_, PyAny>, dim: Option<&Bound<'_, PyAny>>) -> PyResult<Self> {
        let dim = dim.map_or(Ok(2), |dim| count("dim", dim))?;
        if dim != 2 {
            return Err(PyValueError::new_err(format!(
                "dim must be 2 (the only dimension supported), got {dim}"
            )));
        }
        Coverage::new(number("tau", tau)?).map(Self).map_err(value_error)
    }

    /// Radius of the balls, in the units of the effects.
    #[getter]
    fn tau(&self) -> f64 {
        self.0.tau()
    }

    /// Dimension of the effects.
    #[getter]
    fn dim(&self) -> usize {
        2
    }

    /// The measure of the union: the diversity of all effects together.
    #[getter]
    fn measure(&self) -> f64 {
        self.0.measure()
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
    ///     If it is no finite point of this dimension; nothing is added then.
    ///
    /// Examples
    /// --------
    /// >>> import divbandit as db
    /// >>> cov = db.Coverage(0.02)
    /// >>> round(cov.add([0.1, 0.2]), 9)
    /// 0.001256637
    fn add(&mut self, effect: &Bound<'_, PyAny>) -> PyResult<f64> {
        self.0.add(pair(effect)?).map_err(value_error)
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
    ///     If one is no finite point of this dimension; nothing is added then.
    /// KeyboardInterrupt
    ///     On Ctrl-C; the first so many thousand effects are added then.
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
        let effects = Floats::points("effects", effects, 2)?;
        Ok(extend(py, &mut self.0, effects.slice()?)?.into_pyarray(py))
    }

    /// What `add(effect)` would return; nothing is added.
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
    ///     If it is no finite point of this dimension.
    ///
    /// Examples
    /// --------
    /// >>> import divbandit as db
    /// >>> cov = db.Coverage(1.0)
    /// >>> cov.gain([0, 0]), cov.measure
    /// (3.141592653589793, 0.0)
    fn gain(&mut self, effect: &Bound<'_, PyAny>) -> PyResult<f64> {
        self.0.gain(pair(effect)?).map_err(value_error)
    }

    fn __len__(&self) -> usize {
        self.0.len()
    }

    fn __copy__(&self) -> Self {
        self.clone()
    }

    fn __deepcopy__(&self, _memo: &Bound<'_, PyAny>) -> Self {
        self.clone()
    }

    fn __repr__(&self) -> String {
        let (len, tau, measure) = (self.0.len(), self.0.tau(), self.0.measure());
        format!("<Coverage of {len} effects, tau={tau:?}, measure={measure:?}>")
    }
}

/// The diversity C_tau of a whole set of effects at once (Benureau and Oudeyer 2015).
///
/// Parameters
/// ----------
/// effects : array_like, shape (n, 2)
/// tau : float
///     Radius of the discs, in the units of the effects; positive.
///
/// Returns
/// -------
/// float
///     The area of the union of the discs; 0 for no effects.
///
/// Raises
/// ------
/// TypeError, ValueError
///     If one is no finite point of the plane, or `tau` is not a positive number.
///
/// Examples
/// --------
/// >>> import divbandit as db
/// >>> db.coverage([[0, 0], [1, 0]], 1.0)
/// 5.05481560857083
#[pyfunction]
pub(crate) fn coverage(
    py: Python<'_>,
    effects: &Bound<'_, PyAny>,
    tau: &Bound<'_, PyAny>,
) -> PyResult<f64> {
    let effects = Floats::points("effects", effects, 2)?;
    let mut union = Coverage::new(number("tau", tau)?).map_err(value_error)?;
    extend(py, &mut union, effects.slice()?)?;
    Ok(union.measure())
}

/// Adds effects a thousand at a time, without the GIL but open to Ctrl-C in between.
fn extend(py: Python<'_>, union: &mut Coverage, effects: &[f64]) -> PyResult<Vec<f64>> {
    // A copy: while others run, they may change the array between its check and its use.
    let effects = effects.to_vec();
    check_finite("effects", &effects, 2).map_err(value_error)?;
    let mut gains = vec![0.0; effects.len() / 2];
    for (some, gains) in effects.chunks(2000).zip(gains.chunks_mut(1000)) {
        py.detach(|| union.extend(some, gains)).map_err(value_error)?;
        py.check_signals()?;
    }
    Ok(gains)
}

fn pair(effect: &Bound<'_, PyAny>) -> PyResult<[f64; 2]> {
    let effect = Floats::point("effect", effect, Some(2))?;
    let effect = effect.slice()?;
    Ok([effect[0], effect[1]])
}
