//! One union of equal balls, by the kernel of its dimension.

use super::estimate::{Estimate, Estimated};
use super::line::Intervals;
use super::plane::Discs;
use super::space::Balls;

/// Highest dimension of effects.
pub(crate) const HIGHEST: usize = 32;

/// What only an estimate needs: from four dimensions on.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Sampling {
    /// The standard error that each gain is to have at most, as a share of a ball's measure,
    /// in (0, 1).
    pub accuracy: f64,
    /// Decides all randomness.
    pub key: u64,
}

impl Default for Sampling {
    fn default() -> Self {
        Self { accuracy: 1e-3, key: 0 }
    }
}

/// The kernels behind one interface. All gains are exact but the estimate's.
#[derive(Debug, Clone)]
pub(crate) enum Union {
    Line(Box<Intervals>),
    Plane(Box<Discs>),
    Space(Box<Balls>),
    Many(Box<Estimate>),
}

fn exactly(gain: f64) -> Estimated {
    Estimated { gain, standard_error: 0.0 }
}

impl Union {
    /// The empty union of balls of radius `tau` in `dim` dimensions, 1 to [`HIGHEST`].
    pub fn new(tau: f64, dim: usize, sampling: Sampling) -> Self {
        match dim {
            1 => Self::Line(Box::new(Intervals::new(tau))),
            2 => Self::Plane(Box::new(Discs::new(tau))),
            3 => Self::Space(Box::new(Balls::new(tau))),
            _ => {
                let Sampling { accuracy, key } = sampling;
                Self::Many(Box::new(Estimate::new(tau, dim, accuracy, key)))
            }
        }
    }

    /// The measure that a ball around `effect`, of the right length, would add.
    pub fn gain(&mut self, effect: &[f64]) -> Estimated {
        match (self, effect) {
            (Self::Line(line), &[x, ..]) => exactly(line.gain(x)),
            (Self::Plane(plane), &[x, y, ..]) => exactly(plane.gain([x, y])),
            (Self::Space(space), &[x, y, z, ..]) => exactly(space.gain([x, y, z])),
            (Self::Many(many), effect) => many.gain(effect),
            _ => exactly(0.0),
        }
    }

    /// Adds a ball; returns the measure that it adds.
    pub fn insert(&mut self, effect: &[f64]) -> Estimated {
        match (self, effect) {
            (Self::Line(line), &[x, ..]) => exactly(line.insert(x)),
            (Self::Plane(plane), &[x, y, ..]) => exactly(plane.insert([x, y])),
            (Self::Space(space), &[x, y, z, ..]) => exactly(space.insert([x, y, z])),
            (Self::Many(many), effect) => many.insert(effect),
            _ => exactly(0.0),
        }
    }

    /// Adds a ball whose gain is known, without finding it again where that is dear and nothing
    /// else needs it. Returns the gain, or what it should have been.
    pub fn replay(&mut self, effect: &[f64], known: Estimated) -> Estimated {
        match (self, effect) {
            (Self::Space(space), &[x, y, z, ..]) => {
                if known.gain > 0.0 {
                    space.replay([x, y, z]);
                }
                known
            }
            (Self::Many(many), effect) => {
                many.replay(effect);
                known
            }
            (union, effect) => union.insert(effect),
        }
    }

    /// The measure of one ball.
    pub fn ball(&self, tau: f64) -> f64 {
        match self {
            Self::Line(_) => 2.0 * tau,
            Self::Plane(_) => std::f64::consts::PI * tau * tau,
            Self::Space(_) => super::space::ball(tau),
            Self::Many(many) => many.ball(),
        }
    }
}
