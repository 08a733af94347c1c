//! Goal samplers: what goal babbling aims at next, given everything observed so far.
//!
//! - [`Uniform`]: anywhere in a box, as in the paper;
//! - [`Grid`]: in each cell of a grid before there is a second goal in any;
//! - [`Uncovered`]: farther than tau from every effect;
//! - [`Frontier`]: uncovered as well, but near an effect;
//! - [`Novel`]: of a few goals, the one farthest from its nearest effect;
//! - [`Untried`]: of a few uncovered goals, the one whose nearest effect was nearest to the fewest.
//!   It needs no box.

mod area;
mod border;
mod covered;
mod extent;
mod frontier;
mod grid;
mod novel;
mod uncovered;
mod uniform;
mod untried;

use std::fmt;

pub use area::Area;
pub use frontier::Frontier;
pub use grid::Grid;
pub use novel::Novel;
pub use uncovered::Uncovered;
pub use uniform::Uniform;
pub use untried::Untried;

use crate::bounds::{Bounds, UniformStream};
use crate::error::{Error, check_number};
use crate::history::History;

/// What draws the goals of one exploration.
///
/// A sampler belongs to one history, that of its first call.
pub trait GoalSampler: fmt::Debug + Send + Sync {
    /// Where it draws them; None if it needs no box.
    fn area(&self) -> Option<&Area>;

    /// Refuses effects of a dimension that it cannot draw goals for (None if it is not known
    /// yet), and a missing box.
    ///
    /// # Errors
    /// [`Error::Empty`] of "goals" if it has no box and there is no sensory space.
    fn check(
        &self,
        effect_dim: Option<usize>,
        sensory_space: Option<&Bounds>,
    ) -> Result<(), Error> {
        self.area().map_or(Ok(()), |area| area.check(effect_dim, sensory_space).map(|_| ()))
    }

    /// Writes a goal, which takes the length that it needs.
    ///
    /// Until something is observed, samplers that depend on effects draw it uniformly in the box.
    ///
    /// # Errors
    /// If there is no box to draw in, or it does not fit the effects; nothing is drawn then.
    fn sample(
        &mut self,
        history: &mut History,
        draws: &mut dyn UniformStream,
        goal: &mut Vec<f64>,
    ) -> Result<(), Error>;
}

/// Checks that a reach, in tau, does not end within what an effect covers.
fn check_reach(reach: f64) -> Result<(), Error> {
    check_number("reach", reach, reach >= 1.0 && reach.is_finite(), "at least 1, finite")
}
