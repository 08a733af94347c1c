//! A box of motor commands or goals, and the draws made in it.

use crate::elementary::normal_quantile;
use crate::error::{Error, check_finite, check_length, check_share, reserve};

/// What stands for a draw of 0, half of the least other one: the quantile of 0 is no number.
const LEAST: f64 = 0.25 * f64::EPSILON;

/// A stream of independent numbers uniform in [0, 1): the only randomness there is.
///
/// The caller owns it. Every draw advances it by exactly one number, so that draws made
/// here and elsewhere from the same stream stay in step.
pub trait UniformStream {
    /// The next number.
    fn next(&mut self) -> f64;

    /// The next numbers, in order.
    fn fill(&mut self, numbers: &mut [f64]) {
        for number in numbers {
            *number = self.next();
        }
    }

    /// A whole number from 0 to `n` - 1, for `n` of at least 1: one draw.
    fn below(&mut self, n: usize) -> usize {
        ((self.next() * n as f64) as usize).min(n - 1)
    }

    /// A standard normal number: one draw.
    fn normal(&mut self) -> f64 {
        let u = self.next();
        normal_quantile(if u == 0.0 { LEAST } else { u })
    }
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
        // One pass without an early exit is vector code; the culprit is looked for only when
        // there is one. Written so that a NaN is outside.
        let corners = self.low.iter().zip(&self.high);
        if point
            .iter()
            .zip(corners)
            .fold(true, |all, (x, (low, high))| all & (low <= x) & (x <= high))
        {
            return Ok(());
        }
        for (j, ((&low, &high), &x)) in self.low.iter().zip(&self.high).zip(point).enumerate() {
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

    /// Whether a point of as many coordinates lies in the box.
    pub(crate) fn holds(&self, point: &[f64]) -> bool {
        let corners = self.low.iter().zip(&self.high);
        point.iter().zip(corners).all(|(x, (low, high))| low <= x && x <= high)
    }

    /// Moves a point of as many coordinates to the nearest one in the box.
    pub(crate) fn clip(&self, point: &mut [f64]) {
        for (x, (&low, &high)) in point.iter_mut().zip(self.low.iter().zip(&self.high)) {
            *x = x.max(low).min(high);
        }
    }

    /// A point uniform in the box: one draw a coordinate, in order.
    pub fn sample(&self, stream: &mut (impl UniformStream + ?Sized)) -> Vec<f64> {
        let mut point = vec![0.0; self.dim()];
        self.sample_into(&mut point, stream);
        point
    }

    /// `n` points uniform in the box, row by row: the draws of as many calls of
    /// [`sample`](Self::sample).
    ///
    /// # Errors
    /// If there is no memory for so many; nothing is drawn then.
    pub fn sample_many(
        &self,
        n: usize,
        stream: &mut (impl UniformStream + ?Sized),
    ) -> Result<Vec<f64>, Error> {
        let mut points = Vec::new();
        reserve(&mut points, n, self.dim())?;
        points.resize(n * self.dim(), 0.0);
        for point in points.chunks_exact_mut(self.dim()) {
            self.sample_into(point, stream);
        }
        Ok(points)
    }

    /// Writes what [`sample`](Self::sample) returns; `point` has the right length.
    pub(crate) fn sample_into(
        &self,
        point: &mut [f64],
        stream: &mut (impl UniformStream + ?Sized),
    ) {
        stream.fill(point);
        for (x, (&low, &high)) in point.iter_mut().zip(self.low.iter().zip(&self.high)) {
            *x = between(low, high, *x);
        }
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
        stream: &mut (impl UniformStream + ?Sized),
    ) -> Result<Vec<f64>, Error> {
        check_share("d", d)?;
        self.check("parent", parent)?;
        let mut command = vec![0.0; self.dim()];
        self.perturb_into(&mut command, parent, d, stream);
        Ok(command)
    }

    /// Writes what [`perturb`](Self::perturb) returns, for what is known to be right.
    pub(crate) fn perturb_into(
        &self,
        command: &mut [f64],
        parent: &[f64],
        d: f64,
        stream: &mut (impl UniformStream + ?Sized),
    ) {
        stream.fill(command);
        let ranges = self.low.iter().zip(&self.high);
        for ((x, &around), (&low, &high)) in command.iter_mut().zip(parent).zip(ranges) {
            let reach = d * (high - low);
            *x = between((around - reach).max(low), (around + reach).min(high), *x);
        }
    }
}

/// The number in [`low`, `high`] that a draw `u` from [0, 1) stands for.
#[inline(always)]
fn between(low: f64, high: f64, u: f64) -> f64 {
    // Rounding may carry the sum one unit beyond `high`.
    (low + (high - low) * u).min(high)
}
