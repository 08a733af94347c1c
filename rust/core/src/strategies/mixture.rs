//! Mixture: strategies chosen with fixed probabilities.

use super::{Choice, Composite, proportionally, total_of};
use crate::bounds::UniformStream;
use crate::error::{Error, check_each, check_finite, check_positive};

/// Part j with a probability proportional to its weight, always: one draw.
#[derive(Debug, Clone)]
pub struct Mixture {
    weights: Vec<f64>,
}

impl Mixture {
    /// Of parts with these weights.
    ///
    /// # Errors
    /// If there is none, one is negative or not finite, or their sum is not positive and finite.
    pub fn new(weights: Vec<f64>) -> Result<Self, Error> {
        if weights.is_empty() {
            return Err(Error::Empty { name: "weights" });
        }
        check_finite("weights", &weights, weights.len())?;
        check_each("weights", &weights, weights.len(), "not negative", |weight| weight >= 0.0)?;
        let total = total_of(weights.iter().copied());
        check_positive("the sum of weights", total)?;
        Ok(Self { weights })
    }
}

impl Composite for Mixture {
    fn parts(&self) -> usize {
        self.weights.len()
    }

    fn choose(&mut self, draws: &mut dyn UniformStream) -> Choice {
        Choice::of(proportionally(self.weights.iter().copied(), draws.next()))
    }
}
