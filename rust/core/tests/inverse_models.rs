//! Inverse models that look at several effects: exact where the answer is known, and never out of
//! the motor space; many goals at once are the goals and commands one after the other.

mod oracles;

use divbandit_core::inverse::{Observed, babble, k_nearest, local_regression};
use divbandit_core::{Bounds, NearestNeighbors, inverse};
use oracles::{Stream, fixed};
use proptest::prelude::*;

/// `n` effects in R^s, some of them the same, and commands in R^m.
fn known(
    s: usize,
    m: usize,
    n: usize,
    stream: &mut Stream,
) -> (Bounds, NearestNeighbors, Vec<f64>) {
    let low: Vec<f64> = (0..m).map(|_| stream.between(-5.0, 5.0)).collect();
    let high = low.iter().map(|a| a + [0.0, 1e-3, 2.0][stream.below(3)]).collect();
    let space = Bounds::new(low, high).unwrap();
    let mut tree = NearestNeighbors::new(s).unwrap();
    for i in 0..n {
        let effect: Vec<f64> = match stream.below(4) {
            0 if i > 0 => tree.points()[..s].to_vec(),
            _ => (0..s).map(|_| stream.between(-1.0, 1.0)).collect(),
        };
        tree.add(&effect).unwrap();
    }
    let commands = (0..n).flat_map(|_| space.sample(&mut || stream.unit())).collect();
    (space, tree, commands)
}

proptest! {
    #![proptest_config(fixed(300))]

    #[test]
    fn commands_stay_in_the_box_and_cost_a_draw_a_coordinate(
        s in 1..=6_usize, m in 1..=8_usize, n in 1..40_usize, k in 1..50_usize, seed: u64,
        d in prop_oneof![Just(0.0), Just(1.0), 0.0..=1.0],
        scale in prop_oneof![Just(1.0), Just(1e-12), Just(1e12), Just(1e200)],
    ) {
        let mut stream = Stream(seed);
        let (space, tree, commands) = known(s, m, n, &mut stream);
        let observed = Observed { effects: &tree, commands: &commands, motor_space: &space };
        let goal: Vec<f64> = (0..s).map(|_| scale * stream.between(-1.5, 1.5)).collect();
        for model in 0..2 {
            let mut draws = 0;
            let mut count = || { draws += 1; stream.unit() };
            let command = match model {
                0 => k_nearest(&goal, k, d, &observed, &mut count),
                _ => local_regression(&goal, k, 1e-3, 1.0, d, &observed, &mut count),
            }.unwrap();
            prop_assert_eq!(draws, m);
            prop_assert!(space.check("command", &command).is_ok());
        }
    }

    #[test]
    fn many_goals_are_one_after_the_other(
        s in 1..=4_usize, m in 1..=8_usize, n in 1..40_usize, many in 0..20_usize, seed: u64,
    ) {
        let mut stream = Stream(seed);
        let (space, tree, commands) = known(s, m, n, &mut stream);
        let goals = Bounds::new(vec![-1.0; s], vec![1.5; s]).unwrap();
        let observed = Observed { effects: &tree, commands: &commands, motor_space: &space };
        let mut plain = Stream(stream.0);
        let found = babble(many, &goals, 0.1, &observed, &mut || stream.unit()).unwrap();
        let (mut drawn, mut expected) = (Vec::new(), Vec::new());
        for _ in 0..many {
            let goal = goals.sample(&mut || plain.unit());
            let mut unit = || plain.unit();
            expected.extend(inverse(&goal, 0.1, &tree, &commands, &space, &mut unit).unwrap());
            drawn.extend(goal);
        }
        prop_assert_eq!(found, (drawn, expected));
        prop_assert_eq!(stream.0, plain.0);
    }
}

#[test]
fn between_two_effects_the_mean_is_by_inverse_distance() {
    let space = Bounds::new(vec![0.0], vec![1.0]).unwrap();
    let mut tree = NearestNeighbors::new(1).unwrap();
    tree.extend(&[0.0, 4.0]).unwrap();
    let observed = Observed { effects: &tree, commands: &[0.0, 1.0], motor_space: &space };
    let mut half = || 0.5;
    assert_eq!(k_nearest(&[1.0], 2, 0.0, &observed, &mut half).unwrap(), [0.25]);
    assert_eq!(k_nearest(&[4.0], 2, 0.0, &observed, &mut half).unwrap(), [1.0]);
}

#[test]
fn a_line_is_fitted_and_followed_no_farther_than_its_reach() {
    let space = Bounds::new(vec![-100.0], vec![100.0]).unwrap();
    let mut tree = NearestNeighbors::new(1).unwrap();
    tree.extend(&[-1.0, 1.0]).unwrap();
    let observed = Observed { effects: &tree, commands: &[3.0, 7.0], motor_space: &space };
    let mut half = || 0.5;
    // At 0 both weigh the same: mean 0, spread 1, and the command is 5 + 2 y.
    for (goal, reach, expected) in [(0.0, 1.0, 5.0), (0.0, 9.0, 5.0)] {
        let command =
            local_regression(&[goal], 2, 1e-12, reach, 0.0, &observed, &mut half).unwrap();
        assert!((command[0] - expected).abs() < 1e-9);
    }
    let far = |reach| local_regression(&[1e6], 2, 1e-12, reach, 0.0, &observed, &mut half.clone());
    // Seen from so far both weigh almost the same again.
    assert!((far(1.0).unwrap()[0] - 7.0).abs() < 1e-3);
    assert!((far(2.5).unwrap()[0] - 10.0).abs() < 1e-3);
    assert_eq!(far(1e6).unwrap(), [100.0]);
}

#[test]
fn what_does_not_fit_is_refused_and_nothing_drawn() {
    let space = Bounds::new(vec![0.0], vec![1.0]).unwrap();
    let mut tree = NearestNeighbors::new(2).unwrap();
    let mut none = || panic!("nothing may be drawn");
    let empty = Observed { effects: &tree, commands: &[], motor_space: &space };
    assert!(k_nearest(&[0.0, 0.0], 1, 0.1, &empty, &mut none).is_err());
    assert!(babble(1, &space, 0.1, &empty, &mut none).is_err());
    tree.add(&[0.0, 0.0]).unwrap();
    let short = Observed { effects: &tree, commands: &[], motor_space: &space };
    assert!(k_nearest(&[0.0, 0.0], 1, 0.1, &short, &mut none).is_err());
    let observed = Observed { effects: &tree, commands: &[0.5], motor_space: &space };
    for (goal, k, d) in [
        (vec![0.0], 1, 0.1),
        (vec![0.0, f64::NAN], 1, 0.1),
        (vec![0.0; 2], 0, 0.1),
        (vec![0.0; 2], 1, 1.5),
    ] {
        assert!(k_nearest(&goal, k, d, &observed, &mut none).is_err());
        assert!(local_regression(&goal, k, 0.1, 1.0, d, &observed, &mut none).is_err());
    }
    for bad in [0.0, -1.0, f64::NAN, f64::INFINITY] {
        assert!(local_regression(&[0.0; 2], 1, bad, 1.0, 0.1, &observed, &mut none).is_err());
        assert!(local_regression(&[0.0; 2], 1, 1.0, bad, 0.1, &observed, &mut none).is_err());
    }
}
