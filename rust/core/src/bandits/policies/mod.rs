//! Policies: which part a bandit chooses, given the estimates of all.
//!
//! ```
//! use divbandit_core::bandits::policies::{Estimates, PolicyKind};
//!
//! let mut policy = PolicyKind::Proportional { alpha: 0.5, power: 1.0 }.start(2, 6.0).unwrap();
//! let estimates = Estimates { means: &[0.0, 3.0], counts: &[0.0, 1.0], largest: 6.0 };
//! let choice = policy.choose(&estimates, &mut || 0.6);
//! assert_eq!((choice.part, choice.probability), (1, Some(0.75)));
//! ```

mod epsilon_greedy;
mod exp3;
mod exp3s;
mod proportional;
mod round_robin;
mod shares;
mod softmax;
mod thompson;
mod ties;
mod ucb;
mod uniform;

use std::fmt;

use super::estimators::Estimator;
use super::{check_above_0_to_1, check_at_least_0, check_start};
use crate::bounds::UniformStream;
use crate::error::{Error, check_positive, check_share};

pub use proportional::powers;

/// What a policy chooses by: what an estimator holds of each part.
#[derive(Debug, Clone, Copy)]
pub struct Estimates<'a> {
    /// The mean reward of each part.
    pub means: &'a [f64],
    /// The number of rewards behind each mean.
    pub counts: &'a [f64],
    /// Upper bound of the rewards, or of those so far.
    pub largest: f64,
}

impl<'a> Estimates<'a> {
    /// Those of an estimator.
    pub fn of(estimator: &'a (impl Estimator + ?Sized)) -> Self {
        let (means, counts) = (estimator.means(), estimator.counts());
        Self { means, counts, largest: estimator.largest() }
    }
}

/// The part that proposes next.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Choice {
    /// Its index.
    pub part: usize,
    /// The probability with which it was chosen, where the policy knows it.
    pub probability: Option<f64>,
}

impl Choice {
    /// A part that was chosen with a probability that is not known.
    #[must_use]
    pub fn of(part: usize) -> Self {
        Self { part, probability: None }
    }

    /// A part that was chosen with a known probability. Rounding may have carried it beyond 1.
    fn with(part: usize, probability: f64) -> Self {
        Self { part, probability: Some(probability.min(1.0)) }
    }
}

/// A way to choose among parts.
pub trait Policy: fmt::Debug + Send + Sync {
    /// Chooses by the estimates, which hold one mean and one count for each part; all randomness
    /// comes from `draws`.
    ///
    /// # Panics
    /// If the estimates are of another number of parts.
    fn choose(&mut self, estimates: &Estimates<'_>, draws: &mut dyn UniformStream) -> Choice;

    /// Learns what a part has earned, and with which positive probability that choice was made, if
    /// it is known.
    ///
    /// # Panics
    /// If there is no such part.
    fn learn(&mut self, part: usize, reward: f64, probability: Option<f64>) {
        let _ = (part, reward, probability);
    }
}

/// Which policy, and its parameters.
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum PolicyKind {
    /// With probability alpha uniformly at random, else in proportion to the mean reward, or to a
    /// power of it (Benureau and Oudeyer 2015).
    Proportional {
        /// In [0, 1].
        alpha: f64,
        /// Not negative.
        power: f64,
    },
    /// With probability epsilon uniformly at random, else the best mean reward.
    EpsilonGreedy {
        /// In [0, 1].
        epsilon: f64,
    },
    /// In proportion to the exponential of the mean reward.
    Softmax {
        /// Positive.
        temperature: f64,
        /// Whether the temperature is a share of the largest reward.
        scaled: bool,
    },
    /// The largest upper confidence bound.
    Ucb {
        /// Weight of the confidence bound; not negative.
        xi: f64,
    },
    /// Thompson sampling with Gaussian posteriors.
    Thompson,
    /// Weights that grow exponentially with rewards.
    Exp3 {
        /// In (0, 1].
        gamma: f64,
    },
    /// As Exp3, but no weight falls far behind.
    Exp3S {
        /// In (0, 1].
        gamma: f64,
        /// How fast the past is forgotten, in (0, 1].
        alpha: f64,
    },
    /// Each part in turn.
    RoundRobin,
    /// Uniformly at random.
    Uniform,
}

impl PolicyKind {
    /// Starts the policy for so many parts; no reward exceeds `largest`, if that is not 0.
    ///
    /// # Errors
    /// If there are no parts, `largest` is negative or not finite, or a parameter is out of range.
    pub fn start(&self, parts: usize, largest: f64) -> Result<Box<dyn Policy>, Error> {
        check_start(parts, largest)?;
        Ok(match *self {
            Self::Proportional { alpha, power } => {
                check_share("alpha", alpha)?;
                check_at_least_0("power", power)?;
                Box::new(proportional::Proportional::new(alpha, power, parts))
            }
            Self::EpsilonGreedy { epsilon } => {
                check_share("epsilon", epsilon)?;
                Box::new(epsilon_greedy::EpsilonGreedy::new(epsilon, parts))
            }
            Self::Softmax { temperature, scaled } => {
                check_positive("temperature", temperature)?;
                Box::new(softmax::Softmax::new(temperature, scaled, parts))
            }
            Self::Ucb { xi } => {
                check_at_least_0("xi", xi)?;
                Box::new(ucb::Ucb::new(xi, parts))
            }
            Self::Thompson => Box::new(thompson::Thompson),
            Self::Exp3 { gamma } => {
                check_above_0_to_1("gamma", gamma)?;
                Box::new(exp3::Exp3::new(gamma, parts, largest))
            }
            Self::Exp3S { gamma, alpha } => {
                check_above_0_to_1("gamma", gamma)?;
                check_above_0_to_1("alpha", alpha)?;
                Box::new(exp3s::Exp3S::new(gamma, alpha, parts, largest))
            }
            Self::RoundRobin => Box::new(round_robin::RoundRobin::new(parts)),
            Self::Uniform => Box::new(uniform::Uniform::new(parts)),
        })
    }
}
