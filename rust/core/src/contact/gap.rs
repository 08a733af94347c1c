//! Gap: how far two segments are apart, in which direction, and for how long they will be.

use parry2d_f64::math::Vector;
use parry2d_f64::shape::Segment;

/// Clearances below this many metres are contact: less than a posture's rounding could hide a touch.
pub(crate) const CONTACT: f64 = 1e-13;

/// A segment with its direction: points are projected onto it without a division, which takes as long as all else.
#[derive(Debug, Clone, Copy)]
pub(crate) struct Axis {
    /// One end,
    pub a: Vector,
    /// the other,
    pub b: Vector,
    /// a unit vector from a to b, any where they are one,
    pub direction: Vector,
    /// and how far they are apart.
    pub length: f64,
}

impl From<Segment> for Axis {
    fn from(Segment { a, b }: Segment) -> Self {
        let length = (b - a).length();
        let direction = if length > 0.0 { (b - a) / length } else { Vector::X };
        Self { a, b, direction, length }
    }
}

impl Axis {
    /// From the nearest point of it to `point`.
    #[inline(always)]
    pub fn offset(&self, point: Vector) -> Vector {
        point - self.foot(point)
    }

    /// The point nearest to another.
    #[inline(always)]
    fn foot(&self, point: Vector) -> Vector {
        let along = self.direction.dot(point - self.a);
        self.a + self.direction * along.max(0.0).min(self.length)
    }
}

/// How near two segments come to each other.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(crate) struct Closest {
    /// The least distance.
    pub distance: f64,
    /// Its direction: a unit vector from the second segment to the first.
    pub normal: Vector,
    /// Of which segment an end is closest: 0 for the first, 1 for the second.
    pub end_of: usize,
}

/// Where two segments that do not cross are closest.
///
/// That is at an end of one of them: four projections of a point onto a segment. parry's query for two
/// segments at once divides by what vanishes where they are parallel.
#[inline(always)]
pub(crate) fn closest(first: &Axis, second: &Axis) -> Closest {
    let mut offset = second.offset(first.a);
    let (mut square, mut end_of) = (offset.length_squared(), 0);
    for (other, its_end_of) in
        [(second.offset(first.b), 0), (-first.offset(second.a), 1), (-first.offset(second.b), 1)]
    {
        let its_square = other.length_squared();
        if its_square < square {
            (offset, square, end_of) = (other, its_square, its_end_of);
        }
    }
    let distance = square.sqrt();
    Closest { distance, normal: offset / distance, end_of }
}

/// A gap that closes at `closing` a unit of time, if its second derivative is never less than -`acceleration`.
#[derive(Debug, Clone, Copy)]
pub(crate) struct Gap {
    pub width: f64,
    pub closing: f64,
    pub acceleration: f64,
}

impl Gap {
    /// Whether it is open for that long for sure.
    #[inline(always)]
    pub fn is_open_for(&self, time: f64) -> bool {
        self.width > (self.closing + 0.5 * self.acceleration * time) * time
    }

    /// How long it is open for sure: the first root of width - closing t - acceleration t^2 / 2.
    #[inline(always)]
    pub fn open_for(&self) -> f64 {
        let Self { width, closing, acceleration } = *self;
        let root = (closing * closing + 2.0 * acceleration * width).sqrt();
        // Two forms of one root, neither of which takes the difference of what is nearly the same.
        let (over, under) = if closing > 0.0 {
            (2.0 * width, root + closing)
        } else {
            (root - closing, acceleration)
        };
        let time = if under > 0.0 { over / under } else { f64::INFINITY };
        if width > 0.0 { time } else { 0.0 }
    }
}

#[cfg(test)]
mod tests {
    use parry2d_f64::math::Pose;
    use parry2d_f64::query::{self, PointQuery};

    use super::*;

    /// Against parry's projections, which divide, and its distance of capsules.
    #[test]
    fn closest_points_are_those_of_parry() {
        let mut state = 1_u64;
        let mut draw = || {
            state = state.wrapping_mul(6_364_136_223_846_793_005).wrapping_add(1);
            Vector::new((state >> 40) as f64, (state & 0xff_ffff) as f64) / f64::from(1 << 24)
        };
        let mut apart = 0;
        for i in 0..2000 {
            let (a, b, c, e) = (draw(), draw(), draw(), draw());
            let one = Segment::new(a, b);
            let other = if i % 4 == 0 { Segment::new(c, c) } else { Segment::new(c, e) };
            let (axis, its) = (Axis::from(one), Axis::from(other));
            let expected = c - one.project_local_point(c, true).point;
            assert!((axis.offset(c) - expected).length() < 1e-15 * 64.0);
            let here = Pose::identity();
            let distance = query::distance(&here, &one, &here, &other).unwrap().distance;
            if distance > 1e-6 {
                apart += 1;
                let found = closest(&axis, &its);
                assert!((found.distance - distance).abs() < 1e-14, "{found:?} {distance}");
                assert!((found.normal.length() - 1.0).abs() < 1e-15);
                // No point of either is beyond the closest ones: to what rounding turns so short a normal by.
                let near = found.normal.dot(a).min(found.normal.dot(b));
                let far = found.normal.dot(other.a).max(found.normal.dot(other.b));
                assert!((near - far - distance).abs() < 4e-15 / distance);
            }
        }
        assert!(apart > 1000);
    }

    #[test]
    fn a_gap_is_open_until_the_root() {
        for (width, closing, acceleration) in [
            (1.0, 2.0, 3.0),
            (1e-9, 5.0, 20.0),
            (0.5, -1.0, 4.0),
            (1e-12, 0.0, 25.0),
            (2.0, 4.0, 0.0),
        ] {
            let gap = Gap { width, closing, acceleration };
            let time = gap.open_for();
            let left = width - closing * time - 0.5 * acceleration * time * time;
            assert!(left.abs() <= 1e-15 * width.max(1.0), "{left}");
            assert!(gap.is_open_for(0.999 * time) && !gap.is_open_for(1.001 * time));
        }
        let open_for = |width, closing| Gap { width, closing, acceleration: 0.0 }.open_for();
        assert_eq!(open_for(1.0, -1.0), f64::INFINITY);
        assert_eq!(open_for(1.0, 0.0), f64::INFINITY);
        assert_eq!(open_for(0.0, -1.0), 0.0);
        assert_eq!(open_for(f64::NAN, -1.0), 0.0);
    }
}
