//! The weighted mean of the commands of the effects nearest to the goal, perturbed.

use super::InverseModel;
use super::mean::{normalize, perturbed_mean};
use crate::bounds::UniformStream;
use crate::error::{Error, check_count, check_share};
use crate::history::History;

/// A command between those of the k effects nearest to the goal - of all where there are fewer -,
/// perturbed.
///
/// An effect's weight is 1 over its distance; effects at the goal itself share all the weight.
#[derive(Debug, Clone)]
pub struct KNearest {
    k: usize,
    d: f64,
    found: Vec<(f64, usize)>,
    weights: Vec<f64>,
    mean: Vec<f64>,
}

impl KNearest {
    /// Of `k` effects, perturbed by up to the share `d` of each motor range.
    ///
    /// # Errors
    /// If `k` is 0, or `d` is not in [0, 1].
    pub fn new(k: usize, d: f64) -> Result<Self, Error> {
        check_count("k", k)?;
        check_share("d", d)?;
        Ok(Self { k, d, found: Vec::new(), weights: Vec::new(), mean: Vec::new() })
    }
}

impl InverseModel for KNearest {
    fn command(
        &mut self,
        goal: &[f64],
        history: &mut History,
        draws: &mut dyn UniformStream,
        command: &mut [f64],
    ) -> Result<(), Error> {
        let observed = history.observed()?;
        observed.check(goal, command)?;
        let k = self.k.min(observed.effects.len());
        observed.effects.nearest_k_into(goal, k, &mut self.found)?;
        let nearest = self.found.first().map_or(0.0, |&(distance, _)| distance);
        // As shares of the nearest's weight, which neither overflow nor divide 0 by 0.
        let weight = |distance: f64| if distance > nearest { nearest / distance } else { 1.0 };
        self.weights.clear();
        self.weights.extend(self.found.iter().map(|&(distance, _)| weight(distance)));
        normalize(&mut self.weights);
        let (found, weights, mean) = (&self.found, &self.weights, &mut self.mean);
        perturbed_mean(&observed, found, weights, self.d, draws, mean, command);
        Ok(())
    }
}
