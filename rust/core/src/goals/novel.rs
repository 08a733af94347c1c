//! The most novel of a few goals.

use super::area::Area;
use super::{GoalSampler, check_count};
use crate::bounds::{Bounds, UniformStream};
use crate::error::Error;
use crate::history::History;

/// Of a few goals uniform in the box, the one whose nearest effect is farthest away; the first of
/// several.
#[derive(Debug, Clone)]
pub struct Novel {
    candidates: usize,
    area: Area,
    candidate: Vec<f64>,
}

impl Novel {
    /// Of so many candidates, in `goals_box`, or else the sensory space.
    ///
    /// # Errors
    /// If there are no candidates.
    pub fn new(candidates: usize, goals_box: Option<Bounds>) -> Result<Self, Error> {
        check_count("candidates", candidates)?;
        Ok(Self { candidates, area: Area::new(goals_box), candidate: Vec::new() })
    }
}

impl GoalSampler for Novel {
    fn check(
        &self,
        effect_dim: Option<usize>,
        sensory_space: Option<&Bounds>,
    ) -> Result<(), Error> {
        self.area.check(effect_dim, sensory_space).map(|_| ())
    }

    fn sample(
        &mut self,
        history: &mut History,
        draws: &mut dyn UniformStream,
        goal: &mut Vec<f64>,
    ) -> Result<(), Error> {
        if history.is_empty() {
            return self.area.sample(history, draws, goal);
        }
        let (goals, effects) = self.area.with_effects(history)?;
        goal.resize(goals.dim(), 0.0);
        goals.sample_into(goal, draws);
        let mut farthest = effects.nearest(goal)?.0;
        self.candidate.resize(goals.dim(), 0.0);
        for _ in 1..self.candidates {
            goals.sample_into(&mut self.candidate, draws);
            let distance = effects.nearest(&self.candidate)?.0;
            if distance > farthest {
                farthest = distance;
                goal.copy_from_slice(&self.candidate);
            }
        }
        Ok(())
    }
}
