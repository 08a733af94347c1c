//! Choosing in proportion to weights: one draw.

/// The sum in plain order, beginning with 0.
pub fn total_of(weights: impl IntoIterator<Item = f64>) -> f64 {
    weights.into_iter().fold(0.0, |total, weight| total + weight)
}

/// An index with probability proportional to its weight; uniformly if all are 0. `u` is uniform
/// in [0, 1).
///
/// ```
/// use divbandit_core::strategies::proportionally;
///
/// let weights = [1.0, 3.0];
/// assert_eq!(proportionally(weights.into_iter(), 0.2), 0);
/// assert_eq!(proportionally(weights.into_iter(), 0.3), 1);
/// ```
pub fn proportionally(weights: impl ExactSizeIterator<Item = f64> + Clone, u: f64) -> usize {
    let total = total_of(weights.clone());
    share_of(weights, total, u)
}

/// What [`proportionally`] returns, given the sum of the weights.
pub fn share_of(weights: impl ExactSizeIterator<Item = f64>, total: f64, u: f64) -> usize {
    if total <= 0.0 {
        return (u * weights.len() as f64) as usize;
    }
    let mut left = u * total;
    let mut last = 0;
    for (index, weight) in weights.enumerate() {
        if left < weight {
            return index;
        }
        left -= weight;
        if weight > 0.0 {
            last = index;
        }
    }
    last // rounding carried u past the end
}
