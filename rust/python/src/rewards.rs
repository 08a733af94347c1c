//! Bindings of rewards.

use divbandit_core::bandits::rewards::{Reward, RewardKind};
use pyo3::exceptions::PyTypeError;
use pyo3::intern;
use pyo3::prelude::*;

use crate::arrays::Floats;
use crate::errors::value_error;
use crate::history::log_of;
use crate::measures::measure_of;
use crate::parts::class_of;

/// The reward that a value describes; None for a user's reward or measure.
pub(crate) fn reward_of(part: &Bound<'_, PyAny>) -> PyResult<Option<RewardKind>> {
    Ok(match class_of(part)?.as_deref() {
        Some("Gain") => measure_of(&part.getattr("measure")?)?.map(RewardKind::Gain),
        Some("CompetenceProgress") => Some(RewardKind::CompetenceProgress),
        _ => None,
    })
}

/// A running reward, for effects of `dim` dimensions.
///
/// Examples
/// --------
/// >>> import divbandit as db
/// >>> from divbandit._core import Reward
/// >>> history = db.History(db.Box([-1], [1]))
/// >>> history.append([0.5], [1.0, 2.0])
/// >>> gain = Reward(db.bandits.Gain(db.measures.GridCoverage(0.1)), 2)
/// >>> gain.of(db.Trial([0.5]), history.effects[0], history)
/// 1.0
#[pyclass(module = "divbandit._core", name = "Reward")]
pub(crate) struct PyReward(Box<dyn Reward>);

#[pymethods]
impl PyReward {
    #[new]
    fn new(value: &Bound<'_, PyAny>, dim: usize) -> PyResult<Self> {
        let Some(kind) = reward_of(value)? else {
            return Err(PyTypeError::new_err("value must be a reward of the library"));
        };
        kind.start(dim).map(Self).map_err(value_error)
    }

    /// The reward of the newest effect of the history, which is that of the trial.
    fn of(
        &mut self,
        trial: &Bound<'_, PyAny>,
        effect: &Bound<'_, PyAny>,
        history: &Bound<'_, PyAny>,
    ) -> PyResult<f64> {
        let _ = effect;
        let log = log_of(history)?;
        let goal = trial.getattr(intern!(trial.py(), "goal"))?;
        if goal.is_none() {
            return self.0.newest(&log.0, None).map_err(value_error);
        }
        let goal = Floats::finite_point("goal", &goal, log.0.effect_dim())?;
        self.0.newest(&log.0, Some(&goal)).map_err(value_error)
    }
}
