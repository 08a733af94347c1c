//! Locally weighted linear regression from effects to commands, evaluated at the goal, perturbed.
//!
//! The prediction of a least-squares fit is a weighted sum of what it was fitted to, so no map is
//! computed: with weights v that sum to 1, effects centred at their weighted mean and divided by
//! their spread (f, and g for the goal), and C the covariance of f, the command is the sum of
//! v (1 + f C^-1 g) x. The ridge is added to the diagonal of C: where effects do not spread, as
//! across a line on which all of them lie, their differences are ignored.

use nalgebra::{DMatrix, DVector};

use super::mean::{normalize, perturbed_mean};
use super::{InverseModel, Observed};
use crate::bounds::UniformStream;
use crate::error::{Error, check_count, check_positive, check_share};
use crate::history::History;

/// How far the weights reach, in distances of the farthest neighbour: it keeps an eighth.
const BANDWIDTH: f64 = 1.25;

/// What a linear map from the k effects nearest to the goal to their commands makes of the goal,
/// perturbed.
///
/// The fit is weighted, by (1 - (distance / bandwidth)^2)^2, and regularised: the ridge is a share
/// of the effects' mean variance. The map is followed to at most the reach, in spreads, from the
/// effects' weighted mean, where a spread is the root of the mean squared distance from it: beyond,
/// it says little, and a goal far away would have every coordinate at an end of its range. If all
/// effects are equal, it is the mean of the commands.
#[derive(Debug, Clone)]
pub struct LocalRegression {
    k: usize,
    ridge: f64,
    reach: f64,
    d: f64,
    found: Vec<(f64, usize)>,
    weights: Vec<f64>,
    fit: Fit,
    mean: Vec<f64>,
}

/// What a fit is computed in, kept from one to the next.
#[derive(Debug, Clone)]
struct Fit {
    /// The effects around their weighted mean, in spreads; row by row.
    centred: Vec<f64>,
    mean: Vec<f64>,
    covariance: DMatrix<f64>,
    /// The goal, as far as the reach, and then the slopes towards it.
    offset: DVector<f64>,
    /// The weights, each times 1 + f C^-1 g.
    tilted: Vec<f64>,
}

impl LocalRegression {
    /// Of `k` effects - of all where there are fewer - with `ridge`, followed to `reach`, perturbed
    /// by up to the share `d` of each motor range.
    ///
    /// # Errors
    /// If `k` is 0, `ridge` or `reach` is not positive and finite, or `d` is not in [0, 1].
    pub fn new(k: usize, d: f64, ridge: f64, reach: f64) -> Result<Self, Error> {
        check_count("k", k)?;
        check_share("d", d)?;
        check_positive("ridge", ridge)?;
        check_positive("reach", reach)?;
        let fit = Fit {
            centred: Vec::new(),
            mean: Vec::new(),
            covariance: DMatrix::zeros(0, 0),
            offset: DVector::zeros(0),
            tilted: Vec::new(),
        };
        let (found, weights, mean) = (Vec::new(), Vec::new(), Vec::new());
        Ok(Self { k, ridge, reach, d, found, weights, fit, mean })
    }
}

impl InverseModel for LocalRegression {
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
        let farthest = self.found.last().map_or(0.0, |&(distance, _)| distance);
        let kernel = |distance: f64| {
            let share = distance / (BANDWIDTH * farthest);
            let left = 1.0 - share * share;
            left * left
        };
        // Where all distances are 0, or too large for their squares, all effects count alike.
        let alike = !(farthest > 0.0 && (BANDWIDTH * farthest).is_finite());
        let weight = |distance: f64| if alike { 1.0 } else { kernel(distance) };
        self.weights.clear();
        self.weights.extend(self.found.iter().map(|&(distance, _)| weight(distance)));
        normalize(&mut self.weights);
        let (found, weights, mean) = (&self.found, &self.weights, &mut self.mean);
        let is_fitted = self.fit.tilt(goal, self.ridge, self.reach, &observed, found, weights);
        let weights = if is_fitted { &self.fit.tilted } else { weights };
        perturbed_mean(&observed, found, weights, self.d, draws, mean, command);
        Ok(())
    }
}

impl Fit {
    /// Tilts the weights; says whether that could be done: not where the effects have no finite
    /// spread.
    fn tilt(
        &mut self,
        goal: &[f64],
        ridge: f64,
        reach: f64,
        observed: &Observed<'_>,
        found: &[(f64, usize)],
        weights: &[f64],
    ) -> bool {
        let (s, points) = (goal.len(), observed.effects.points());
        // Everything relative to the goal, so that the place does not matter.
        self.centred.clear();
        for &(_, index) in found {
            let effect = &points[index * s..][..s];
            self.centred.extend(effect.iter().zip(goal).map(|(y, g)| y - g));
        }
        self.mean.clear();
        self.mean.resize(s, 0.0);
        for (effect, &weight) in self.centred.chunks_exact(s).zip(weights) {
            self.mean.iter_mut().zip(effect).for_each(|(sum, y)| *sum += weight * y);
        }
        let mut variance = 0.0;
        for (effect, &weight) in self.centred.chunks_exact_mut(s).zip(weights) {
            for (y, mean) in effect.iter_mut().zip(&self.mean) {
                *y -= mean;
                variance += weight * (*y * *y);
            }
        }
        let spread = (variance / s as f64).sqrt();
        if !(spread > 0.0 && spread.is_finite()) {
            return false;
        }
        self.centred.iter_mut().for_each(|y| *y /= spread);
        if self.offset.len() != s {
            self.offset = DVector::zeros(s);
        }
        let mut squared = 0.0;
        for (x, mean) in self.offset.iter_mut().zip(&self.mean) {
            *x = -mean / spread;
            squared += *x * *x;
        }
        let farthest = reach * (s as f64).sqrt();
        if squared.sqrt() > farthest {
            self.offset *= farthest / squared.sqrt();
        }
        if !self.solve(ridge, weights) {
            return false;
        }
        self.tilted.clear();
        for (effect, &weight) in self.centred.chunks_exact(s).zip(weights) {
            let mut slope = 1.0;
            for (y, along) in effect.iter().zip(&self.offset) {
                slope += y * along;
            }
            self.tilted.push(weight * slope);
        }
        self.tilted.iter().all(|weight| weight.is_finite())
    }

    /// Makes slopes of the offset; says whether that could be done.
    fn solve(&mut self, ridge: f64, weights: &[f64]) -> bool {
        let s = self.offset.len();
        // Taken apart by the factorisation, which gives it back.
        let mut covariance = std::mem::replace(&mut self.covariance, DMatrix::zeros(0, 0));
        if covariance.nrows() != s {
            covariance = DMatrix::zeros(s, s);
        }
        // Plain sums: a matrix product could be computed otherwise on another CPU.
        covariance.fill(0.0);
        covariance.fill_diagonal(ridge);
        for (effect, &weight) in self.centred.chunks_exact(s).zip(weights) {
            for j in 0..s {
                for l in 0..s {
                    covariance[(j, l)] += weight * (effect[j] * effect[l]);
                }
            }
        }
        let Some(factor) = covariance.cholesky() else { return false };
        factor.solve_mut(&mut self.offset);
        self.covariance = factor.unpack_dirty();
        true
    }
}
