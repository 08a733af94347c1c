//! What holds for any union of balls: order, gains, duplicates, motions, extremes.

use std::f64::consts::PI;

use crate::oracles::space::scatter;
use crate::oracles::{Stream, fixed};
use divbandit_core::coverage::space::Balls;
use proptest::prelude::*;

const BALL: f64 = 4.0 * PI / 3.0;

fn volume(effects: &[[f64; 3]], tau: f64) -> f64 {
    let mut balls = Balls::new(tau);
    effects.iter().map(|&effect| balls.insert(effect)).sum()
}

#[test]
fn a_ball_that_touches_none_gains_the_same_bits() {
    let tau = 0.3;
    let mut balls = Balls::new(tau);
    let first = balls.insert([0.0; 3]);
    assert!((first / (tau * tau * tau) - BALL).abs() <= 4.0 * f64::EPSILON);
    for i in 1..200 {
        let far = f64::from(i) * 0.6001;
        assert_eq!(balls.insert([far, -far, 0.5 * far]).to_bits(), first.to_bits());
    }
    // Touching is no overlap.
    assert_eq!(balls.insert([0.0, 0.6, 0.0]).to_bits(), first.to_bits());
    assert_eq!(balls.stored(), 201);
}

#[test]
fn extreme_coordinates_do_no_harm() {
    let extremes = [0.0, 1e-300, -1e-30, 1.0, 1e15, -1e16, 1e150, -1e300, 1e300];
    for tau in [1e-100, 1e-9, 1.0, 1e100] {
        let mut balls = Balls::new(tau);
        let lone = balls.gain([0.0; 3]);
        for x in extremes {
            for y in extremes {
                for z in extremes {
                    let gain = balls.insert([x, y, z]);
                    assert!((0.0..=lone).contains(&gain), "{tau} {x} {y} {z}: {gain}");
                    assert_eq!(balls.insert([x, y, z]), 0.0);
                }
            }
        }
    }
}

#[test]
fn a_void_can_be_filled() {
    // Centres evenly on a sphere of radius 1.2: the union is a shell with a void inside.
    let n = 400;
    let shell: Vec<[f64; 3]> = (0..n)
        .map(|i| {
            let z = (2.0 * f64::from(i) + 1.0) / f64::from(n) - 1.0;
            let (sine, cosine) = (f64::from(i) * 2.399_963_229_728_653).sin_cos();
            let r = (1.0 - z * z).sqrt();
            [1.2 * r * cosine, 1.2 * r * sine, 1.2 * z]
        })
        .collect();
    let mut balls = Balls::new(1.0);
    for &centre in &shell {
        balls.insert(centre);
    }
    let void = balls.insert([0.01, 0.02, -0.01]);
    // Each point of the void is within 0.2 of the middle and a little more between centres.
    assert!(void > BALL * 0.008 && void < BALL * 0.012, "{}", void / BALL);
    assert_eq!(balls.insert([0.0; 3]), 0.0);
    let filled: Vec<_> = shell.iter().copied().chain([[0.01, 0.02, -0.01]]).collect();
    let difference = volume(&filled, 1.0) - volume(&shell, 1.0);
    assert!((difference - void).abs() < 1e-12);
}

#[test]
fn redundant_balls_do_not_add_up() {
    let mut stream = Stream(3);
    let mut balls = Balls::new(1.0);
    let mut total = 0.0;
    for _ in 0..30_000 {
        total += balls.insert([0; 3].map(|_| 1e-9 * stream.between(-1.0, 1.0)));
    }
    // A ball moved about by a cube of edge 2e-9: its surface's projections, to first order.
    let swept = BALL + 2e-9 * 3.0 * PI;
    assert!((total - swept).abs() < 2e-9, "{}", (total - BALL) / (swept - BALL));
    assert!(balls.stored() < 1000, "{}", balls.stored());
}

proptest! {
    #![proptest_config(fixed(300))]

    #[test]
    fn any_order_has_the_same_total(
        n in 1..150_usize, spread in -3.0..1.0_f64, lattice: bool, tau in 0.001..3.0_f64, seed: u64,
    ) {
        let mut effects = scatter(n, 10_f64.powf(spread), lattice, tau, seed);
        let expected = volume(&effects, tau);
        Stream(seed).shuffle(&mut effects);
        prop_assert!((volume(&effects, tau) - expected).abs() <= 1e-13 * expected);
        effects.sort_by(|a, b| a[0].total_cmp(&b[0]));
        prop_assert!((volume(&effects, tau) - expected).abs() <= 1e-13 * expected);
    }

    #[test]
    fn perturbed_lattices_in_any_order(
        n in 1..150_usize, spread in -0.5..0.6_f64, jitter in -16.0..-3.0_f64, seed: u64,
    ) {
        let mut stream = Stream(seed);
        let mut effects = scatter(n, 10_f64.powf(spread), true, 1.0, seed);
        for x in effects.as_flattened_mut() {
            *x += 10_f64.powf(jitter) * stream.between(-1.0, 1.0);
        }
        let expected = volume(&effects, 1.0);
        stream.shuffle(&mut effects);
        prop_assert!((volume(&effects, 1.0) - expected).abs() <= 1e-13 * expected);
    }

    #[test]
    fn clusters_of_any_width_in_any_order(
        n in 1..100_usize, width in -12.0..0.0_f64, far in 0.0..2.1_f64, seed: u64,
    ) {
        let mut stream = Stream(seed);
        let mut effects: Vec<[f64; 3]> = (0..n)
            .map(|_| [0; 3].map(|_| 10_f64.powf(width) * stream.normals()[0]))
            .collect();
        // A second cluster, that overlaps with the first or just touches it.
        for effect in &mut effects[n / 2..] {
            effect[0] += far;
        }
        let expected = volume(&effects, 1.0);
        stream.shuffle(&mut effects);
        let shuffled = volume(&effects, 1.0);
        prop_assert!((shuffled - expected).abs() <= 1e-13 * n as f64 * BALL);
    }

    #[test]
    fn announced_is_added_within_a_ball_and_never_again(
        n in 1..100_usize, spread in -2.0..1.0_f64, lattice: bool, seed: u64,
    ) {
        let mut balls = Balls::new(1.0);
        let lone = balls.gain([0.0; 3]);
        for effect in scatter(n, 10_f64.powf(spread), lattice, 1.0, seed) {
            let stored = balls.stored();
            let announced = balls.gain(effect);
            prop_assert_eq!(balls.stored(), stored);
            let gain = balls.insert(effect);
            prop_assert_eq!(gain.to_bits(), announced.to_bits());
            prop_assert!((0.0..=lone).contains(&gain));
            prop_assert_eq!(balls.stored(), stored + usize::from(gain > 0.0));
            prop_assert_eq!(balls.insert(effect), 0.0);
        }
    }

    #[test]
    fn a_larger_union_leaves_less_to_gain(
        n in 1..60_usize, spread in -2.0..0.7_f64, lattice: bool, seed: u64,
    ) {
        let effects = scatter(n + 20, 10_f64.powf(spread), lattice, 1.0, seed);
        let (old, new) = effects.split_at(n);
        let (mut small, mut large) = (Balls::new(1.0), Balls::new(1.0));
        for (i, &effect) in old.iter().enumerate() {
            large.insert(effect);
            if i % 2 == 0 {
                small.insert(effect);
            }
        }
        for &effect in new {
            prop_assert!(large.gain(effect) <= small.gain(effect) + 2e-13 * BALL);
        }
    }

    #[test]
    fn exact_motions_change_nothing(
        n in 1..100_usize, spread in -1.0..0.8_f64, by in -1000..1000_i32, seed: u64,
    ) {
        let effects = scatter(n, 10_f64.powf(spread), true, 1.0, seed);
        let expected = volume(&effects, 1.0);
        let by = f64::from(by);
        type Motion = fn(&[f64; 3], f64) -> [f64; 3];
        let motions: [Motion; 4] = [
            |&[x, y, z], by| [x + by, y - by, z + 0.5 * by],
            |&[x, y, z], _| [y, z, x],
            |&[x, y, z], _| [-y, x, z],
            |&[x, y, z], _| [x, y, -z],
        ];
        for motion in motions {
            let moved: Vec<_> = effects.iter().map(|effect| motion(effect, by)).collect();
            prop_assert!((volume(&moved, 1.0) - expected).abs() <= 1e-13 * expected);
        }
    }

    #[test]
    fn a_translation_changes_nothing(
        n in 1..100_usize, spread in -2.0..1.0_f64, seed: u64, by in -30.0..30.0_f64,
    ) {
        let effects = scatter(n, 10_f64.powf(spread), false, 1.0, seed);
        let moved: Vec<_> = effects.iter().map(|&[x, y, z]| [x + by, y - by, z]).collect();
        // Sums rounded to 4e-15 misplace each of n balls; its surface is 4 pi.
        let rounding = n as f64 * 4.0 * PI * 2.0 * 4e-15;
        prop_assert!((volume(&moved, 1.0) - volume(&effects, 1.0)).abs() <= rounding);
    }

    #[test]
    fn a_power_of_two_scales_without_rounding(
        n in 1..100_usize, spread in -2.0..1.0_f64, lattice: bool, power in -60..60_i32, seed: u64,
    ) {
        let effects = scatter(n, 10_f64.powf(spread), lattice, 1.0, seed);
        let scale = 2_f64.powi(power);
        let scaled: Vec<_> = effects.iter().map(|effect| effect.map(|x| scale * x)).collect();
        let found = volume(&scaled, scale) / (scale * scale * scale);
        prop_assert_eq!(found.to_bits(), volume(&effects, 1.0).to_bits());
    }
}
