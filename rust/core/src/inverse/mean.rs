//! Weighted means of the commands of a few effects, perturbed.

use super::Observed;
use crate::bounds::UniformStream;

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

/// Writes the sum of the commands of the effects `found`, each times its weight, clipped to the
/// motor space and perturbed by up to `d` of its ranges.
///
/// The weights sum to 1; then the sum is taken around the first command, which comes back exactly
/// where all are the same. `mean` is overwritten.
pub(super) fn perturbed_mean(
    observed: &Observed<'_>,
    found: &[(f64, usize)],
    weights: &[f64],
    d: f64,
    draws: &mut dyn UniformStream,
    mean: &mut Vec<f64>,
    command: &mut [f64],
) {
    let first = observed.command(found.first().map_or(0, |&(_, index)| index));
    mean.clear();
    mean.extend_from_slice(first);
    for (&(_, index), weight) in found.iter().zip(weights) {
        for ((sum, x), at) in mean.iter_mut().zip(observed.command(index)).zip(first) {
            *sum += weight * (x - at);
        }
    }
    if mean.iter().any(|x| !x.is_finite()) {
        mean.copy_from_slice(first);
    }
    observed.motor_space.clip(mean);
    observed.motor_space.perturb_into(command, mean, d, draws);
}
