//! The weighted mean of the commands of the effects nearest to the goal, perturbed.

use super::Observed;
use crate::bounds::UniformStream;
use crate::error::Error;

/// A command between those of the `k` effects nearest to `goal`, perturbed.
///
/// An effect's weight is 1 over its distance; effects that are the goal itself share all of it.
///
/// # Errors
/// If nothing was observed yet, `goal` is not a finite point of the effects' dimension, `k` is 0,
/// `d` is not in [0, 1], or the sizes do not fit; `stream` is then untouched.
pub fn k_nearest(
    goal: &[f64],
    k: usize,
    d: f64,
    observed: &Observed<'_>,
    stream: &mut (impl UniformStream + ?Sized),
) -> Result<Vec<f64>, Error> {
    let found = observed.neighbours(goal, k)?;
    let nearest = found.first().map_or(0.0, |&(distance, _)| distance);
    // As shares of the nearest's weight, which neither overflow nor divide 0 by 0.
    let weight = |distance: f64| if distance > nearest { nearest / distance } else { 1.0 };
    let mut weights: Vec<f64> = found.iter().map(|&(distance, _)| weight(distance)).collect();
    normalize(&mut weights);
    observed.perturbed_mean(&found, &weights, d, stream)
}

/// Makes weights in [0, 1], one of them 1, sum to 1.
pub(super) fn normalize(weights: &mut [f64]) {
    let mut total = 0.0;
    for weight in &*weights {
        total += weight;
    }
    for weight in weights {
        *weight /= total;
    }
}
