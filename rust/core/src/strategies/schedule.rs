//! Schedule: one strategy after another.

use super::{Choice, Composite};
use crate::bounds::UniformStream;
use crate::error::Error;

/// Each part for a number of its own proposals, then the next; the last one never ends.
#[derive(Debug, Clone)]
pub struct Schedule {
    /// Without that of the last.
    steps: Vec<u64>,
    phase: usize,
    proposed: u64,
}

impl Schedule {
    /// Of parts that have these numbers of steps, and a last one.
    ///
    /// # Errors
    /// If a part has no steps.
    pub fn new(steps: Vec<u64>) -> Result<Self, Error> {
        if steps.contains(&0) {
            return Err(Error::Count { name: "steps", must_be: "at least 1 each".into(), got: 0 });
        }
        Ok(Self { steps, phase: 0, proposed: 0 })
    }
}

impl Composite for Schedule {
    fn parts(&self) -> usize {
        self.steps.len() + 1
    }

    fn choose(&mut self, _draws: &mut dyn UniformStream) -> Choice {
        if self.steps.get(self.phase).is_some_and(|&steps| self.proposed >= steps) {
            self.phase += 1;
            self.proposed = 0;
        }
        self.proposed = self.proposed.saturating_add(1);
        Choice::of(self.phase)
    }
}
