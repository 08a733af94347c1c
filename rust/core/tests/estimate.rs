//! The laws of estimated gains: bounds, exact cases, repetition, copies, extremes.

use crate::oracles::{Stream, fixed};
use divbandit_core::coverage::estimate::{Estimate, Estimated};
use proptest::prelude::*;

const EXACT_ZERO: Estimated = Estimated { gain: 0.0, standard_error: 0.0 };

fn scatter(n: usize, dim: usize, spread: f64, seed: u64) -> Vec<Vec<f64>> {
    let mut stream = Stream(seed);
    (0..n).map(|_| (0..dim).map(|_| stream.between(-spread, spread)).collect()).collect()
}

proptest! {
    #![proptest_config(fixed(150))]

    #[test]
    fn gains_are_gains(n in 1_usize..25, dim in 1_usize..12, spread in 0.05..2.0, key: u64) {
        let effects = scatter(n, dim, spread, key);
        let mut estimate = Estimate::new(0.5, dim, 0.02, key);
        let mut before = Estimate::new(0.5, dim, 0.02, key).insert(&effects[n - 1]);
        for (i, effect) in effects.iter().enumerate() {
            let mut copy = estimate.clone();
            let gain = estimate.gain(effect);
            prop_assert!((0.0..=estimate.ball()).contains(&gain.gain));
            prop_assert!((0.0..=0.02 * estimate.ball()).contains(&gain.standard_error));
            // Asking changes nothing, neither here nor in a copy.
            prop_assert_eq!(gain, copy.insert(effect));
            prop_assert_eq!(gain, estimate.insert(effect));
            // What has been added adds nothing, exactly.
            prop_assert_eq!(estimate.insert(effect), EXACT_ZERO);
            prop_assert_eq!(copy.insert(effect), EXACT_ZERO);
            // The last effect's gain only shrinks, within errors.
            if i + 1 < n {
                let now = estimate.gain(&effects[n - 1]);
                let error = now.standard_error.hypot(before.standard_error);
                prop_assert!(now.gain <= before.gain + 5.0 * error, "{now:?} {before:?}");
                before = now;
            }
        }
    }
}

#[test]
fn where_nothing_overlaps_a_gain_is_a_ball() {
    for dim in 1..=32 {
        let mut estimate = Estimate::new(0.25, dim, 1e-3, 1);
        let ball = Estimated { gain: estimate.ball(), standard_error: 0.0 };
        for i in 0..20 {
            let mut effect = vec![0.125; dim];
            effect[i % dim] += 0.5 * i as f64; // touching neighbours included
            assert_eq!(estimate.insert(&effect), ball);
        }
    }
}

/// One older ball: everything but the lens, in three dimensions d (12 - d^2) / 16.
#[test]
fn one_neighbour_is_exact() {
    for i in 1..200 {
        let d = 0.01 * f64::from(i);
        let mut estimate = Estimate::new(1.0, 3, 0.1, 1);
        estimate.insert(&[0.0, 0.0, 0.0]);
        let found = estimate.gain(&[0.0, d, 0.0]);
        let error = found.gain / estimate.ball() - d * (12.0 - d * d) / 16.0;
        assert!(error.abs() < 1e-14, "{d}: {error}");
        assert!(found.standard_error < 1e-12);
    }
}

#[test]
fn finite_effects_give_finite_gains() {
    for tau in [1e-100, 1e-3, 1.0, 1e100] {
        for dim in [1, 2, 4, 32] {
            let mut estimate = Estimate::new(tau, dim, 0.02, 5);
            let mut stream = Stream(1);
            for scale in [0.0, 1e-300, 1e-9, 1.0, 1e9, 1e300, f64::MAX] {
                for tau in [1.0, tau] {
                    for _ in 0..3 {
                        let effect: Vec<f64> = (0..dim)
                            .map(|_| {
                                (stream.between(-1.0, 1.0) * scale * tau).clamp(f64::MIN, f64::MAX)
                            })
                            .collect();
                        let found = estimate.insert(&effect);
                        assert!(!found.gain.is_nan() && !found.standard_error.is_nan());
                        assert!((0.0..=estimate.ball()).contains(&found.gain));
                        assert_eq!(estimate.gain(&effect), EXACT_ZERO);
                    }
                }
            }
        }
    }
}

/// Lattices, where balls touch, coincide and meet in many at once.
#[test]
fn lattices_keep_within_the_laws() {
    for dim in [2, 3, 4, 6] {
        let mut estimate = Estimate::new(1.0, dim, 0.02, 9);
        let mut stream = Stream(dim as u64);
        for _ in 0..150 {
            let effect: Vec<f64> = (0..dim).map(|_| 0.5 * stream.below(5) as f64).collect();
            let gain = estimate.insert(&effect).gain;
            assert!((0.0..=estimate.ball()).contains(&gain));
            assert_eq!(estimate.insert(&effect), EXACT_ZERO);
        }
    }
}

/// Over many keys the mean meets the closed form: balls at -a and b of one line cover their
/// lenses, less the lens of each other.
#[test]
fn the_mean_is_unbiased() {
    let (a, b, keys) = (0.7, 0.9, 2000);
    // In five dimensions 1 - lens is (15 x - 10 x^3 + 3 x^5) / 8, x half the distance.
    let outside = |d: f64| {
        let x = 0.5 * d;
        x * (15.0 - 10.0 * x * x + 3.0 * x * x * x * x) / 8.0
    };
    let truth = outside(a) + outside(b) - outside(a + b);
    let (mut mean, mut squares) = (0.0, 0.0);
    for key in 0..keys {
        let mut estimate = Estimate::new(1.0, 5, 0.02, key);
        estimate.insert(&[0.0, 0.0, -a, 0.0, 0.0]);
        estimate.insert(&[0.0, 0.0, b, 0.0, 0.0]);
        let off = estimate.gain(&[0.0; 5]).gain / estimate.ball() - truth;
        mean += off / keys as f64;
        squares += off * off / keys as f64;
    }
    let error = (squares / keys as f64).sqrt();
    println!("mean error {mean:.2e}, its standard error {error:.2e}");
    assert!(mean.abs() < 4.0 * error, "{mean} +- {error}");
}
