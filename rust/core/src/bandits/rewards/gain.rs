//! Gain: what an effect adds to a measure of diversity, given all effects before it.

use super::{Reward, unseen};
use crate::error::Error;
use crate::history::History;
use crate::measures::Measure;

/// The gain of the newest effect: div(y, E) = C(E + y) - C(E) (Benureau and Oudeyer 2015).
///
/// A nested bandit rewards its own trials alone; the effects of others, which it has not seen, are
/// added first.
#[derive(Debug)]
pub(super) struct Gain {
    measure: Box<dyn Measure>,
    newest: f64,
}

impl Gain {
    pub fn new(measure: Box<dyn Measure>) -> Self {
        Self { measure, newest: 0.0 }
    }
}

impl Reward for Gain {
    fn newest(&mut self, history: &History, _goal: Option<&[f64]>) -> Result<f64, Error> {
        let dim = self.measure.dim();
        let unseen = unseen(history, self.measure.len(), dim)?;
        self.measure.check("effect", unseen)?;
        for effect in unseen.chunks_exact(dim) {
            self.newest = self.measure.add(effect);
        }
        Ok(self.newest)
    }
}
