//! A window has the mean of a plain list of its gains, bit for bit, after any number of them.

mod oracles;

use divbandit_core::bandits::GainWindow;
use oracles::sums::{in_parts, on_paper};
use oracles::{Stream, fixed};
use proptest::prelude::*;

/// Gains as they are, and as a user's own measure may give them; far from overflow.
fn gain() -> impl Strategy<Value = f64> {
    let wild = (any::<u64>(), 0.0..1.0).prop_map(|(bits, share)| {
        let any = f64::from_bits(bits);
        if any.is_finite() && any.abs() < 1e300 { any } else { share }
    });
    prop_oneof![Just(0.0), 1e-19..1.3e-3, -1.0..1.0, Just(2_f64.powi(53)), Just(1.0), wild]
}

fn mean(gains: &[f64], sum: fn(&[f64]) -> f64) -> f64 {
    if gains.is_empty() { 0.0 } else { sum(gains) / gains.len() as f64 }
}

proptest! {
    #![proptest_config(fixed(300))]

    #[test]
    fn equals_a_plain_list(
        size in 0_usize..9,
        head_start in gain(),
        count in 0_usize..11,
        gains in prop::collection::vec(gain(), 0..30),
    ) {
        let mut window = GainWindow::new(size, head_start, count);
        let mut all = vec![head_start; count.min(size)];
        for next in gains.into_iter().map(Some).chain([None]) {
            let kept = &all[all.len() - size.min(all.len())..];
            prop_assert_eq!(window.len(), kept.len());
            prop_assert_eq!(window.is_empty(), kept.is_empty());
            prop_assert_eq!(window.mean().to_bits(), mean(kept, on_paper).to_bits());
            if let Some(gain) = next {
                window.add(gain);
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
        let mut window = GainWindow::new(size, 1.26e-3, 1);
        let mut all = vec![1.26e-3];
        for i in 0..100_000 {
            let gain = plausible(&mut stream);
            window.add(gain);
            all.push(gain);
            // At steps that share no factor with the sizes, and at the last.
            if i % 997 == 0 || i == 99_999 {
                let kept = &all[all.len() - size.min(all.len())..];
                assert_eq!(window.mean().to_bits(), mean(kept, in_parts).to_bits(), "gain {i}");
            }
        }
    }
}

#[test]
fn large_gains_leave_no_rounding_behind_when_they_leave() {
    let mut window = GainWindow::new(2, 1.0, 1);
    for gain in [1e300, 0.1, -1e16, 0.1, 0.1] {
        window.add(gain);
    }
    assert_eq!(window.mean(), 0.1);
}

#[test]
fn a_head_start_is_gone_when_as_many_gains_as_the_window_holds_have_followed() {
    let mut window = GainWindow::new(3, 6.0, 2);
    let means = [3.0, 0.0, 6.0].map(|gain| {
        window.add(gain);
        window.mean()
    });
    assert_eq!(means, [5.0, 3.0, 3.0]);
}

#[test]
fn a_head_start_never_overfills_the_window() {
    let mut window = GainWindow::new(2, 4.0, usize::MAX);
    assert_eq!((window.len(), window.mean()), (2, 4.0));
    window.add(0.0);
    assert_eq!((window.len(), window.mean()), (2, 2.0));
}

/// Room for all of such a window could not be had.
#[test]
fn a_window_takes_room_for_what_is_in_it_only() {
    let mut window = GainWindow::new(usize::MAX, 1.0, 1);
    window.add(2.0);
    assert_eq!(window.mean(), 1.5);
}

#[test]
fn an_infinite_sum_or_what_is_no_number_leaves_no_trace() {
    let mut window = GainWindow::new(2, 1.0, 0);
    for (gain, mean) in [(f64::MAX, f64::MAX), (f64::MAX, f64::INFINITY), (0.0, f64::MAX / 2.0)] {
        window.add(gain);
        assert_eq!(window.mean(), mean);
    }
    window.add(f64::NAN);
    window.add(f64::INFINITY);
    assert_eq!(window.mean(), f64::INFINITY);
    window.add(3.0);
    window.add(4.0);
    assert_eq!(window.mean(), 3.5);
}
