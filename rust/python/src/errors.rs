//! From a kernel's error to the Python exception that says the same.

use divbandit_core::Error;
use numpy::{AsSliceError, BorrowError};
use pyo3::exceptions::PyValueError;
use pyo3::pycell::{PyBorrowError, PyBorrowMutError};
use pyo3::{CastError, PyErr};

/// What a binding returns: `?` makes exceptions of the kernels' errors.
pub(crate) type Result<T, E = Raised> = std::result::Result<T, E>;

/// A Python exception.
pub(crate) struct Raised(PyErr);

impl From<Raised> for PyErr {
    fn from(raised: Raised) -> Self {
        raised.0
    }
}

/// Every kernel error is about a value: the message names the argument, what it must be and
/// what it was.
impl From<Error> for Raised {
    fn from(error: Error) -> Self {
        Self(PyValueError::new_err(error.to_string()))
    }
}

macro_rules! raised_as_they_are {
    ($($error:ty),*) => {$(
        impl From<$error> for Raised {
            fn from(error: $error) -> Self {
                Self(error.into())
            }
        }
    )*};
}
raised_as_they_are!(
    PyErr,
    CastError<'_, '_>,
    PyBorrowError,
    PyBorrowMutError,
    AsSliceError,
    BorrowError
);
