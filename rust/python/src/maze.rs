//! Binding of the hard maze.

use divbandit_core::{Error, Maze};
use numpy::PyArray1;
use pyo3::prelude::*;

use crate::arrays::{Any, Array2, Floats, rows_of};
use crate::errors::Result;

/// The hard maze of novelty search, and a robot whose network's weights are the command.
#[pyclass(module = "divbandit._core", name = "Maze", frozen)]
pub(crate) struct PyMaze(pub Maze);

#[pymethods]
impl PyMaze {
    #[new]
    fn new() -> Self {
        Self(Maze::new())
    }

    /// The number of weights.
    #[getter]
    fn weights(&self) -> usize {
        Maze::WEIGHTS
    }

    /// The weights' limit, up or down.
    #[getter]
    fn limit(&self) -> f64 {
        Maze::LIMIT
    }

    /// Where the goal is: x and y.
    #[getter]
    fn goal(&self) -> (f64, f64) {
        Maze::GOAL.into()
    }

    /// The walls' ends, x1, y1, x2 and y2 of each: (13, 4).
    #[getter]
    fn walls<'py>(&self, py: Python<'py>) -> Result<Array2<'py>> {
        Ok(rows_of(py, Maze::WALLS.map(|[[x1, y1], [x2, y2]]| [x1, y1, x2, y2]))?)
    }

    /// Where the robot ends: (weights,) -> (2,), or (n, weights) -> (n, 2).
    fn effect<'py>(&self, command: &Any<'py>) -> Result<Any<'py>> {
        let (py, floats) = (command.py(), Floats::either("command", command, Maze::WEIGHTS)?);
        let weights = floats.copied()?;
        if !floats.is_batch() {
            let effect = py.detach(|| self.0.effect(&weights))?;
            return Ok(PyArray1::from_slice(py, &effect).into_any());
        }
        let effects = py.detach(|| {
            self.0.check(&weights)?;
            let each = weights.chunks_exact(Maze::WEIGHTS);
            each.map(|command| self.0.effect(command)).collect::<Result<Vec<_>, Error>>()
        })?;
        Ok(rows_of(py, effects)?.into_any())
    }

    /// Where the robot starts, and where it is after each step: (weights,) -> (k, 2).
    fn path<'py>(&self, command: &Any<'py>) -> Result<Array2<'py>> {
        let weights = Floats::point("command", command, Some(Maze::WEIGHTS))?.copied()?;
        let path = command.py().detach(|| self.0.path(&weights))?;
        Ok(rows_of(command.py(), path)?)
    }
}
