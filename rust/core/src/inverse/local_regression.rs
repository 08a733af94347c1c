//! Locally weighted linear regression from effects to commands, evaluated at the goal, perturbed.
//!
//! The prediction of a least-squares fit is a weighted sum of what it was fitted to, so no map
//! is computed: with weights v that sum to 1, effects centred at their weighted mean and divided by
//! their spread (f, and g for the goal), and C the covariance of f, the command is the sum of
//! v (1 + f C^-1 g) x. The ridge is added to the diagonal of C: where effects do not spread, as
//! across a line on which all of them lie, nothing is made of their differences.

use nalgebra::{DMatrix, DVector};

use super::Observed;
use super::k_nearest::normalize;
use crate::bounds::UniformStream;
use crate::error::Error;

/// How far the weights reach, in distances of the farthest neighbour: it keeps an eighth.
const BANDWIDTH: f64 = 1.25;

/// What a linear map from the `k` effects nearest to `goal` to their commands makes of `goal`,
/// perturbed.
///
/// The fit is weighted, by (1 - (distance / bandwidth)^2)^2, and regularised: `ridge` is a share of
/// the effects' mean variance. The map is followed to at most `reach` spreads from the effects'
/// weighted mean, where a spread is the root of the mean squared distance from it: beyond, it says
/// little, and a goal far away would have every coordinate at an end of its range. Of effects that are all the same it is the mean of the commands.
///
/// # Errors
/// If nothing was observed yet, `goal` is not a finite point of the effects' dimension, `k` is 0,
/// `ridge` or `reach` is not positive, `d` is not in [0, 1], or the sizes do not fit; `stream` is then
/// untouched.
pub fn local_regression(
    goal: &[f64],
    k: usize,
    ridge: f64,
    reach: f64,
    d: f64,
    observed: &Observed<'_>,
    stream: &mut (impl UniformStream + ?Sized),
) -> Result<Vec<f64>, Error> {
    for (name, got) in [("ridge", ridge), ("reach", reach)] {
        if !(got > 0.0 && got.is_finite()) {
            return Err(Error::Number { name, must_be: "positive and finite", got });
        }
    }
    let found = observed.neighbours(goal, k)?;
    let farthest = found.last().map_or(0.0, |&(distance, _)| distance);
    let kernel = |distance: f64| {
        let share = distance / (BANDWIDTH * farthest);
        let left = 1.0 - share * share;
        left * left
    };
    // Where all distances are 0, or too large for their squares, all effects count alike.
    let alike = !(farthest > 0.0 && (BANDWIDTH * farthest).is_finite());
    let weight = |distance: f64| if alike { 1.0 } else { kernel(distance) };
    let mut weights: Vec<f64> = found.iter().map(|&(distance, _)| weight(distance)).collect();
    normalize(&mut weights);
    let tilted = tilted(goal, ridge, reach, observed, &found, &weights);
    observed.perturbed_mean(&found, tilted.as_ref().unwrap_or(&weights), d, stream)
}

/// The weights, each times 1 + f C^-1 g; None where the effects have no finite spread.
fn tilted(
    goal: &[f64],
    ridge: f64,
    reach: f64,
    observed: &Observed<'_>,
    found: &[(f64, usize)],
    weights: &[f64],
) -> Option<Vec<f64>> {
    let (s, points) = (goal.len(), observed.effects.points());
    // Everything relative to the goal, so that the place does not matter.
    let mut centred = DMatrix::from_fn(s, found.len(), |j, i| points[found[i].1 * s + j] - goal[j]);
    let mut mean = DVector::<f64>::zeros(s);
    for (effect, &weight) in centred.column_iter().zip(weights) {
        for j in 0..s {
            mean[j] += weight * effect[j];
        }
    }
    let mut variance = 0.0;
    for (mut effect, &weight) in centred.column_iter_mut().zip(weights) {
        for j in 0..s {
            effect[j] -= mean[j];
            variance += weight * (effect[j] * effect[j]);
        }
    }
    let spread = (variance / s as f64).sqrt();
    if !(spread > 0.0 && spread.is_finite()) {
        return None;
    }
    for x in centred.iter_mut() {
        *x /= spread;
    }
    // Plain sums: a matrix product could be computed otherwise on another CPU.
    let mut covariance = DMatrix::from_diagonal_element(s, s, ridge);
    for (effect, &weight) in centred.column_iter().zip(weights) {
        for j in 0..s {
            for l in 0..s {
                covariance[(j, l)] += weight * (effect[j] * effect[l]);
            }
        }
    }
    let mut offset = mean.map(|x| -x / spread);
    let mut squared = 0.0;
    for j in 0..s {
        squared += offset[j] * offset[j];
    }
    let farthest = reach * (s as f64).sqrt();
    if squared.sqrt() > farthest {
        offset *= farthest / squared.sqrt();
    }
    let slopes = covariance.cholesky()?.solve(&offset);
    let mut tilted = Vec::with_capacity(weights.len());
    for (effect, &weight) in centred.column_iter().zip(weights) {
        let mut slope = 1.0;
        for j in 0..s {
            slope += effect[j] * slopes[j];
        }
        tilted.push(weight * slope);
    }
    tilted.iter().all(|weight| weight.is_finite()).then_some(tilted)
}
