//! Environments as the engine calls them: the library's own in Rust, any other black box back in
//! Python.

use divbandit_core::Environment;
use divbandit_core::obstructed_arm::Moving;
use pyo3::prelude::*;
use pyo3::types::{PyFloat, PyInt, PyList, PyTuple};

use crate::arm::PyPlanarArm;
use crate::arrays::{Any, Floats, read_only};
use crate::linear_projection::PyLinearProjection;
use crate::maze::PyMaze;
use crate::obstructed_arm::PyObstructedArm;
use crate::parts::class_of;

/// The library's own environments that exist in Rust; None for all others.
pub(crate) fn environment_of(part: &Any<'_>) -> PyResult<Option<Box<dyn Environment>>> {
    const NATIVE: [&str; 5] = ["PlanarArm", "PushArm", "ArmRepertoire", "LinearProjection", "Maze"];
    if !class_of(part)?.is_some_and(|class| NATIVE.contains(&class.as_str())) {
        return Ok(None);
    }
    let kernel = part.getattr("_kernel")?;
    Ok(if let Ok(arm) = kernel.cast::<PyPlanarArm>() {
        Some(Box::new(arm.get().0.clone()))
    } else if let Ok(arm) = kernel.cast::<PyObstructedArm>() {
        Some(Box::new(Moving::from(arm.get().0.clone())))
    } else if let Ok(projection) = kernel.cast::<PyLinearProjection>() {
        Some(Box::new(projection.get().0))
    } else if let Ok(maze) = kernel.cast::<PyMaze>() {
        Some(Box::new(maze.get().0.clone()))
    } else {
        None
    })
}

/// A black box in Python, to be called for its effect.
pub(crate) struct BlackBox<'py> {
    call: Any<'py>,
    /// Whether it takes the numbers of a command one by one.
    scalars: bool,
    /// Whether it may return a number for an effect of one coordinate.
    numbers: bool,
}

impl<'py> BlackBox<'py> {
    /// Any environment; the function of a `FunctionEnvironment` is called itself.
    pub fn of(environment: &Any<'py>) -> PyResult<Self> {
        if class_of(environment)?.as_deref() == Some("FunctionEnvironment")
            && !environment.getattr("vectorized")?.is_truthy()?
        {
            let scalars = environment.getattr("scalars")?.extract()?;
            return Ok(Self { call: environment.getattr("f")?, scalars, numbers: true });
        }
        Ok(Self { call: environment.clone(), scalars: false, numbers: false })
    }

    /// The effect of a command: a finite point of `dim` coordinates, or of any number of them.
    pub fn effect(
        &self,
        py: Python<'py>,
        command: &[f64],
        dim: Option<usize>,
    ) -> PyResult<Vec<f64>> {
        let result = if self.scalars {
            self.call.call1(PyTuple::new(py, command)?)?
        } else {
            self.call.call1((read_only(py, command)?,))?
        };
        if self.numbers && (result.is_exact_instance_of::<PyFloat>() || is_number(&result)?) {
            let number = PyList::new(py, [result.extract::<f64>()?])?;
            return Floats::finite_point("effect", &number, dim);
        }
        Floats::finite_point("effect", &result, dim)
    }
}

/// Whether a value is a number, but no boolean: Python's, or a scalar of NumPy.
fn is_number(value: &Any<'_>) -> PyResult<bool> {
    if value.is_exact_instance_of::<PyInt>() {
        return Ok(true);
    }
    static NUMBER: pyo3::sync::PyOnceLock<Py<pyo3::types::PyType>> = pyo3::sync::PyOnceLock::new();
    value.is_instance(NUMBER.import(value.py(), "numpy", "number")?)
}
