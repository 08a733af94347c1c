//! Inverse models that look at several effects: exact where the answer is known, and never out of
//! the motor space.

use crate::oracles::past::past;
use crate::oracles::{Stream, fixed};
use divbandit_core::inverse::{InverseModel, KNearest, LocalRegression};
use divbandit_core::{Bounds, Error, History};
use proptest::prelude::*;

/// `n` effects in R^s, some of them the same, and commands in R^m.
fn known(s: usize, m: usize, n: usize, stream: &mut Stream) -> (Bounds, History) {
    let low: Vec<f64> = (0..m).map(|_| stream.between(-5.0, 5.0)).collect();
    let high = low.iter().map(|a| a + [0.0, 1e-3, 2.0][stream.below(3)]).collect();
    let space = Bounds::new(low, high).unwrap();
    let mut effects: Vec<f64> = Vec::new();
    for i in 0..n {
        match stream.below(4) {
            0 if i > 0 => effects.extend_from_within(..s),
            _ => effects.extend((0..s).map(|_| stream.between(-1.0, 1.0))),
        }
    }
    let commands: Vec<f64> = (0..n).flat_map(|_| space.sample(&mut || stream.unit())).collect();
    let history = past(&space, None, s, &commands, &effects);
    (space, history)
}

/// The command of one motor coordinate that a model makes with all draws a half.
fn one(
    model: Result<impl InverseModel, Error>,
    goal: f64,
    history: &mut History,
) -> Result<f64, Error> {
    let mut command = [0.0];
    model?.command(&[goal], history, &mut || 0.5, &mut command)?;
    Ok(command[0])
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
        let (space, mut history) = known(s, m, n, &mut stream);
        let goal: Vec<f64> = (0..s).map(|_| scale * stream.between(-1.5, 1.5)).collect();
        for model in 0..2 {
            let mut draws = 0;
            let mut count = || { draws += 1; stream.unit() };
            let mut command = vec![0.0; m];
            let mut model: Box<dyn InverseModel> = match model {
                0 => Box::new(KNearest::new(k, d).unwrap()),
                _ => Box::new(LocalRegression::new(k, d, 1e-3, 1.0).unwrap()),
            };
            model.command(&goal, &mut history, &mut count, &mut command).unwrap();
            prop_assert_eq!(draws, m);
            prop_assert!(space.check("command", &command).is_ok());
        }
    }

    #[test]
    fn a_model_remembers_nothing(
        s in 1..=4_usize, m in 1..=8_usize, n in 1..40_usize, k in 1..50_usize, seed: u64,
    ) {
        let mut stream = Stream(seed);
        let (_, mut history) = known(s, m, n, &mut stream);
        let fresh = || (KNearest::new(k, 0.1).unwrap(), LocalRegression::new(k, 0.1, 1e-3, 1.0).unwrap());
        let mut old = fresh();
        for _ in 0..5 {
            let goal: Vec<f64> = (0..s).map(|_| stream.between(-1.5, 1.5)).collect();
            let mut new = fresh();
            let (mut one, mut other) = (vec![0.0; m], vec![0.0; m]);
            old.0.command(&goal, &mut history, &mut || 0.3, &mut one).unwrap();
            new.0.command(&goal, &mut history, &mut || 0.3, &mut other).unwrap();
            prop_assert_eq!(&one, &other);
            old.1.command(&goal, &mut history, &mut || 0.3, &mut one).unwrap();
            new.1.command(&goal, &mut history, &mut || 0.3, &mut other).unwrap();
            prop_assert_eq!(&one, &other);
        }
    }
}

#[test]
fn between_two_effects_the_mean_is_by_inverse_distance() {
    let space = Bounds::new(vec![0.0], vec![1.0]).unwrap();
    let mut history = past(&space, None, 1, &[0.0, 1.0], &[0.0, 4.0]);
    assert_eq!(one(KNearest::new(2, 0.0), 1.0, &mut history), Ok(0.25));
    assert_eq!(one(KNearest::new(2, 0.0), 4.0, &mut history), Ok(1.0));
}

#[test]
fn a_line_is_fitted_and_followed_no_farther_than_its_reach() {
    let space = Bounds::new(vec![-100.0], vec![100.0]).unwrap();
    let mut history = past(&space, None, 1, &[3.0, 7.0], &[-1.0, 1.0]);
    let mut at =
        |goal, reach| one(LocalRegression::new(2, 0.0, 1e-12, reach), goal, &mut history).unwrap();
    // At 0 both weigh the same: mean 0, spread 1, and the command is 5 + 2 y.
    for reach in [1.0, 9.0] {
        assert!((at(0.0, reach) - 5.0).abs() < 1e-9);
    }
    // Seen from so far both weigh almost the same again.
    assert!((at(1e6, 1.0) - 7.0).abs() < 1e-3);
    assert!((at(1e6, 2.5) - 10.0).abs() < 1e-3);
    assert_eq!(at(1e6, 1e6), 100.0);
}

#[test]
fn what_does_not_fit_is_refused_and_nothing_drawn() {
    let space = Bounds::new(vec![0.0], vec![1.0]).unwrap();
    let mut empty = past(&space, None, 2, &[], &[]);
    let mut observed = past(&space, None, 2, &[0.5], &[0.0, 0.0]);
    let mut forgetful = History::new(space, None, false, 0).unwrap();
    forgetful.record(&[0.5], &[0.0, 0.0], &[], &[]).unwrap();
    let models: [Box<dyn InverseModel>; 2] = [
        Box::new(KNearest::new(1, 0.1).unwrap()),
        Box::new(LocalRegression::new(1, 0.1, 0.1, 1.0).unwrap()),
    ];
    for mut model in models {
        let mut ask = |goal: &[f64], history: &mut History, m: usize| {
            let mut none = || panic!("nothing may be drawn");
            model.command(goal, history, &mut none, &mut vec![0.0; m]).unwrap_err().to_string()
        };
        assert_eq!(ask(&[0.0; 2], &mut empty, 1), "history must not be empty");
        assert_eq!(ask(&[0.0; 2], &mut forgetful, 1), "commands must have length 1, got 0");
        assert_eq!(ask(&[0.0], &mut observed, 1), "goal must have length 2, got 1");
        assert_eq!(ask(&[0.0, f64::NAN], &mut observed, 1), "goal[1] must be finite, got NaN");
        assert_eq!(ask(&[0.0; 2], &mut observed, 2), "command must have length 1, got 2");
    }
}

#[test]
fn settings_are_checked() {
    assert!(KNearest::new(0, 0.1).is_err());
    assert!(KNearest::new(1, 1.5).is_err());
    assert!(LocalRegression::new(0, 0.1, 0.1, 1.0).is_err());
    assert!(LocalRegression::new(1, -0.1, 0.1, 1.0).is_err());
    for bad in [0.0, -1.0, f64::NAN, f64::INFINITY] {
        assert!(LocalRegression::new(1, 0.1, bad, 1.0).is_err());
        assert!(LocalRegression::new(1, 0.1, 1.0, bad).is_err());
    }
}
