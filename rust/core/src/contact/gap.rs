//! Gap: how far two segments are apart, in which direction, and for how long they will be.

use parry2d_f64::math::Vector;
use parry2d_f64::query::PointQuery;
use parry2d_f64::shape::Segment;

/// Clearances below this many metres are contact: less than a posture's rounding could hide a touch.
pub(crate) const CONTACT: f64 = 1e-13;

/// The least distance of two segments that do not cross, and its direction, a unit vector from `to` to `from`.
///
/// Such segments are closest at an end of one of them: four projections of a point onto a segment. parry's
/// query for two segments at once divides by what vanishes where they are parallel.
#[inline]
pub(crate) fn closest(from: &Segment, to: &Segment) -> (f64, Vector) {
    let mut offset = from.a - foot(to, from.a);
    let mut square = offset.length_squared();
    for other in [from.b - foot(to, from.b), foot(from, to.a) - to.a, foot(from, to.b) - to.b] {
        let its_square = other.length_squared();
        if its_square < square {
            (offset, square) = (other, its_square);
        }
    }
    let distance = square.sqrt();
    (distance, offset / distance)
}

#[inline]
fn foot(segment: &Segment, point: Vector) -> Vector {
    segment.project_local_point(point, true).point
}

/// How long a gap that closes at `closing` a unit of time is open for sure, if its second derivative is
/// never less than -`acceleration`: the first root of gap - closing t - acceleration t^2 / 2.
#[inline]
pub(crate) fn open_for(gap: f64, closing: f64, acceleration: f64) -> f64 {
    // Not NaN either, whose root would be no time.
    if !(gap > 0.0) {
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
