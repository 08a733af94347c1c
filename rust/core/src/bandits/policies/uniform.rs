//! Uniform: parts uniformly at random.

use super::{Choice, Estimates, Policy};
use crate::bounds::UniformStream;

/// A part uniformly at random, whatever it earned. One draw a choice.
#[derive(Debug)]
pub(super) struct Uniform {
    parts: usize,
}

impl Uniform {
    pub fn new(parts: usize) -> Self {
        Self { parts }
    }
}

impl Policy for Uniform {
    fn choose(&mut self, _estimates: &Estimates<'_>, draws: &mut dyn UniformStream) -> Choice {
        let parts = self.parts as f64;
        Choice::with((draws.next() * parts) as usize, 1.0 / parts)
    }
}
