//! Schedule: one strategy after another.

use super::Composite;
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
    /// Of parts that have these numbers of steps, and a last one. It begins with, or goes on in,
    /// part `phase`, which has `proposed` so many commands already.
    ///
    /// # Errors
    /// If a part has no steps, or there is no part `phase`.
    pub fn new(steps: Vec<u64>, phase: usize, proposed: u64) -> Result<Self, Error> {
        if steps.contains(&0) {
            return Err(Error::Count { name: "steps", must_be: "at least 1 each".into(), got: 0 });
        }
        if phase > steps.len() {
            let must_be = format!("one of {} parts", steps.len() + 1);
            return Err(Error::Count { name: "phase", must_be, got: phase });
        }
        Ok(Self { steps, phase, proposed })
    }
}

impl Composite for Schedule {
    fn parts(&self) -> usize {
        self.steps.len() + 1
    }

    fn choose(&mut self, _draws: &mut dyn UniformStream) -> usize {
        if self.steps.get(self.phase).is_some_and(|&steps| self.proposed >= steps) {
            self.phase += 1;
            self.proposed = 0;
        }
        self.proposed = self.proposed.saturating_add(1);
        self.phase
    }
}
