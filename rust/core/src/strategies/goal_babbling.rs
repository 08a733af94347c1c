//! GoalBabbling: goals at random, and the inverse model to reach them.

use super::Strategy;
use crate::bounds::{Bounds, UniformStream, check_share};
use crate::error::{Error, check_length};
use crate::history::History;

/// A goal uniform in a box, inverted; with nothing observed yet, a command uniform in M.
///
/// One draw a coordinate of S, then of M.
#[derive(Debug, Clone)]
pub struct GoalBabbling {
    d: f64,
    goals: Option<Bounds>,
    goal: Vec<f64>,
}

impl GoalBabbling {
    /// Perturbing by the share `d` of each motor range; goals come from `goals`, or else from the
    /// sensory space.
    ///
    /// # Errors
    /// If `d` is not in [0, 1].
    pub fn new(d: f64, goals: Option<Bounds>) -> Result<Self, Error> {
        check_share("d", d)?;
        Ok(Self { d, goals, goal: Vec::new() })
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
            history.motor_space().sample_into(command, draws);
            return Ok(());
        }
        let Some(goals) = self.goals.as_ref().or(history.sensory_space()) else {
            return Err(Error::Empty { name: "goals" });
        };
        self.goal.resize(goals.dim(), 0.0);
        goals.sample_into(&mut self.goal, draws);
        history.inverse(&self.goal, self.d, draws, command)
    }

    fn needs_commands(&self) -> bool {
        true
    }

    fn check(&self, history: &History) -> Result<(), Error> {
        match self.goals.as_ref().or(history.sensory_space()) {
            Some(goals) => check_length("goals", goals.low(), history.effect_dim()),
            None => Err(Error::Empty { name: "goals" }),
        }
    }
}
