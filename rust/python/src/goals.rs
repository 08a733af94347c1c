//! Bindings of the goal samplers.

use divbandit_core::Error;
use divbandit_core::goals::{Frontier, GoalSampler, Grid, Novel, Uncovered, Uniform, Untried};
use pyo3::exceptions::PyValueError;
use pyo3::prelude::*;

use crate::arrays::{Any, Array1, read_only};
use crate::errors::Result;
use crate::history::log_of;
use crate::parts::{class_of, made_of, ours};
use crate::random::NumpyStream;

/// The running sampler of a value of the library; None for a user's sampler.
pub(crate) fn goals_of(part: &Any<'_>) -> Result<Option<Box<dyn GoalSampler>>> {
    Ok(Some(match class_of(part)?.as_deref() {
        Some("UniformGoals") => Box::new(made_of!(part, Uniform::new(box))?),
        Some("GridGoals") => Box::new(made_of!(part, Grid::new(cells, box))?),
        Some("UncoveredGoals") => Box::new(made_of!(part, Uncovered::new(tau, tries, box))?),
        Some("FrontierGoals") => Box::new(made_of!(part, Frontier::new(tau, reach, tries, box))?),
        Some("NovelGoals") => Box::new(made_of!(part, Novel::new(candidates, box))?),
        Some("UntriedGoals") => {
            Box::new(made_of!(part, Untried::new(tau, candidates, tries, reach, box))?)
        }
        _ => return Ok(None),
    }))
}

/// A running goal sampler, for one exploration.
///
/// Parameters
/// ----------
/// value : UniformGoals, GridGoals, UncoveredGoals, FrontierGoals, NovelGoals or UntriedGoals
///
/// Examples
/// --------
/// >>> import numpy as np
/// >>> import divbandit as db
/// >>> from divbandit._core import GoalSampler
/// >>> history = db.History(db.Box([0], [1]), db.Box([0], [1]))
/// >>> history.append([0.5], [0.6])
/// >>> goals = GoalSampler(db.goals.UncoveredGoals(0.1))
/// >>> goals.sample(history, np.random.default_rng(0))
/// array([0.26978671])
#[pyclass(module = "divbandit._core", name = "GoalSampler")]
pub(crate) struct PyGoalSampler {
    class: String,
    sampler: Box<dyn GoalSampler>,
    goal: Vec<f64>,
}

#[pymethods]
impl PyGoalSampler {
    #[new]
    fn new(value: &Any<'_>) -> Result<Self> {
        let sampler = ours(goals_of(value)?, "a goal sampler", value)?;
        Ok(Self { class: class_of(value)?.unwrap_or_default(), sampler, goal: Vec::new() })
    }

    /// Draw a goal; until something is observed, from the box alone.
    fn sample<'py>(&mut self, history: &Any<'py>, rng: &Any<'py>) -> Result<Array1<'py>> {
        let log = &mut log_of(history)?.0;
        match self.sampler.sample(log, NumpyStream::lock(rng)?.draws(), &mut self.goal) {
            Ok(()) => Ok(read_only(rng.py(), &self.goal)?),
            Err(Error::Empty { name: "goals" }) => Err(PyValueError::new_err(format!(
                "there must be a sensory space to draw goals from, or {}(box=...)",
                self.class
            ))
            .into()),
            Err(other) => Err(other.into()),
        }
    }
}
