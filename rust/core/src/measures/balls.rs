//! The volume of the union of balls around effects: the paper's diversity, without a log.
//!
//! C_tau(E), as [`Coverage`] finds it (Benureau and Oudeyer, ICDL-EpiRob 2015), of which only the
//! union and its measure are kept: the effects are in the history.

use super::Measure;
use crate::coverage::{Coverage, Sampling, Union};
use crate::error::Error;
use crate::exact_sum::ExactSum;

/// What the random numbers of an estimate are made from, in more than three dimensions:
/// `numpy.random.default_rng(0).random() * 2**53`, as `divbandit.Coverage(..., rng=0)` has it.
pub const KEY: u64 = 5_737_240_835_340_368;

/// A union of balls.
#[derive(Debug)]
pub(super) struct Balls {
    dim: usize,
    len: usize,
    union: Union,
    ball: f64,
    measure: ExactSum,
}

impl Balls {
    pub fn new(tau: f64, accuracy: f64, dim: usize) -> Result<Self, Error> {
        let empty = Coverage::sampled(tau, dim, Sampling { accuracy, key: KEY })?;
        let (union, ball) = (empty.empty_union(), empty.ball());
        Ok(Self { dim, len: 0, union, ball, measure: ExactSum::default() })
    }
}

impl Measure for Balls {
    fn dim(&self) -> usize {
        self.dim
    }

    fn len(&self) -> usize {
        self.len
    }

    fn largest_gain(&self) -> f64 {
        self.ball
    }

    fn measure(&self) -> f64 {
        self.measure.value()
    }

    fn check(&self, _name: &'static str, _effects: &[f64]) -> Result<(), Error> {
        Ok(())
    }

    fn gain(&mut self, effect: &[f64]) -> f64 {
        self.union.gain(effect).gain
    }

    fn add(&mut self, effect: &[f64]) -> f64 {
        let gain = self.union.insert(effect).gain;
        self.measure.add(gain);
        self.len += 1;
        gain
    }
}
