//! Bandits: composites that choose by the rewards that their parts earned.
//!
//! A [`Bandit`] has three parts: what is [rewarded](rewards), what is remembered of it
//! ([estimators]), and who is chosen ([policies]). ADAPT is one combination: gains, windows, and
//! choices in proportion.

mod bandit;
pub mod estimators;
mod exact_sum;
pub mod policies;
pub mod rewards;

pub use bandit::Bandit;
pub use exact_sum::ExactSum;
