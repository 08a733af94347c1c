//! Environments as the engine calls them: the library's arms in Rust, any other black box back in
//! Python.

use divbandit_core::Environment;
use divbandit_core::obstructed_arm::Moving;
use pyo3::prelude::*;
use pyo3::types::{PyFloat, PyInt, PyList, PyTuple};

use crate::arm::PyPlanarArm;
use crate::arrays::{Floats, read_only};
use crate::obstructed_arm::PyObstructedArm;
use crate::parts::class_of;
use crate::push_arm::PyPushArm;

/// The library's own environments that exist in Rust; None for all others.
pub(crate) fn environment_of(part: &Bound<'_, PyAny>) -> PyResult<Option<Box<dyn Environment>>> {
    if !matches!(class_of(part)?.as_deref(), Some("PlanarArm" | "PushArm")) {
        return Ok(None);
    }
    let kernel = part.getattr("_kernel")?;
    Ok(if let Ok(arm) = kernel.cast::<PyPlanarArm>() {
        Some(Box::new(arm.get().0.clone()))
    } else if let Ok(arm) = kernel.cast::<PyObstructedArm>() {
        Some(Box::new(Moving::from(arm.get().0.clone())))
    } else if let Ok(arm) = kernel.cast::<PyPushArm>() {
        Some(Box::new(Moving::from(arm.get().0.clone())))
    } else {
        None
    })
}

/// A black box in Python, to be called for its effect.
pub(crate) struct BlackBox<'py> {
    call: Bound<'py, PyAny>,
    /// Whether it takes the numbers of a command one by one.
    scalars: bool,
    /// Whether it may return a number for an effect of one coordinate.
    numbers: bool,
}

impl<'py> BlackBox<'py> {
    /// Any environment; the function of a `FunctionEnvironment` is called itself.
    pub fn of(environment: &Bound<'py, PyAny>) -> PyResult<Self> {
        if class_of(environment)?.as_deref() == Some("FunctionEnvironment")
            && !environment.getattr("vectorized")?.is_truthy()?
        {
            let scalars = environment.getattr("scalars")?.extract()?;
            return Ok(Self { call: environment.getattr("f")?, scalars, numbers: true });
        }
        Ok(Self { call: environment.clone(), scalars: false, numbers: false })
    }

    /// Calls it with a command, and reads the effect.
    pub fn evaluate(
        &self,
        py: Python<'py>,
        command: &[f64],
        dim: Option<usize>,
        effect: &mut Vec<f64>,
    ) -> PyResult<()> {
        let result = if self.scalars {
            self.call.call1(PyTuple::new(py, command)?)?
        } else {
            self.call.call1((read_only(py, command)?,))?
        };
        if self.numbers && (result.is_exact_instance_of::<PyFloat>() || is_number(&result)?) {
            let number = result.extract::<f64>()?;
            return Self::read(PyList::new(py, [number])?.as_any(), dim, effect);
        }
        Self::read(&result, dim, effect)
    }

    /// Reads an effect as a finite point of `dim` coordinates, or of any number of them.
    pub fn read(
        value: &Bound<'_, PyAny>,
        dim: Option<usize>,
        effect: &mut Vec<f64>,
    ) -> PyResult<()> {
        effect.clear();
        if let Ok(list) = value.cast_exact::<PyList>() {
            for number in list {
                match number.cast_exact::<PyFloat>().map(|number| number.value()) {
                    Ok(number) if number.is_finite() => effect.push(number),
                    _ => break,
                }
            }
            if !effect.is_empty()
                && effect.len() == list.len()
                && dim.is_none_or(|s| s == list.len())
            {
                return Ok(());
            }
            effect.clear();
        }
        effect.extend(Floats::finite_point("effect", value, dim)?);
        Ok(())
    }
}

/// Whether a value is a number, but no boolean: Python's, or a scalar of NumPy.
fn is_number(value: &Bound<'_, PyAny>) -> PyResult<bool> {
    if value.is_exact_instance_of::<PyInt>() {
        return Ok(true);
    }
    static NUMBER: pyo3::sync::PyOnceLock<Py<pyo3::types::PyType>> = pyo3::sync::PyOnceLock::new();
    value.is_instance(NUMBER.import(value.py(), "numpy", "number")?)
}
