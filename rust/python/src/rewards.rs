//! Bindings of rewards.

use divbandit_core::bandits::rewards::{Reward, RewardKind};
use pyo3::exceptions::PyTypeError;
use pyo3::prelude::*;

use crate::arrays::Floats;
use crate::errors::value_error;
use crate::history::PyHistory;
use crate::measures::measure_of;
use crate::parts::class_of;

/// The reward that a value describes; None for a user's, also where the measure alone is.
pub(crate) fn reward_of(part: &Bound<'_, PyAny>) -> PyResult<Option<RewardKind>> {
    Ok(match class_of(part)?.as_deref() {
        Some("Gain") => measure_of(&part.getattr("measure")?)?.map(RewardKind::Gain),
        Some("CompetenceProgress") => Some(RewardKind::CompetenceProgress),
        _ => None,
    })
}

/// A reward under way, for effects of `dim` dimensions.
///
/// Examples
/// --------
/// >>> from divbandit import bandits, measures
/// >>> from divbandit._core import Bounds, History, Reward
/// >>> history = History(Bounds([-1], [1]), None)
/// >>> history.record([0.5], [1.0, 2.0], (), None)
/// >>> Reward(bandits.Gain(measures.GridCoverage(0.1)), 2).newest(history, None)
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

    /// The reward of the newest effect of the history, whose trial had this goal.
    #[pyo3(signature = (history, goal))]
    fn newest(
        &mut self,
        history: PyRef<'_, PyHistory>,
        goal: Option<&Bound<'_, PyAny>>,
    ) -> PyResult<f64> {
        let dim = history.0.effect_dim();
        let goal = goal.map(|goal| Floats::finite_point("goal", goal, dim)).transpose()?;
        self.0.newest(&history.0, goal.as_deref()).map_err(value_error)
    }
}
