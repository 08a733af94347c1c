//! Directions, arcs and contacts on circles of radius 1.
//!
//! A direction is a unit vector together with its *turn*, a number in [0, 4] that grows with
//! the angle but costs one division instead of an arc tangent. Arcs never pass over turn 0:
//! an interval that does is two arcs. Angles in radians are needed for areas alone, and there
//! they come from `libm`'s arc tangent, a fixed sequence of plain operations.

/// A point of the unit circle.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(crate) struct Direction {
    /// Quarter turns from +x, counter-clockwise, by the 1-norm's measure: in [0, 4].
    pub turn: f64,
    pub x: f64,
    pub y: f64,
}

impl Direction {
    /// Where the circle begins: +x, turn 0.
    pub const START: Self = Self { turn: 0.0, x: 1.0, y: 0.0 };
    /// Where it ends: +x again, turn 4.
    pub const END: Self = Self { turn: 4.0, x: 1.0, y: 0.0 };

    /// The direction of (`x`, `y`), a unit vector.
    ///
    /// Without a branch: the quadrants of crossings come in no predictable order.
    #[inline]
    pub fn new(x: f64, y: f64) -> Self {
        let along = x / (x.abs() + y.abs());
        Self { turn: 2.0 - (1.0 + along).copysign(y), x, y }
    }

    #[inline]
    pub fn opposite(self) -> Self {
        Self { turn: self.turn - 2.0_f64.copysign(self.turn - 2.0), x: -self.x, y: -self.y }
    }
}

/// Part of a circle, counter-clockwise, with `from.turn < to.turn`.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(crate) struct Arc {
    pub from: Direction,
    pub to: Direction,
}

impl Arc {
    /// The one or two arcs that go counter-clockwise from `from` to `to`.
    #[inline]
    pub fn between(from: Direction, to: Direction) -> (Self, Option<Self>) {
        if from.turn <= to.turn {
            (Self { from, to }, None)
        } else {
            (Self { from, to: Direction::END }, Some(Self { from: Direction::START, to }))
        }
    }

    /// What two arcs have in common, unless it is empty.
    #[inline]
    pub fn common(self, other: Self) -> Option<Self> {
        let from = if self.from.turn >= other.from.turn { self.from } else { other.from };
        let to = if self.to.turn <= other.to.turn { self.to } else { other.to };
        (from.turn < to.turn).then_some(Self { from, to })
    }

    /// The angle that the arc spans, in radians.
    #[inline]
    pub fn angle(self) -> f64 {
        let Self { from, to } = self;
        let angle = libm::atan2(from.x * to.y - from.y * to.x, from.x * to.x + from.y * to.y);
        // The arc tangent gives the angle but for a whole circle more or less, in (-pi, pi];
        // the turns, which are no angles but near enough, tell whether one is missing.
        if angle < 0.0 && to.turn - from.turn > 1.0 {
            angle + 2.0 * std::f64::consts::PI
        } else if angle == 0.0 && to.turn - from.turn > 3.0 {
            2.0 * std::f64::consts::PI
        } else {
            angle
        }
    }
}

/// A stored disc, seen from a new centre.
#[derive(Debug, Clone, Copy, Default)]
pub(crate) struct Neighbour {
    pub disc: u32,
    /// Its centre.
    pub x: f64,
    pub y: f64,
    /// Its centre relative to the new one, in units of the radius, and that squared.
    pub dx: f64,
    pub dy: f64,
    pub squared: f64,
}

/// How another circle of the same radius overlaps the one at the origin.
#[derive(Debug, Clone, Copy)]
pub(crate) struct Contact {
    /// Counter-clockwise from here ...
    pub from: Direction,
    /// ... to here, this circle lies inside the other disc.
    pub to: Direction,
}

impl Contact {
    /// The contact with another disc; None if the two do not overlap.
    #[inline]
    pub fn with(other: &Neighbour, (x, y): (f64, f64), tau: f64) -> Option<Self> {
        let Neighbour { dx, dy, squared, .. } = *other;
        let distance = squared.sqrt();
        let cosine = 0.5 * distance;
        let sine_squared = if squared > NEARLY_TANGENT {
            0.25 * four_minus_squared_distance((other.x, other.y), (x, y), tau)
        } else {
            (1.0 - cosine) * (1.0 + cosine)
        };
        if sine_squared < TOUCHING {
            return None;
        }
        let sine = sine_squared.sqrt();
        let (ux, uy) = (dx / distance, dy / distance);
        Some(Self {
            from: Direction::new(ux * cosine + uy * sine, uy * cosine - ux * sine),
            to: Direction::new(ux * cosine - uy * sine, uy * cosine + ux * sine),
        })
    }

    /// The part of the other circle that lies inside this disc: from here to there.
    #[inline]
    pub fn swallowed(self) -> (Direction, Direction) {
        (self.from.opposite(), self.to.opposite())
    }
}

/// Beyond this squared distance 4 - d^2 loses digits to cancellation. Two circles that touch
/// cross at an angle proportional to its root, so that an error of 1e-16 in it would move the
/// crossing by up to 1e-8 - and with it whole arcs where near-coincident discs touch a third.
const NEARLY_TANGENT: f64 = 4.0 - 1e-4;

/// Discs that overlap by less than this squared half-angle only touch: their common area is
/// below 1e-38, and crossings closer together than 1e-13 rad could not be told in order.
const TOUCHING: f64 = 1e-26;

/// 4 - d^2 to full relative precision, where d is the distance of two points in units of `tau`
/// and near 2: from the points themselves, since a rounded difference is as bad as a rounded square.
fn four_minus_squared_distance(a: (f64, f64), b: (f64, f64), tau: f64) -> f64 {
    let ((dx, dx_rest), (dy, dy_rest)) = (exact_sum(a.0, -b.0), exact_sum(a.1, -b.1));
    let ((xx, xx_rest), (yy, yy_rest)) = (exact_square(dx), exact_square(dy));
    let (tau_squared, tau_squared_rest) = exact_square(tau);
    let (sum, sum_rest) = exact_sum(xx, yy);
    let rest = (sum_rest + (xx_rest + yy_rest)) + 2.0 * (dx * dx_rest + dy * dy_rest);
    // `sum` is within a factor 2 of 4 tau^2: the difference is exact.
    ((4.0 * tau_squared - sum) + (4.0 * tau_squared_rest - rest)) / tau_squared
}

/// a^2 as a rounded product and its rounding error (Dekker).
fn exact_square(a: f64) -> (f64, f64) {
    let scaled = 134_217_729.0 * a; // 2^27 + 1
    let high = scaled - (scaled - a);
    let low = a - high;
    let product = a * a;
    (product, ((high * high - product) + 2.0 * high * low) + low * low)
}

/// a + b as a rounded sum and its rounding error (Knuth).
fn exact_sum(a: f64, b: f64) -> (f64, f64) {
    let sum = a + b;
    let b_part = sum - a;
    (sum, (a - (sum - b_part)) + (b - b_part))
}

#[cfg(test)]
mod tests {
    use super::*;
    use std::f64::consts::{PI, TAU};

    fn at(angle: f64) -> Direction {
        Direction::new(angle.cos(), angle.sin())
    }

    #[test]
    fn turns_grow_with_the_angle() {
        let turns: Vec<f64> = (0..1000).map(|i| at(f64::from(i) * TAU / 1000.0).turn).collect();
        assert!(turns.is_sorted());
        assert_eq!((turns[0], turns[250].round(), turns[500].round()), (0.0, 1.0, 2.0));
    }

    #[test]
    fn an_arc_spans_its_angle() {
        for (from, to) in [(0.1, 0.2), (0.1, PI), (1.0, 1.0 + PI), (0.1, 6.2), (3.0, 3.0 + 1e-9)] {
            let arc = Arc { from: at(from), to: at(to) };
            assert!((arc.angle() - (to - from)).abs() < 4e-16 * 4.0, "{from} {to}");
        }
        let circle = Arc { from: Direction::START, to: Direction::END };
        assert_eq!(circle.angle(), TAU);
    }

    #[test]
    fn four_minus_squared_distance_keeps_its_digits() {
        for exponent in 3..7 {
            // 2 - distance and 2 + distance are exact, and so are these coordinates' differences.
            let distance = 2.0 * 10_f64.powi(-exponent).cos();
            let exact = (2.0 - distance) * (2.0 + distance);
            let found = four_minus_squared_distance((distance - 0.5, 7.0), (-0.5, 7.0), 1.0);
            assert!((found / exact - 1.0).abs() < 4.0 * f64::EPSILON, "{exponent}");
        }
        // By hand: 4 - e^2 - (2 - 2 e)^2.
        let e = f64::EPSILON;
        let found = four_minus_squared_distance((e, 2.0 - 2.0 * e), (0.0, 0.0), 1.0);
        assert_eq!(found, 8.0 * e - 5.0 * e * e);
    }

    #[test]
    fn discs_that_touch_are_no_contact() {
        let other = Neighbour { disc: 0, x: 2.0, y: 0.0, dx: 2.0, dy: 0.0, squared: 4.0 };
        assert!(Contact::with(&other, (0.0, 0.0), 1.0).is_none());
    }
}
