//! Binding of obstacles and of the arm that stops at them.

use divbandit_core::error::check_length;
use divbandit_core::{Error, Obstacle, ObstructedArm, PlanarArm};
use numpy::{IntoPyArray, PyArray2, PyArrayMethods};
use pyo3::prelude::*;

use crate::arm::PyPlanarArm;
use crate::arrays::{Floats, flag, number};
use crate::errors::value_error;

/// What a link cannot pass; one of the static methods makes it.
#[pyclass(module = "divbandit._core", name = "Obstacle", frozen)]
pub(crate) struct PyObstacle(pub Obstacle);

#[pymethods]
impl PyObstacle {
    /// A disc.
    #[staticmethod]
    fn disc(center: &Bound<'_, PyAny>, radius: &Bound<'_, PyAny>) -> PyResult<Self> {
        let center = pair("center", center)?;
        Obstacle::disc(center, number("radius", radius)?).map(Self).map_err(value_error)
    }

    /// A rectangle along the axes.
    #[staticmethod]
    fn rectangle(low: &Bound<'_, PyAny>, high: &Bound<'_, PyAny>) -> PyResult<Self> {
        let (low, high) = (pair("low", low)?, pair("high", high)?);
        Obstacle::rectangle(low, high).map(Self).map_err(value_error)
    }

    /// A polygon, by its corners.
    #[staticmethod]
    fn polygon(points: &Bound<'_, PyAny>) -> PyResult<Self> {
        let points = Floats::points("points", points, 2)?.copied()?;
        let corners: Vec<[f64; 2]> = points.as_chunks().0.to_vec();
        Obstacle::polygon(&corners).map(Self).map_err(value_error)
    }

    /// A wall with rounded ends.
    #[staticmethod]
    fn wall(
        start: &Bound<'_, PyAny>,
        end: &Bound<'_, PyAny>,
        thickness: &Bound<'_, PyAny>,
    ) -> PyResult<Self> {
        let (start, end) = (pair("start", start)?, pair("end", end)?);
        Obstacle::wall(start, end, number("thickness", thickness)?).map(Self).map_err(value_error)
    }
}

pub(crate) fn pair(name: &'static str, value: &Bound<'_, PyAny>) -> PyResult<[f64; 2]> {
    let numbers = Floats::point(name, value, Some(2))?.copied()?;
    check_length(name, &numbers, 2).map_err(value_error)?;
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
        thickness: &Bound<'_, PyAny>,
        obstacles: Vec<PyRef<'_, PyObstacle>>,
        self_contact: &Bound<'_, PyAny>,
    ) -> PyResult<Self> {
        let thickness = number("thickness", thickness)?;
        let self_contact = flag("self_contact", self_contact)?;
        let obstacles = obstacles.iter().map(|each| each.0.clone()).collect();
        ObstructedArm::new(arm.get().0.clone(), thickness, obstacles, self_contact)
            .map(Self)
            .map_err(value_error)
    }

    /// Where the tip stops: (joints,) -> (2,), or (n, joints) -> (n, 2).
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

    /// Where the tip stops on a trajectory of rows of angles: (k, joints) -> (2,).
    fn follow<'py>(
        &self,
        py: Python<'py>,
        trajectory: &Bound<'py, PyAny>,
    ) -> PyResult<Bound<'py, PyAny>> {
        let joints = self.0.free().joints();
        let angles = Floats::points("trajectory", trajectory, joints)?.copied()?;
        let tip = py.detach(|| self.0.moving().follow(&angles)).map_err(value_error)?;
        Ok(tip.to_vec().into_pyarray(py).into_any())
    }
}

/// What becomes of each command; all are checked before the first move.
pub(crate) fn each<'py, const WIDTH: usize>(
    py: Python<'py>,
    arm: &PlanarArm,
    command: &Bound<'py, PyAny>,
    mut becomes: impl FnMut(&[f64]) -> Result<[f64; WIDTH], Error> + Send,
) -> PyResult<Bound<'py, PyAny>> {
    let joints = arm.joints();
    let commands = Floats::either("command", command, joints)?;
    let angles = commands.copied()?;
    if !commands.is_batch() {
        let outcome = becomes(&angles).map_err(value_error)?;
        return Ok(outcome.to_vec().into_pyarray(py).into_any());
    }
    let rows = py.detach(|| {
        arm.check("command", &angles)?;
        let mut rows = Vec::with_capacity(angles.len() / joints * WIDTH);
        for command in angles.chunks_exact(joints) {
            rows.extend(becomes(command)?);
        }
        Ok(rows)
    });
    let rows = rows.map_err(value_error)?.into_pyarray(py);
    Ok(rows.reshape([angles.len() / joints, WIDTH])?.into_any())
}
