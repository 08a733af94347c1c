//! Closed forms: the measure of a ball, and what one ball covers of another.

use std::f64::consts::PI;

/// The measure of a ball of radius `tau`: V_d = V_(d-2) 2 pi / d, times tau^d.
///
/// Radius and factor are multiplied in turn, so that the way to a number in range stays in
/// range for longer; a tiny radius gives 0.
pub(super) fn ball(tau: f64, dim: usize) -> f64 {
    let start = if dim.is_multiple_of(2) { 1.0 } else { 2.0 * tau };
    (1..=dim)
        .filter(|d| *d >= 2 && d.is_multiple_of(2) == dim.is_multiple_of(2))
        .fold(start, |volume, d| volume * (2.0 * PI / d as f64) * tau * tau)
}

/// The share of a unit ball that lies in another whose centre is `square`^(1/2) away.
///
/// Two caps of height 1 - a, a = half the distance: their share is the integral of
/// (1 - x^2)^((d-1)/2) from a to 1, over that from 0 to 1. Both by integration in parts,
/// J_d = ((d - 1) J_(d-2) - a (1 - a^2)^((d-1)/2)) / d. Errors stay below 1e-14 of a ball.
pub(super) fn lens(square: f64, dim: usize) -> f64 {
    if square >= 4.0 {
        return 0.0;
    }
    let (a, height) = (0.5 * square.sqrt(), 1.0 - 0.25 * square);
    // J and its complete value; the power is of 1 - a^2, by half-integers.
    let even = dim.is_multiple_of(2);
    let (mut part, mut whole, mut power) =
        if even { (libm::acos(a), 0.5 * PI, height.sqrt()) } else { (1.0 - a, 1.0, height) };
    let mut d = if even { 2 } else { 3 };
    while d <= dim {
        let n = d as f64;
        part = ((n - 1.0) * part - a * power) / n;
        whole *= (n - 1.0) / n;
        power *= height;
        d += 2;
    }
    (part / whole).clamp(0.0, 1.0)
}

/// Whether what two balls cover of the unit ball at the origin has no common point but ends:
/// whether no point is less than 1 away from the origin, `a` and `b`.
///
/// That is a question of the smallest ball around these three: in an obtuse triangle its
/// diameter is the longest side, in an acute one it is the circumscribed circle's.
pub(super) fn apart(a: &[f64], b: &[f64], square_a: f64, square_b: f64) -> bool {
    let between = a.iter().zip(b).fold(0.0, |sum, (a, b)| sum + (a - b) * (a - b));
    if between >= square_a + square_b {
        return between >= 4.0;
    }
    if square_a >= square_b + between || square_b >= square_a + between {
        return false; // neither is 2 or more away from the origin
    }
    let twice_dot = square_a + square_b - between;
    // The squared circumradius is the product of the squared sides over 16 squared areas.
    square_a * square_b * between >= 4.0 * square_a * square_b - twice_dot * twice_dot
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn balls_have_the_textbook_volumes() {
        let expected = [2.0, PI, PI * 4.0 / 3.0, PI * PI / 2.0, PI * PI * 8.0 / 15.0];
        for (dim, volume) in (1..).zip(expected) {
            let tau = 0.3_f64;
            let error = ball(tau, dim) / (volume * tau.powi(dim as i32)) - 1.0;
            assert!(error.abs() < 1e-15, "{dim}: {error}");
        }
        assert_eq!(ball(1e-100, 32), 0.0);
        // pi^16 / 16!
        assert!((ball(1.0, 32) / 4.303_069_587_032_947e-6 - 1.0).abs() < 1e-14);
    }

    /// Against Simpson's rule on the caps' profile, in the angle: sin^d has no kinks.
    #[test]
    fn lenses_agree_with_quadrature() {
        for dim in 1..=32 {
            for i in 0..40 {
                let distance = f64::from(i) * 0.05;
                let n = 2000;
                let integral = |from: f64| -> f64 {
                    let step = from / f64::from(n);
                    let f = |k: i32| (f64::from(k) * step).sin().powi(dim as i32);
                    let odd: f64 = (1..n).step_by(2).map(f).sum();
                    let even: f64 = (2..n).step_by(2).map(f).sum();
                    step / 3.0 * (f(0) + f(n) + 4.0 * odd + 2.0 * even)
                };
                let expected = integral((distance / 2.0).acos()) / integral(0.5 * PI);
                let error = lens(distance * distance, dim) - expected;
                assert!(error.abs() < 2e-11, "{dim}, {distance}: {error}");
            }
            assert!((lens(0.0, dim) - 1.0).abs() < 1e-15);
            assert_eq!(lens(4.0, dim), 0.0);
        }
    }

    /// The least of a convex function on [-2, 2].
    fn least(f: impl Fn(f64) -> f64) -> f64 {
        let (mut low, mut high) = (-2.0, 2.0);
        for _ in 0..60 {
            let (a, b) = (low + 0.45 * (high - low), low + 0.55 * (high - low));
            if f(a) < f(b) { high = b } else { low = a }
        }
        f(0.5 * (low + high))
    }

    /// Against the least radius found by searching for the centre.
    #[test]
    fn apart_means_no_common_point() {
        for i in 0..20 {
            for j in 0..20 {
                let (a, b) = (0.1 * f64::from(i), 0.1 * f64::from(j) + 0.03);
                for angle in [0.3_f64, 0.9, 1.3, 2.0, 2.9] {
                    let (p, q) = ([a, 0.0], [b * angle.cos(), b * angle.sin()]);
                    let radius = |x: f64, y: f64| {
                        let away = |[u, v]: [f64; 2]| (x - u).hypot(y - v);
                        away([0.0; 2]).max(away(p)).max(away(q))
                    };
                    let least = least(|x| least(|y| radius(x, y)));
                    if (least - 1.0).abs() > 1e-4 {
                        assert_eq!(apart(&p, &q, a * a, b * b), least > 1.0, "{p:?} {q:?} {least}");
                    }
                }
            }
        }
    }
}
