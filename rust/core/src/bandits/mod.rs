//! Bandits, as the engine runs them: composites that choose by the gains that their parts made
//! lately.

mod adapt;
mod exact_sum;
mod window;

pub use adapt::Adapt;
pub use exact_sum::ExactSum;
pub use window::GainWindow;
