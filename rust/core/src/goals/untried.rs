//! An uncovered goal, next to an effect that has been nearest to the fewest goals.

use super::area::Area;
use super::border::Border;
use super::covered::Covered;
use super::extent::Extent;
use super::{GoalSampler, check_reach};
use crate::bounds::{Bounds, UniformStream};
use crate::error::{Error, check_count};
use crate::history::History;

/// How far beyond the effects goals are drawn at least where there is no box, in tau.
const MARGIN: f64 = 2.0;

/// Of a few uncovered goals, the one whose nearest effect has the smallest count so far, the first
/// of several; that effect is counted once more.
///
/// Points are drawn uniformly in a box - a given one, or that of all effects, a little wider -, at
/// most so many; those within tau of an effect are passed over. A goal whose nearest effect was
/// never counted is taken at once: no other is better. What is farther than the reach times tau
/// from its nearest effect is moved straight towards it, to that distance. Where all points were
/// covered, the goal lies just beyond the border of what is covered; if none is found there, it is
/// the last of these points.
#[derive(Debug, Clone)]
pub struct Untried {
    tau: f64,
    candidates: usize,
    tries: usize,
    reach: f64,
    area: Option<Area>,
    extent: Extent,
    covered: Covered,
    border: Border,
    /// How often each effect was the nearest of a goal.
    counts: Vec<u32>,
    candidate: Vec<f64>,
}

impl Untried {
    /// Of up to `candidates` goals among `tries` points, not farther than `reach` times `tau` from
    /// the nearest effect, in `goals_box`, or else around all effects.
    ///
    /// # Errors
    /// If a count is 0, `tau` is not positive and finite, or `reach` is less than 1 or not finite.
    pub fn new(
        tau: f64,
        candidates: usize,
        tries: usize,
        reach: f64,
        goals_box: Option<Bounds>,
    ) -> Result<Self, Error> {
        let covered = Covered::new(tau)?;
        check_count("candidates", candidates)?;
        check_count("tries", tries)?;
        check_reach(reach)?;
        Ok(Self {
            tau,
            candidates,
            tries,
            reach,
            area: goals_box.map(|given| Area::new(Some(given))),
            extent: Extent::default(),
            covered,
            border: Border::new(tau, reach),
            counts: Vec::new(),
            candidate: Vec::new(),
        })
    }
}

impl GoalSampler for Untried {
    fn area(&self) -> Option<&Area> {
        self.area.as_ref()
    }

    fn sample(
        &mut self,
        history: &mut History,
        draws: &mut dyn UniformStream,
        goal: &mut Vec<f64>,
    ) -> Result<(), Error> {
        let (goals, effects) = match &mut self.area {
            Some(area) => {
                let Some(found) = area.begin(history, draws, goal)? else { return Ok(()) };
                found
            }
            None if history.is_empty() => return Area::new(None).sample(history, draws, goal),
            None => {
                let effects = history.observed()?.effects;
                (self.extent.update(effects, MARGIN * self.tau)?, effects)
            }
        };
        self.covered.update(goals, effects);
        self.counts.resize(effects.len(), 0);
        goal.resize(goals.dim(), 0.0);
        self.candidate.resize(goals.dim(), 0.0);
        // The count, the squared distance and the index of the nearest effect.
        let mut best: Option<(u32, f64, usize)> = None;
        let mut found = 0;
        for _ in 0..self.tries {
            goals.sample_into(&mut self.candidate, draws);
            let nearest = self.covered.nearest_unless_covered(&self.candidate, effects)?;
            let Some((squared, index)) = nearest else { continue };
            let count = self.counts[index];
            if best.is_none_or(|(least, ..)| count < least) {
                best = Some((count, squared, index));
                goal.copy_from_slice(&self.candidate);
            }
            found += 1;
            if count == 0 || found == self.candidates {
                break;
            }
        }
        let Some((count, squared, index)) = best else {
            if !self.border.sample(goals, &self.covered, effects, draws, goal)? {
                goal.copy_from_slice(&self.candidate);
            }
            return Ok(());
        };
        self.counts[index] = count.saturating_add(1);
        let (distance, wanted) = (squared.sqrt(), self.reach * self.tau);
        if distance > wanted {
            let nearest = &effects.points()[index * goal.len()..][..goal.len()];
            for (x, y) in goal.iter_mut().zip(nearest) {
                let moved = y + (*x - y) * (wanted / distance);
                if moved.is_finite() {
                    *x = moved;
                }
            }
            goals.clip(goal);
        }
        Ok(())
    }
}
