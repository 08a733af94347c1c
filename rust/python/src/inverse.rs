//! Bindings of the inverse models.

use divbandit_core::inverse::{
    Crossover, InverseModel, KNearest, LineVariation, LocalJacobian, LocalRegression, Nearest,
};
use pyo3::prelude::*;

use crate::arrays::{Any, Array1, Floats, read_only};
use crate::errors::Result;
use crate::history::log_of;
use crate::parts::{class_of, made_of, ours};
use crate::random::NumpyStream;

/// The running model of a value of the library; None for a user's model.
pub(crate) fn inverse_of(part: &Any<'_>) -> Result<Option<Box<dyn InverseModel>>> {
    Ok(Some(match class_of(part)?.as_deref() {
        Some("Nearest") => Box::new(made_of!(part, Nearest::new(d))?),
        Some("KNearest") => Box::new(made_of!(part, KNearest::new(k, d))?),
        Some("LocalRegression") => {
            Box::new(made_of!(part, LocalRegression::new(k, d, ridge, reach))?)
        }
        Some("LocalJacobian") => {
            Box::new(made_of!(part, LocalJacobian::new(k, used, ridge, reach, noise))?)
        }
        Some("LineVariation") => Box::new(made_of!(part, LineVariation::new(d, along))?),
        Some("Crossover") => Box::new(made_of!(part, Crossover::new(k, d))?),
        _ => return Ok(None),
    }))
}

/// A running inverse model, for one exploration.
///
/// Parameters
/// ----------
/// value : Nearest, KNearest, LocalRegression, LocalJacobian, LineVariation or Crossover
///
/// Examples
/// --------
/// >>> import numpy as np
/// >>> import divbandit as db
/// >>> from divbandit._core import InverseModel
/// >>> history = db.History(db.Box([0], [1]))
/// >>> history.append([0.25], [7.0])
/// >>> model = InverseModel(db.inverse.Nearest(0.1))
/// >>> model.command([8.0], history, np.random.default_rng(0))
/// array([0.27739234])
#[pyclass(module = "divbandit._core", name = "InverseModel")]
pub(crate) struct PyInverseModel {
    model: Box<dyn InverseModel>,
    command: Vec<f64>,
}

#[pymethods]
impl PyInverseModel {
    #[new]
    fn new(value: &Any<'_>) -> Result<Self> {
        let model = ours(inverse_of(value)?, "an inverse model", value)?;
        Ok(Self { model, command: Vec::new() })
    }

    /// Return a command for a goal.
    fn command<'py>(
        &mut self,
        goal: &Any<'py>,
        history: &Any<'py>,
        rng: &Any<'py>,
    ) -> Result<Array1<'py>> {
        let log = &mut log_of(history)?.0;
        let goal = Floats::point("goal", goal, Some(log.observed()?.effects.dim()))?.copied()?;
        self.command.resize(log.motor_space().dim(), 0.0);
        self.model.command(&goal, log, NumpyStream::lock(rng)?.draws(), &mut self.command)?;
        Ok(read_only(rng.py(), &self.command)?)
    }
}
