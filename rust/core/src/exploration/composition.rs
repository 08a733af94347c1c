//! Composition: strategies that are made of strategies, side by side in one list.
//!
//! A part is known by its place. A composite's parts come before it, so that there are no
//! circles; a part of two composites is one and the same, with one running state.

use crate::error::Error;
use crate::strategies::{Composite, Strategy};

/// The parts that a strategy is made of.
#[derive(Debug, Default)]
pub struct Composition {
    pub(super) parts: Vec<Part>,
}

/// One strategy.
#[derive(Debug)]
pub(super) enum Part {
    /// That proposes by itself.
    Strategy(Box<dyn Strategy>),
    /// That lets one of others propose.
    Composite(Box<dyn Composite>, Vec<usize>),
}

impl Composition {
    /// Adds a strategy that proposes by itself, and returns its place.
    pub fn add(&mut self, strategy: impl Strategy + 'static) -> usize {
        self.push(Part::Strategy(Box::new(strategy)))
    }

    /// Adds a strategy over the parts at these places, and returns its own.
    ///
    /// # Errors
    /// If their number is not that of the parts that it chooses among, or one of them does
    /// not exist yet.
    pub fn compose(
        &mut self,
        composite: impl Composite + 'static,
        parts: Vec<usize>,
    ) -> Result<usize, Error> {
        if parts.len() != composite.parts() {
            let must_be = format!("{} parts", composite.parts());
            return Err(Error::Count { name: "parts", must_be, got: parts.len() });
        }
        for &part in &parts {
            self.check(part)?;
        }
        Ok(self.push(Part::Composite(Box::new(composite), parts)))
    }

    /// Whether one of the parts looks at the commands of the history.
    #[must_use]
    pub fn needs_commands(&self) -> bool {
        self.parts.iter().any(|part| match part {
            Part::Strategy(strategy) => strategy.needs_commands(),
            Part::Composite(..) => false,
        })
    }

    pub(super) fn check(&self, part: usize) -> Result<(), Error> {
        if part < self.parts.len() {
            return Ok(());
        }
        let must_be = format!("one of {} parts", self.parts.len());
        Err(Error::Count { name: "part", must_be, got: part })
    }

    fn push(&mut self, part: Part) -> usize {
        self.parts.push(part);
        self.parts.len() - 1
    }
}
