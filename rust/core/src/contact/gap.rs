//! Gap: how far two segments are apart, in which direction, and for how long they will be.

use parry2d_f64::math::Vector;
use parry2d_f64::query::PointQuery;
use parry2d_f64::shape::Segment;

/// Clearances below this many metres are contact: less than a posture's rounding could hide a touch.
pub(crate) const CONTACT: f64 = 1e-13;

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
#[inline]
pub(crate) fn closest(first: &Segment, second: &Segment) -> Closest {
    let mut offset = first.a - foot(second, first.a);
    let (mut square, mut end_of) = (offset.length_squared(), 0);
    for (other, its_end_of) in [
        (first.b - foot(second, first.b), 0),
        (foot(first, second.a) - second.a, 1),
        (foot(first, second.b) - second.b, 1),
    ] {
        let its_square = other.length_squared();
        if its_square < square {
            (offset, square, end_of) = (other, its_square, its_end_of);
        }
    }
    let distance = square.sqrt();
    Closest { distance, normal: offset / distance, end_of }
}

#[inline]
fn foot(segment: &Segment, point: Vector) -> Vector {
    segment.project_local_point(point, true).point
}

/// How long a gap that closes at `closing` a unit of time is open for sure, if its second derivative is
/// never less than -`acceleration`: the first root of gap - closing t - acceleration t^2 / 2.
#[inline]
pub(crate) fn open_for(gap: f64, closing: f64, acceleration: f64) -> f64 {
    // The root of what is no number would be no time either.
    if gap <= 0.0 || gap.is_nan() {
        return 0.0;
    }
    let root = (closing * closing + 2.0 * acceleration * gap).sqrt();
    if closing > 0.0 {
        2.0 * gap / (root + closing)
    } else if acceleration > 0.0 {
        (root - closing) / acceleration
    } else {
        f64::INFINITY
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_gap_is_open_until_the_root() {
        for (gap, closing, acceleration) in [
            (1.0, 2.0, 3.0),
            (1e-9, 5.0, 20.0),
            (0.5, -1.0, 4.0),
            (1e-12, 0.0, 25.0),
            (2.0, 4.0, 0.0),
        ] {
            let time = open_for(gap, closing, acceleration);
            let left = gap - closing * time - 0.5 * acceleration * time * time;
            assert!(left.abs() <= 1e-15 * gap.max(1.0), "{left}");
        }
        assert_eq!(open_for(1.0, -1.0, 0.0), f64::INFINITY);
        assert_eq!(open_for(1.0, 0.0, 0.0), f64::INFINITY);
        assert_eq!(open_for(0.0, -1.0, 0.0), 0.0);
    }
}
