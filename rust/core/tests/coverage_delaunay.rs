//! Gains and totals agree with those of another family: Voronoi cells on a Delaunay triangulation.

use std::f64::consts::{PI, TAU};

use crate::delaunay::Cells;
use crate::oracles::{Stream, fixed, scatter, union_area};
use divbandit_core::Coverage;
use proptest::prelude::*;

/// How far two gains may be apart, in discs. Seen were 1e-15.
const EACH: f64 = 1e-13;

/// How far the totals may be apart, relatively. Seen were 9e-14, where each of 5000 gains is a
/// rounding of `Coverage`'s sums in size, and 1e-14 elsewhere.
const ALL: f64 = 1e-12;

/// Adds effects to both and compares each gain, the totals, and the triangulation's area from
/// scratch.
fn check(name: &str, effects: &[[f64; 2]], tau: f64) {
    let mut coverage = Coverage::new(tau, 2).unwrap();
    let mut cells: Cells = Cells::new(tau);
    let (disc, mut worst) = (PI * tau * tau, 0.0_f64);
    for (i, &effect) in effects.iter().enumerate() {
        let (ours, theirs) = (coverage.add(effect).unwrap(), cells.add(effect));
        worst = worst.max((ours - theirs).abs() / disc);
        assert!((ours - theirs).abs() <= EACH * disc, "{name}, {i}: {ours:e}, {theirs:e}");
    }
    let error = |area: f64| (coverage.measure() / area - 1.0).abs();
    let (total, area) = (error(cells.measure()), error(cells.area()));
    println!("{name}: gains {worst:.1e} discs, total {total:.1e}, from scratch {area:.1e}");
    assert!(total <= ALL && area <= ALL, "{name}: off by {total:e}, {area:e}");
}

proptest! {
    #![proptest_config(fixed(300))]

    #[test]
    fn for_any_effects(
        n in 1..200_usize, spread in -7.0..1.3_f64, lattice: bool, tau in 0.001..3.0_f64, seed: u64,
    ) {
        check("scatter", &scatter(n, 10_f64.powf(spread), lattice, tau, seed), tau);
    }

    #[test]
    fn and_both_with_the_slabs(
        n in 1..40_usize, spread in -6.0..1.2_f64, lattice: bool, tau in 0.001..3.0_f64, seed: u64,
    ) {
        let effects = scatter(n, 10_f64.powf(spread), lattice, tau, seed);
        let error = crate::delaunay::union_area(&effects, tau) - union_area(&effects, tau);
        prop_assert!(error.abs() <= 1e-10 * PI * tau * tau);
    }
}

#[test]
fn for_even_effects() {
    let mut stream = Stream(1);
    for tau in [0.002, 0.02, 0.2] {
        let set: Vec<_> = (0..20_000).map(|_| [stream.unit(), stream.unit()]).collect();
        check(&format!("even, tau {tau}"), &set, tau);
    }
}

#[test]
fn for_clusters() {
    let mut stream = Stream(2);
    for width in [1.0, 1e-3, 1e-6, 1e-9, 1e-12] {
        let set = (0..5000).map(|i| {
            let [x, y] = stream.normals();
            [f64::from(i % 10) * 0.7 + width * x, 0.3 + width * y]
        });
        check(&format!("clusters {width:e} wide"), &set.collect::<Vec<_>>(), 1.0);
    }
}

#[test]
fn for_lattices() {
    // In order, each row extends a straight hull; shuffled, cocircular fours abound.
    for step in [2.0_f64.sqrt(), 0.5, 1e-3] {
        let mut set: Vec<_> =
            (0..900).map(|i| [f64::from(i % 30) * step, f64::from(i / 30) * step]).collect();
        check(&format!("lattice, step {step}"), &set, 1.0);
        Stream(3).shuffle(&mut set);
        check(&format!("lattice, step {step}, shuffled"), &set, 1.0);
    }
}

#[test]
fn for_lines_and_duplicates() {
    let mut line: Vec<_> = (0..200).map(|i| [f64::from(i % 100) * 0.13, 0.0]).collect();
    check("line", &line, 1.0);
    Stream(4).shuffle(&mut line);
    check("line, shuffled", &line, 1.0);
    line.extend((0..50).map(|i| [f64::from(i) * 0.26, 0.5]));
    check("line and a second", &line, 1.0);
}

#[test]
fn for_centres_on_a_circle() {
    let mut set: Vec<_> = (0..5000).map(|i| (f64::from(i) / 5000.0 * TAU).sin_cos()).collect();
    for radius in [1.0, 1e-3, 1e-9] {
        let scaled: Vec<_> = set.iter().map(|&(y, x)| [radius * x, radius * y]).collect();
        check(&format!("circle of radius {radius:e}"), &scaled, 1.0);
        Stream(5).shuffle(&mut set);
    }
}

/// As goal babbling with tiny perturbations piles effects up: each beside an earlier one, at
/// distances of all magnitudes.
#[test]
fn for_something_like_an_exploration() {
    let mut stream = Stream(6);
    for tau in [0.005, 0.02, 0.1] {
        let mut set = vec![[0.9, 0.1]];
        for i in 1..20_000 {
            let ([x, y], [dx, dy]) = (set[stream.below(i)], stream.normals());
            let step = 10_f64.powf(stream.between(-8.0, -1.5));
            set.push([x + step * dx, y + step * dy]);
        }
        check(&format!("exploration, tau {tau}"), &set, tau);
    }
}

/// Centres evenly on a circle within the discs: from its centre the union is a star of n circular
/// sectors and 2 n triangles.
#[test]
fn and_both_with_a_closed_form() {
    for (n, radius) in [(5, 0.5), (100, 0.9), (5000, 1e-3), (5000, 0.3)] {
        let mut set: Vec<_> = (0..n)
            .map(|i| (f64::from(i) / f64::from(n) * TAU).sin_cos())
            .map(|(y, x)| [radius * x, radius * y])
            .collect();
        let (sine, cosine) = (PI / f64::from(n)).sin_cos();
        let aside = radius * sine;
        let crossing = radius * cosine + (1.0 - aside * aside).sqrt();
        let area = PI + f64::from(n) * (crossing * aside + aside.asin());
        for _ in 0..2 {
            let mut coverage = Coverage::new(1.0, 2).unwrap();
            set.iter().for_each(|&effect| {
                coverage.add(effect).unwrap();
            });
            let theirs = crate::delaunay::union_area(&set, 1.0);
            let error = [coverage.measure(), theirs].map(|measure| (measure / area - 1.0).abs());
            println!("{n} centres at {radius}: ours {:.1e}, Delaunay {:.1e}", error[0], error[1]);
            assert!(error[0] <= ALL && error[1] <= 1e-14, "{n}, {radius}: {error:?}");
            Stream(7).shuffle(&mut set);
        }
    }
}
