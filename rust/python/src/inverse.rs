//! Bindings of the inverse models.

use divbandit_core::Error;
use divbandit_core::inverse::{InverseModel, KNearest, LocalJacobian, LocalRegression, Nearest};
use numpy::PyArray1;
use pyo3::exceptions::PyTypeError;
use pyo3::prelude::*;

use crate::arrays::{Floats, read_only};
use crate::errors::value_error;
use crate::history::log_of;
use crate::parts::{class_of, field};
use crate::random::NumpyStream;

/// The running model of a value of the library; None for a user's model.
pub(crate) fn inverse_of(part: &Bound<'_, PyAny>) -> PyResult<Option<Box<dyn InverseModel>>> {
    let Some(class) = class_of(part)? else { return Ok(None) };
    let count = |name: &str| field::<usize>(part, name);
    let number = |name: &str| field::<f64>(part, name);
    Ok(Some(match &class[..] {
        "Nearest" => ready(Nearest::new(number("d")?))?,
        "KNearest" => ready(KNearest::new(count("k")?, number("d")?))?,
        "LocalRegression" => ready(LocalRegression::new(
            count("k")?,
            number("d")?,
            number("ridge")?,
            number("reach")?,
        ))?,
        "LocalJacobian" => ready(LocalJacobian::new(
            count("k")?,
            count("used")?,
            number("ridge")?,
            number("reach")?,
            number("noise")?,
        ))?,
        _ => return Ok(None),
    }))
}

/// A model, or why its settings are refused.
fn ready(model: Result<impl InverseModel + 'static, Error>) -> PyResult<Box<dyn InverseModel>> {
    Ok(Box::new(model.map_err(value_error)?))
}

/// A running inverse model, for one exploration.
///
/// Parameters
/// ----------
/// value : Nearest, KNearest, LocalRegression or LocalJacobian
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
    fn new(value: &Bound<'_, PyAny>) -> PyResult<Self> {
        match inverse_of(value)? {
            Some(model) => Ok(Self { model, command: Vec::new() }),
            None => Err(PyTypeError::new_err(format!(
                "value must be an inverse model of the library, got {}",
                value.get_type().name()?
            ))),
        }
    }

    /// Return a command for a goal.
    fn command<'py>(
        &mut self,
        goal: &Bound<'py, PyAny>,
        history: &Bound<'py, PyAny>,
        rng: &Bound<'py, PyAny>,
    ) -> PyResult<Bound<'py, PyArray1<f64>>> {
        let mut log = log_of(history)?;
        let dim = log.0.observed().map_err(value_error)?.effects.dim();
        let goal = Floats::point("goal", goal, Some(dim))?.copied()?;
        self.command.resize(log.0.motor_space().dim(), 0.0);
        let mut stream = NumpyStream::lock(rng)?;
        self.model
            .command(&goal, &mut log.0, &mut stream, &mut self.command)
            .map_err(value_error)?;
        read_only(rng.py(), &self.command)
    }
}
