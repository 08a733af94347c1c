//! A local linear model from commands to effects, and a short step in it towards the goal.
//!
//! Where commands have more coordinates than effects, similar effects come from very different
//! commands, and a map fitted across them means nothing. So the model is fitted around one command,
//! that of the nearest effect, to the commands next to it in *motor* space.
//!
//! With u the directions to these neighbours (unit vectors, in shares of the motor ranges), v how
//! the effects change along them, and D the distances, the Jacobian is J = v^T (u u^T + R)^-1 u: of
//! all matrices that agree with the neighbours as far as the ridge R lets them, the smallest. R is
//! diagonal, the ridge times (D / nearest D)^2: what is far counts less, as the environment is
//! curved. The step is the damped least-squares solution of J step = goal - effect.
//!
//! The systems are small - a row for each neighbour, or effect coordinate - and solved by a
//! Cholesky factorisation written out here: its sums have one order, whatever the CPU or the
//! version of a library.

use super::{InverseModel, Observed};
use crate::bounds::UniformStream;
use crate::error::{Error, check_count, check_positive, check_share};
use crate::history::History;
use crate::kdtree::nearer;

/// Squared distances between commands, in shares of the motor ranges, below which they count as
/// the same: the squares of what is smaller lose digits.
const SAME: f64 = 1e-280;

/// What is added to the diagonal of J J^T, as a share of its trace.
const DAMPING: f64 = 1e-6;

/// The least that a pivot of a factorisation may be; the matrices have diagonals of the order of 1.
const LEAST_PIVOT: f64 = 1e-12;

/// Coordinates that are a line of memory.
const AT_ONCE: usize = 8;

/// The command of the nearest effect, moved by a step in the model and perturbed.
///
/// The step is cut to a root mean square of the reach, a share of the motor ranges, and perturbed
/// by up to the noise, a share of its own root mean square. Where nothing can be fitted, the command
/// is perturbed by up to the noise times the reach. No setting depends on the units of commands or
/// effects.
#[derive(Debug, Clone)]
pub struct LocalJacobian {
    k: usize,
    used: usize,
    ridge: f64,
    reach: f64,
    noise: f64,
    found: Vec<(f64, usize)>,
    near: Vec<(f64, usize)>,
    fit: Fit,
}

/// What a model is computed in, kept from one to the next: matrices row by row.
#[derive(Debug, Clone, Default)]
struct Fit {
    /// 1 over the motor ranges; 0 for a range that is a point, or so narrow that it has no
    /// reciprocal: it is left alone.
    shares: Vec<f64>,
    directions: Vec<f64>,
    changes: Vec<f64>,
    gram: Vec<f64>,
    jacobian: Vec<f64>,
    squares: Vec<f64>,
    error: Vec<f64>,
    /// In shares of the motor ranges, and then the command that it leads to.
    step: Vec<f64>,
}

impl LocalJacobian {
    /// Of the `k` effects nearest to the goal, the nearest itself excluded, the `used` whose
    /// commands are nearest to that one's are fitted, with `ridge`; the step is at most `reach` and
    /// its perturbation `noise` of it.
    ///
    /// # Errors
    /// If a count is 0, `ridge` is not positive and finite, or `reach` or `noise` are not in
    /// [0, 1].
    pub fn new(k: usize, used: usize, ridge: f64, reach: f64, noise: f64) -> Result<Self, Error> {
        check_count("k", k)?;
        check_count("used", used)?;
        check_positive("ridge", ridge)?;
        check_share("reach", reach)?;
        check_share("noise", noise)?;
        let (found, near, fit) = (Vec::new(), Vec::new(), Fit::default());
        Ok(Self { k, used, ridge, reach, noise, found, near, fit })
    }
}

impl InverseModel for LocalJacobian {
    fn command(
        &mut self,
        goal: &[f64],
        history: &mut History,
        draws: &mut dyn UniformStream,
        command: &mut [f64],
    ) -> Result<(), Error> {
        let observed = history.observed()?;
        observed.check(goal, command)?;
        let k = self.k.saturating_add(1).min(observed.effects.len());
        observed.effects.nearest_k_squared(goal, k, &mut self.found)?;
        let nearest = self.found.iter().copied().min_by(nearer);
        let base = nearest.map_or(0, |(_, index)| index);

        let space = observed.motor_space;
        let corners = || space.low().iter().zip(space.high());
        self.fit.shares.clear();
        self.fit.shares.extend(corners().map(|(low, high)| {
            let share = 1.0 / (high - low);
            if share.is_finite() { share } else { 0.0 }
        }));
        self.find_near(base, &observed);
        let length = self.fit.step(goal, base, &self.near, self.ridge, self.reach, &observed);
        let (centre, parent) = (&mut self.fit.step, observed.command(base));
        if length.is_none() {
            centre.clear();
            centre.extend_from_slice(parent);
        } else {
            for ((x, at), (&low, &high)) in centre.iter_mut().zip(parent).zip(corners()) {
                *x = (at + *x * (high - low)).max(low).min(high);
            }
        }
        let d = self.noise * length.unwrap_or(self.reach);
        space.perturb_into(command, centre, d, draws);
        Ok(())
    }
}

impl LocalJacobian {
    /// Finds, among the effects found but `base`, the `used` whose commands are nearest to its own
    /// but not the same: squared distances in shares of the motor ranges, and indices, at the same
    /// distance the earliest first.
    fn find_near(&mut self, base: usize, observed: &Observed<'_>) {
        let parent = observed.command(base);
        let shares = &self.fit.shares;
        // A few coordinates of all commands, then the next of all: loading the commands from memory
        // is most of the work, and so several loads overlap.
        self.found.iter_mut().for_each(|(squared, _)| *squared = 0.0);
        for from in (0..parent.len()).step_by(AT_ONCE) {
            let part = from..parent.len().min(from + AT_ONCE);
            let (parent, shares) = (&parent[part.clone()], &shares[part.clone()]);
            for (squared, index) in &mut self.found {
                let command = &observed.command(*index)[part.clone()];
                let mut sum = *squared;
                for ((x, at), share) in command.iter().zip(parent).zip(shares) {
                    let along = (x - at) * share;
                    sum += along * along;
                }
                *squared = sum;
            }
        }
        self.near.clear();
        for &(squared, index) in &self.found {
            let is_full = self.near.len() == self.used;
            let last = self.near.last().copied().filter(|_| is_full);
            if index == base {
                continue;
            }
            let each = (squared, index);
            if squared >= SAME && last.is_none_or(|last| nearer(&each, &last).is_lt()) {
                if is_full {
                    self.near.pop();
                }
                let place = self.near.partition_point(|other| nearer(other, &each).is_lt());
                self.near.insert(place, each);
            }
        }
    }
}

impl Fit {
    /// Computes the step, in shares of the motor ranges; returns its root mean square over those
    /// that are not points, or None where there is no direction towards the goal.
    fn step(
        &mut self,
        goal: &[f64],
        base: usize,
        near: &[(f64, usize)],
        ridge: f64,
        reach: f64,
        observed: &Observed<'_>,
    ) -> Option<f64> {
        let (s, m) = (goal.len(), self.shares.len());
        let free = self.shares.iter().filter(|share| **share > 0.0).count();
        let effect = |index: usize| &observed.effects.points()[index * s..][..s];
        let (parent, origin) = (observed.command(base), effect(base));
        let (h, nearest) = (near.len(), near.first()?.0);
        let Self { shares, directions, changes, gram, jacobian, squares, error, step } = self;

        directions.clear();
        changes.clear();
        for &(squared, index) in near {
            let distance = squared.sqrt();
            let along = observed.command(index).iter().zip(parent).zip(&*shares);
            directions.extend(along.map(|((x, at), share)| (x - at) * share / distance));
            changes.extend(effect(index).iter().zip(origin).map(|(y, at)| y - at));
        }
        error.clear();
        error.extend(goal.iter().zip(origin).map(|(g, at)| g - at));
        step.clear();
        step.resize(m, 0.0);
        let far = to_unit(error)?;
        if far == 0.0 {
            return Some(0.0);
        }
        // In units of their own, so that no unit of the effects is too large or too small.
        let spread = to_unit(changes)?;
        for (change, &(squared, _)) in changes.chunks_exact_mut(s).zip(near) {
            let distance = squared.sqrt();
            change.iter_mut().for_each(|y| *y /= distance);
        }

        gram.clear();
        gram.resize(h * h, 0.0);
        for (a, row) in directions.chunks_exact(m).enumerate() {
            for (b, other) in directions.chunks_exact(m).enumerate().take(a + 1) {
                gram[a * h + b] = dot(row, other);
            }
            gram[a * h + a] += ridge * (near[a].0 / nearest);
        }
        solve(gram, h, changes, s);
        jacobian.clear();
        jacobian.resize(s * m, 0.0);
        for (row, weights) in directions.chunks_exact(m).zip(changes.chunks_exact(s)) {
            for (slopes, weight) in jacobian.chunks_exact_mut(m).zip(weights) {
                slopes.iter_mut().zip(row).for_each(|(slope, u)| *slope += weight * u);
            }
        }

        squares.clear();
        squares.resize(s * s, 0.0);
        let mut trace = 0.0;
        for (a, row) in jacobian.chunks_exact(m).enumerate() {
            for (b, other) in jacobian.chunks_exact(m).enumerate().take(a + 1) {
                squares[a * s + b] = dot(row, other);
            }
            trace += squares[a * s + a];
        }
        if !(trace > 0.0 && trace.is_finite()) {
            return None;
        }
        squares.iter_mut().for_each(|square| *square /= trace);
        for a in 0..s {
            squares[a * s + a] += DAMPING;
        }
        solve(squares, s, error, 1);
        for (slopes, z) in jacobian.chunks_exact(m).zip(&*error) {
            let z = z / trace;
            step.iter_mut().zip(slopes).for_each(|(x, slope)| *x += slope * z);
        }

        let size = (dot(step, step) / free as f64).sqrt();
        if !(size > f64::MIN_POSITIVE && size.is_finite()) {
            return None;
        }
        let length = size * (far / spread);
        let (factor, length) =
            if length > reach { (reach / size, reach) } else { (far / spread, length) };
        step.iter_mut().for_each(|x| *x *= factor);
        Some(length)
    }
}

/// Divides numbers by the largest of their absolute values, which is returned; None if one of them
/// is not finite.
fn to_unit(numbers: &mut [f64]) -> Option<f64> {
    let mut largest = 0.0_f64;
    for number in &*numbers {
        if !number.is_finite() {
            return None;
        }
        largest = largest.max(number.abs());
    }
    if largest > 0.0 {
        numbers.iter_mut().for_each(|number| *number /= largest);
    }
    Some(largest)
}

fn dot(a: &[f64], b: &[f64]) -> f64 {
    let mut sum = 0.0;
    for (x, y) in a.iter().zip(b) {
        sum += x * y;
    }
    sum
}

/// Replaces `right`, of `n` rows and `width` columns, by the solution of `matrix` solution = right.
///
/// The matrix is symmetric and positive definite; only its lower triangle is read, and overwritten
/// by its Cholesky factor.
fn solve(matrix: &mut [f64], n: usize, right: &mut [f64], width: usize) {
    for a in 0..n {
        for b in 0..=a {
            let mut left = matrix[a * n + b];
            for q in 0..b {
                left -= matrix[a * n + q] * matrix[b * n + q];
            }
            matrix[a * n + b] =
                if a == b { left.max(LEAST_PIVOT).sqrt() } else { left / matrix[b * n + b] };
        }
        for c in 0..width {
            let mut left = right[a * width + c];
            for q in 0..a {
                left -= matrix[a * n + q] * right[q * width + c];
            }
            right[a * width + c] = left / matrix[a * n + a];
        }
    }
    for a in (0..n).rev() {
        for c in 0..width {
            let mut left = right[a * width + c];
            for q in a + 1..n {
                left -= matrix[q * n + a] * right[q * width + c];
            }
            right[a * width + c] = left / matrix[a * n + a];
        }
    }
}

#[cfg(test)]
mod tests {
    use super::solve;

    #[test]
    fn a_system_is_solved() {
        // [[4, 2], [2, 5]] [[1, -1], [2, 3]] = [[8, 2], [12, 13]]; the upper triangle is not read.
        let mut matrix = [4.0, f64::NAN, 2.0, 5.0];
        let mut right = [8.0, 2.0, 12.0, 13.0];
        solve(&mut matrix, 2, &mut right, 2);
        assert_eq!(right, [1.0, -1.0, 2.0, 3.0]);
    }
}
