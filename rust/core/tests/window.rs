//! A window has the mean of a plain list of its rewards, bit for bit, after any number of them.

use crate::oracles::sums::{in_parts, on_paper};
use crate::oracles::{Stream, fixed};
use divbandit_core::bandits::estimators::{Estimator, EstimatorKind};
use proptest::prelude::*;

/// Gains as they are, and as a user's own measure may give them; far from overflow.
fn gain() -> impl Strategy<Value = f64> {
    let wild = (any::<u64>(), 0.0..1.0).prop_map(|(bits, share)| {
        let any = f64::from_bits(bits);
        if any.is_finite() && any.abs() < 1e300 { any } else { share }
    });
    prop_oneof![Just(0.0), 1e-19..1.3e-3, -1.0..1.0, Just(2_f64.powi(53)), Just(1.0), wild]
}

/// The window of one part that begins with `head_start` rewards of `largest`.
fn window(size: usize, largest: f64, head_start: usize) -> Box<dyn Estimator> {
    EstimatorKind::Window { size, head_start }.start(1, largest).unwrap()
}

fn mean(gains: &[f64], sum: fn(&[f64]) -> f64) -> f64 {
    if gains.is_empty() { 0.0 } else { sum(gains) / gains.len() as f64 }
}

proptest! {
    #![proptest_config(fixed(300))]

    #[test]
    fn equals_a_plain_list(
        size in 1_usize..9,
        largest in gain(),
        head_start in 0_usize..9,
        gains in prop::collection::vec(gain(), 0..30),
    ) {
        let (largest, head_start) = (largest.abs(), head_start.min(size));
        let mut window = window(size, largest, head_start);
        let mut all = vec![largest; head_start];
        for next in gains.into_iter().map(Some).chain([None]) {
            let kept = &all[all.len() - size.min(all.len())..];
            prop_assert_eq!(window.counts(), [kept.len() as f64]);
            prop_assert_eq!(window.means()[0].to_bits(), mean(kept, on_paper).to_bits());
            if let Some(gain) = next {
                window.add(0, gain);
                all.push(gain);
            }
        }
    }
}

/// What gains look like: many zeros, most of the others small, over sixteen orders of magnitude.
fn plausible(stream: &mut Stream) -> f64 {
    let gain = 1.26e-3 * 10_f64.powf(-16.0 * stream.unit());
    if stream.below(5) == 0 { 0.0 } else { gain }
}

#[test]
fn never_drifts() {
    for size in [1, 50, 3000] {
        let mut stream = Stream(7);
        let mut window = window(size, 1.26e-3, 1);
        let mut all = vec![1.26e-3];
        for i in 0..100_000 {
            let gain = plausible(&mut stream);
            window.add(0, gain);
            all.push(gain);
            // At steps that share no factor with the sizes, and at the last.
            if i % 997 == 0 || i == 99_999 {
                let kept = &all[all.len() - size.min(all.len())..];
                assert_eq!(window.means()[0].to_bits(), mean(kept, in_parts).to_bits(), "gain {i}");
            }
        }
    }
}

#[test]
fn large_gains_leave_no_rounding_behind_when_they_leave() {
    let mut window = window(2, 1.0, 1);
    for gain in [1e300, 0.1, -1e16, 0.1, 0.1] {
        window.add(0, gain);
    }
    assert_eq!(window.means()[0], 0.1);
}

#[test]
fn a_head_start_is_gone_when_as_many_gains_as_the_window_holds_have_followed() {
    let mut window = window(3, 6.0, 2);
    let means = [3.0, 0.0, 6.0].map(|gain| {
        window.add(0, gain);
        window.means()[0]
    });
    assert_eq!(means, [5.0, 3.0, 3.0]);
}

#[test]
fn an_infinite_sum_leaves_no_trace() {
    let mut window = window(2, 1.0, 0);
    for (gain, mean) in [(f64::MAX, f64::MAX), (f64::MAX, f64::INFINITY), (0.0, f64::MAX / 2.0)] {
        window.add(0, gain);
        assert_eq!(window.means()[0], mean);
    }
    window.add(0, 3.0);
    window.add(0, 4.0);
    assert_eq!(window.means()[0], 3.5);
}
