//! The most novel of a few goals.

use super::GoalSampler;
use super::area::Area;
use crate::bounds::{Bounds, UniformStream};
use crate::error::{Error, check_count};
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
    fn area(&self) -> Option<&Area> {
        Some(&self.area)
    }

    fn sample(
        &mut self,
        history: &mut History,
        draws: &mut dyn UniformStream,
        goal: &mut Vec<f64>,
    ) -> Result<(), Error> {
        let Some((goals, effects)) = self.area.begin(history, draws, goal)? else {
            return Ok(());
        };
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
