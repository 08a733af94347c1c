//! A goal in each cell of a grid before there is a second one in any.

use super::GoalSampler;
use super::area::Area;
use crate::bounds::{Bounds, UniformStream};
use crate::error::Error;
use crate::history::History;
use crate::shape::Shape;

/// Goals uniform in the cells of a grid: each cell once, in random order, then each again.
///
/// Draws: the cell, then one a coordinate.
#[derive(Debug, Clone)]
pub struct Grid {
    cells: Shape,
    area: Area,
    /// The shape of the grid, and its cells that are still to come in this round.
    shape: Vec<usize>,
    left: Vec<u32>,
}

impl Grid {
    /// Of so many cells, in `goals_box`, or else the sensory space.
    ///
    /// # Errors
    /// If a number of cells is 0, there are none or more than ten million, or they are not of the
    /// dimension of the box.
    pub fn new(cells: Shape, goals_box: Option<Bounds>) -> Result<Self, Error> {
        cells.check_counts()?;
        if let Some(goals) = &goals_box {
            cells.check(goals.dim())?;
        }
        Ok(Self { cells, area: Area::new(goals_box), shape: Vec::new(), left: Vec::new() })
    }
}

impl GoalSampler for Grid {
    fn area(&self) -> Option<&Area> {
        Some(&self.area)
    }

    fn check(
        &self,
        effect_dim: Option<usize>,
        sensory_space: Option<&Bounds>,
    ) -> Result<(), Error> {
        let goals = self.area.check(effect_dim, sensory_space)?;
        self.cells.check(goals.dim()).map(|_| ())
    }

    fn sample(
        &mut self,
        history: &mut History,
        draws: &mut dyn UniformStream,
        goal: &mut Vec<f64>,
    ) -> Result<(), Error> {
        let goals = self.area.of(history)?;
        let total = self.cells.check(goals.dim())?;
        if self.left.is_empty() || self.shape.len() != goals.dim() {
            self.shape.clear();
            self.shape.extend(self.cells.along(goals.dim()));
            self.left.clear();
            self.left.extend(0..total as u32);
        }
        let place = draws.below(self.left.len());
        let mut cell = self.left.swap_remove(place) as usize;
        goal.resize(goals.dim(), 0.0);
        draws.fill(goal);
        let corners = goals.low().iter().zip(goals.high());
        for ((x, &count), (&low, &high)) in goal.iter_mut().zip(&self.shape).zip(corners) {
            let share = ((cell % count) as f64 + *x) / count as f64;
            cell /= count;
            *x = (low + (high - low) * share).min(high);
        }
        Ok(())
    }
}
