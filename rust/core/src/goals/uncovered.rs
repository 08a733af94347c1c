//! A goal that no effect covers.

use crate::bounds::{Bounds, UniformStream};
use crate::error::Error;
use crate::kdtree::NearestNeighbors;

/// A goal uniform among those of the box that are farther than `tau` from every effect: the first
/// of at most `tries` that is, or else the last.
///
/// # Errors
/// If the sizes do not fit, there is no effect, `tau` is not positive or `tries` is 0; `stream` is
/// then untouched.
pub fn uncovered(
    goals: &Bounds,
    tau: f64,
    tries: usize,
    effects: &NearestNeighbors,
    stream: &mut (impl UniformStream + ?Sized),
) -> Result<Vec<f64>, Error> {
    super::check(goals, effects, "tries", tries)?;
    super::check_distance("tau", tau)?;
    let mut goal = goals.sample(stream);
    for _ in 1..tries {
        if effects.nearest(&goal)?.0 > tau {
            break;
        }
        goals.sample_into(&mut goal, stream);
    }
    Ok(goal)
}
