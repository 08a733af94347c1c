//! A perturbed command stays in the box and near its parent, and costs one draw a coordinate.

use crate::oracles::past::past;
use crate::oracles::{Stream, by_distance, fixed};
use divbandit_core::inverse::{InverseModel, Nearest};
use divbandit_core::{Bounds, History};
use proptest::prelude::*;

/// What an exploration knows: effects in 2-D and the commands behind them.
struct Known {
    space: Bounds,
    effects: Vec<Vec<f64>>,
    history: History,
    commands: Vec<f64>,
}

fn known(m: usize, n: usize, stream: &mut Stream) -> Known {
    let low: Vec<f64> = (0..m).map(|_| stream.between(-5.0, 5.0)).collect();
    let high = low.iter().map(|a| a + [0.0, 1e-3, 2.0][stream.below(3)]).collect();
    let space = Bounds::new(low, high).unwrap();
    let effects: Vec<Vec<f64>> =
        (0..n).map(|_| vec![stream.between(-1.0, 1.0), stream.between(-1.0, 1.0)]).collect();
    let commands: Vec<f64> = (0..n).flat_map(|_| space.sample(&mut || stream.unit())).collect();
    let history = past(&space, None, 2, &commands, &effects.concat());
    Known { space, effects, history, commands }
}

proptest! {
    #![proptest_config(fixed(400))]

    #[test]
    fn a_command_is_near_the_nearest_effects(
        m in 1..=20_usize, n in 1..60_usize, seed: u64,
        d in prop_oneof![Just(0.0), Just(1.0), 0.0..=1.0, 1e-17..1e-12],
    ) {
        let mut stream = Stream(seed);
        let Known { space, effects, mut history, commands } = known(m, n, &mut stream);
        let goal = [stream.between(-1.5, 1.5), stream.between(-1.5, 1.5)];
        let parent = &commands[by_distance(&effects, &goal)[0].1 * m..][..m];
        let mut draws = Vec::new();
        let mut count = || { draws.push(stream.unit()); draws[draws.len() - 1] };
        let mut command = vec![0.0; m];
        let mut model = Nearest::new(d).unwrap();
        model.command(&goal, &mut history, &mut count, &mut command).unwrap();

        prop_assert_eq!(draws.len(), m);
        prop_assert!(space.check("command", &command).is_ok());
        for j in 0..m {
            let (a, b) = (space.low()[j], space.high()[j]);
            let (x, reach) = (parent[j], d * (b - a));
            let rounding = 4.0 * f64::EPSILON * (x.abs() + b - a);
            prop_assert!((command[j] - x).abs() <= reach + rounding);
            // Uniform, so the draw says how far from the lower end to the upper.
            let (from, to) = (a.max(x - reach), b.min(x + reach));
            prop_assert!((command[j] - (from + draws[j] * (to - from))).abs() <= rounding);
        }
    }

    #[test]
    fn without_perturbation_the_parent_returns(m in 1..=20_usize, n in 1..60_usize, seed: u64) {
        let mut stream = Stream(seed);
        let Known { effects, mut history, commands, .. } = known(m, n, &mut stream);
        let i = stream.below(n);
        let first = effects.iter().position(|effect| *effect == effects[i]).unwrap();
        let mut unit = || stream.unit();
        let mut command = vec![0.0; m];
        let mut model = Nearest::new(0.0).unwrap();
        model.command(&effects[i], &mut history, &mut unit, &mut command).unwrap();
        prop_assert_eq!(&command[..], &commands[first * m..][..m]);
    }
}

#[test]
fn the_largest_draw_does_not_leave_the_box() {
    let space = Bounds::new(vec![-0.3, 0.1], vec![0.1, 0.7]).unwrap();
    let mut largest = || 1.0_f64.next_down();
    for d in [0.1, 0.3, 1.0] {
        let command = space.perturb(&[0.1, 0.7], d, &mut largest).unwrap();
        assert!(space.check("command", &command).is_ok(), "{command:?}");
    }
    let mut least = || 0.0;
    assert_eq!(space.perturb(&[0.1, 0.7], 1.0, &mut least).unwrap(), [-0.3, 0.1]);
}

#[test]
fn a_refusal_draws_nothing() {
    let Known { space, mut history, .. } = known(3, 10, &mut Stream(1));
    let mut none = || panic!("nothing may be drawn");
    let mut ask = |goal: &[f64], history: &mut History, m: usize| {
        let mut model = Nearest::new(0.1).unwrap();
        model.command(goal, history, &mut none, &mut vec![0.0; m]).unwrap_err().to_string()
    };
    let goal = [0.0, 0.0];
    let mut empty = past(&space, None, 2, &[], &[]);
    assert_eq!(ask(&goal, &mut empty, 3), "history must not be empty");
    assert_eq!(ask(&[0.0], &mut history, 3), "goal must have length 2, got 1");
    assert_eq!(ask(&[0.0, f64::NAN], &mut history, 3), "goal[1] must be finite, got NaN");
    assert_eq!(ask(&goal, &mut history, 2), "command must have length 3, got 2");
    let corner = space.low().to_vec();
    let mut forgetful = History::new(space, None, false, 0).unwrap();
    forgetful.record(&corner, &[0.0; 2], &[], &[]).unwrap();
    assert_eq!(ask(&goal, &mut forgetful, 3), "commands must have length 3, got 0");
    for (d, said) in [(-0.1, "-0.1"), (1.5, "1.5"), (f64::NAN, "NaN")] {
        let expected = format!("d must be in [0, 1], got {said}");
        assert_eq!(Nearest::new(d).unwrap_err().to_string(), expected);
    }
}
