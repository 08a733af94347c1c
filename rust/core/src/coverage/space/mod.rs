//! The exact volume of a growing union of equal balls in space.
//!
//! The union is known by its centres alone. What a new ball adds follows from the faces of the
//! new centre's Voronoi cell and of the cells that it takes from (`survey`); each face is a
//! convex polygon in a disc (`face`, `polygon`, `turn`), found anew each time from the centres
//! around (`neighbours`); most redundant balls are known by less (`cover`). Nothing is
//! traced round the union's surface, so balls that touch, coincide or meet in one point are no
//! special cases: tiny faces give tiny amounts.
//!
//! The error of a gain is some 1e-15 of a ball, as slices and orders of insertion show. A ball
//! that adds nothing but rounding noise lies in the union and is not stored, so crowded places
//! stay cheap.

mod cover;
mod face;
mod neighbours;
mod polygon;
mod survey;
mod turn;
mod vector;

use super::cubes::Cubes;
use survey::Survey;

/// The union of the balls of radius tau around effects in space.
#[derive(Debug, Clone)]
pub struct Balls {
    tau: f64,
    centres: Cubes,
    survey: Survey,
}

impl Balls {
    /// The empty union of balls of radius `tau`, in [1e-100, 1e100].
    #[must_use]
    pub fn new(tau: f64) -> Self {
        Self { tau, centres: Cubes::new(3, tau), survey: Survey::default() }
    }

    /// The volume that a ball around `effect` would add, without adding it.
    ///
    /// `effect` must be finite. A gain below 1e-13 of a ball is 0.
    pub fn gain(&mut self, effect: [f64; 3]) -> f64 {
        // A lone ball's gain has the same bits each time.
        self.survey.gain(effect, self.tau, &self.centres) * (self.tau * self.tau * self.tau)
    }

    /// Adds a ball around `effect`, which must be finite, and returns the volume that it adds.
    pub fn insert(&mut self, effect: [f64; 3]) -> f64 {
        let gain = self.gain(effect);
        if gain > 0.0 {
            self.centres.insert(&effect);
        }
        gain
    }

    /// Adds a ball that is known to add something, without finding out how much.
    pub(crate) fn replay(&mut self, effect: [f64; 3]) {
        self.centres.insert(&effect);
    }

    /// How many balls had to be stored: the others lay wholly in the union.
    #[must_use]
    pub fn stored(&self) -> usize {
        self.centres.len()
    }
}

/// The volume of a ball of radius `tau`: the bits that a lone ball gains.
#[must_use]
pub fn ball(tau: f64) -> f64 {
    survey::BALL * (tau * tau * tau)
}
