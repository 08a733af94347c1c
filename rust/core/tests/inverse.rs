//! A perturbed command stays in the box and near its parent, and costs one draw a coordinate.

mod oracles;

use divbandit_core::{Bounds, Error, NearestNeighbors, inverse};
use oracles::{Stream, by_distance, fixed};
use proptest::prelude::*;

/// What an exploration knows: effects in 2-D and the commands behind them.
struct Known {
    space: Bounds,
    effects: Vec<Vec<f64>>,
    tree: NearestNeighbors,
    commands: Vec<f64>,
}

fn known(m: usize, n: usize, stream: &mut Stream) -> Known {
    let low: Vec<f64> = (0..m).map(|_| stream.between(-5.0, 5.0)).collect();
    let high = low.iter().map(|a| a + [0.0, 1e-3, 2.0][stream.below(3)]).collect();
    let space = Bounds::new(low, high).unwrap();
    let effects: Vec<Vec<f64>> =
        (0..n).map(|_| vec![stream.between(-1.0, 1.0), stream.between(-1.0, 1.0)]).collect();
    let mut tree = NearestNeighbors::new(2).unwrap();
    tree.extend(&effects.concat()).unwrap();
    let commands = (0..n).flat_map(|_| space.sample(&mut || stream.unit())).collect();
    Known { space, effects, tree, commands }
}

proptest! {
    #![proptest_config(fixed(400))]

    #[test]
    fn a_command_is_near_the_nearest_effects(
        m in 1..=20_usize, n in 1..60_usize, seed: u64,
        d in prop_oneof![Just(0.0), Just(1.0), 0.0..=1.0, 1e-17..1e-12],
    ) {
        let mut stream = Stream(seed);
        let Known { space, effects, tree, commands } = known(m, n, &mut stream);
        let goal = [stream.between(-1.5, 1.5), stream.between(-1.5, 1.5)];
        let parent = &commands[by_distance(&effects, &goal)[0].1 * m..][..m];
        let mut draws = Vec::new();
        let mut count = || { draws.push(stream.unit()); draws[draws.len() - 1] };
        let command = inverse(&goal, d, &tree, &commands, &space, &mut count).unwrap();

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
        let Known { space, effects, tree, commands } = known(m, n, &mut stream);
        let i = stream.below(n);
        let first = effects.iter().position(|effect| *effect == effects[i]).unwrap();
        let mut unit = || stream.unit();
        let command = inverse(&effects[i], 0.0, &tree, &commands, &space, &mut unit).unwrap();
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
    let Known { space, tree, commands, .. } = known(3, 10, &mut Stream(1));
    let empty = NearestNeighbors::new(2).unwrap();
    let mut draws = 0;
    let mut ask = |goal: &[f64], d: f64, tree: &NearestNeighbors, commands: &[f64]| {
        let mut count = || {
            draws += 1;
            0.5
        };
        let refused: Error = inverse(goal, d, tree, commands, &space, &mut count).unwrap_err();
        refused.to_string()
    };
    let goal = [0.0, 0.0];
    assert_eq!(ask(&goal, 0.1, &empty, &[]), "the set of points must not be empty");
    assert_eq!(ask(&goal, -0.1, &tree, &commands), "d must be in [0, 1], got -0.1");
    assert_eq!(ask(&goal, 1.5, &tree, &commands), "d must be in [0, 1], got 1.5");
    assert_eq!(ask(&goal, f64::NAN, &tree, &commands), "d must be in [0, 1], got NaN");
    assert_eq!(ask(&[0.0], 0.1, &tree, &commands), "goal must have length 2, got 1");
    assert_eq!(ask(&[0.0, f64::NAN], 0.1, &tree, &commands), "goal[1] must be finite, got NaN");
    assert_eq!(ask(&goal, 0.1, &tree, &commands[1..]), "commands must have length 30, got 29");
    let outside = ask(&goal, 0.1, &tree, &[99.0; 30]);
    assert!(outside.starts_with("parent[0] must be in the range ["), "{outside}");
    assert_eq!(draws, 0);
}
