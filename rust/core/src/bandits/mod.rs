//! What a bandit believes of its strategies: the mean of the gains that each made lately.

mod exact_sum;
mod window;

pub use exact_sum::ExactSum;
pub use window::GainWindow;
