//! Goals at random, as the paper draws them.

use super::GoalSampler;
use super::area::Area;
use crate::bounds::{Bounds, UniformStream};
use crate::error::Error;
use crate::history::History;

/// Goals uniform in a box: one draw a coordinate.
#[derive(Debug, Clone)]
pub struct Uniform {
    area: Area,
}

impl Uniform {
    /// In `goals_box`, or else the sensory space.
    ///
    /// # Errors
    /// Never; other samplers refuse some settings.
    pub fn new(goals_box: Option<Bounds>) -> Result<Self, Error> {
        Ok(Self { area: Area::new(goals_box) })
    }
}

impl GoalSampler for Uniform {
    fn area(&self) -> Option<&Area> {
        Some(&self.area)
    }

    fn sample(
        &mut self,
        history: &mut History,
        draws: &mut dyn UniformStream,
        goal: &mut Vec<f64>,
    ) -> Result<(), Error> {
        self.area.sample(history, draws, goal)
    }
}
