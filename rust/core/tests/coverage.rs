//! What a measure of a growing union must obey, whatever the effects are.

use std::f64::consts::PI;

use crate::oracles::{Stream, fixed, scatter};
use divbandit_core::{Coverage, Error};
use proptest::prelude::*;

proptest! {
    #![proptest_config(fixed(600))]

    #[test]
    fn every_gain_is_announced_bounded_and_kept(
        n in 1..120_usize, spread in -3.0..1.5_f64, lattice: bool, tau in 0.001..3.0_f64, seed: u64,
    ) {
        let effects = scatter(n, 10_f64.powf(spread), lattice, tau, seed);
        let mut coverage = Coverage::new(tau, 2).unwrap();
        let mut gains = Vec::new();
        for &effect in &effects {
            let before = coverage.measure();
            let announced = coverage.gain(effect).unwrap();
            prop_assert_eq!(coverage.measure(), before, "gain() alone changes nothing");
            let gain = coverage.add(effect).unwrap();
            prop_assert_eq!(announced.to_bits(), gain.to_bits());
            prop_assert!((0.0..=PI * tau * tau).contains(&gain), "{gain}");
            prop_assert!(coverage.measure() >= before);
            prop_assert_eq!(coverage.gain(effect).unwrap(), 0.0, "right after");
            gains.push(gain);
        }
        prop_assert_eq!(coverage.len(), n);
        prop_assert_eq!(gains[0], coverage.ball());
        let (total, measure) = (gains.iter().sum::<f64>(), coverage.measure());
        prop_assert!((total - measure).abs() <= 1e-13 * measure);

        // Many at once are the same as one by one.
        let mut together = Coverage::new(tau, 2).unwrap();
        let mut written = vec![f64::NAN; n];
        together.extend(effects.as_flattened(), &mut written).unwrap();
        prop_assert_eq!(written, gains);
        prop_assert_eq!(together.measure().to_bits(), coverage.measure().to_bits());
    }

    #[test]
    fn what_was_added_once_gains_exactly_nothing(
        n in 1..120_usize, spread in -3.0..1.5_f64, lattice: bool, tau in 0.001..3.0_f64, seed: u64,
    ) {
        let effects = scatter(n, 10_f64.powf(spread), lattice, tau, seed);
        let mut coverage = Coverage::new(tau, 2).unwrap();
        coverage.extend(effects.as_flattened(), &mut vec![0.0; n]).unwrap();
        let (measure, boundary) = (coverage.measure(), coverage.boundary_integral());
        for &effect in &effects {
            prop_assert_eq!(coverage.add(effect).unwrap(), 0.0);
        }
        prop_assert_eq!(coverage.measure(), measure);
        prop_assert_eq!(coverage.boundary_integral(), boundary, "a repeated disc changes nothing");
    }

    #[test]
    fn a_later_effect_gains_no_more(
        n in 1..60_usize, spread in -2.0..1.0_f64, lattice: bool, seed: u64,
    ) {
        // The gain of a fixed effect falls as others arrive (the measure is submodular).
        let effects = scatter(n, 10_f64.powf(spread), lattice, 1.0, seed);
        let mut coverage = Coverage::new(1.0, 2).unwrap();
        let probe = scatter(1, 10_f64.powf(spread), false, 1.0, !seed)[0];
        let mut last = coverage.gain(probe).unwrap();
        for &effect in &effects {
            coverage.add(effect).unwrap();
            let gain = coverage.gain(probe).unwrap();
            prop_assert!(gain <= last + 1e-14 * n as f64, "{gain} > {last}");
            last = gain;
        }
    }

    #[test]
    fn discs_apart_add_up(
        columns in 1..12_usize, rows in 1..12_usize, gap in 1e-12..2.0_f64, tau in 0.001..3.0_f64,
        seed: u64,
    ) {
        let step = 2.0 * tau * (1.0 + gap);
        let mut effects: Vec<[f64; 2]> = (0..columns * rows)
            .map(|i| [(i % columns) as f64 * step, (i / columns) as f64 * step])
            .collect();
        Stream(seed).shuffle(&mut effects);
        let mut coverage = Coverage::new(tau, 2).unwrap();
        for &effect in &effects {
            prop_assert_eq!(coverage.add(effect).unwrap(), coverage.ball());
        }
        let expected = (columns * rows) as f64 * PI * tau * tau;
        prop_assert!((coverage.measure() - expected).abs() <= 1e-15 * expected);
    }
}

#[test]
fn a_radius_has_a_square() {
    for tau in [0.0, -1.0, f64::NAN, f64::INFINITY, 0.9e-100, 1.1e100] {
        let message = Coverage::new(tau, 2).unwrap_err().to_string();
        assert_eq!(
            message,
            format!("tau must be a positive radius in [1e-100, 1e100], got {tau:?}")
        );
    }
    for tau in [1e-100, 1e100] {
        let mut coverage = Coverage::new(tau, 2).unwrap();
        coverage.add([0.0, 0.0]).unwrap();
        coverage.add([tau * 8.0, tau]).unwrap();
        assert_eq!(coverage.measure(), 2.0 * PI * tau * tau);
    }
}

#[test]
fn a_refusal_adds_nothing() {
    let mut coverage = Coverage::new(0.1, 2).unwrap();
    for i in 0..30 {
        coverage.add([f64::from(i * i % 7) * 0.03, f64::from(i % 5) * 0.05]).unwrap();
    }
    let before = format!("{coverage:?}");
    let message = |refused: Result<f64, Error>| refused.unwrap_err().to_string();
    assert_eq!(message(coverage.add([f64::NAN, 0.0])), "effect[0] must be finite, got NaN");
    assert_eq!(message(coverage.gain([0.0, f64::INFINITY])), "effect[1] must be finite, got inf");
    let mut gains = [7.25; 3];
    let mut extend = |effects: &[f64], room: usize| {
        coverage.extend(effects, &mut gains[..room]).unwrap_err().to_string()
    };
    assert_eq!(extend(&[5.0; 5], 2), "effects must be whole rows of 2 numbers, got 5");
    assert_eq!(extend(&[5.0; 6], 2), "gains must have length 3, got 2");
    let culprit = extend(&[5.0, 5.0, 6.0, 6.0, f64::NAN, 7.0], 3);
    assert_eq!(culprit, "effects[2, 0] must be finite, got NaN");
    assert_eq!(gains, [7.25; 3]);
    assert_eq!(format!("{coverage:?}"), before);
}
