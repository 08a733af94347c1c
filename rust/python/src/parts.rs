//! Parts: the library's immutable values, read field by field from the Python objects.

use pyo3::prelude::*;
use pyo3::types::PyType;

/// The package whose classes are the library's own.
const PACKAGE: &str = "divbandit.";

/// The name of the class of a part of the library; None for a part that a user defined, also where
/// its class derives from one of the library's.
pub(crate) fn class_of(part: &Bound<'_, PyAny>) -> PyResult<Option<String>> {
    let class = part.get_type();
    Ok(if is_ours(&class)? { Some(class.name()?.to_string()) } else { None })
}

/// The name of the class of the library that a part is of, or that its class derives from.
pub(crate) fn library_class_of(part: &Bound<'_, PyAny>) -> PyResult<Option<String>> {
    for class in part.get_type().mro() {
        let class = class.cast_into::<PyType>()?;
        if is_ours(&class)? {
            return Ok(Some(class.name()?.to_string()));
        }
    }
    Ok(None)
}

/// Whether a class is defined in the package.
fn is_ours(class: &Bound<'_, PyType>) -> PyResult<bool> {
    Ok(class.module()?.to_str()?.starts_with(PACKAGE))
}

/// The field `name` of a part.
pub(crate) fn field<'py, T>(part: &Bound<'py, PyAny>, name: &str) -> PyResult<T>
where
    T: for<'a> FromPyObject<'a, 'py, Error = PyErr>,
{
    part.getattr(name)?.extract()
}
