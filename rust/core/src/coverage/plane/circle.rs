//! Directions, arcs and contacts on circles of radius 1.
//!
//! A direction is a unit vector together with its *turn*, a number in [0, 4] that grows with
//! the angle but costs one division instead of an arc tangent. Arcs never pass over turn 0:
//! an interval that does is two arcs. Angles in radians are needed for areas alone, and there
//! they come from `libm`'s arc tangent, a fixed sequence of plain operations.

/// A point of the unit circle.
#[derive(Debug, Clone, Copy, Default, PartialEq)]
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

    /// The direction at a turn in [0, 4], to within its rounding.
    #[inline]
    pub fn at(turn: f64) -> Self {
        let along = (turn - 2.0).abs() - 1.0;
        let across = (1.0 - along.abs()).copysign(2.0 - turn);
        let length = (along * along + across * across).sqrt();
        Self { turn, x: along / length, y: across / length }
    }

    #[inline]
    pub fn opposite(self) -> Self {
        Self { turn: self.turn - 2.0_f64.copysign(self.turn - 2.0), x: -self.x, y: -self.y }
    }
}

/// What is kept of an arc: the turns of its ends. A third of an arc's memory, and memory is
/// what most of a step's time goes to among a million discs.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(crate) struct Span {
    pub from: f64,
    pub to: f64,
}

impl Span {
    /// What it has in common with another, unless that is empty.
    #[inline]
    pub fn common(self, other: Self) -> Option<Self> {
        let (from, to) = (self.from.max(other.from), self.to.min(other.to));
        (from < to).then_some(Self { from, to })
    }

    /// What is left of it outside of `hole`, which passes over turn 0 if it ends before it begins.
    #[inline]
    pub fn without(self, hole: Self) -> [Option<Self>; 2] {
        let (from, to) = (hole.to, hole.from);
        if from > to {
            let (below, above) = (Self { from: 0.0, to }, Self { from, to: 4.0 });
            [self.common(below), self.common(above)]
        } else {
            [self.common(Self { from, to }), None]
        }
    }

    /// What it has in common with an arc, whose ends are kept as they are.
    #[inline]
    pub fn part_of(self, arc: Arc) -> Option<Arc> {
        let Span { from, to } = self.common(arc.span())?;
        let end =
            |turn, known: Direction| if turn == known.turn { known } else { Direction::at(turn) };
        Some(Arc { from: end(from, arc.from), to: end(to, arc.to) })
    }
}

/// Part of a circle, counter-clockwise, with `from.turn < to.turn`.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(crate) struct Arc {
    pub from: Direction,
    pub to: Direction,
}

impl Arc {
    /// All of the circle.
    pub const CIRCLE: Self = Self { from: Direction::START, to: Direction::END };

    /// The one or two arcs that go counter-clockwise from `from` to `to`.
    #[inline]
    pub fn between(from: Direction, to: Direction) -> (Self, Option<Self>) {
        if from.turn <= to.turn {
            (Self { from, to }, None)
        } else {
            (Self { from, to: Direction::END }, Some(Self { from: Direction::START, to }))
        }
    }

    /// The turns of its ends.
    #[inline]
    pub fn span(self) -> Span {
        Span { from: self.from.turn, to: self.to.turn }
    }
}

/// A stored disc, seen from a new centre.
#[derive(Debug, Clone, Copy, Default)]
pub(crate) struct Neighbour {
    /// Its centre.
    pub x: f64,
    pub y: f64,
    /// Its centre relative to the new one, in units of the radius, and that squared.
    pub dx: f64,
    pub dy: f64,
    pub squared: f64,
}

impl Neighbour {
    #[inline]
    pub fn new([x, y]: [f64; 2], centre: (f64, f64), tau: f64) -> Self {
        let (dx, dy) = ((x - centre.0) / tau, (y - centre.1) / tau);
        Self { x, y, dx, dy, squared: dx * dx + dy * dy }
    }

    /// Whether the two discs are one.
    #[inline]
    pub fn is_same(&self) -> bool {
        self.squared < f64::MIN_POSITIVE
    }

    /// Whether they overlap but for rounding; what lies between, the contact decides precisely.
    #[inline]
    pub fn is_near(&self) -> bool {
        self.squared <= 4.000_000_000_001
    }
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
        let sine_squared = if squared > NEARLY_TANGENT {
            0.25 * four_minus_squared_distance((other.x, other.y), (x, y), tau)
        } else {
            1.0 - 0.25 * squared
        };
        if sine_squared < TOUCHING {
            return None;
        }
        // Half the common chord, for each unit of the distance.
        let slope = (sine_squared / squared).sqrt();
        Some(Self {
            from: Direction::new(0.5 * dx + dy * slope, 0.5 * dy - dx * slope),
            to: Direction::new(0.5 * dx - dy * slope, 0.5 * dy + dx * slope),
        })
    }

    /// The part of the other circle that lies inside this disc. It may pass over turn 0.
    #[inline]
    pub fn swallowed(self) -> Arc {
        Arc { from: self.from.opposite(), to: self.to.opposite() }
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

/// The greatest whole number that is no greater, as far as those go. Without a call of the
/// platform's function, which the oldest instruction set needs for each.
#[inline]
pub(crate) fn floor(x: f64) -> i64 {
    let towards_zero = x as i64;
    towards_zero.saturating_sub(i64::from(towards_zero as f64 > x))
}

#[cfg(test)]
mod tests {
    use super::*;
    use std::f64::consts::TAU;

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
    fn a_turn_gives_its_direction() {
        for i in 0..1000 {
            let (direction, again) = (
                at(f64::from(i) * TAU / 1000.0),
                Direction::at(at(f64::from(i) * TAU / 1000.0).turn),
            );
            assert!((direction.x - again.x).abs() < 1e-15 && (direction.y - again.y).abs() < 1e-15);
        }
        assert_eq!((Direction::at(0.0), Direction::at(4.0).x), (Direction::START, 1.0));
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
        let other = Neighbour { x: 2.0, dx: 2.0, squared: 4.0, ..Neighbour::default() };
        assert!(Contact::with(&other, (0.0, 0.0), 1.0).is_none());
    }
}
