//! Elementary functions with the same bits on every platform.
//!
//! A platform's own differ in the last bit from one C library to another, and trajectories with
//! them. These are `libm`'s, a fixed sequence of plain operations. What is not a number, or lies
//! outside of a function's domain, gives what it gives there: NaN, or an infinity.
//!
//! ```
//! use divbandit_core::elementary::{exp, log, normal_quantile, power};
//!
//! assert_eq!(exp(0.0), 1.0);
//! assert_eq!(log(1.0), 0.0);
//! assert_eq!(power(9.0, 0.5), 3.0);
//! assert_eq!(normal_quantile(0.5), 0.0);
//! ```

mod normal;

pub use normal::quantile as normal_quantile;

/// e to the power of `x`.
#[must_use]
pub fn exp(x: f64) -> f64 {
    libm::exp(x)
}

/// The natural logarithm of `x`.
#[must_use]
pub fn log(x: f64) -> f64 {
    libm::log(x)
}

/// `base` to the power of `exponent`.
#[must_use]
pub fn power(base: f64, exponent: f64) -> f64 {
    libm::pow(base, exponent)
}
