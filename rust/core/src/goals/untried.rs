//! A goal that no effect covers, next to an effect that was started from least often.

use crate::bounds::{Bounds, UniformStream};
use crate::error::Error;
use crate::kdtree::NearestNeighbors;

/// The search's settings.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Untried {
    tau: f64,
    candidates: usize,
    tries: usize,
    reach: f64,
}

impl Untried {
    /// Of up to `candidates` goals, each drawn at most `tries` times until it is farther than `tau`
    /// from every effect, and not farther than `reach` times `tau` from the nearest.
    ///
    /// # Errors
    /// If a count is 0, `tau` is not positive and finite, or `reach` is less than 1 or not finite.
    pub fn new(tau: f64, candidates: usize, tries: usize, reach: f64) -> Result<Self, Error> {
        super::check_distance("tau", tau)?;
        for (name, got) in [("candidates", candidates), ("tries", tries)] {
            if got == 0 {
                return Err(Error::Count { name, must_be: "at least 1".into(), got });
            }
        }
        if !(reach >= 1.0 && reach.is_finite()) {
            return Err(Error::Number { name: "reach", must_be: "at least 1, finite", got: reach });
        }
        Ok(Self { tau, candidates, tries, reach })
    }

    /// The goal whose nearest effect was counted least so far, the first of several; that effect is
    /// counted once more.
    ///
    /// `counts` holds at least one number for each effect. A goal whose nearest effect was never
    /// counted is taken at once: no other is better. What is farther than `reach` times `tau` from
    /// its nearest effect is moved straight towards it, to that distance; the goal stays in the box.
    ///
    /// # Errors
    /// If the sizes do not fit, or there is no effect; `stream` and `counts` are then untouched.
    pub fn sample(
        &self,
        goals: &Bounds,
        effects: &NearestNeighbors,
        counts: &mut [u32],
        stream: &mut (impl UniformStream + ?Sized),
    ) -> Result<Vec<f64>, Error> {
        super::check(goals, effects, "tries", self.tries)?;
        if counts.len() < effects.len() {
            let (must_be, got) = (effects.len(), counts.len());
            return Err(Error::Length { name: "counts", must_be, got });
        }
        let mut goal = vec![0.0; effects.dim()];
        let mut best = goal.clone();
        let mut from: Option<(u32, usize)> = None;
        for _ in 0..self.candidates {
            let (distance, index) = self.candidate(goals, effects, &mut goal, stream)?;
            if from.is_none_or(|(least, _)| counts[index] < least) {
                from = Some((counts[index], index));
                best.copy_from_slice(&goal);
                self.pull(&mut best, distance, index, goals, effects);
                if counts[index] == 0 {
                    break;
                }
            }
        }
        if let Some((count, index)) = from {
            counts[index] = count.saturating_add(1);
        }
        Ok(best)
    }

    /// Draws a goal that no effect covers, or else the last of all tries; tells the distance and
    /// the index of its nearest effect.
    fn candidate(
        &self,
        goals: &Bounds,
        effects: &NearestNeighbors,
        goal: &mut [f64],
        stream: &mut (impl UniformStream + ?Sized),
    ) -> Result<(f64, usize), Error> {
        goals.sample_into(goal, stream);
        let mut found = effects.nearest(goal)?;
        for _ in 1..self.tries {
            if found.0 > self.tau {
                break;
            }
            goals.sample_into(goal, stream);
            found = effects.nearest(goal)?;
        }
        Ok(found)
    }

    /// Moves a goal that is too far from its nearest effect towards it.
    fn pull(
        &self,
        goal: &mut [f64],
        distance: f64,
        index: usize,
        goals: &Bounds,
        effects: &NearestNeighbors,
    ) {
        let wanted = self.reach * self.tau;
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
}
