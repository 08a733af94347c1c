//! Binding of obstacles, and of the arm that stops at them or pushes a ball.

use divbandit_core::{Error, Obstacle, ObstructedArm, PlanarArm};
use numpy::PyArray1;
use pyo3::prelude::*;

use crate::arm::PyPlanarArm;
use crate::arrays::{Any, Array1, Array2, Floats, flag, number, rows_of};
use crate::errors::Result;

/// What a link cannot pass; one of the static methods makes it.
#[pyclass(module = "divbandit._core", name = "Obstacle", frozen)]
pub(crate) struct PyObstacle(pub Obstacle);

#[pymethods]
impl PyObstacle {
    /// A disc.
    #[staticmethod]
    fn disc(center: &Any<'_>, radius: &Any<'_>) -> Result<Self> {
        Ok(Self(Obstacle::disc(pair("center", center)?, number("radius", radius)?)?))
    }

    /// A rectangle along the axes.
    #[staticmethod]
    fn rectangle(low: &Any<'_>, high: &Any<'_>) -> Result<Self> {
        Ok(Self(Obstacle::rectangle(pair("low", low)?, pair("high", high)?)?))
    }

    /// A polygon, by its corners.
    #[staticmethod]
    fn polygon(points: &Any<'_>) -> Result<Self> {
        let points = Floats::points("points", points, 2)?.copied()?;
        Ok(Self(Obstacle::polygon(points.as_chunks().0)?))
    }

    /// A wall with rounded ends.
    #[staticmethod]
    fn wall(start: &Any<'_>, end: &Any<'_>, thickness: &Any<'_>) -> Result<Self> {
        let (start, end) = (pair("start", start)?, pair("end", end)?);
        Ok(Self(Obstacle::wall(start, end, number("thickness", thickness)?)?))
    }
}

/// Reads a point of the plane.
fn pair(name: &'static str, value: &Any<'_>) -> PyResult<[f64; 2]> {
    let point = Floats::point(name, value, Some(2))?;
    let numbers = point.slice()?;
    Ok([numbers[0], numbers[1]])
}

/// A planar arm with thick links among obstacles.
///
/// Parameters
/// ----------
/// arm : PlanarArm
///     As it is without obstacles.
/// thickness : float
/// obstacles : list of Obstacle
/// self_contact : bool
#[pyclass(module = "divbandit._core", name = "ObstructedArm", frozen)]
pub(crate) struct PyObstructedArm(pub ObstructedArm);

#[pymethods]
impl PyObstructedArm {
    #[new]
    fn new(
        arm: &Bound<'_, PyPlanarArm>,
        thickness: &Any<'_>,
        obstacles: Vec<PyRef<'_, PyObstacle>>,
        self_contact: &Any<'_>,
    ) -> Result<Self> {
        let thickness = number("thickness", thickness)?;
        let self_contact = flag("self_contact", self_contact)?;
        let obstacles = obstacles.iter().map(|each| each.0.clone()).collect();
        let arm = arm.get().0.clone();
        Ok(Self(ObstructedArm::new(arm, thickness, obstacles, self_contact)?))
    }

    /// The same arm with a ball in its way; its effects are the ball's.
    ///
    /// Parameters
    /// ----------
    /// ball : array_like, shape (2,)
    ///     The ball's center.
    /// ball_radius : float
    fn pushing(&self, ball: &Any<'_>, ball_radius: &Any<'_>) -> Result<Self> {
        let (ball, radius) = (pair("ball", ball)?, number("ball_radius", ball_radius)?);
        Ok(Self(self.0.clone().pushing(ball, radius)?))
    }

    /// Where the tip stops, or the ball: (joints,) -> (2,), or (n, joints) -> (n, 2).
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

    /// Where the tip stops, or the ball, on a trajectory of rows of angles: (k, joints) -> (2,).
    fn follow<'py>(&self, trajectory: &Any<'py>) -> Result<Array1<'py>> {
        let (py, joints) = (trajectory.py(), self.0.free().joints());
        let angles = Floats::points("trajectory", trajectory, joints)?.copied()?;
        let effect = py.detach(|| self.0.moving().follow(&angles))?;
        Ok(PyArray1::from_slice(py, &effect))
    }
}

/// What becomes of each command; all are checked before the first move.
fn each<'py, const WIDTH: usize>(
    arm: &PlanarArm,
    command: &Any<'py>,
    mut becomes: impl FnMut(&[f64]) -> Result<[f64; WIDTH], Error> + Send,
) -> Result<Any<'py>> {
    let (py, joints) = (command.py(), arm.joints());
    let commands = Floats::either("command", command, joints)?;
    let angles = commands.copied()?;
    if !commands.is_batch() {
        return Ok(PyArray1::from_slice(py, &becomes(&angles)?).into_any());
    }
    let outcomes = py.detach(|| {
        arm.check("command", &angles)?;
        angles.chunks_exact(joints).map(becomes).collect::<Result<Vec<_>, _>>()
    })?;
    Ok(rows_of(py, outcomes)?.into_any())
}
