//! Arrays and numbers from Python, checked in one place; arrays for Python.
//!
//! A C-contiguous float64 array is borrowed; anything else that NumPy can read as real
//! numbers is converted. Booleans, strings, complex numbers and objects are refused.

use numpy::ndarray::Dimension;
use numpy::{
    PyArray, PyArray1, PyArray2, PyArrayDyn, PyArrayMethods, PyReadonlyArrayDyn, PyUntypedArray,
    PyUntypedArrayMethods,
};
use pyo3::exceptions::{PyException, PyOverflowError, PyTypeError, PyValueError};
use pyo3::intern;
use pyo3::prelude::*;
use pyo3::sync::PyOnceLock;
use pyo3::types::{PyBool, PyFloat, PyInt, PyList, PyTuple, PyType};

/// Any object.
pub(crate) type Any<'py> = Bound<'py, PyAny>;

/// A row of numbers.
pub(crate) type Array1<'py> = Bound<'py, PyArray1<f64>>;

/// Rows of numbers.
pub(crate) type Array2<'py> = Bound<'py, PyArray2<f64>>;

/// Loads NumPy's C interface, with what Python code that takes.
///
/// It would be loaded at the first use of an array, and a Ctrl-C just then would be a panic.
pub(crate) fn prepare(py: Python<'_>) -> PyResult<()> {
    for module in ["numpy.lib", "numpy.random", "numpy.ma", "numbers"] {
        py.import(module)?;
    }
    PyArray1::<f64>::zeros(py, 0, false).try_readwrite()?;
    Ok(())
}

/// A borrowed, C-contiguous array of float64.
pub(crate) struct Floats<'py>(PyReadonlyArrayDyn<'py, f64>);

impl<'py> Floats<'py> {
    /// Reads `value`, of any shape.
    fn read(name: &str, value: &Any<'py>) -> PyResult<Self> {
        if value.is_exact_instance_of::<PyUntypedArray>()
            && let Ok(array) = value.cast::<PyArrayDyn<f64>>()
            && array.is_c_contiguous()
        {
            let floats = borrow(name, array)?;
            // An array may also be misaligned: then there is no slice, and a copy is made below.
            if floats.0.as_slice().is_ok() {
                return Ok(floats);
            }
        }
        if let Some(floats) = plain_floats(value) {
            return borrow(name, PyArray1::from_vec(value.py(), floats).to_dyn());
        }
        let refused = |detail: String| {
            PyTypeError::new_err(format!("{name} must be an array of real numbers, got {detail}"))
        };
        let py = value.py();
        static MASKED: PyOnceLock<Py<PyType>> = PyOnceLock::new();
        if value.is_instance(MASKED.import(py, "numpy.ma", "MaskedArray")?)? {
            return Err(refused("a masked array".to_owned()));
        }
        let numpy = py.import(intern!(py, "numpy"))?;
        let array = numpy.call_method1(intern!(py, "asarray"), (value,)).map_err(|error| {
            // An exception such as KeyboardInterrupt is not about the value.
            let of_value = error.is_instance_of::<PyException>(py);
            if of_value { refused(kind(value)) } else { error }
        })?;
        let dtype = array.getattr(intern!(py, "dtype"))?;
        let dtype_kind: String = dtype.getattr(intern!(py, "kind"))?.extract()?;
        if !matches!(dtype_kind.as_str(), "f" | "i" | "u") {
            return Err(refused(format!("{} of dtype {dtype}", kind(value))));
        }
        // C-contiguous, aligned, and a plain array rather than a subclass of it.
        let plain = numpy.call_method1(intern!(py, "require"), (array, "float64", "CAE"))?;
        borrow(name, plain.cast::<PyArrayDyn<f64>>().map_err(|_| refused(kind(value)))?)
    }

    /// Reads `value` if its shape fits, or says which it must have.
    fn shaped(
        name: &str,
        value: &Any<'py>,
        fits: impl Fn(&[usize]) -> bool,
        must_be: impl Fn() -> String,
    ) -> PyResult<Self> {
        let floats = Self::read(name, value)?;
        let got = match floats.0.shape() {
            shape if fits(shape) => return Ok(floats),
            [] => "a single number (put it in a list)".to_owned(),
            shape => PyTuple::new(value.py(), shape)?.to_string(),
        };
        Err(PyValueError::new_err(format!("{name} must have shape {}, got {got}", must_be())))
    }

    /// Reads one point: shape (`length`,), or of any length if `length` is None.
    pub fn point(name: &str, value: &Any<'py>, length: Option<usize>) -> PyResult<Self> {
        let fits = |shape: &[usize]| shape.len() == 1 && is_of(shape[0], length);
        Self::shaped(name, value, fits, || format!("({},)", width_of(length, "dimension")))
    }

    /// Copies one finite point that is not empty: see [`as_point`].
    pub fn finite_point(name: &str, value: &Any<'py>, length: Option<usize>) -> PyResult<Vec<f64>> {
        let values = match plain_floats(value) {
            Some(values) if is_of(values.len(), length) => values,
            _ => Self::point(name, value, length)?.copied()?,
        };
        if values.is_empty() {
            return Err(PyValueError::new_err(format!("{name} must not be empty")));
        }
        if let Some(index) = values.iter().position(|x| !x.is_finite()) {
            let got = values[index];
            return Err(PyValueError::new_err(format!(
                "{name}[{index}] must be finite, got {got:?}"
            )));
        }
        Ok(values)
    }

    /// Reads many points: shape (n, `length`).
    pub fn points(name: &str, value: &Any<'py>, length: usize) -> PyResult<Self> {
        let fits = |shape: &[usize]| shape.len() == 2 && shape[1] == length;
        Self::shaped(name, value, fits, || format!("(n, {length})"))
    }

    /// Copies many points of one dimension, `length` or any: shape (n, s), and s.
    pub fn any_points(
        name: &str,
        value: &Any<'py>,
        length: Option<usize>,
    ) -> PyResult<(Vec<f64>, usize)> {
        let fits = |shape: &[usize]| shape.len() == 2 && shape[1] > 0 && is_of(shape[1], length);
        let floats = Self::shaped(name, value, fits, || format!("(n, {})", width_of(length, "s")))?;
        Ok((floats.copied()?, floats.0.shape()[1]))
    }

    /// Reads one point or many: shape (`length`,) or (n, `length`).
    pub fn either(name: &str, value: &Any<'py>, length: usize) -> PyResult<Self> {
        let fits = |shape: &[usize]| matches!(shape, [got] | [_, got] if *got == length);
        Self::shaped(name, value, fits, || format!("({length},) or (n, {length})"))
    }

    /// Whether these are many points rather than one.
    pub fn is_batch(&self) -> bool {
        self.0.shape().len() == 2
    }

    /// A copy of all numbers, row by row, for what is checked first and used later: another thread
    /// may write to the array in between.
    pub fn copied(&self) -> PyResult<Vec<f64>> {
        Ok(self.slice()?.to_vec())
    }

    /// All numbers, row by row.
    pub fn slice(&self) -> PyResult<&[f64]> {
        Ok(self.0.as_slice()?)
    }
}

/// Whether a length is the one asked for, if there is one.
fn is_of(got: usize, length: Option<usize>) -> bool {
    length.is_none_or(|length| length == got)
}

/// A length in a message, by this name if it can be any.
fn width_of(length: Option<usize>, any: &str) -> String {
    length.map_or(any.to_owned(), |length| length.to_string())
}

/// The numbers of a list or a tuple of floats, without the detour through NumPy.
fn plain_floats(value: &Any<'_>) -> Option<Vec<f64>> {
    let float = |item: Any<'_>| item.cast::<PyFloat>().map(|float| float.value()).ok();
    if let Ok(list) = value.cast_exact::<PyList>() {
        list.iter().map(float).collect()
    } else if let Ok(tuple) = value.cast_exact::<PyTuple>() {
        tuple.iter().map(float).collect()
    } else {
        None
    }
}

fn borrow<'py>(name: &str, array: &Bound<'py, PyArrayDyn<f64>>) -> PyResult<Floats<'py>> {
    let in_use = |error| PyValueError::new_err(format!("{name} is in use elsewhere: {error}"));
    array.try_readonly().map(Floats).map_err(in_use)
}

/// The name of a value's type, for a message.
pub(crate) fn kind(value: &Any<'_>) -> String {
    let class = value.get_type().name();
    let name = class.as_ref().ok().and_then(|name| name.to_str().ok());
    name.unwrap_or("an object").to_owned()
}

/// That a value is not of the type that it must be.
pub(crate) fn wrong_type(name: &str, must_be: &str, value: &Any<'_>) -> PyErr {
    PyTypeError::new_err(format!("{name} must be {must_be}, got {}", kind(value)))
}

/// Reads a real number: what Python or NumPy registers as one, except booleans.
pub(crate) fn number(name: &str, value: &Any<'_>) -> PyResult<f64> {
    static REAL: PyOnceLock<Py<PyType>> = PyOnceLock::new();
    let py = value.py();
    let is_real = value.is_instance_of::<PyFloat>()
        || (value.is_instance(REAL.import(py, "numbers", "Real")?)?
            && !value.is_instance_of::<PyBool>());
    if !is_real {
        return Err(wrong_type(name, "a number", value));
    }
    value.extract::<f64>().map_err(|error| match error.is_instance_of::<PyOverflowError>(py) {
        true => PyValueError::new_err(format!("{name} must be a finite number, got one too large")),
        false => error,
    })
}

/// Reads a flag: True or False and nothing else that is true or false.
pub(crate) fn flag(name: &str, value: &Any<'_>) -> PyResult<bool> {
    let flag = value.cast::<PyBool>();
    Ok(flag.map_err(|_| wrong_type(name, "True or False", value))?.is_true())
}

/// Reads a count: what Python or NumPy registers as a whole number, except booleans, from 0 on.
pub(crate) fn count(name: &str, value: &Any<'_>) -> PyResult<usize> {
    static INTEGRAL: PyOnceLock<Py<PyType>> = PyOnceLock::new();
    let is_whole = !value.is_instance_of::<PyBool>()
        && (value.is_instance_of::<PyInt>()
            || value.is_instance(INTEGRAL.import(value.py(), "numbers", "Integral")?)?);
    if !is_whole {
        return Err(wrong_type(name, "a whole number", value));
    }
    let must_be = "at least 0 and fit a machine word";
    let refused = |_| PyValueError::new_err(format!("{name} must be {must_be}, got {value}"));
    value.extract().map_err(refused)
}

/// A new array that cannot be written to.
pub(crate) fn read_only<'py>(py: Python<'py>, values: &[f64]) -> PyResult<Array1<'py>> {
    locked(PyArray1::from_slice(py, values))
}

/// The same array, which cannot be written to any more.
pub(crate) fn locked<D: Dimension>(
    array: Bound<'_, PyArray<f64, D>>,
) -> PyResult<Bound<'_, PyArray<f64, D>>> {
    array.try_readwrite()?.make_nonwriteable();
    Ok(array)
}

/// A new array of rows of this length, which takes over the numbers given.
pub(crate) fn rows(py: Python<'_>, values: Vec<f64>, row: usize) -> PyResult<Array2<'_>> {
    let n = values.len().checked_div(row).unwrap_or(0);
    PyArray1::from_vec(py, values).reshape([n, row])
}

/// A new array of these rows.
pub(crate) fn rows_of<const ROW: usize>(
    py: Python<'_>,
    values: impl IntoIterator<Item = [f64; ROW]>,
) -> PyResult<Array2<'_>> {
    rows(py, values.into_iter().flatten().collect(), ROW)
}

/// A read-only copy of `value` as a finite point in R^length (any length if None).
///
/// Parameters
/// ----------
/// name : str
///     What an error calls it.
/// value : array_like, shape (length,)
/// length : int, optional
///
/// Returns
/// -------
/// numpy.ndarray of float64, shape (length,)
///
/// Raises
/// ------
/// TypeError
///     If it does not hold real numbers.
/// ValueError
///     If it has another shape, is empty, or is not finite.
///
/// Examples
/// --------
/// >>> from divbandit._core import as_point
/// >>> as_point("effect", [1, 2], 2)
/// array([1., 2.])
#[pyfunction]
#[pyo3(signature = (name, value, length=None))]
pub(crate) fn as_point<'py>(
    name: &str,
    value: &Any<'py>,
    length: Option<usize>,
) -> PyResult<Array1<'py>> {
    read_only(value.py(), &Floats::finite_point(name, value, length)?)
}
