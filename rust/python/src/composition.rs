//! Composition: the library's strategies, read from the Python values that describe them.

use std::collections::HashMap;

use divbandit_core::bandits::Bandit;
use divbandit_core::bandits::estimators::EstimatorKind;
use divbandit_core::bandits::policies::PolicyKind;
use divbandit_core::strategies::{GoalBabbling, Mixture, MotorBabbling, Schedule};
use divbandit_core::{Composition, History};
use pyo3::exceptions::PyValueError;
use pyo3::prelude::*;

use crate::errors::value_error;
use crate::estimators::estimator_of;
use crate::goals::goals_of;
use crate::inverse::inverse_of;
use crate::parts::{class_of, field};
use crate::policies::policy_of;
use crate::rewards::reward_of;

pyo3::create_exception!(
    divbandit._core,
    NotBuiltInError,
    PyValueError,
    "Some part of a strategy is not the library's own: which, and its class."
);

/// Upper limit on a schedule's steps, which is never reached.
const MOST_STEPS: u64 = 1 << 63;

/// The strategies found so far, each part with its place: one that occurs twice is started once.
pub(crate) struct Reader<'a> {
    history: &'a History,
    pub composition: Composition,
    places: HashMap<usize, usize>,
}

impl<'a> Reader<'a> {
    /// Of strategies that are to explore with this history.
    pub fn new(history: &'a History) -> Self {
        Self { history, composition: Composition::default(), places: HashMap::new() }
    }

    /// The place of a strategy, which is added if it was not before. A [`NotBuiltInError`] says
    /// which part is a user's, `path` being where the strategy stands.
    pub fn place(&mut self, path: &str, part: &Bound<'_, PyAny>) -> PyResult<usize> {
        let key = part.as_ptr() as usize;
        if let Some(&place) = self.places.get(&key) {
            return Ok(place);
        }
        let place = match class_of(part)?.as_deref() {
            Some("MotorBabbling") => self.composition.add(MotorBabbling),
            Some("GoalBabbling") => self.goal_babbling(path, part)?,
            Some("Mixture") => {
                let parts = self.places_of(path, part)?;
                let mixture = Mixture::new(field(part, "weights")?).map_err(value_error)?;
                self.composition.compose(mixture, parts).map_err(value_error)?
            }
            Some("Schedule") => self.schedule(path, part)?,
            Some("Adapt") => {
                let estimator = EstimatorKind::Window {
                    size: field(part, "window")?,
                    head_start: field(part, "head_start")?,
                };
                let policy = PolicyKind::Proportional {
                    alpha: field(part, "alpha")?,
                    power: field(part, "power")?,
                };
                self.bandit(path, part, estimator, policy)?
            }
            Some("Bandit") => {
                let (estimator, policy) = (part.getattr("estimator")?, part.getattr("policy")?);
                let known = estimator_of(&estimator)?;
                let estimator = ours(known, &format!("{path}.estimator"), &estimator)?;
                let policy = ours(policy_of(&policy)?, &format!("{path}.policy"), &policy)?;
                self.bandit(path, part, estimator, policy)?
            }
            _ => return Err(foreign(path, part)),
        };
        self.places.insert(key, place);
        Ok(place)
    }

    fn goal_babbling(&mut self, path: &str, part: &Bound<'_, PyAny>) -> PyResult<usize> {
        let (sampler, model) = (part.getattr("sampler")?, part.getattr("model")?);
        let goals = ours(goals_of(&sampler)?, &format!("{path}.goals"), &sampler)?;
        let inverse = ours(inverse_of(&model)?, &format!("{path}.inverse"), &model)?;
        Ok(self.composition.add(GoalBabbling::new(goals, inverse)))
    }

    fn schedule(&mut self, path: &str, part: &Bound<'_, PyAny>) -> PyResult<usize> {
        let phases: Vec<(Option<Bound<'_, PyAny>>, Bound<'_, PyAny>)> = field(part, "phases")?;
        let (mut steps, mut parts) = (Vec::new(), Vec::new());
        for (index, (count, strategy)) in phases.iter().enumerate() {
            parts.push(self.place(&format!("{path}.phases[{index}]"), strategy)?);
            // A number too large for a machine word is never reached.
            steps.push(count.as_ref().map_or(MOST_STEPS, |count| {
                count.extract::<u64>().map_or(MOST_STEPS, |steps| steps.min(MOST_STEPS))
            }));
        }
        steps.pop();
        let schedule = Schedule::new(steps).map_err(value_error)?;
        self.composition.compose(schedule, parts).map_err(value_error)
    }

    fn bandit(
        &mut self,
        path: &str,
        part: &Bound<'_, PyAny>,
        estimator: EstimatorKind,
        policy: PolicyKind,
    ) -> PyResult<usize> {
        let parts = self.places_of(path, part)?;
        let reward = part.getattr("rewarding")?;
        let Some(reward) = reward_of(&reward)? else {
            let path = format!("{path}.reward");
            return Err(match class_of(&reward)?.as_deref() {
                Some("Gain") => foreign(&format!("{path}.measure"), &reward.getattr("measure")?),
                _ => foreign(&path, &reward),
            });
        };
        let dim = self.history.effect_dim();
        let bandit =
            Bandit::new(parts.len(), reward, estimator, policy, dim).map_err(value_error)?;
        self.composition.compose(bandit, parts).map_err(value_error)
    }

    /// The places of a composite's strategies.
    fn places_of(&mut self, path: &str, part: &Bound<'_, PyAny>) -> PyResult<Vec<usize>> {
        let strategies: Vec<Bound<'_, PyAny>> = field(part, "strategies")?;
        let places = strategies
            .iter()
            .enumerate()
            .map(|(index, each)| self.place(&format!("{path}.strategies[{index}]"), each));
        places.collect()
    }
}

/// What was read of a part, unless that is a user's.
fn ours<T>(known: Option<T>, path: &str, part: &Bound<'_, PyAny>) -> PyResult<T> {
    known.ok_or_else(|| foreign(path, part))
}

fn foreign(path: &str, part: &Bound<'_, PyAny>) -> PyErr {
    let kind = part.get_type().name().map_or_else(|_| "object".into(), |name| name.to_string());
    NotBuiltInError::new_err((path.to_owned(), kind))
}
