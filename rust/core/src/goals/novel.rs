//! The most novel of a few goals.

use crate::bounds::{Bounds, UniformStream};
use crate::error::Error;
use crate::kdtree::NearestNeighbors;

/// Of `candidates` goals uniform in the box the one whose nearest effect is farthest away; the
/// first of several.
///
/// # Errors
/// If the sizes do not fit, there is no effect or no candidate; `stream` is then untouched.
pub fn novel(
    goals: &Bounds,
    candidates: usize,
    effects: &NearestNeighbors,
    stream: &mut (impl UniformStream + ?Sized),
) -> Result<Vec<f64>, Error> {
    super::check(goals, effects, "candidates", candidates)?;
    let mut best = goals.sample(stream);
    let mut farthest = effects.nearest(&best)?.0;
    let mut goal = best.clone();
    for _ in 1..candidates {
        goals.sample_into(&mut goal, stream);
        let distance = effects.nearest(&goal)?.0;
        if distance > farthest {
            farthest = distance;
            best.copy_from_slice(&goal);
        }
    }
    Ok(best)
}
