//! Proposal: a command, and how it came about.

use crate::bandits::policies::Choice;
use crate::paths::ROOT;

/// What the strategies proposed: a command, its goal, and the choices on the way to it.
#[derive(Debug, Clone)]
pub struct Proposal {
    pub(super) command: Vec<f64>,
    pub(super) goal: Vec<f64>,
    pub(super) has_goal: bool,
    /// The composites on the way, outermost first, and the choice of each.
    pub(super) choices: Vec<(usize, Choice)>,
    /// The path of these choices, by its end.
    pub(super) end: u32,
    /// The outermost strategy's estimates when it chose, if it is a bandit.
    pub(super) estimates: Vec<f64>,
}

impl Proposal {
    /// A proposal for commands of so many coordinates.
    #[must_use]
    pub fn new(motor_dim: usize) -> Self {
        Self {
            command: vec![0.0; motor_dim],
            goal: Vec::new(),
            has_goal: false,
            choices: Vec::new(),
            end: ROOT,
            estimates: Vec::new(),
        }
    }

    /// The motor command.
    #[must_use]
    pub fn command(&self) -> &[f64] {
        &self.command
    }

    /// The effect that it is meant to bring about.
    #[must_use]
    pub fn goal(&self) -> Option<&[f64]> {
        self.has_goal.then_some(self.goal.as_slice())
    }

    /// The probability with which the outermost strategy chose, where that is known.
    #[must_use]
    pub fn probability(&self) -> Option<f64> {
        self.choices.first().and_then(|(_, choice)| choice.probability)
    }

    /// Who proposed it: indices of strategies, outermost first.
    pub fn path(&self) -> impl ExactSizeIterator<Item = usize> {
        self.choices.iter().map(|(_, choice)| choice.part)
    }
}
