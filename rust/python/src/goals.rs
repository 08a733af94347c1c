//! Bindings of the goal samplers.

use divbandit_core::goals::{
    Cells, Frontier, GoalSampler, Grid, Novel, Uncovered, Uniform, Untried,
};
use divbandit_core::{Bounds, Error};
use numpy::PyArray1;
use pyo3::exceptions::{PyTypeError, PyValueError};
use pyo3::prelude::*;

use crate::arrays::read_only;
use crate::bounds::PyBounds;
use crate::errors::value_error;
use crate::history::log_of;
use crate::parts::{class_of, field};
use crate::random::NumpyStream;

/// The running sampler of a value of the library; None for a user's sampler.
pub(crate) fn goals_of(part: &Bound<'_, PyAny>) -> PyResult<Option<Box<dyn GoalSampler>>> {
    let Some(class) = class_of(part)? else { return Ok(None) };
    let count = |name: &str| field::<usize>(part, name);
    let number = |name: &str| field::<f64>(part, name);
    let boxed = || box_of(part);
    Ok(Some(match &class[..] {
        "UniformGoals" => ready(Uniform::new(boxed()?))?,
        "GridGoals" => ready(Grid::new(cells_of(part)?, boxed()?))?,
        "UncoveredGoals" => ready(Uncovered::new(number("tau")?, count("tries")?, boxed()?))?,
        "FrontierGoals" => {
            ready(Frontier::new(number("tau")?, number("reach")?, count("tries")?, boxed()?))?
        }
        "NovelGoals" => ready(Novel::new(count("candidates")?, boxed()?))?,
        "UntriedGoals" => ready(Untried::new(
            number("tau")?,
            count("candidates")?,
            count("tries")?,
            number("reach")?,
            boxed()?,
        ))?,
        _ => return Ok(None),
    }))
}

/// A sampler, or why its settings are refused.
fn ready(sampler: Result<impl GoalSampler + 'static, Error>) -> PyResult<Box<dyn GoalSampler>> {
    Ok(Box::new(sampler.map_err(value_error)?))
}

/// The box of a sampler, if it has one.
fn box_of(part: &Bound<'_, PyAny>) -> PyResult<Option<Bounds>> {
    let goals = part.getattr("box")?;
    if goals.is_none() {
        return Ok(None);
    }
    let bounds = goals.getattr("bounds")?;
    Ok(Some(bounds.cast::<PyBounds>()?.get().0.clone()))
}

/// The cells of a grid: a number of them, or one for each coordinate.
fn cells_of(part: &Bound<'_, PyAny>) -> PyResult<Cells> {
    let cells = part.getattr("cells")?;
    match cells.extract::<usize>() {
        Ok(count) => Ok(Cells::Alike(count)),
        Err(_) => Ok(Cells::Each(cells.extract()?)),
    }
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
    fn new(value: &Bound<'_, PyAny>) -> PyResult<Self> {
        match goals_of(value)? {
            Some(sampler) => {
                let class = class_of(value)?.unwrap_or_default();
                Ok(Self { class, sampler, goal: Vec::new() })
            }
            None => Err(PyTypeError::new_err(format!(
                "value must be a goal sampler of the library, got {}",
                value.get_type().name()?
            ))),
        }
    }

    /// Draw a goal; until something is observed, from the box alone.
    fn sample<'py>(
        &mut self,
        history: &Bound<'py, PyAny>,
        rng: &Bound<'py, PyAny>,
    ) -> PyResult<Bound<'py, PyArray1<f64>>> {
        let mut log = log_of(history)?;
        let mut stream = NumpyStream::lock(rng)?;
        self.sampler.sample(&mut log.0, &mut stream, &mut self.goal).map_err(
            |error| match error {
                Error::Empty { name: "goals" } => PyValueError::new_err(format!(
                    "goals must be given a box ({}(box=...)): there is no sensory space",
                    self.class
                )),
                other => value_error(other),
            },
        )?;
        read_only(rng.py(), &self.goal)
    }
}
