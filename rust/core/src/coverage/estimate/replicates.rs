//! From the sets' means to one mean and its standard error.
//!
//! Each set is rotated independently, so its mean is an unbiased estimate of its own, and the
//! spread of the means says how far to trust their mean. What the balls cover each, added up,
//! was sampled along the same rays and is known exactly: a control variate. How much of its
//! error is carried over to a set's mean is a regression over the *other* sets, so that the
//! factor is independent of what it multiplies and the mean stays unbiased.

use super::directions::SETS;
use super::rays::Shares;

/// The mean of the sets' free shares, and its standard error, of at most SETS sets. `expected` is
/// the covered share's known mean, where it was sampled.
pub(super) fn combine(sets: &[Shares], expected: Option<f64>) -> (f64, f64) {
    let n = sets.len() as f64;
    let mean = |values: &mut dyn Iterator<Item = f64>| values.fold(0.0, |sum, x| sum + x) / n;
    let mut free = [0.0; SETS];
    let free = &mut free[..sets.len()];
    free.iter_mut().zip(sets).for_each(|(free, set)| *free = set.free);
    if let Some(expected) = expected {
        let free_mean = mean(&mut free.iter().copied());
        let covered_mean = mean(&mut sets.iter().map(|set| set.covered));
        let (mut cross, mut square) = (0.0, 0.0);
        for set in sets {
            let covered = set.covered - covered_mean;
            cross += (set.free - free_mean) * covered;
            square += covered * covered;
        }
        for (free, set) in free.iter_mut().zip(sets) {
            // Both sums without this set, around the others' means.
            let (f, c) = (set.free - free_mean, set.covered - covered_mean);
            let out = n / (n - 1.0);
            let (cross_left, left) = (cross - out * f * c, square - out * c * c);
            // Where the others met nothing they know of no overlap, and without overlaps the
            // factor is -1.
            let factor = if left > 1e-12 * square { cross_left / left } else { -1.0 };
            *free -= factor * (set.covered - expected);
        }
    }
    let mean = mean(&mut free.iter().copied());
    let squares = free.iter().fold(0.0, |sum, x| sum + (x - mean) * (x - mean));
    (mean, (squares / ((n - 1.0) * n)).sqrt())
}
