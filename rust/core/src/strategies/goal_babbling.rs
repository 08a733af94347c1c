//! GoalBabbling: a goal is drawn, and an inverse model turns it into a command.

use super::Strategy;
use crate::bounds::{Bounds, UniformStream};
use crate::error::Error;
use crate::goals::GoalSampler;
use crate::history::History;
use crate::inverse::InverseModel;

/// A goal, inverted; until something is observed, a command uniform in M.
///
/// The draws of the goal, then those of the inverse model.
#[derive(Debug)]
pub struct GoalBabbling {
    goals: Box<dyn GoalSampler>,
    inverse: Box<dyn InverseModel>,
    /// The newest goal; empty where the newest command had none.
    goal: Vec<f64>,
}

impl GoalBabbling {
    /// With goals from `goals`, turned into commands by `inverse`.
    #[must_use]
    pub fn new(goals: Box<dyn GoalSampler>, inverse: Box<dyn InverseModel>) -> Self {
        Self { goals, inverse, goal: Vec::new() }
    }
}

impl Strategy for GoalBabbling {
    fn propose(
        &mut self,
        history: &mut History,
        draws: &mut dyn UniformStream,
        command: &mut [f64],
    ) -> Result<(), Error> {
        if history.is_empty() {
            self.goal.clear();
            history.motor_space().sample_into(command, draws);
            return Ok(());
        }
        self.goals.sample(history, draws, &mut self.goal)?;
        self.inverse.command(&self.goal, history, draws, command)
    }

    fn goal(&self) -> Option<&[f64]> {
        (!self.goal.is_empty()).then_some(&self.goal[..])
    }

    fn needs_commands(&self) -> bool {
        true
    }

    fn check(
        &self,
        effect_dim: Option<usize>,
        sensory_space: Option<&Bounds>,
    ) -> Result<(), Error> {
        self.goals.check(effect_dim, sensory_space)
    }
}
