//! Bandits: composites that choose by the rewards that their parts earned.
//!
//! A [`Bandit`] has three parts: a [reward](rewards), an estimate of its mean for each part
//! ([estimators]), and a choice ([policies]). ADAPT is one combination: gains, windows, and choices
//! in proportion.

mod bandit;
pub mod estimators;
pub mod policies;
pub mod rewards;

pub use bandit::Bandit;

use crate::error::{Error, check_count, check_number};

/// Checks the number of parts that a bandit chooses among, and the upper bound of the rewards: 0 if
/// there is none.
fn check_start(parts: usize, largest: f64) -> Result<(), Error> {
    check_count("parts", parts)?;
    check_at_least_0("largest", largest)
}

/// Checks that a number is finite and not negative.
fn check_at_least_0(name: &'static str, number: f64) -> Result<(), Error> {
    check_number(name, number, number.is_finite() && number >= 0.0, "finite and not negative")
}

/// Checks that a number is in (0, 1].
fn check_above_0_to_1(name: &'static str, number: f64) -> Result<(), Error> {
    check_number(name, number, 0.0 < number && number <= 1.0, "in (0, 1]")
}
