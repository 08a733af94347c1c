//! The measure is the area of the union, found in a second way: by vertical slabs.

use std::f64::consts::{PI, TAU};

use crate::oracles::{Stream, fixed, scatter, union_area};
use divbandit_core::Coverage;
use proptest::prelude::*;

/// Checks the measure, and with it each of the other ways to the same area.
fn check(name: &str, effects: &[[f64; 2]], tau: f64) {
    let mut coverage = Coverage::new(tau, 2).unwrap();
    coverage.extend(effects.as_flattened(), &mut vec![0.0; effects.len()]).unwrap();
    let (measure, expected) = (coverage.measure(), union_area(effects, tau));
    let error = (measure - expected).abs() / (PI * tau * tau);
    assert!(error < 1e-10, "{name}: off by {error:e} discs\n{effects:?}");
    let boundary = coverage.boundary_integral().unwrap();
    assert!((measure - boundary).abs() <= 1e-11 * measure, "{name}: {measure} {boundary}");
}

proptest! {
    #![proptest_config(fixed(400))]

    #[test]
    fn for_any_effects(
        n in 1..60_usize, spread in -6.0..1.2_f64, lattice: bool, tau in 0.001..3.0_f64, seed: u64,
    ) {
        check("scatter", &scatter(n, 10_f64.powf(spread), lattice, tau, seed), tau);
    }
}

/// `columns` x `rows` points, `step` apart, every second row shifted by `shift`.
fn lattice(columns: usize, rows: usize, step: [f64; 2], shift: f64) -> Vec<[f64; 2]> {
    let point = |i: usize| {
        let (column, row) = ((i % columns) as f64, (i / columns) as f64);
        [step[0] * column + shift * (row % 2.0), step[1] * row]
    };
    (0..columns * rows).map(point).collect()
}

fn ring(n: usize, radius: f64) -> Vec<[f64; 2]> {
    let at = |i: usize| i as f64 / n as f64 * TAU;
    (0..n).map(|i| [radius * at(i).cos(), radius * at(i).sin()]).collect()
}

/// Checks a set in units of the radius: as it is, reversed and shuffled, for several radii.
fn check_orders(name: &str, mut set: Vec<[f64; 2]>) {
    for (tau, seed) in [(1.0, 1), (0.02, 2), (700.0, 3)] {
        let scaled =
            |set: &[[f64; 2]]| -> Vec<_> { set.iter().map(|c| c.map(|x| x * tau)).collect() };
        check(name, &scaled(&set), tau);
        set.reverse();
        check(name, &scaled(&set), tau);
        Stream(seed).shuffle(&mut set);
        check(name, &scaled(&set), tau);
    }
}

#[test]
fn for_square_grids() {
    for step in [0.5, 1.0, 2.0_f64.sqrt(), 2.0] {
        check_orders(&format!("step {step}"), lattice(7, 6, [step, step], 0.0));
    }
}

/// On whole numbers, each disc through its neighbours' centres: some circles go exactly through
/// the points where two others touch.
#[test]
fn for_turned_square_grids() {
    for [a, b, c] in [[3.0, 4.0, 5.0], [5.0, 12.0, 13.0], [20.0, 21.0, 29.0]] {
        let turn = |[x, y]: [f64; 2]| [(a * x - b * y) / c, (b * x + a * y) / c];
        let grid = lattice(9, 9, [1.0, 1.0], 0.0);
        check_orders(&format!("turned by {a}, {b}"), grid.iter().map(|&p| turn(p)).collect());
        let mut exact: Vec<_> = grid.iter().map(|&p| turn(p).map(|x| (x * c).round())).collect();
        for seed in 0..20 {
            Stream(seed).shuffle(&mut exact);
            check(&format!("turned by {a}, {b}, order {seed}"), &exact, c);
        }
    }
}

#[test]
fn for_hexagonal_lattices() {
    // Just touching; without holes between; each through its neighbours' centres.
    let third = 3.0_f64.sqrt();
    for step in [2.0, third, 1.0] {
        check_orders(
            &format!("step {step}"),
            lattice(6, 6, [step, step * third / 2.0], step / 2.0),
        );
    }
}

#[test]
fn for_circles_through_one_point() {
    check_orders("all around", ring(60, 1.0));
    let mut stream = Stream(9);
    let anywhere = || stream.between(0.0, TAU).sin_cos();
    let centres = std::iter::repeat_with(anywhere).take(60).map(|(sine, cosine)| [cosine, sine]);
    check_orders("anywhere", centres.collect());
}

#[test]
fn for_centres_on_a_small_circle() {
    check_orders("tau / 1000", ring(60, 1e-3));
    check_orders("tau / 1e9", ring(60, 1e-9));
    check_orders("two close rings", [ring(30, 1.0), ring(30, 1.0 - 1e-9)].concat());
}

#[test]
fn for_duplicates() {
    let set = scatter(15, 2.0, false, 1.0, 4);
    check_orders("all three times", [set.clone(), set.clone(), set].concat());
    check_orders("one place", vec![[0.25, -0.5]; 20]);
}

#[test]
fn for_clusters() {
    let mut stream = Stream(6);
    for width in [1e-3, 1e-6, 1e-9, 1e-12, 1e-15] {
        let set = (0..60).map(|i| {
            let [x, y] = stream.normals();
            [f64::from(i % 3) * 1.1 + width * x, width * y]
        });
        check_orders(&format!("width {width:e}"), set.collect());
    }
}

#[test]
fn for_clusters_far_apart() {
    // Multiples of 2^-16 stay exact 2^30 away: each cluster must count as it does alone.
    let set = |seed| -> Vec<[f64; 2]> {
        let round = |x: f64| (x * 65536.0).round() / 65536.0;
        scatter(40, 2.0, false, 1.0, seed).iter().map(|c| c.map(round)).collect()
    };
    let far = 2.0_f64.powi(30);
    let mut coverage = Coverage::new(1.0, 2).unwrap();
    let mut expected = 0.0;
    for (seed, offset) in [(1, [0.0, 0.0]), (2, [far, far]), (3, [-far, 0.0]), (4, [far, -far])] {
        expected += union_area(&set(seed), 1.0);
        for [x, y] in set(seed) {
            coverage.add([x + offset[0], y + offset[1]]).unwrap();
        }
    }
    assert!((coverage.measure() - expected).abs() < 1e-10 * PI);
}
