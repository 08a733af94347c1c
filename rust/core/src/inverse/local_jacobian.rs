//! A local linear model from commands to effects, and a short step in it towards the goal.
//!
//! Where there are more motor coordinates than effect coordinates, alike effects come from very
//! different commands, and a map fitted across them means nothing. So the model is fitted around
//! one command, that of the nearest effect, to the commands next to it in *motor* space.
//!
//! With u the directions to these neighbours (unit vectors, in shares of the motor ranges), v how
//! the effects change along them, and D the distances, the Jacobian is J = v^T (u u^T + R)^-1 u: of
//! all matrices that agree with the neighbours as far as the ridge R lets them, the least. R is
//! diagonal, the ridge times (D / nearest D)^2: what is far tells less, as the environment curves.
//! The step is the damped least-squares solution of J step = goal - effect.
//!
//! The systems are small - as many rows as neighbours, or effect coordinates - and solved by a
//! Cholesky factorisation written out here: its sums have one order, whatever the CPU or the
//! version of a library.

use smallvec::SmallVec;

use super::Observed;
use crate::bounds::{UniformStream, check_share};
use crate::error::Error;

/// Squared distances between commands, in shares of the motor ranges, below which they count as
/// the same: the squares of what is smaller lose digits.
const SAME: f64 = 1e-280;

/// What is added to the diagonal of J J^T, as a share of its trace.
const DAMPING: f64 = 1e-6;

/// The least that a pivot of a factorisation may be; the matrices have diagonals of the order of 1.
const LEAST_PIVOT: f64 = 1e-12;

/// Numbers that fit without an allocation: for 10 neighbours in up to 25 motor coordinates.
type Numbers = SmallVec<[f64; 256]>;

/// The model's settings; none depends on the units of commands or effects.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct LocalJacobian {
    k: usize,
    used: usize,
    ridge: f64,
    reach: f64,
    noise: f64,
}

impl LocalJacobian {
    /// Of the `k` effects nearest to the goal, beside the very nearest, the `used` whose commands
    /// are nearest to that one's are fitted, with `ridge`; the step is at most `reach` and its
    /// perturbation `noise` of it.
    ///
    /// # Errors
    /// If a count is 0, `ridge` is not positive and finite, or `reach` or `noise` are not in
    /// [0, 1].
    pub fn new(k: usize, used: usize, ridge: f64, reach: f64, noise: f64) -> Result<Self, Error> {
        for (name, got) in [("k", k), ("used", used)] {
            if got == 0 {
                return Err(Error::Count { name, must_be: "at least 1".into(), got });
            }
        }
        if !(ridge > 0.0 && ridge.is_finite()) {
            return Err(Error::Number {
                name: "ridge",
                must_be: "positive and finite",
                got: ridge,
            });
        }
        check_share("reach", reach)?;
        check_share("noise", noise)?;
        Ok(Self { k, used, ridge, reach, noise })
    }

    /// A command likely to bring the nearest effect nearer to `goal`: one draw a motor coordinate.
    ///
    /// The command of the nearest effect, moved by the step - cut to a root mean square of `reach`
    /// of the motor ranges - and perturbed by up to `noise` of that root mean square. Where nothing
    /// can be fitted, it is perturbed by up to `noise` of `reach`.
    ///
    /// # Errors
    /// If nothing was observed yet, `goal` is not a finite point of the effects' dimension, or the
    /// sizes do not fit; `stream` is then untouched.
    pub fn command(
        &self,
        goal: &[f64],
        observed: &Observed<'_>,
        stream: &mut (impl UniformStream + ?Sized),
    ) -> Result<Vec<f64>, Error> {
        let found = observed.neighbours(goal, self.k.saturating_add(1))?;
        let base = found.first().map_or(0, |&(_, index)| index);
        let space = observed.motor_space;
        let parent = observed.command(base);
        space.check("parent", parent)?;
        let step = self.step(goal, base, &found, observed);
        let length = step.as_ref().map_or(self.reach, |&(_, length)| length);
        let mut centre: Numbers = SmallVec::from_slice(parent);
        if let Some((step, _)) = &step {
            let corners = space.low().iter().zip(space.high());
            for ((x, share), (&low, &high)) in centre.iter_mut().zip(step).zip(corners) {
                *x = (*x + share * (high - low)).max(low).min(high);
            }
        }
        let mut command = vec![0.0; space.dim()];
        space.perturb_into(&mut command, &centre, self.noise * length, stream);
        Ok(command)
    }

    /// The step, in shares of the motor ranges, and its root mean square over those that are not
    /// points; None where no direction towards the goal can be told.
    fn step(
        &self,
        goal: &[f64],
        base: usize,
        found: &[(f64, usize)],
        observed: &Observed<'_>,
    ) -> Option<(Numbers, f64)> {
        let (s, m) = (goal.len(), observed.motor_space.dim());
        let corners = observed.motor_space.low().iter().zip(observed.motor_space.high());
        // A range that is a point, or so narrow that it has no reciprocal, is left alone.
        let shares: Numbers = corners
            .map(|(low, high)| 1.0 / (high - low))
            .map(|share| if share.is_finite() { share } else { 0.0 })
            .collect();
        let free = shares.iter().filter(|share| **share > 0.0).count();
        let effect = |index: usize| &observed.effects.points()[index * s..][..s];

        let (parent, origin) = (observed.command(base), effect(base));
        let near = self.nearest_commands(parent, &shares, found, observed);
        let (h, nearest) = (near.len(), near.first()?.0);

        let mut directions = Numbers::new();
        let mut changes = Numbers::new();
        for &(squared, index) in &near {
            let distance = squared.sqrt();
            let along = observed.command(index).iter().zip(parent).zip(&shares);
            directions.extend(along.map(|((x, at), share)| (x - at) * share / distance));
            changes.extend(effect(index).iter().zip(origin).map(|(y, at)| y - at));
        }
        let mut error: Numbers = goal.iter().zip(origin).map(|(g, at)| g - at).collect();
        let far = to_unit(&mut error)?;
        if far == 0.0 {
            return Some((SmallVec::from_elem(0.0, m), 0.0));
        }
        // In units of their own, so that no unit of the effects is too large or too small.
        let spread = to_unit(&mut changes)?;
        for (change, &(squared, _)) in changes.chunks_exact_mut(s).zip(&near) {
            let distance = squared.sqrt();
            change.iter_mut().for_each(|y| *y /= distance);
        }

        let mut gram: Numbers = SmallVec::from_elem(0.0, h * h);
        for (a, row) in directions.chunks_exact(m).enumerate() {
            for (b, other) in directions.chunks_exact(m).enumerate().take(a + 1) {
                gram[a * h + b] = dot(row, other);
            }
            gram[a * h + a] += self.ridge * (near[a].0 / nearest);
        }
        solve(&mut gram, h, &mut changes, s);
        let mut jacobian: Numbers = SmallVec::from_elem(0.0, s * m);
        for (row, weights) in directions.chunks_exact(m).zip(changes.chunks_exact(s)) {
            for (slopes, weight) in jacobian.chunks_exact_mut(m).zip(weights) {
                slopes.iter_mut().zip(row).for_each(|(slope, u)| *slope += weight * u);
            }
        }

        let mut squares: Numbers = SmallVec::from_elem(0.0, s * s);
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
        solve(&mut squares, s, &mut error, 1);
        let mut step: Numbers = SmallVec::from_elem(0.0, m);
        for (slopes, z) in jacobian.chunks_exact(m).zip(&error) {
            let z = z / trace;
            step.iter_mut().zip(slopes).for_each(|(x, slope)| *x += slope * z);
        }

        let size = (dot(&step, &step) / free as f64).sqrt();
        if !(size > f64::MIN_POSITIVE && size.is_finite()) {
            return None;
        }
        let length = size * (far / spread);
        let (factor, length) = if length > self.reach {
            (self.reach / size, self.reach)
        } else {
            (far / spread, length)
        };
        step.iter_mut().for_each(|x| *x *= factor);
        Some((step, length))
    }

    /// The squared distances and indices of the `used` commands nearest to `parent` but not the
    /// same, in shares of the motor ranges; at the same distance the earliest first.
    fn nearest_commands(
        &self,
        parent: &[f64],
        shares: &[f64],
        found: &[(f64, usize)],
        observed: &Observed<'_>,
    ) -> SmallVec<[(f64, usize); 64]> {
        let mut near = SmallVec::new();
        for &(_, index) in found.iter().skip(1) {
            let mut squared = 0.0;
            for ((x, at), share) in observed.command(index).iter().zip(parent).zip(shares) {
                let along = (x - at) * share;
                squared += along * along;
            }
            if squared >= SAME {
                near.push((squared, index));
            }
        }
        let order = |a: &(f64, usize), b: &(f64, usize)| a.0.total_cmp(&b.0).then(a.1.cmp(&b.1));
        if near.len() > self.used {
            near.select_nth_unstable_by(self.used, order);
            near.truncate(self.used);
        }
        near.sort_unstable_by(order);
        near
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
