//! Binding of the inverse model.

use numpy::PyArray1;
use pyo3::exceptions::PyValueError;
use pyo3::prelude::*;

use crate::arrays::{Floats, number, read_only};
use crate::bounds::PyBounds;
use crate::errors::value_error;
use crate::kdtree::PyNearestNeighbors;
use crate::random::NumpyStream;

/// Inverse_d(goal): the command of the observed effect nearest to `goal`, perturbed.
///
/// `commands` holds at least as many rows as `effects` has points, in the same order.
///
/// Examples
/// --------
/// >>> import numpy as np
/// >>> from divbandit._core import Bounds, NearestNeighbors, inverse
/// >>> effects = NearestNeighbors(1)
/// >>> effects.extend([[0.0], [8.0]])
/// >>> commands = np.array([[-1.0, 0.0], [1.0, 0.5]])
/// >>> motor_space = Bounds([-1, -1], [1, 1])
/// >>> inverse([7.0], 0.0, effects, commands, motor_space, np.random.default_rng(0))
/// array([1. , 0.5])
#[pyfunction]
pub(crate) fn inverse<'py>(
    goal: &Bound<'py, PyAny>,
    d: &Bound<'py, PyAny>,
    effects: PyRef<'py, PyNearestNeighbors>,
    commands: &Bound<'py, PyAny>,
    motor_space: &Bound<'py, PyBounds>,
    rng: &Bound<'py, PyAny>,
) -> PyResult<Bound<'py, PyArray1<f64>>> {
    let motor_space = &motor_space.get().0;
    let goal = Floats::point("goal", goal, Some(effects.0.dim()))?;
    let d = number("d", d)?;
    let commands = Floats::points("commands", commands, motor_space.dim())?;
    let used = effects.0.len() * motor_space.dim();
    let Some(commands) = commands.slice()?.get(..used) else {
        return Err(PyValueError::new_err("commands must have a row for each effect"));
    };
    let mut stream = NumpyStream::lock(rng)?;
    let command =
        divbandit_core::inverse(&goal.copied()?, d, &effects.0, commands, motor_space, &mut stream)
            .map_err(value_error)?;
    read_only(rng.py(), &command)
}
