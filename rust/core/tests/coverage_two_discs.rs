//! Two discs cover what the closed formula of their lens says, at any distance.

use std::f64::consts::{PI, TAU};

use crate::oracles::Stream;
use divbandit_core::Coverage;

/// What a second disc adds to a first of the same radius 1: the disc without the lens.
///
/// The textbook's lens, 2 acos(d / 2) - d / 2 sqrt(4 - d^2), subtracted from pi, with
/// acos(d / 2) = pi / 2 - asin(d / 2) so that a small gain does not drown.
fn crescent(distance: f64) -> f64 {
    let half = (distance / 2.0).min(1.0);
    2.0 * half.asin() + 2.0 * half * ((1.0 - half) * (1.0 + half)).sqrt()
}

/// The largest error of the second gain, over directions and orders, in areas of a disc.
fn error(distance: f64, tau: f64) -> f64 {
    let mut worst = 0.0_f64;
    for i in 0..48 {
        let (sine, cosine) = (f64::from(i) * TAU / 48.0).sin_cos();
        let other = [distance * cosine * tau, distance * sine * tau];
        // The distance that the rounded coordinates really have.
        let expected = crescent((other[0] / tau).hypot(other[1] / tau));
        for [first, second] in [[[0.0, 0.0], other], [other, [0.0, 0.0]]] {
            let mut coverage = Coverage::new(tau, 2).unwrap();
            coverage.add(first).unwrap();
            let gain = coverage.add(second).unwrap() / (tau * tau);
            worst = worst.max((gain - expected).abs() / PI);
        }
    }
    worst
}

/// Four arcs at most take part, each good to a few 1e-16.
const ROUNDING: f64 = 1e-15;

#[test]
fn at_any_distance() {
    let mut stream = Stream(2);
    for _ in 0..2000 {
        let distance = stream.between(0.0, 2.0);
        let tau = 10_f64.powf(stream.between(-3.0, 3.0));
        assert!(error(distance, tau) < ROUNDING, "{distance} {tau}: {}", error(distance, tau));
    }
}

#[test]
fn nearly_coincident() {
    for exponent in 3..=15 {
        for digit in 1..10 {
            let distance = f64::from(digit) * 10_f64.powi(-exponent);
            assert!(error(distance, 1.0) < ROUNDING, "{distance}: {}", error(distance, 1.0));
            assert!(error(distance, 0.02) < ROUNDING, "{distance}: {}", error(distance, 0.02));
        }
    }
}

#[test]
fn nearly_tangent() {
    for exponent in 3..=12 {
        for digit in 1..10 {
            let short = f64::from(digit) * 10_f64.powi(-exponent);
            for distance in [2.0 * (1.0 - short), 2.0 * (1.0 + short)] {
                assert!(error(distance, 1.0) < ROUNDING, "{distance}: {}", error(distance, 1.0));
                assert!(error(distance, 0.02) < ROUNDING, "{distance}: {}", error(distance, 0.02));
            }
        }
    }
}

#[test]
fn coincident_tangent_and_apart() {
    let second = |x: f64| {
        let mut coverage = Coverage::new(1.0, 2).unwrap();
        coverage.add([0.0, 0.0]).unwrap();
        coverage.add([x, 0.0]).unwrap()
    };
    assert_eq!(second(0.0), 0.0);
    assert_eq!(second(2.0), PI);
    assert_eq!(second(-2.0), PI);
    assert_eq!(second(2.0_f64.next_up()), PI);
    // Half-way, the lens has the area 2 pi / 3 - sqrt(3) / 2.
    assert!((second(1.0) - (PI / 3.0 + 3.0_f64.sqrt() / 2.0)).abs() < 1e-15);
}
