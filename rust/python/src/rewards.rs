//! Bindings of rewards.

use divbandit_core::bandits::rewards::{Reward, RewardKind};
use pyo3::intern;
use pyo3::prelude::*;

use crate::arrays::{Any, Floats};
use crate::errors::Result;
use crate::history::log_of;
use crate::measures::measure_of;
use crate::parts::{class_of, ours};

/// The reward that a value describes; None for a user's reward or measure.
pub(crate) fn reward_of(part: &Any<'_>) -> Result<Option<RewardKind>> {
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
    fn new(value: &Any<'_>, dim: usize) -> Result<Self> {
        Ok(Self(ours(reward_of(value)?, "a reward", value)?.start(dim)?))
    }

    /// The reward of the newest effect of the history, which is that of the trial.
    fn of(&mut self, trial: &Any<'_>, effect: &Any<'_>, history: &Any<'_>) -> Result<f64> {
        let _ = effect;
        let log = &log_of(history)?.0;
        let goal: Option<Any<'_>> = trial.getattr(intern!(trial.py(), "goal"))?.extract()?;
        let read = |goal| Floats::finite_point("goal", &goal, log.effect_dim());
        Ok(self.0.newest(log, goal.map(read).transpose()?.as_deref())?)
    }
}
