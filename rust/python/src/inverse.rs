//! Bindings of the inverse models.

use divbandit_core::Bounds;
use divbandit_core::inverse::{self as models, LocalJacobian, Observed};
use numpy::{PyArray1, PyArray2};
use pyo3::exceptions::PyValueError;
use pyo3::prelude::*;

use crate::arrays::{Floats, count, number, read_only, read_only_rows};
use crate::bounds::PyBounds;
use crate::errors::value_error;
use crate::kdtree::PyNearestNeighbors;
use crate::random::NumpyStream;

/// An array of points, row by row.
type Rows<'py> = Bound<'py, PyArray2<f64>>;

/// The commands that produced `effects`: as many rows, of at least as many that there are.
fn observed<'a>(
    effects: &'a PyNearestNeighbors,
    commands: &'a Floats<'_>,
    motor_space: &'a Bounds,
) -> PyResult<Observed<'a>> {
    let used = effects.0.len() * motor_space.dim();
    match commands.slice()?.get(..used) {
        Some(commands) => Ok(Observed { effects: &effects.0, commands, motor_space }),
        None => Err(PyValueError::new_err("commands must have a row for each effect")),
    }
}

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
    let known = observed(&effects, &commands, motor_space)?;
    let mut stream = NumpyStream::lock(rng)?;
    let command = divbandit_core::inverse(
        &goal.copied()?,
        d,
        known.effects,
        known.commands,
        motor_space,
        &mut stream,
    )
    .map_err(value_error)?;
    read_only(rng.py(), &command)
}

/// The weighted mean of the commands of the `k` effects nearest to `goal`, perturbed.
///
/// Examples
/// --------
/// >>> import numpy as np
/// >>> from divbandit._core import Bounds, NearestNeighbors, k_nearest
/// >>> effects = NearestNeighbors(1)
/// >>> effects.extend([[0.0], [8.0]])
/// >>> commands, motor_space = np.array([[-1.0], [1.0]]), Bounds([-1], [1])
/// >>> k_nearest([6.0], 2, 0.0, effects, commands, motor_space, np.random.default_rng(0))
/// array([0.5])
#[pyfunction]
pub(crate) fn k_nearest<'py>(
    goal: &Bound<'py, PyAny>,
    k: &Bound<'py, PyAny>,
    d: &Bound<'py, PyAny>,
    effects: PyRef<'py, PyNearestNeighbors>,
    commands: &Bound<'py, PyAny>,
    motor_space: &Bound<'py, PyBounds>,
    rng: &Bound<'py, PyAny>,
) -> PyResult<Bound<'py, PyArray1<f64>>> {
    let motor_space = &motor_space.get().0;
    let goal = Floats::point("goal", goal, Some(effects.0.dim()))?;
    let (k, d) = (count("k", k)?, number("d", d)?);
    let commands = Floats::points("commands", commands, motor_space.dim())?;
    let known = observed(&effects, &commands, motor_space)?;
    let mut stream = NumpyStream::lock(rng)?;
    let command =
        models::k_nearest(&goal.copied()?, k, d, &known, &mut stream).map_err(value_error)?;
    read_only(rng.py(), &command)
}

/// What a linear map from the `k` effects nearest to `goal` to their commands makes of `goal`,
/// perturbed.
///
/// Examples
/// --------
/// >>> import numpy as np
/// >>> from divbandit._core import Bounds, NearestNeighbors, local_regression
/// >>> effects = NearestNeighbors(1)
/// >>> effects.extend([[0.0], [4.0], [8.0]])
/// >>> commands, motor_space = np.array([[-0.9], [-0.2], [0.5]]), Bounds([-1], [1])
/// >>> rng = np.random.default_rng(0)
/// >>> local_regression([5.0], 3, 1e-9, 2.0, 0.0, effects, commands, motor_space, rng).round(6)
/// array([-0.025])
#[pyfunction]
#[expect(clippy::too_many_arguments, reason = "options by keyword are Python's, not the kernel's")]
pub(crate) fn local_regression<'py>(
    goal: &Bound<'py, PyAny>,
    k: &Bound<'py, PyAny>,
    ridge: &Bound<'py, PyAny>,
    reach: &Bound<'py, PyAny>,
    d: &Bound<'py, PyAny>,
    effects: PyRef<'py, PyNearestNeighbors>,
    commands: &Bound<'py, PyAny>,
    motor_space: &Bound<'py, PyBounds>,
    rng: &Bound<'py, PyAny>,
) -> PyResult<Bound<'py, PyArray1<f64>>> {
    let motor_space = &motor_space.get().0;
    let goal = Floats::point("goal", goal, Some(effects.0.dim()))?;
    let (k, d) = (count("k", k)?, number("d", d)?);
    let (ridge, reach) = (number("ridge", ridge)?, number("reach", reach)?);
    let commands = Floats::points("commands", commands, motor_space.dim())?;
    let known = observed(&effects, &commands, motor_space)?;
    let mut stream = NumpyStream::lock(rng)?;
    let command =
        models::local_regression(&goal.copied()?, k, ridge, reach, d, &known, &mut stream)
            .map_err(value_error)?;
    read_only(rng.py(), &command)
}

/// The command of the effect nearest to `goal`, moved towards it by a step in a linear model of the
/// commands around it, and perturbed.
///
/// Examples
/// --------
/// >>> import numpy as np
/// >>> from divbandit._core import Bounds, NearestNeighbors, local_jacobian
/// >>> effects = NearestNeighbors(1)
/// >>> effects.extend([[0.0], [4.0]])
/// >>> commands, motor_space = np.array([[0.0], [0.5]]), Bounds([-1], [1])
/// >>> rng = np.random.default_rng(0)
/// >>> step = (50, 10, 1e-9, 1.0, 0.0)
/// >>> local_jacobian([5.0], *step, effects, commands, motor_space, rng).round(6)
/// array([0.625])
#[pyfunction]
#[expect(clippy::too_many_arguments, reason = "options by keyword are Python's, not the kernel's")]
pub(crate) fn local_jacobian<'py>(
    goal: &Bound<'py, PyAny>,
    k: &Bound<'py, PyAny>,
    used: &Bound<'py, PyAny>,
    ridge: &Bound<'py, PyAny>,
    reach: &Bound<'py, PyAny>,
    noise: &Bound<'py, PyAny>,
    effects: PyRef<'py, PyNearestNeighbors>,
    commands: &Bound<'py, PyAny>,
    motor_space: &Bound<'py, PyBounds>,
    rng: &Bound<'py, PyAny>,
) -> PyResult<Bound<'py, PyArray1<f64>>> {
    let motor_space = &motor_space.get().0;
    let goal = Floats::point("goal", goal, Some(effects.0.dim()))?;
    let (k, used, ridge) = (count("k", k)?, count("used", used)?, number("ridge", ridge)?);
    let (reach, noise) = (number("reach", reach)?, number("noise", noise)?);
    let model = LocalJacobian::new(k, used, ridge, reach, noise).map_err(value_error)?;
    let commands = Floats::points("commands", commands, motor_space.dim())?;
    let known = observed(&effects, &commands, motor_space)?;
    let mut stream = NumpyStream::lock(rng)?;
    let command = model.command(&goal.copied()?, &known, &mut stream).map_err(value_error)?;
    read_only(rng.py(), &command)
}

/// The goals (n, s) and the commands (n, m) of `n` trials of random goal babbling.
///
/// Examples
/// --------
/// >>> import numpy as np
/// >>> from divbandit._core import Bounds, NearestNeighbors, babble
/// >>> effects = NearestNeighbors(1)
/// >>> effects.extend([[0.0], [8.0]])
/// >>> commands, motor_space = np.array([[-1.0], [1.0]]), Bounds([-1], [1])
/// >>> rng = np.random.default_rng(0)
/// >>> babble(3, Bounds([0], [8]), 0.0, effects, commands, motor_space, rng)[1].ravel()
/// array([ 1., -1.,  1.])
#[pyfunction]
pub(crate) fn babble<'py>(
    n: &Bound<'py, PyAny>,
    goals: &Bound<'py, PyBounds>,
    d: &Bound<'py, PyAny>,
    effects: PyRef<'py, PyNearestNeighbors>,
    commands: &Bound<'py, PyAny>,
    motor_space: &Bound<'py, PyBounds>,
    rng: &Bound<'py, PyAny>,
) -> PyResult<(Rows<'py>, Rows<'py>)> {
    let (goals, motor_space) = (&goals.get().0, &motor_space.get().0);
    let (n, d) = (count("n", n)?, number("d", d)?);
    let commands = Floats::points("commands", commands, motor_space.dim())?;
    let known = observed(&effects, &commands, motor_space)?;
    let mut stream = NumpyStream::lock(rng)?;
    let (drawn, commands) =
        models::babble(n, goals, d, &known, &mut stream).map_err(value_error)?;
    let py = rng.py();
    Ok((read_only_rows(py, drawn, goals.dim())?, read_only_rows(py, commands, motor_space.dim())?))
}
