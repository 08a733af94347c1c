//! Clear: the least displacement that takes a ball out of all that it overlaps.

use parry2d_f64::math::Vector;

/// What is left between a ball that was cleared and what it was cleared of, in metres.
pub(crate) const LEFT: f64 = 1e-10;

/// How much of that may be missing.
const SLACK: f64 = 1e-12;

/// Something near a ball: the ball is this far away in this direction.
#[derive(Debug, Clone, Copy)]
pub(crate) struct Near {
    /// A unit vector to the ball.
    pub normal: Vector,
    /// The gap in between; less than 0 where they overlap.
    pub gap: f64,
}

/// The shortest displacement after which a ball is clear of all that is near, as if these were half planes; none if
/// there is none.
///
/// It is the nearest point to 0 of an intersection of half planes: 0 itself, on the edge of one, or in the corner of two.
pub(crate) fn least_displacement(near: &[Near]) -> Option<Vector> {
    // How much the ball must move along the normal.
    let lack = |each: &Near| LEFT - each.gap;
    let is_clear = |displacement: Vector| {
        near.iter().all(|each| each.normal.dot(displacement) >= lack(each) - SLACK)
    };
    if is_clear(Vector::ZERO) {
        return Some(Vector::ZERO);
    }
    for each in near {
        let displacement = each.normal * lack(each);
        if lack(each) > 0.0 && is_clear(displacement) {
            return Some(displacement);
        }
    }
    let mut least: Option<Vector> = None;
    for (index, one) in near.iter().enumerate() {
        for other in &near[index + 1..] {
            let det = one.normal.perp_dot(other.normal);
            if det.abs() < 1e-9 {
                continue;
            }
            let (a, b) = (lack(one), lack(other));
            let corner = Vector::new(
                a * other.normal.y - b * one.normal.y,
                b * one.normal.x - a * other.normal.x,
            ) / det;
            let shorter =
                least.is_none_or(|least| corner.length_squared() < least.length_squared());
            if shorter && is_clear(corner) {
                least = Some(corner);
            }
        }
    }
    least
}

#[cfg(test)]
mod tests {
    use std::f64::consts::{FRAC_PI_2, TAU};

    use super::*;

    fn near(angle: f64, gap: f64) -> Near {
        Near { normal: Vector::new(angle.cos(), angle.sin()), gap }
    }

    #[test]
    fn one_pushes_along_its_normal() {
        let moved = least_displacement(&[near(0.3, -0.1), near(1.0, 0.5)]).unwrap();
        assert!((moved.length() - 0.1 - LEFT).abs() < 1e-15);
        assert!((moved.y / moved.x - 0.3_f64.tan()).abs() < 1e-12);
    }

    #[test]
    fn two_push_into_their_corner() {
        let moved = least_displacement(&[near(0.0, -0.1), near(FRAC_PI_2, -0.2)]);
        let moved = moved.unwrap();
        assert!((moved - Vector::new(0.1, 0.2)).length() < 1e-9, "{moved}");
        // A wall at the side lets it slide.
        let moved = least_displacement(&[near(0.4, -0.1), near(-FRAC_PI_2, 0.0)]);
        let moved = moved.unwrap();
        assert!(moved.y.abs() < 1e-9 && (moved.x - 0.1 / 0.4_f64.cos()).abs() < 1e-9, "{moved}");
    }

    #[test]
    fn opposite_ones_leave_no_way() {
        assert_eq!(least_displacement(&[near(0.0, -0.1), near(std::f64::consts::PI, 0.05)]), None);
        let three = [near(0.0, -0.1), near(2.1, -0.1), near(4.2, -0.1)];
        assert_eq!(least_displacement(&three), None);
        assert_eq!(least_displacement(&[]), Some(Vector::ZERO));
    }

    /// Against a fine search over directions and lengths.
    #[test]
    fn no_displacement_is_shorter() {
        let mut state = 1_u64;
        let mut draw = || {
            state = state.wrapping_mul(6_364_136_223_846_793_005).wrapping_add(1);
            (state >> 11) as f64 / (1_u64 << 53) as f64
        };
        for _ in 0..200 {
            let all: Vec<Near> = (0..3).map(|_| near(TAU * draw(), 0.15 * draw() - 0.1)).collect();
            let shortest = (0..2000)
                .filter_map(|k| {
                    let direction = Vector::new(
                        (k as f64 * 6.283e-3 / 2.0).cos(),
                        (k as f64 * 6.283e-3 / 2.0).sin(),
                    );
                    // Along a direction the clear lengths are an interval.
                    let (mut low, mut high) = (0.0_f64, 1.0_f64);
                    for each in &all {
                        let along = each.normal.dot(direction);
                        let lack = -each.gap;
                        if along > 0.0 {
                            low = low.max(lack / along);
                        } else if lack > 0.0 {
                            return None;
                        } else if along < 0.0 {
                            high = high.min(lack / along);
                        }
                    }
                    (low <= high).then_some(low)
                })
                .fold(f64::INFINITY, f64::min);
            match least_displacement(&all) {
                Some(moved) => {
                    assert!(moved.length() <= shortest + 1e-8, "{moved} {shortest}");
                    assert!(all.iter().all(|each| each.gap + each.normal.dot(moved) > 0.0));
                }
                // What is left is a wedge between two of the directions searched.
                None => assert!(shortest.is_infinite(), "{shortest}"),
            }
        }
    }
}
