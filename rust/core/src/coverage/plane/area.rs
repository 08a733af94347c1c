//! Green's theorem: the area between a new circle and the boundary that its disc swallows.
//!
//! Twice the area is the integral of x dy - y dx around it: along an arc of the unit circle
//! around (cx, cy), the angle that the arc spans and cx (y1 - y0) - cy (x1 - x0). The angles are
//! added up by multiplying unit vectors, so that one arc tangent, the dearest operation here,
//! serves all arcs of a disc. What is left open, multiples of a whole turn, the arcs' ends
//! tell: their turns differ from the angle by less than 0.15 rad an arc.

use std::f64::consts::{FRAC_PI_2, TAU};

use super::circle::Arc;

/// The sum of integrals along arcs.
#[derive(Debug, Clone, Copy)]
pub(crate) struct TwiceArea {
    /// The angles of what `rotated` no longer holds, and all that is no angle.
    sum: f64,
    /// The product of the arcs' rotations, their number, and about their angle.
    rotated: (f64, f64),
    arcs: u32,
    about: f64,
}

impl Default for TwiceArea {
    fn default() -> Self {
        Self { sum: 0.0, rotated: (1.0, 0.0), arcs: 0, about: 0.0 }
    }
}

/// So many arcs' turns are off by less than half a turn in all.
const AT_ONCE: u32 = 16;

impl TwiceArea {
    /// Adds an arc of the unit circle around `(cx, cy)`, or with the sign -1 takes it away.
    #[inline]
    pub fn add(&mut self, Arc { from, to }: Arc, (cx, cy): (f64, f64), sign: f64) {
        self.sum += sign * (cx * (to.y - from.y) - cy * (to.x - from.x));
        if self.arcs == AT_ONCE {
            *self = Self { sum: self.total(), ..Self::default() };
        }
        let (cosine, sine) =
            (from.x * to.x + from.y * to.y, sign * (from.x * to.y - from.y * to.x));
        let (x, y) = self.rotated;
        self.rotated = (x * cosine - y * sine, x * sine + y * cosine);
        self.about += sign * (to.turn - from.turn);
        self.arcs += 1;
    }

    pub fn total(&self) -> f64 {
        if self.arcs == 0 {
            return self.sum;
        }
        let angle = libm::atan2(self.rotated.1, self.rotated.0);
        let turns = (self.about * FRAC_PI_2 - angle) / TAU;
        let whole = (turns + 0.5_f64.copysign(turns)).trunc();
        self.sum + (angle + whole * TAU)
    }
}
