//! The measure depends neither on the order of the effects nor on where they lie, and grows
//! with the square of the scale.

use crate::oracles::{Stream, fixed, scatter};
use divbandit_core::Coverage;
use proptest::prelude::*;

fn measure(effects: &[[f64; 2]], tau: f64) -> f64 {
    let mut coverage = Coverage::new(tau, 2).unwrap();
    coverage.extend(effects.as_flattened(), &mut vec![0.0; effects.len()]).unwrap();
    coverage.measure()
}

type Motion = fn(&[f64; 2]) -> [f64; 2];

proptest! {
    #![proptest_config(fixed(600))]

    #[test]
    fn any_order_has_the_same_total(
        n in 1..150_usize, spread in -3.0..1.5_f64, lattice: bool, tau in 0.001..3.0_f64, seed: u64,
    ) {
        let mut effects = scatter(n, 10_f64.powf(spread), lattice, tau, seed);
        let expected = measure(&effects, tau);
        Stream(seed).shuffle(&mut effects);
        let shuffled = measure(&effects, tau);
        prop_assert!((shuffled - expected).abs() <= 1e-12 * expected);
        effects.sort_by(|a, b| a[0].total_cmp(&b[0]));
        let sorted = measure(&effects, tau);
        prop_assert!((sorted - expected).abs() <= 1e-12 * expected);
    }

    #[test]
    fn a_translation_changes_nothing(
        n in 1..150_usize, spread in -2.0..1.5_f64, seed: u64, by in [-30.0..30.0_f64, -30.0..30.0],
    ) {
        let effects = scatter(n, 10_f64.powf(spread), false, 1.0, seed);
        let moved: Vec<_> = effects.iter().map(|[x, y]| [x + by[0], y + by[1]]).collect();
        // Sums rounded to 4e-15 misplace each of n discs; its rim is at most 2 pi long.
        let rounding = n as f64 * 6.3 * 2.0 * 4e-15;
        prop_assert!((measure(&moved, 1.0) - measure(&effects, 1.0)).abs() <= rounding);
    }

    #[test]
    fn a_rotation_changes_nothing(
        n in 1..150_usize, spread in -2.0..1.5_f64, seed: u64, angle in 0.0..std::f64::consts::TAU,
    ) {
        let effects = scatter(n, 10_f64.powf(spread), false, 1.0, seed);
        let (sine, cosine) = angle.sin_cos();
        let turned: Vec<_> =
            effects.iter().map(|[x, y]| [cosine * x - sine * y, sine * x + cosine * y]).collect();
        let rounding = n as f64 * 6.3 * 2.0 * 8e-15;
        prop_assert!((measure(&turned, 1.0) - measure(&effects, 1.0)).abs() <= rounding);
    }

    #[test]
    fn a_quarter_turn_and_a_reflection_change_nothing_for_lattices(
        n in 1..150_usize, spread in -1.0..1.0_f64, seed: u64,
    ) {
        // Exact motions: also sets full of ties and tangencies must keep their area.
        let effects = scatter(n, 10_f64.powf(spread), true, 1.0, seed);
        let expected = measure(&effects, 1.0);
        let motions: [Motion; 3] = [|&[x, y]| [-y, x], |&[x, y]| [-x, y], |&[x, y]| [y, x]];
        for motion in motions {
            let moved: Vec<_> = effects.iter().map(motion).collect();
            prop_assert!((measure(&moved, 1.0) - expected).abs() <= 1e-12 * expected);
        }
    }

    #[test]
    fn a_scale_multiplies_by_its_square(
        n in 1..150_usize, spread in -2.0..1.5_f64, lattice: bool, tau in 0.001..3.0_f64,
        scale in 1e-6..1e6_f64, power in -60..60_i32, seed: u64,
    ) {
        let effects = scatter(n, 10_f64.powf(spread), lattice, tau, seed);
        let expected = measure(&effects, tau);
        let scaled = |s: f64| -> f64 {
            let effects: Vec<_> = effects.iter().map(|[x, y]| [s * x, s * y]).collect();
            measure(&effects, s * tau) / (s * s)
        };
        // Powers of two scale without rounding: the same bits.
        prop_assert_eq!(scaled(2_f64.powi(power)).to_bits(), expected.to_bits());
        let rounding = 1e-12 * (expected + n as f64 * tau * tau);
        prop_assert!((scaled(scale) - expected).abs() <= rounding);
    }
}
