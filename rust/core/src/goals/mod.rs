//! Goals drawn by what is known already: away from all effects, or just beyond them.
//!
//! Each search draws points of a box of goals until one is right.
//!
//! - [`uncovered`]: farther than tau from every effect;
//! - [`frontier`]: such a goal around an effect;
//! - [`novel`]: of a few, the one farthest from its nearest effect;
//! - [`Untried`]: of a few uncovered ones, the one whose nearest effect was started from least often.

mod frontier;
mod novel;
mod uncovered;
mod untried;

pub use frontier::frontier;
pub use novel::novel;
pub use uncovered::uncovered;
pub use untried::Untried;

use crate::bounds::Bounds;
use crate::error::{Error, check_length};
use crate::kdtree::NearestNeighbors;

/// Checks what every search is given: a box, effects, and how often to draw.
fn check(
    goals: &Bounds,
    effects: &NearestNeighbors,
    name: &'static str,
    times: usize,
) -> Result<(), Error> {
    check_length("goals", goals.low(), effects.dim())?;
    if effects.is_empty() {
        return Err(Error::Empty { name: "the set of effects" });
    }
    if times == 0 {
        return Err(Error::Count { name, must_be: "at least 1".into(), got: times });
    }
    Ok(())
}

/// Checks that a distance called `name` is one.
fn check_distance(name: &'static str, distance: f64) -> Result<(), Error> {
    if distance > 0.0 && distance.is_finite() {
        return Ok(());
    }
    Err(Error::Number { name, must_be: "positive and finite", got: distance })
}
