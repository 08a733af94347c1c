//! A goal just beyond what is covered.

use super::area::Area;
use super::covered::Covered;
use super::{GoalSampler, check_reach};
use crate::bounds::{Bounds, UniformStream};
use crate::error::{Error, check_count};
use crate::history::History;

/// Goals around an effect that no effect covers: the first of at most so many that is farther than
/// tau from every effect, or else the last.
///
/// Each is drawn from an effect taken at random, at a distance uniform between tau and the reach
/// times tau, in the direction of a point uniform in a cube around it; what leaves the box is
/// brought back to its border. Draws: the effect, the direction coordinate by coordinate, the
/// distance.
#[derive(Debug, Clone)]
pub struct Frontier {
    tau: f64,
    reach: f64,
    tries: usize,
    area: Area,
    covered: Covered,
}

impl Frontier {
    /// Between `tau` and `reach` times `tau` from an effect, the first of at most `tries`, in
    /// `goals_box`, or else the sensory space.
    ///
    /// # Errors
    /// If `tau` is not positive, `reach` is less than 1, one of them is not finite, or `tries` is 0.
    pub fn new(
        tau: f64,
        reach: f64,
        tries: usize,
        goals_box: Option<Bounds>,
    ) -> Result<Self, Error> {
        let covered = Covered::new(tau)?;
        check_reach(reach)?;
        check_count("tries", tries)?;
        Ok(Self { tau, reach, tries, area: Area::new(goals_box), covered })
    }
}

impl GoalSampler for Frontier {
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
        let (n, dim) = (effects.len(), effects.dim());
        for left in (0..self.tries).rev() {
            let index = draws.below(n);
            let centre = &effects.points()[index * dim..][..dim];
            draws.fill(goal);
            let mut squared = 0.0;
            for x in &mut *goal {
                *x = 2.0 * *x - 1.0;
                squared += *x * *x;
            }
            let distance = self.tau * (1.0 + (self.reach - 1.0) * draws.next());
            // If all draws are 1/2 there is no direction: the goal is the effect itself.
            let scale = if squared > 0.0 { distance / squared.sqrt() } else { 0.0 };
            goal.iter_mut().zip(centre).for_each(|(x, y)| *x = y + *x * scale);
            goals.clip(goal);
            if left > 0 && !self.covered.covers(goal, effects)? {
                break;
            }
        }
        Ok(())
    }
}
