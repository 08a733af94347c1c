//! A goal that no effect covers.

use super::GoalSampler;
use super::area::Area;
use super::covered::Covered;
use crate::bounds::{Bounds, UniformStream};
use crate::error::{Error, check_count};
use crate::history::History;

/// Goals uniform among those of the box that are farther than tau from every effect: the first of
/// at most so many that is, or else the last.
#[derive(Debug, Clone)]
pub struct Uncovered {
    tries: usize,
    area: Area,
    covered: Covered,
}

impl Uncovered {
    /// Farther than `tau`, the first of at most `tries`, in `goals_box`, or else the sensory space.
    ///
    /// # Errors
    /// If `tau` is not positive and finite, or `tries` is 0.
    pub fn new(tau: f64, tries: usize, goals_box: Option<Bounds>) -> Result<Self, Error> {
        check_count("tries", tries)?;
        Ok(Self { tries, area: Area::new(goals_box), covered: Covered::new(tau)? })
    }
}

impl GoalSampler for Uncovered {
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
        self.covered.update(goals, effects);
        goals.sample_into(goal, draws);
        for _ in 1..self.tries {
            if !self.covered.covers(goal, effects)? {
                break;
            }
            goals.sample_into(goal, draws);
        }
        Ok(())
    }
}
