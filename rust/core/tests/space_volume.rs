//! The volume agrees with slices and with closed forms.

use std::f64::consts::{PI, SQRT_2};

use crate::oracles::fixed;
use crate::oracles::space::{scatter, union_volume};
use divbandit_core::coverage::space::Balls;
use proptest::prelude::*;

const BALL: f64 = 4.0 * PI / 3.0;

fn volume(effects: &[[f64; 3]], tau: f64) -> f64 {
    let mut balls = Balls::new(tau);
    effects.iter().map(|&effect| balls.insert(effect)).sum()
}

fn check(effects: &[[f64; 3]], tolerance: f64) {
    let (found, expected) = (volume(effects, 1.0), union_volume(effects, 1.0));
    let error = (found - expected).abs();
    assert!(error <= tolerance, "{found} is not {expected}: {error:e}, {effects:?}");
}

#[test]
fn slices_know_a_ball_and_a_lens() {
    assert!((union_volume(&[[0.3, -0.2, 7.0]], 2.0) - 8.0 * BALL).abs() < 1e-12);
    let d = 0.7_f64;
    let expected = BALL + PI * d - PI * d.powi(3) / 12.0;
    let pair = [[0.1, 0.2, 0.3], [0.1 + 0.6 * d, 0.2, 0.3 + 0.8 * d]];
    assert!((union_volume(&pair, 1.0) - expected).abs() < 1e-12);
}

#[test]
fn random_sets() {
    for (n, spread) in [
        (2, 1.0),
        (3, 1.0),
        (10, 1.5),
        (30, 0.5),
        (30, 2.0),
        (100, 2.5),
        (150, 0.2),
        (200, 1.5),
        (300, 5.0),
    ] {
        for seed in 0..2 {
            check(&scatter(n, spread, false, 1.0, seed), 1e-11 * n as f64);
        }
    }
}

#[test]
fn four_balls_at_the_corners_of_a_tetrahedron() {
    // Every two unit balls' centres are 1 apart; what all four share is Reuleaux's tetrahedron.
    let s = 0.5 / SQRT_2;
    let corners = [[s, s, s], [s, -s, -s], [-s, s, -s], [-s, -s, s]];
    let two = 2.0 * BALL - (BALL + PI - PI / 12.0);
    let three = volume(&corners[..3], 1.0) - 3.0 * BALL + 3.0 * two;
    let four = 4.0 * BALL - 6.0 * two + 4.0 * three - volume(&corners, 1.0);
    let reuleaux = (3.0 * SQRT_2 - 49.0 * PI + 162.0 * SQRT_2.atan()) / 12.0;
    assert!((four - reuleaux).abs() < 2e-14, "{four} {reuleaux}");
}

#[test]
fn cubic_lattices() {
    let covering_cube = |a: f64| {
        volume(&cube(7, a), 1.0) - 3.0 * volume(&cube(6, a), 1.0) + 3.0 * volume(&cube(5, a), 1.0)
            - volume(&cube(4, a), 1.0)
    };
    // Third differences of a block's volume leave six cells, whatever its surface adds.
    for a in [0.5, 0.75, 1.0, 2.0 / 3.0_f64.sqrt()] {
        let found = covering_cube(a);
        assert!((found - 6.0 * a.powi(3)).abs() < 1e-10, "{a}: {found}");
    }
    // Spheres that do not cover: in a simple cube of edge sqrt 2 only neighbours along the axes
    // overlap, and the next ones' surfaces meet in one point each.
    let a = SQRT_2;
    let lens = 2.0 * BALL - (BALL + PI * a - PI * a.powi(3) / 12.0);
    for n in 2..7_usize {
        let count = n.pow(3) as f64;
        let pairs = (3 * n * n * (n - 1)) as f64;
        let expected = count * BALL - pairs * lens;
        assert!((volume(&cube(n, a), 1.0) - expected).abs() < 1e-14 * expected, "{n}");
    }
}

#[test]
fn close_packing_and_its_overlaps() {
    // Face-centred cubic with nearest neighbours at distance d: tangent at 2, only pairs
    // overlap down to the triangle's circumradius, d = sqrt 3.
    for d in [2.0, 1.999_999, 1.9, 3.0_f64.sqrt()] {
        let mut effects = Vec::new();
        let mut pairs = 0.0;
        let step = d / SQRT_2;
        for i in 0..8_i32 {
            for j in 0..8_i32 {
                for k in (0..8_i32).filter(|k| (i + j + k) % 2 == 0) {
                    effects.push([i, j, k].map(|x| step * f64::from(x)));
                }
            }
        }
        for (i, a) in effects.iter().enumerate() {
            for b in &effects[..i] {
                let squared: f64 = a.iter().zip(b).map(|(x, y)| (x - y) * (x - y)).sum();
                pairs += f64::from(u8::from(squared < 1.01 * d * d));
            }
        }
        let lens = BALL - PI * d + PI * d.powi(3) / 12.0;
        let expected = effects.len() as f64 * BALL - pairs * lens;
        assert!((volume(&effects, 1.0) - expected).abs() < 1e-13 * expected, "{d}");
    }
}

#[test]
fn lenses_at_all_distances() {
    for exponent in -12..1 {
        for mantissa in [1.0, 1.3, 1.999] {
            let d = mantissa * 10_f64.powi(exponent);
            let mut balls = Balls::new(1.0);
            balls.insert([0.5, 0.25, -0.125]);
            let gain = balls.gain([0.5 + 0.6 * d, 0.25 - 0.8 * d, -0.125]);
            let expected = PI * d - PI * d.powi(3) / 12.0;
            assert!((gain - expected).abs() < 1e-15 * BALL, "{d}");
        }
    }
}

fn cube(n: usize, a: f64) -> Vec<[f64; 3]> {
    let place = |i: usize| [i / (n * n), i / n % n, i % n].map(|x| a * x as f64);
    (0..n.pow(3)).map(place).collect()
}

proptest! {
    #![proptest_config(fixed(150))]

    #[test]
    fn agrees_with_slices(n in 1..25_usize, spread in -1.5..0.7_f64, lattice: bool, seed: u64) {
        check(&scatter(n, 10_f64.powf(spread), lattice, 1.0, seed), 1e-11 * n as f64);
    }
}
