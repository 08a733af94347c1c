//! From a kernel's error to the Python exception that says the same.

use divbandit_core::Error;
use pyo3::PyErr;
use pyo3::exceptions::PyValueError;

/// Every kernel error is about a value: the message names the argument, what it must be and
/// what it was.
pub(crate) fn value_error(error: Error) -> PyErr {
    PyValueError::new_err(error.to_string())
}
