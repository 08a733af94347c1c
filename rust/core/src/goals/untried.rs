//! An uncovered goal, next to an effect that has been nearest to the fewest goals.

use super::area::Area;
use super::covered::Covered;
use super::{GoalSampler, check_reach};
use crate::bounds::{Bounds, UniformStream};
use crate::error::{Error, check_count};
use crate::history::History;
use crate::kdtree::NearestNeighbors;

/// Of a few uncovered goals, the one whose nearest effect has the smallest count so far, the first
/// of several; that effect is counted once more.
///
/// Each is drawn at most so many times until it is farther than tau from every effect. A goal whose
/// nearest effect was never counted is taken at once: no other is better. What is farther than
/// the reach times tau from its nearest effect is moved straight towards it, to that distance; the
/// goal stays in the box.
#[derive(Debug, Clone)]
pub struct Untried {
    tau: f64,
    candidates: usize,
    tries: usize,
    reach: f64,
    area: Area,
    covered: Covered,
    /// How often each effect was the nearest of a goal.
    counts: Vec<u32>,
    candidate: Vec<f64>,
}

impl Untried {
    /// Of up to `candidates` goals, each drawn at most `tries` times, not farther than `reach` times
    /// `tau` from the nearest effect, in `goals_box`, or else the sensory space.
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
        let (area, counts, candidate) = (Area::new(goals_box), Vec::new(), Vec::new());
        Ok(Self { tau, candidates, tries, reach, area, covered, counts, candidate })
    }
}

impl GoalSampler for Untried {
    fn area(&self) -> &Area {
        &self.area
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
        self.counts.resize(effects.len(), 0);
        self.candidate.resize(goals.dim(), 0.0);
        let candidate = &mut self.candidate[..];
        // The count, the distance and the index of the nearest effect.
        let mut best: Option<(u32, f64, usize)> = None;
        for _ in 0..self.candidates {
            let (squared, index) =
                uncovered(goals, self.tries, &self.covered, effects, draws, candidate)?;
            let count = self.counts[index];
            if best.is_none_or(|(least, ..)| count < least) {
                best = Some((count, squared.sqrt(), index));
                goal.copy_from_slice(candidate);
                if count == 0 {
                    break;
                }
            }
        }
        if let Some((count, distance, index)) = best {
            self.counts[index] = count.saturating_add(1);
            pull(goal, distance, self.reach * self.tau, index, goals, effects);
        }
        Ok(())
    }
}

/// Draws a goal that no effect covers, or else the last of all tries; tells the squared distance and
/// the index of its nearest effect.
fn uncovered(
    goals: &Bounds,
    tries: usize,
    covered: &Covered,
    effects: &NearestNeighbors,
    draws: &mut dyn UniformStream,
    goal: &mut [f64],
) -> Result<(f64, usize), Error> {
    for _ in 1..tries {
        goals.sample_into(goal, draws);
        if let Some(found) = covered.nearest_unless_covered(goal, effects)? {
            return Ok(found);
        }
    }
    goals.sample_into(goal, draws);
    effects.nearest_squared(goal)
}

/// Moves a goal that is farther than `wanted` from its nearest effect towards it.
fn pull(
    goal: &mut [f64],
    distance: f64,
    wanted: f64,
    index: usize,
    goals: &Bounds,
    effects: &NearestNeighbors,
) {
    if distance > wanted {
        let nearest = &effects.points()[index * goal.len()..][..goal.len()];
        let corners = goals.low().iter().zip(goals.high());
        for ((x, y), (&low, &high)) in goal.iter_mut().zip(nearest).zip(corners) {
            let moved = y + (*x - y) * (wanted / distance);
            if moved.is_finite() {
                *x = moved.max(low).min(high);
            }
        }
    }
}
