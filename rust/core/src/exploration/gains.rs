//! Gains: what each new effect covers, measured once for all bandits that measure alike.

use crate::coverage::{Coverage, Union};
use crate::error::Error;
use crate::history::History;

/// The unions by which bandits want gains, each brought up to date when one of them is told.
#[derive(Debug, Default)]
pub(super) struct Gains {
    measures: Vec<Measure>,
}

/// The union of balls around the first so many effects of a history, without a log of its own.
#[derive(Debug)]
struct Measure {
    template: Coverage,
    union: Union,
    known: usize,
    newest: f64,
}

impl Gains {
    /// Where to ask for gains measured by `template`: two that are alike are one.
    ///
    /// # Errors
    /// If effects have another dimension.
    pub fn of(&mut self, template: &Coverage, effect_dim: usize) -> Result<usize, Error> {
        if template.dim() != effect_dim {
            let (must_be, got) = (effect_dim, template.dim());
            return Err(Error::Length { name: "measure", must_be, got });
        }
        let known = self.measures.iter().position(|measure| measure.template.is_like(template));
        if let Some(place) = known {
            return Ok(place);
        }
        let (template, union) = (template.clone(), template.empty_union());
        self.measures.push(Measure { template, union, known: 0, newest: 0.0 });
        Ok(self.measures.len() - 1)
    }

    /// What the newest effect of the history has gained, given all before it.
    pub fn newest(&mut self, place: usize, history: &History) -> f64 {
        let measure = &mut self.measures[place];
        let dim = history.effect_dim();
        for effect in history.effects()[measure.known * dim..].chunks_exact(dim) {
            measure.newest = measure.union.insert(effect).gain;
        }
        measure.known = history.len();
        measure.newest
    }
}
