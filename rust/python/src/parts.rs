//! Parts: the library's immutable values, read field by field from the Python objects.

use divbandit_core::measures::PerCoordinate;
use divbandit_core::{Bounds, Shape};
use pyo3::exceptions::PyTypeError;
use pyo3::prelude::*;
use pyo3::types::PyType;

use crate::arrays::{Any, kind};
use crate::bounds::PyBounds;

/// The package whose classes are the library's own.
const PACKAGE: &str = "divbandit.";

/// The name of the class of a part of the library; None for a part that a user defined, also where
/// its class derives from one of the library's.
pub(crate) fn class_of(part: &Any<'_>) -> PyResult<Option<String>> {
    name_of(&part.get_type())
}

/// The name of the class of the library that a part is of, or that its class derives from.
pub(crate) fn library_class_of(part: &Any<'_>) -> PyResult<Option<String>> {
    for class in part.get_type().mro() {
        if let Some(name) = name_of(&class.cast_into()?)? {
            return Ok(Some(name));
        }
    }
    Ok(None)
}

/// The name of a class, if the package defines it.
fn name_of(class: &Bound<'_, PyType>) -> PyResult<Option<String>> {
    let is_ours = class.module()?.to_str()?.starts_with(PACKAGE);
    // Formatting an object would swallow a Ctrl-C.
    if is_ours { Ok(Some(class.name()?.to_str()?.to_owned())) } else { Ok(None) }
}

/// What was read of a value, which must be `what` of the library.
pub(crate) fn ours<T>(read: Option<T>, what: &str, value: &Any<'_>) -> PyResult<T> {
    let must_be = |got| format!("value must be {what} of the library, got {got}");
    read.ok_or_else(|| PyTypeError::new_err(must_be(kind(value))))
}

/// What is made of the fields of a part: `made_of!(part, Kind::Name { field, ... })` for a struct
/// that has fields of the same names, `made_of!(part, Name::new(field, ...))` for a function.
macro_rules! made_of {
    ($part:expr, $($made:ident)::+ { $($name:ident),* }) => {
        $($made)::+ { $($name: $crate::parts::field($part, stringify!($name))?),* }
    };
    ($part:expr, $($made:ident)::+ ($($name:ident),*)) => {
        $($made)::+($($crate::parts::field($part, stringify!($name))?),*)
    };
}
pub(crate) use made_of;

/// The field `name` of a part.
pub(crate) fn field<T: Field>(part: &Any<'_>, name: &str) -> PyResult<T> {
    T::read(&part.getattr(name)?)
}

/// What a field can hold.
pub(crate) trait Field: Sized {
    fn read(value: &Any<'_>) -> PyResult<Self>;
}

macro_rules! plain_fields {
    ($($plain:ty),*) => {$(
        impl Field for $plain {
            fn read(value: &Any<'_>) -> PyResult<Self> {
                value.extract()
            }
        }
    )*};
}
plain_fields!(bool, usize, f64, Vec<f64>);

/// A number, or a tuple of one for each coordinate.
impl Field for PerCoordinate {
    fn read(value: &Any<'_>) -> PyResult<Self> {
        value.extract().map(Self::All).or_else(|_| value.extract().map(Self::Each))
    }
}

/// A number of cells, or one for each coordinate.
impl Field for Shape {
    fn read(value: &Any<'_>) -> PyResult<Self> {
        value.extract().map(Self::Alike).or_else(|_| value.extract().map(Self::Each))
    }
}

/// A `Box`, or None.
impl Field for Option<Bounds> {
    fn read(value: &Any<'_>) -> PyResult<Self> {
        if value.is_none() {
            return Ok(None);
        }
        Ok(Some(value.getattr("bounds")?.cast::<PyBounds>()?.get().0.clone()))
    }
}
