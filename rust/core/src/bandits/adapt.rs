//! Adapt: the paper's algorithm, strategies chosen in proportion to their diversity.

use super::window::GainWindow;
use crate::bounds::UniformStream;
use crate::coverage::Coverage;
use crate::elementary;
use crate::error::Error;
use crate::strategies::{Composite, proportionally};

/// The longest window: its gains are kept one by one.
const LONGEST: usize = 1_000_000;

/// ADAPT(w, tau, alpha): with probability alpha a part uniformly at random, otherwise in
/// proportion to the mean gain of its last w effects, or to a power of it. Two draws.
#[derive(Debug, Clone)]
pub struct Adapt {
    measure: Coverage,
    alpha: f64,
    power: f64,
    windows: Vec<GainWindow>,
    diversities: Vec<f64>,
}

impl Adapt {
    /// Over so many `parts`, measuring gains by `measure`, which is empty. `head_start` gains of a
    /// whole ball come first in each window.
    ///
    /// # Errors
    /// If there are no parts, `measure` holds effects, `window` is not from 1 to a million,
    /// `alpha` is not in [0, 1], or the head start is longer than the window.
    pub fn new(
        parts: usize,
        measure: Coverage,
        window: usize,
        alpha: f64,
        head_start: usize,
    ) -> Result<Self, Error> {
        let count = |name, must_be: &str, got| Error::Count { name, must_be: must_be.into(), got };
        if parts == 0 {
            return Err(count("parts", "at least 1", parts));
        }
        if !measure.is_empty() {
            return Err(count("measure", "empty", measure.len()));
        }
        if !(1..=LONGEST).contains(&window) {
            return Err(count("window", "from 1 to 1000000", window));
        }
        if !(0.0..=1.0).contains(&alpha) {
            return Err(Error::Number { name: "alpha", must_be: "in [0, 1]", got: alpha });
        }
        if head_start > window {
            return Err(count("head_start", "at most the window", head_start));
        }
        let window = GainWindow::new(window, measure.ball(), head_start);
        Ok(Self {
            measure,
            alpha,
            power: 1.0,
            diversities: vec![window.mean(); parts],
            windows: vec![window; parts],
        })
    }

    /// Chooses in proportion to this power of the mean gains.
    ///
    /// # Errors
    /// If `power` is negative or not finite.
    pub fn with_power(mut self, power: f64) -> Result<Self, Error> {
        if !(power.is_finite() && power >= 0.0) {
            let must_be = "finite and not negative";
            return Err(Error::Number { name: "power", must_be, got: power });
        }
        self.power = power;
        Ok(self)
    }

    /// What a mean gain counts, the largest of which is `top`, more than 0: the share of it to the
    /// power, so that nothing overflows, nor all of them vanish.
    fn weight(&self, mean: f64, top: f64) -> f64 {
        if mean > 0.0 { elementary::power(mean / top, self.power) } else { 0.0 }
    }
}

impl Composite for Adapt {
    fn parts(&self) -> usize {
        self.windows.len()
    }

    fn choose(&mut self, draws: &mut dyn UniformStream) -> usize {
        let uniformly = draws.next() < self.alpha;
        let u = draws.next();
        if uniformly {
            return (u * self.parts() as f64) as usize;
        }
        let positive = self.diversities.iter().map(|mean| mean.max(0.0));
        if self.power == 1.0 {
            return proportionally(positive, u);
        }
        let top = positive.clone().fold(0.0, f64::max);
        proportionally(self.diversities.iter().map(|&mean| self.weight(mean, top)), u)
    }

    fn measure(&self) -> Option<&Coverage> {
        Some(&self.measure)
    }

    fn credit(&mut self, part: usize, gain: f64) {
        self.windows[part].add(gain);
        self.diversities[part] = self.windows[part].mean();
    }

    fn diversities(&self) -> Option<&[f64]> {
        Some(&self.diversities)
    }
}
