//! RoundRobin: one part after another.

use super::{Choice, Estimates, Policy};
use crate::bounds::UniformStream;

/// Each part in turn, whatever it earned. No draws.
#[derive(Debug)]
pub(super) struct RoundRobin {
    parts: usize,
    next: usize,
}

impl RoundRobin {
    pub fn new(parts: usize) -> Self {
        Self { parts, next: 0 }
    }
}

impl Policy for RoundRobin {
    fn choose(&mut self, _estimates: &Estimates<'_>, _draws: &mut dyn UniformStream) -> Choice {
        let part = self.next;
        self.next = (part + 1) % self.parts;
        Choice::with(part, 1.0)
    }
}
