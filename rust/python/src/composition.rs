//! Composition: the library's strategies, read from the Python values that describe them.

use std::collections::HashMap;

use divbandit_core::bandits::Bandit;
use divbandit_core::bandits::estimators::EstimatorKind;
use divbandit_core::bandits::policies::PolicyKind;
use divbandit_core::strategies::{GoalBabbling, Mixture, MotorBabbling, Schedule};
use divbandit_core::{Composition, History};
use pyo3::exceptions::PyValueError;
use pyo3::prelude::*;

use crate::arrays::{Any, kind};
use crate::errors::Result;
use crate::estimators::estimator_of;
use crate::goals::goals_of;
use crate::inverse::inverse_of;
use crate::parts::{class_of, field, made_of};
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
    pub fn place(&mut self, path: &str, part: &Any<'_>) -> Result<usize> {
        let key = part.as_ptr() as usize;
        if let Some(&place) = self.places.get(&key) {
            return Ok(place);
        }
        let place = match class_of(part)?.as_deref() {
            Some("MotorBabbling") => self.composition.add(MotorBabbling),
            Some("GoalBabbling") => {
                let goals = read(goals_of, part, "sampler", path, "goals")?;
                let inverse = read(inverse_of, part, "model", path, "inverse")?;
                self.composition.add(GoalBabbling::new(goals, inverse))
            }
            Some("Mixture") => {
                let parts = self.places_of(path, part)?;
                self.composition.compose(made_of!(part, Mixture::new(weights))?, parts)?
            }
            Some("Schedule") => self.schedule(path, part)?,
            Some("Adapt") => {
                let (size, head_start) = (field(part, "window")?, field(part, "head_start")?);
                let policy = made_of!(part, PolicyKind::Proportional { alpha, power });
                self.bandit(path, part, EstimatorKind::Window { size, head_start }, policy)?
            }
            Some("Bandit") => {
                let estimator = read(estimator_of, part, "estimator", path, "estimator")?;
                let policy = read(policy_of, part, "policy", path, "policy")?;
                self.bandit(path, part, estimator, policy)?
            }
            _ => return Err(foreign(path, part).into()),
        };
        self.places.insert(key, place);
        Ok(place)
    }

    fn schedule(&mut self, path: &str, part: &Any<'_>) -> Result<usize> {
        let phases: Vec<(Option<Any<'_>>, Any<'_>)> = part.getattr("phases")?.extract()?;
        let (mut steps, mut parts) = (Vec::new(), Vec::new());
        for (index, (count, strategy)) in phases.iter().enumerate() {
            parts.push(self.place(&format!("{path}.phases[{index}]"), strategy)?);
            // A number too large for a machine word is never reached.
            let steps_of = |count: &Any<'_>| count.extract().unwrap_or(MOST_STEPS).min(MOST_STEPS);
            steps.push(count.as_ref().map_or(MOST_STEPS, steps_of));
        }
        steps.pop();
        Ok(self.composition.compose(Schedule::new(steps)?, parts)?)
    }

    fn bandit(
        &mut self,
        path: &str,
        part: &Any<'_>,
        estimator: EstimatorKind,
        policy: PolicyKind,
    ) -> Result<usize> {
        let parts = self.places_of(path, part)?;
        let reward = part.getattr("rewarding")?;
        let Some(kind) = reward_of(&reward)? else {
            return Err(match class_of(&reward)?.as_deref() {
                Some("Gain") => {
                    foreign(&format!("{path}.reward.measure"), &reward.getattr("measure")?)
                }
                _ => foreign(&format!("{path}.reward"), &reward),
            }
            .into());
        };
        let dim = self.history.effect_dim();
        let bandit = Bandit::new(parts.len(), kind, estimator, policy, dim)?;
        Ok(self.composition.compose(bandit, parts)?)
    }

    /// The places of a composite's strategies.
    fn places_of(&mut self, path: &str, part: &Any<'_>) -> Result<Vec<usize>> {
        let strategies: Vec<Any<'_>> = part.getattr("strategies")?.extract()?;
        let each = strategies.iter().enumerate();
        each.map(|(index, each)| self.place(&format!("{path}.strategies[{index}]"), each)).collect()
    }
}

/// What `kind_of` reads of a field, unless that is a user's part; an error calls it `argument`.
fn read<T>(
    kind_of: impl Fn(&Any<'_>) -> Result<Option<T>>,
    part: &Any<'_>,
    name: &str,
    path: &str,
    argument: &str,
) -> Result<T> {
    let field = part.getattr(name)?;
    kind_of(&field)?.ok_or_else(|| foreign(&format!("{path}.{argument}"), &field).into())
}

fn foreign(path: &str, part: &Any<'_>) -> PyErr {
    NotBuiltInError::new_err((path.to_owned(), kind(part)))
}
