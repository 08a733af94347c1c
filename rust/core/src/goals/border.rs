//! Border: goals just beyond the effects around which something is uncovered.
//!
//! Effects take turns, the newest first. One around which nothing uncovered is found is taken to lie
//! inside of what is covered, which only grows: its turn does not come again.

use std::collections::VecDeque;

use super::covered::Covered;
use crate::bounds::{Bounds, UniformStream};
use crate::error::Error;
use crate::kdtree::NearestNeighbors;

/// How many directions are tried around an effect.
const DIRECTIONS: usize = 8;

/// Upper limit on the effects tried for a goal.
const EFFECTS: usize = 20;

/// How far from an effect a point must be uncovered, in tau: just beyond what the effect covers.
const BEYOND: f64 = 1.02;

/// The effects whose turn may come.
#[derive(Debug, Clone)]
pub(super) struct Border {
    tau: f64,
    /// How far from an effect goals lie at most, in tau.
    reach: f64,
    turns: VecDeque<u32>,
    /// How many effects have been queued.
    seen: usize,
    /// The point beyond an effect that is looked at.
    point: Vec<f64>,
}

impl Border {
    /// With goals from `tau` to `reach` times that from an effect.
    pub fn new(tau: f64, reach: f64) -> Self {
        Self { tau, reach, turns: VecDeque::new(), seen: 0, point: Vec::new() }
    }

    /// Writes a goal of the box, in a direction from an effect in which nothing else covers what is
    /// just beyond; returns whether there is one.
    ///
    /// The direction is that of a point uniform in a cube. Draws: for each direction one a
    /// coordinate; at the end, the distance.
    pub fn sample(
        &mut self,
        goals: &Bounds,
        covered: &Covered,
        effects: &NearestNeighbors,
        draws: &mut dyn UniformStream,
        goal: &mut [f64],
    ) -> Result<bool, Error> {
        for index in self.seen..effects.len() {
            self.turns.push_front(index as u32);
        }
        self.seen = effects.len();
        self.point.resize(goal.len(), 0.0);
        for _ in 0..EFFECTS {
            let Some(index) = self.turns.pop_front() else { break };
            let centre = &effects.points()[index as usize * goal.len()..][..goal.len()];
            for _ in 0..DIRECTIONS {
                draws.fill(goal);
                goal.iter_mut().for_each(|x| *x = 2.0 * *x - 1.0);
                let length = goal.iter().fold(0.0, |sum, x| sum + x * x).sqrt();
                if length == 0.0 {
                    continue;
                }
                let at = |distance: f64, x: f64, y: f64| y + x * (distance / length);
                for ((p, &x), &y) in self.point.iter_mut().zip(&*goal).zip(centre) {
                    *p = at(BEYOND * self.tau, x, y);
                }
                if !goals.holds(&self.point) || covered.covers(&self.point, effects)? {
                    continue;
                }
                self.turns.push_back(index);
                let distance = self.tau * (1.0 + (self.reach - 1.0) * draws.next());
                goal.iter_mut().zip(centre).for_each(|(x, &y)| *x = at(distance, *x, y));
                goals.clip(goal);
                return Ok(true);
            }
        }
        Ok(false)
    }
}
