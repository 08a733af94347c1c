//! Area: the box that goals are drawn in - the sampler's own, or else the sensory space.

use crate::bounds::{Bounds, UniformStream};
use crate::error::{Error, check_length};
use crate::history::History;
use crate::kdtree::NearestNeighbors;

/// Where a sampler draws its goals.
#[derive(Debug, Clone)]
pub struct Area {
    given: bool,
    /// The box, or that of the sensory space seen last.
    goals: Option<Bounds>,
}

impl Area {
    /// The given box, or else the sensory space.
    pub(super) fn new(given: Option<Bounds>) -> Self {
        Self { given: given.is_some(), goals: given }
    }

    /// The box for goals in this sensory space; checks that it is of the effects' dimension.
    pub(super) fn check<'a>(
        &'a self,
        effect_dim: Option<usize>,
        sensory_space: Option<&'a Bounds>,
    ) -> Result<&'a Bounds, Error> {
        let goals = if self.given { self.goals.as_ref() } else { sensory_space };
        let goals = goals.ok_or(MISSING)?;
        effect_dim.map_or(Ok(()), |dim| check_length("goals", goals.low(), dim))?;
        Ok(goals)
    }

    /// The box for goals in this history.
    pub(super) fn of(&mut self, history: &History) -> Result<&Bounds, Error> {
        if !self.given && self.goals.as_ref() != history.sensory_space() {
            self.goals = history.sensory_space().cloned();
        }
        self.goals.as_ref().ok_or(MISSING)
    }

    /// The box, and all effects of the history, with room in `goal`; None while there are none: then
    /// a goal uniform in the box is written.
    pub(super) fn begin<'a>(
        &'a mut self,
        history: &'a mut History,
        draws: &mut dyn UniformStream,
        goal: &mut Vec<f64>,
    ) -> Result<Option<(&'a Bounds, &'a NearestNeighbors)>, Error> {
        if history.is_empty() {
            return self.sample(history, draws, goal).map(|()| None);
        }
        let goals = self.of(history)?;
        let effects = history.observed()?.effects;
        check_length("goals", goals.low(), effects.dim())?;
        goal.resize(goals.dim(), 0.0);
        Ok(Some((goals, effects)))
    }

    /// Writes a goal uniform in the box.
    pub(super) fn sample(
        &self,
        history: &History,
        draws: &mut dyn UniformStream,
        goal: &mut Vec<f64>,
    ) -> Result<(), Error> {
        let own = self.goals.as_ref().filter(|_| self.given);
        let goals = own.or(history.sensory_space()).ok_or(MISSING)?;
        goal.resize(goals.dim(), 0.0);
        goals.sample_into(goal, draws);
        Ok(())
    }
}

/// There is no box.
const MISSING: Error = Error::Empty { name: "goals" };
