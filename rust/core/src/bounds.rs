//! A box of motor commands or goals, and the draws made in it.

use crate::error::{Error, check_finite, check_length};

/// A stream of independent numbers uniform in [0, 1): the only randomness there is.
///
/// The caller owns it. Every draw advances it by exactly one number, so that draws made
/// here and elsewhere from the same stream stay in step.
pub trait UniformStream {
    /// The next number.
    fn next(&mut self) -> f64;
}

impl<F: FnMut() -> f64> UniformStream for F {
    fn next(&mut self) -> f64 {
        self()
    }
}

/// The points between a lowest and a highest corner.
#[derive(Debug, Clone, PartialEq)]
pub struct Bounds {
    low: Vec<f64>,
    high: Vec<f64>,
}

impl Bounds {
    /// The box [`low`, `high`].
    ///
    /// # Errors
    /// If the corners are empty, not finite or of different lengths, `low` is above `high`
    /// somewhere, or an edge is too long for a number.
    pub fn new(low: Vec<f64>, high: Vec<f64>) -> Result<Self, Error> {
        if low.is_empty() {
            return Err(Error::Empty { name: "low" });
        }
        check_finite("low", &low, low.len())?;
        check_length("high", &high, low.len())?;
        check_finite("high", &high, high.len())?;
        for (j, (&a, &b)) in low.iter().zip(&high).enumerate() {
            if a > b || !(b - a).is_finite() {
                return Err(Error::Element {
                    name: "low",
                    at: format!("[{j}]"),
                    must_be: format!("at most high[{j}] = {b:?}, and not farther than 1e308 below"),
                    got: a,
                });
            }
        }
        Ok(Self { low, high })
    }

    /// The number of coordinates.
    #[must_use]
    pub fn dim(&self) -> usize {
        self.low.len()
    }

    /// The lowest corner.
    #[must_use]
    pub fn low(&self) -> &[f64] {
        &self.low
    }

    /// The highest corner.
    #[must_use]
    pub fn high(&self) -> &[f64] {
        &self.high
    }

    /// Checks that `point`, called `name`, lies in the box.
    ///
    /// # Errors
    /// If it does not, or has another length.
    pub fn check(&self, name: &'static str, point: &[f64]) -> Result<(), Error> {
        check_length(name, point, self.dim())?;
        for (j, ((&low, &high), &x)) in self.low.iter().zip(&self.high).zip(point).enumerate() {
            // Written so that a NaN is outside.
            if !(low <= x && x <= high) {
                return Err(Error::Element {
                    name,
                    at: format!("[{j}]"),
                    must_be: format!("in the range [{low:?}, {high:?}]"),
                    got: x,
                });
            }
        }
        Ok(())
    }

    /// A point uniform in the box: one draw a coordinate, in order.
    pub fn sample(&self, stream: &mut impl UniformStream) -> Vec<f64> {
        self.low.iter().zip(&self.high).map(|(&low, &high)| between(low, high, stream)).collect()
    }

    /// Perturb_d, the paper's exploration around a known command.
    ///
    /// Each coordinate is uniform in [max(a, x - d (b - a)), min(b, x + d (b - a))], where
    /// [a, b] is its range: one draw a coordinate, in order.
    ///
    /// # Errors
    /// If `d` is not in [0, 1], or `parent` is no point of the box; nothing is drawn then.
    pub fn perturb(
        &self,
        parent: &[f64],
        d: f64,
        stream: &mut impl UniformStream,
    ) -> Result<Vec<f64>, Error> {
        if !(0.0..=1.0).contains(&d) {
            return Err(Error::Number { name: "d", must_be: "in [0, 1]", got: d });
        }
        self.check("parent", parent)?;
        let ranges = self.low.iter().zip(&self.high);
        let perturbed = parent.iter().zip(ranges).map(|(&x, (&low, &high))| {
            let reach = d * (high - low);
            between((x - reach).max(low), (x + reach).min(high), stream)
        });
        Ok(perturbed.collect())
    }
}

/// A number uniform in [`low`, `high`], from one draw.
#[inline]
fn between(low: f64, high: f64, stream: &mut impl UniformStream) -> f64 {
    // Rounding may carry the sum one unit beyond `high`.
    (low + (high - low) * stream.next()).min(high)
}
