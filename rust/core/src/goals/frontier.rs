//! A goal just beyond what is covered.

use super::uncovered;
use crate::bounds::{Bounds, UniformStream};
use crate::error::Error;
use crate::kdtree::NearestNeighbors;

/// A goal that no effect covers, moved towards the effect nearest to it until its distance is
/// uniform between `tau` and `reach` times `tau`; one that is nearer already stays.
///
/// No effect comes nearer on the way: a ball around the goal holds none, and the ball around any
/// point on the way to its rim that touches it there lies inside of it. One draw after those of
/// [`uncovered`]. What moves out of the box is brought back, which only takes it farther away.
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
    if !(reach >= 1.0 && reach.is_finite()) {
        return Err(Error::Number { name: "reach", must_be: "at least 1, finite", got: reach });
    }
    let mut goal = uncovered(goals, tau, tries, effects, stream)?;
    let wanted = tau * (1.0 + (reach - 1.0) * stream.next());
    let (distance, index) = effects.nearest(&goal)?;
    if distance > wanted {
        let dim = effects.dim();
        let nearest = &effects.points()[index * dim..][..dim];
        let corners = goals.low().iter().zip(goals.high());
        for ((x, y), (&low, &high)) in goal.iter_mut().zip(nearest).zip(corners) {
            let moved = y + (*x - y) * (wanted / distance);
            if moved.is_finite() {
                *x = moved.max(low).min(high);
            }
        }
    }
    Ok(goal)
}
