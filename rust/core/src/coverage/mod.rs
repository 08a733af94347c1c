//! The diversity measure: what a growing set of effects covers.

pub mod estimate;
mod plane;
pub mod space;
mod sum;

use crate::error::{Error, check_finite, check_length, check_rows};
use plane::Discs;
use sum::CompensatedSum;

/// The union of the discs of radius tau around effects in the plane.
#[derive(Debug, Clone)]
pub struct Coverage {
    tau: f64,
    len: usize,
    measure: CompensatedSum,
    discs: Discs,
}

impl Coverage {
    /// The empty union of discs of radius `tau`.
    ///
    /// # Errors
    /// If `tau` is not in [1e-100, 1e100]: its square must be a normal number.
    pub fn new(tau: f64) -> Result<Self, Error> {
        if !(1e-100..=1e100).contains(&tau) {
            return Err(Error::Number {
                name: "tau",
                must_be: "a positive radius in [1e-100, 1e100]",
                got: tau,
            });
        }
        Ok(Self { tau, len: 0, measure: CompensatedSum::default(), discs: Discs::new(tau) })
    }

    /// The radius of the discs.
    #[must_use]
    pub fn tau(&self) -> f64 {
        self.tau
    }

    /// How many effects have been added.
    #[must_use]
    pub fn len(&self) -> usize {
        self.len
    }

    /// Whether none has.
    #[must_use]
    pub fn is_empty(&self) -> bool {
        self.len == 0
    }

    /// How many discs had to be stored: the others lay wholly in the union.
    #[must_use]
    pub fn stored(&self) -> usize {
        self.discs.live()
    }

    /// The area of the union.
    #[must_use]
    pub fn measure(&self) -> f64 {
        self.measure.total()
    }

    /// The area of one disc, which no gain exceeds.
    #[must_use]
    pub fn disc_area(&self) -> f64 {
        std::f64::consts::PI * self.tau * self.tau
    }

    /// The area that `effect` would add, without adding it.
    ///
    /// # Errors
    /// If `effect` is not finite.
    pub fn gain(&mut self, effect: [f64; 2]) -> Result<f64, Error> {
        check_finite("effect", &effect, 2)?;
        Ok(self.discs.gain(effect))
    }

    /// Adds an effect and returns its gain, the area that it adds.
    ///
    /// # Errors
    /// If `effect` is not finite; nothing is added then.
    pub fn add(&mut self, effect: [f64; 2]) -> Result<f64, Error> {
        check_finite("effect", &effect, 2)?;
        Ok(self.insert(effect))
    }

    /// Adds effects (x and y of each in turn) and writes the gain of each.
    ///
    /// # Errors
    /// If one of them is not finite, `effects` does not hold whole pairs or `gains` not one
    /// number for each; nothing is added then.
    pub fn extend(&mut self, effects: &[f64], gains: &mut [f64]) -> Result<(), Error> {
        check_rows("effects", effects, 2)?;
        check_length("gains", gains, effects.len() / 2)?;
        check_finite("effects", effects, 2)?;
        for (gain, effect) in gains.iter_mut().zip(effects.chunks_exact(2)) {
            *gain = self.insert([effect[0], effect[1]]);
        }
        Ok(())
    }

    fn insert(&mut self, effect: [f64; 2]) -> f64 {
        let gain = self.discs.insert(effect);
        self.len += 1;
        self.measure.add(gain);
        gain
    }

    /// The area enclosed by the exposed arcs, from scratch.
    #[must_use]
    pub fn boundary_integral(&self) -> f64 {
        self.discs.boundary_integral()
    }
}
