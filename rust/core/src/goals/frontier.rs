//! A goal just beyond what is covered.

use crate::bounds::{Bounds, UniformStream};
use crate::error::Error;
use crate::kdtree::NearestNeighbors;

/// A goal around an effect that no effect covers: the first of at most `tries` that is farther
/// than `tau` from every effect, or else the last.
///
/// Each is drawn from an effect taken at random, at a distance uniform between `tau` and `reach`
/// times `tau`, in the direction of a point uniform in a cube around it; what leaves the box is
/// brought back to its border. Draws: the effect, the direction coordinate by coordinate, the
/// distance.
///
/// # Errors
/// If the sizes do not fit, there is no effect, `tau` is not positive, `reach` is less than 1 or
/// `tries` is 0; `stream` is then untouched.
pub fn frontier(
    goals: &Bounds,
    tau: f64,
    reach: f64,
    tries: usize,
    effects: &NearestNeighbors,
    stream: &mut (impl UniformStream + ?Sized),
) -> Result<Vec<f64>, Error> {
    super::check(goals, effects, "tries", tries)?;
    super::check_distance("tau", tau)?;
    if !(reach >= 1.0 && reach.is_finite()) {
        return Err(Error::Number { name: "reach", must_be: "at least 1, finite", got: reach });
    }
    let (n, dim) = (effects.len(), effects.dim());
    let mut goal = vec![0.0; dim];
    for left in (0..tries).rev() {
        let index = ((stream.next() * n as f64) as usize).min(n - 1);
        let centre = &effects.points()[index * dim..][..dim];
        stream.fill(&mut goal);
        let mut squared = 0.0;
        for x in &mut goal {
            *x = 2.0 * *x - 1.0;
            squared += *x * *x;
        }
        let distance = tau * (1.0 + (reach - 1.0) * stream.next());
        // Of a direction there is none where all draws are 1/2: that is the effect itself.
        let scale = if squared > 0.0 { distance / squared.sqrt() } else { 0.0 };
        let corners = goals.low().iter().zip(goals.high());
        for ((x, y), (&low, &high)) in goal.iter_mut().zip(centre).zip(corners) {
            *x = (y + *x * scale).max(low).min(high);
        }
        if left > 0 && effects.nearest(&goal)?.0 > tau {
            break;
        }
    }
    Ok(goal)
}
