//! Contact: how far a chain of links gets before it touches something.
//!
//! The links are capsules, and so is all that they can touch ([`Obstacle`]): a disc is one without
//! length, a polygon's edges are without width. A chain goes along a straight line in joint space. When
//! it touches first is found by conservative advancement (`sweep`): each link is known to be safe for a while,
//! and the one that is safe for the shortest is looked at again.

pub(crate) mod chain;
pub(crate) mod clear;
pub(crate) mod gap;
mod moving;
mod obstacle;
pub(crate) mod scene;
pub(crate) mod sweep;

pub use obstacle::Obstacle;
