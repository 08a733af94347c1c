//! Arrays and numbers from Python, checked in one place.
//!
//! A C-contiguous float64 array is borrowed; anything else that NumPy can read as real
//! numbers is converted. Booleans, strings, complex numbers and objects are refused.

use numpy::{
    PyArray1, PyArray2, PyArrayDyn, PyArrayMethods, PyReadonlyArrayDyn, PyUntypedArray,
    PyUntypedArrayMethods,
};
use pyo3::exceptions::{PyException, PyOverflowError, PyTypeError, PyValueError};
use pyo3::intern;
use pyo3::prelude::*;
use pyo3::sync::PyOnceLock;
use pyo3::types::{PyBool, PyFloat, PyInt, PyList, PyTuple, PyType};

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
    fn read(name: &str, value: &Bound<'py, PyAny>) -> PyResult<Self> {
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
        match plain.cast::<PyArrayDyn<f64>>() {
            Ok(array) => borrow(name, array),
            Err(_) => Err(refused(kind(value))),
        }
    }

    /// Reads one point: shape (`length`,), or of any length if `length` is None.
    pub fn point(name: &str, value: &Bound<'py, PyAny>, length: Option<usize>) -> PyResult<Self> {
        let floats = Self::read(name, value)?;
        match (floats.0.shape(), length) {
            ([_], None) => Ok(floats),
            ([got], Some(length)) if *got == length => Ok(floats),
            (shape, _) => Err(wrong_shape(name, &point_shape(length), shape)),
        }
    }

    /// Reads one finite point that is not empty, and copies it: see [`as_point`].
    pub fn finite_point(
        name: &str,
        value: &Bound<'py, PyAny>,
        length: Option<usize>,
    ) -> PyResult<Vec<f64>> {
        let values = Self::point(name, value, length)?.copied()?;
        if values.is_empty() {
            return Err(PyValueError::new_err(format!("{name} must not be empty")));
        }
        if let Some(index) = values.iter().position(|x| !x.is_finite()) {
            return Err(PyValueError::new_err(format!(
                "{name}[{index}] must be finite, got {:?}",
                values[index]
            )));
        }
        Ok(values)
    }

    /// Reads many points: shape (n, `length`).
    pub fn points(name: &str, value: &Bound<'py, PyAny>, length: usize) -> PyResult<Self> {
        let floats = Self::read(name, value)?;
        match floats.0.shape() {
            [_, got] if *got == length => Ok(floats),
            shape => Err(wrong_shape(name, &format!("(n, {length})"), shape)),
        }
    }

    /// Copies many points of one dimension, `length` or any: shape (n, s), and s.
    pub fn any_points(
        name: &str,
        value: &Bound<'py, PyAny>,
        length: Option<usize>,
    ) -> PyResult<(Vec<f64>, usize)> {
        let floats = Self::read(name, value)?;
        match floats.0.shape() {
            &[_, got] if got > 0 && length.is_none_or(|length| length == got) => {
                Ok((floats.copied()?, got))
            }
            shape => {
                let width = length.map_or("s".to_owned(), |length| length.to_string());
                Err(wrong_shape(name, &format!("(n, {width})"), shape))
            }
        }
    }

    /// Reads one point or many: shape (`length`,) or (n, `length`).
    pub fn either(name: &str, value: &Bound<'py, PyAny>, length: usize) -> PyResult<Self> {
        let floats = Self::read(name, value)?;
        match floats.0.shape() {
            [got] | [_, got] if *got == length => Ok(floats),
            shape => Err(wrong_shape(name, &format!("({length},) or (n, {length})"), shape)),
        }
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

/// The numbers of a list or a tuple of floats, without the detour through NumPy.
fn plain_floats(value: &Bound<'_, PyAny>) -> Option<Vec<f64>> {
    let float = |item: Bound<'_, PyAny>| item.cast::<PyFloat>().map(|float| float.value()).ok();
    if let Ok(list) = value.cast_exact::<PyList>() {
        list.iter().map(float).collect()
    } else if let Ok(tuple) = value.cast_exact::<PyTuple>() {
        tuple.iter().map(float).collect()
    } else {
        None
    }
}

fn borrow<'py>(name: &str, array: &Bound<'py, PyArrayDyn<f64>>) -> PyResult<Floats<'py>> {
    match array.try_readonly() {
        Ok(array) => Ok(Floats(array)),
        Err(error) => Err(PyValueError::new_err(format!("{name} is in use elsewhere: {error}"))),
    }
}

fn point_shape(length: Option<usize>) -> String {
    match length {
        Some(length) => format!("({length},)"),
        None => "(dimension,)".to_owned(),
    }
}

fn wrong_shape(name: &str, must_be: &str, got: &[usize]) -> PyErr {
    let got = match got {
        [] => "a single number (put it in a list)".to_owned(),
        [one] => format!("({one},)"),
        _ => format!("({})", got.iter().map(usize::to_string).collect::<Vec<_>>().join(", ")),
    };
    PyValueError::new_err(format!("{name} must have shape {must_be}, got {got}"))
}

/// The name of a value's type, for a message.
fn kind(value: &Bound<'_, PyAny>) -> String {
    value.get_type().name().map_or_else(|_| "an object".to_owned(), |name| name.to_string())
}

/// Reads a real number: what Python or NumPy registers as one, except booleans.
pub(crate) fn number(name: &str, value: &Bound<'_, PyAny>) -> PyResult<f64> {
    static REAL: PyOnceLock<Py<PyType>> = PyOnceLock::new();
    let py = value.py();
    let is_real = value.is_instance_of::<PyFloat>()
        || (value.is_instance(REAL.import(py, "numbers", "Real")?)?
            && !value.is_instance_of::<PyBool>());
    if !is_real {
        let got = kind(value);
        return Err(PyTypeError::new_err(format!("{name} must be a number, got {got}")));
    }
    value.extract::<f64>().map_err(|error| {
        if error.is_instance_of::<PyOverflowError>(py) {
            PyValueError::new_err(format!("{name} must be a finite number, got one too large"))
        } else {
            error
        }
    })
}

/// Reads a flag: True or False and nothing else that is true or false.
pub(crate) fn flag(name: &str, value: &Bound<'_, PyAny>) -> PyResult<bool> {
    match value.cast::<PyBool>() {
        Ok(flag) => Ok(flag.is_true()),
        Err(_) => {
            let got = kind(value);
            Err(PyTypeError::new_err(format!("{name} must be True or False, got {got}")))
        }
    }
}

/// Reads a count: what Python or NumPy registers as a whole number, except booleans, from 0 on.
pub(crate) fn count(name: &str, value: &Bound<'_, PyAny>) -> PyResult<usize> {
    static INTEGRAL: PyOnceLock<Py<PyType>> = PyOnceLock::new();
    let py = value.py();
    let is_whole = !value.is_instance_of::<PyBool>()
        && (value.is_instance_of::<PyInt>()
            || value.is_instance(INTEGRAL.import(py, "numbers", "Integral")?)?);
    if !is_whole {
        let got = kind(value);
        return Err(PyTypeError::new_err(format!("{name} must be a whole number, got {got}")));
    }
    value.extract::<usize>().map_err(|_| {
        PyValueError::new_err(format!(
            "{name} must be at least 0 and fit a machine word, got {value}"
        ))
    })
}

/// A new array that cannot be written to.
pub(crate) fn read_only<'py>(
    py: Python<'py>,
    values: &[f64],
) -> PyResult<Bound<'py, PyArray1<f64>>> {
    let array = PyArray1::from_slice(py, values);
    array.try_readwrite()?.make_nonwriteable();
    Ok(array)
}

/// A new array of rows of this length that cannot be written to; it takes over the numbers given.
pub(crate) fn read_only_rows(
    py: Python<'_>,
    values: Vec<f64>,
    row: usize,
) -> PyResult<Bound<'_, PyArray2<f64>>> {
    let n = values.len() / row;
    let array = PyArray1::from_vec(py, values).reshape([n, row])?;
    array.try_readwrite()?.make_nonwriteable();
    Ok(array)
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
    value: &Bound<'py, PyAny>,
    length: Option<usize>,
) -> PyResult<Bound<'py, PyArray1<f64>>> {
    read_only(value.py(), &Floats::finite_point(name, value, length)?)
}
