//! Binding of the arm that pushes a ball.

use divbandit_core::ObstructedArm;
use numpy::PyArray1;
use pyo3::prelude::*;

use crate::arrays::{Any, Array1, Array2, Floats, number, rows_of};
use crate::errors::Result;
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
        ball: &Any<'_>,
        ball_radius: &Any<'_>,
    ) -> Result<Self> {
        let (ball, radius) = (pair("ball", ball)?, number("ball_radius", ball_radius)?);
        Ok(Self(arm.get().0.clone().pushing(ball, radius)?))
    }

    /// Where the ball ends: (joints,) -> (2,), or (n, joints) -> (n, 2).
    fn effect<'py>(&self, command: &Any<'py>) -> Result<Any<'py>> {
        let mut moving = self.0.moving();
        each(self.0.free(), command, |command| moving.effect(command))
    }

    /// The share of the way that can be gone: (joints,) -> (1,), or (n, joints) -> (n, 1).
    fn progress<'py>(&self, command: &Any<'py>) -> Result<Any<'py>> {
        let mut moving = self.0.moving();
        each(self.0.free(), command, |command| Ok([moving.progress(command)?]))
    }

    /// The positions of the base, of each joint's far end and, last, of the tip, where the arm stops.
    fn posture<'py>(&self, command: &Any<'py>) -> Result<Array2<'py>> {
        let angles = Floats::point("command", command, Some(self.0.free().joints()))?.copied()?;
        Ok(rows_of(command.py(), self.0.moving().posture(&angles)?)?)
    }

    /// The share of the way and the ball's place, whenever it was looked at: (k, 3).
    fn path<'py>(&self, command: &Any<'py>) -> Result<Array2<'py>> {
        let angles = Floats::point("command", command, Some(self.0.free().joints()))?.copied()?;
        let path = command.py().detach(|| self.0.moving().path(&angles))?;
        Ok(rows_of(command.py(), path)?)
    }

    /// Where the ball ends on a trajectory of rows of angles: (k, joints) -> (2,).
    fn follow<'py>(&self, trajectory: &Any<'py>) -> Result<Array1<'py>> {
        let (py, joints) = (trajectory.py(), self.0.free().joints());
        let angles = Floats::points("trajectory", trajectory, joints)?.copied()?;
        let ball = py.detach(|| self.0.moving().follow(&angles))?;
        Ok(PyArray1::from_slice(py, &ball))
    }
}
