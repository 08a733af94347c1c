//! Gains: what each new effect covers, measured once for all bandits that measure alike.

use crate::coverage::Coverage;
use crate::error::{Error, check_length};
use crate::history::History;

/// The unions by which bandits want gains, each brought up to date when one of them is told.
#[derive(Debug, Default)]
pub(super) struct Gains {
    unions: Vec<Coverage>,
}

impl Gains {
    /// Where to ask for gains measured by `template`: two that are alike are one.
    ///
    /// # Errors
    /// If effects have another dimension.
    pub fn of(&mut self, template: &Coverage, effect_dim: usize) -> Result<usize, Error> {
        check_length("measure", &vec![0.0; template.dim()], effect_dim)?;
        let alike = |union: &Coverage| {
            union.tau().to_bits() == template.tau().to_bits()
                && union.dim() == template.dim()
                && union.sampling() == template.sampling()
        };
        if let Some(place) = self.unions.iter().position(alike) {
            return Ok(place);
        }
        self.unions.push(template.clone());
        Ok(self.unions.len() - 1)
    }

    /// What the newest effect of the history has gained, given all before it.
    ///
    /// # Errors
    /// If an effect is not finite.
    pub fn newest(&mut self, place: usize, history: &History) -> Result<f64, Error> {
        let union = &mut self.unions[place];
        let known = union.len() * history.effect_dim();
        for effect in history.effects()[known..].chunks_exact(history.effect_dim()) {
            union.add(effect)?;
        }
        Ok(union.gains().last().copied().unwrap_or(0.0))
    }
}
