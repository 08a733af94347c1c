//! Binding of the arm that pushes a ball.

use divbandit_core::ObstructedArm;
use numpy::{IntoPyArray, PyArray2, PyArrayMethods};
use pyo3::prelude::*;

use crate::arrays::{Floats, number};
use crate::errors::value_error;
use crate::obstructed_arm::{PyObstructedArm, each, pair};

/// A planar arm and a ball in its way.
///
/// Parameters
/// ----------
/// arm : ObstructedArm
/// ball : array_like, shape (2,)
///     The ball's center.
/// ball_radius : float
#[pyclass(module = "divbandit._core", name = "PushArm", frozen)]
pub(crate) struct PyPushArm(pub ObstructedArm);

#[pymethods]
impl PyPushArm {
    #[new]
    fn new(
        arm: &Bound<'_, PyObstructedArm>,
        ball: &Bound<'_, PyAny>,
        ball_radius: &Bound<'_, PyAny>,
    ) -> PyResult<Self> {
        let (ball, radius) = (pair("ball", ball)?, number("ball_radius", ball_radius)?);
        arm.get().0.clone().pushing(ball, radius).map(Self).map_err(value_error)
    }

    /// Where the ball ends: (joints,) -> (2,), or (n, joints) -> (n, 2).
    fn effect<'py>(
        &self,
        py: Python<'py>,
        command: &Bound<'py, PyAny>,
    ) -> PyResult<Bound<'py, PyAny>> {
        let mut moving = self.0.moving();
        each(py, self.0.free(), command, |command| moving.effect(command))
    }

    /// The share of the way that can be gone: (joints,) -> (1,), or (n, joints) -> (n, 1).
    fn progress<'py>(
        &self,
        py: Python<'py>,
        command: &Bound<'py, PyAny>,
    ) -> PyResult<Bound<'py, PyAny>> {
        let mut moving = self.0.moving();
        each(py, self.0.free(), command, |command| Ok([moving.progress(command)?]))
    }

    /// The positions of the base, of each joint's far end and, last, of the tip, where the arm stops.
    fn posture<'py>(
        &self,
        py: Python<'py>,
        command: &Bound<'py, PyAny>,
    ) -> PyResult<Bound<'py, PyArray2<f64>>> {
        let command = Floats::point("command", command, Some(self.0.free().joints()))?.copied()?;
        let points = self.0.moving().posture(&command).map_err(value_error)?;
        points.concat().into_pyarray(py).reshape([points.len(), 2])
    }

    /// The share of the way and the ball's place, whenever it was looked at: (k, 3).
    fn path<'py>(
        &self,
        py: Python<'py>,
        command: &Bound<'py, PyAny>,
    ) -> PyResult<Bound<'py, PyArray2<f64>>> {
        let command = Floats::point("command", command, Some(self.0.free().joints()))?.copied()?;
        let path = py.detach(|| self.0.moving().path(&command)).map_err(value_error)?;
        path.concat().into_pyarray(py).reshape([path.len(), 3])
    }

    /// Where the ball ends on a trajectory of rows of angles: (k, joints) -> (2,).
    fn follow<'py>(
        &self,
        py: Python<'py>,
        trajectory: &Bound<'py, PyAny>,
    ) -> PyResult<Bound<'py, PyAny>> {
        let angles = Floats::points("trajectory", trajectory, self.0.free().joints())?.copied()?;
        let ball = py.detach(|| self.0.moving().follow(&angles)).map_err(value_error)?;
        Ok(ball.to_vec().into_pyarray(py).into_any())
    }
}
