//! The local model's steps equal a plain solution of its equations; whatever was observed, commands
//! stay in the box and cost one draw a coordinate.

use crate::oracles::past::past;
use crate::oracles::{Stream, by_distance, fixed};
use divbandit_core::inverse::{InverseModel, LocalJacobian};
use divbandit_core::{Bounds, Error, History, UniformStream};
use nalgebra::{DMatrix, DVector};
use proptest::prelude::*;

/// What an exploration knows.
struct Known {
    space: Bounds,
    effects: Vec<Vec<f64>>,
    history: History,
    commands: Vec<f64>,
}

/// The command that a model makes of a goal.
fn command(
    model: &LocalJacobian,
    goal: &[f64],
    history: &mut History,
    draws: &mut dyn UniformStream,
) -> Result<Vec<f64>, Error> {
    let mut command = vec![0.0; history.motor_space().dim()];
    model.clone().command(goal, history, draws, &mut command)?;
    Ok(command)
}

/// Commands in a box of which one edge in four is a point, and the effects of a curved map; some
/// commands, and some effects of other commands, occur again.
fn known(m: usize, s: usize, n: usize, scale: f64, stream: &mut Stream) -> Known {
    let low: Vec<f64> = (0..m).map(|_| stream.between(-5.0, 5.0)).collect();
    let high = low.iter().map(|a| a + [0.0, 1e-3, 2.0, 30.0][stream.below(4)]).collect();
    let space = Bounds::new(low, high).unwrap();
    let slopes: Vec<f64> = (0..s * m).map(|_| stream.between(-1.0, 1.0)).collect();
    let (mut effects, mut commands): (Vec<Vec<f64>>, Vec<f64>) = (Vec::new(), Vec::new());
    for i in 0..n {
        let command = if i > 0 && stream.below(5) == 0 {
            commands[stream.below(i) * m..][..m].to_vec()
        } else {
            space.sample(&mut || stream.unit())
        };
        let effect = if i > 0 && stream.below(8) == 0 {
            effects[stream.below(i)].clone()
        } else {
            let slope = |row: &[f64]| row.iter().zip(&command).map(|(a, x)| a * x).sum::<f64>();
            slopes.chunks_exact(m).map(|row| scale * (slope(row) + slope(row).powi(2))).collect()
        };
        effects.push(effect);
        commands.extend(command);
    }
    let history = past(&space, None, s, &commands, &effects.concat());
    Known { space, effects, history, commands }
}

/// The centre of the perturbation and its reach, by nalgebra's general decompositions; None where
/// no step can be told.
fn step(
    known: &Known,
    goal: &[f64],
    k: usize,
    used: usize,
    ridge: f64,
    reach: f64,
) -> Option<(Vec<f64>, f64)> {
    let (m, s) = (known.space.dim(), goal.len());
    let width: Vec<f64> =
        known.space.low().iter().zip(known.space.high()).map(|(a, b)| b - a).collect();
    let share = |i: usize| {
        DVector::from_fn(m, |q, _| {
            let x = known.commands[i * m + q] - known.space.low()[q];
            if width[q] > 0.0 { x / width[q] } else { 0.0 }
        })
    };
    let found = by_distance(&known.effects, goal);
    let base = found[0].1;
    let (x0, y0) = (share(base), DVector::from_column_slice(&known.effects[base]));
    let mut near: Vec<(f64, usize)> = found[1..found.len().min(k + 1)]
        .iter()
        .map(|&(_, i)| ((share(i) - &x0).norm(), i))
        .filter(|&(distance, _)| distance > 0.0)
        .collect();
    near.sort_by(|a, b| a.0.total_cmp(&b.0).then(a.1.cmp(&b.1)));
    near.truncate(used);
    let h = near.len();
    if h == 0 {
        return None;
    }
    let u = DMatrix::from_fn(h, m, |a, q| (share(near[a].1) - &x0)[q] / near[a].0);
    let v = DMatrix::from_fn(h, s, |a, c| (known.effects[near[a].1][c] - y0[c]) / near[a].0);
    let regular =
        DMatrix::from_fn(
            h,
            h,
            |a, b| {
                if a == b { ridge * (near[a].0 / near[0].0).powi(2) } else { 0.0 }
            },
        );
    let weights = (&u * u.transpose() + regular).lu().solve(&v)?;
    let jacobian = weights.transpose() * &u;
    let squares = &jacobian * jacobian.transpose();
    let damped = &squares + DMatrix::identity(s, s) * (1e-6 * squares.trace());
    let error = DVector::from_column_slice(goal) - &y0;
    let step = jacobian.transpose() * damped.lu().solve(&error)?;
    let free = width.iter().filter(|width| **width > 0.0).count();
    let length = step.norm() / (free as f64).sqrt();
    let cut = if length > reach { reach / length } else { 1.0 };
    let centre = (0..m).map(|q| {
        let x = known.commands[base * m + q] + cut * step[q] * width[q];
        x.clamp(known.space.low()[q], known.space.high()[q])
    });
    Some((centre.collect(), length.min(reach)))
}

proptest! {
    #![proptest_config(fixed(300))]

    #[test]
    fn a_command_is_a_step_from_the_nearest_effects(
        m in 1..=8_usize, s in 1..=3_usize, n in 2..80_usize, k in 1..60_usize,
        used in 1..12_usize, seed: u64, noise in prop_oneof![Just(0.0), 0.0..=1.0],
        reach in prop_oneof![Just(1.0), 1e-3..0.1], scale in prop_oneof![Just(1.0), Just(1e-9)],
    ) {
        let mut stream = Stream(seed);
        let mut known = known(m, s, n, scale, &mut stream);
        let goal: Vec<f64> = (0..s).map(|_| scale * stream.between(-20.0, 20.0)).collect();
        let model = LocalJacobian::new(k, used, 0.01, reach, noise).unwrap();
        let mut draws = Vec::new();
        let mut count = || { draws.push(stream.unit()); draws[draws.len() - 1] };
        let command = command(&model, &goal, &mut known.history, &mut count).unwrap();

        prop_assert_eq!(draws.len(), m);
        prop_assert!(known.space.check("command", &command).is_ok());
        let Some((centre, length)) = step(&known, &goal, k, used, 0.01, reach) else {
            return Ok(());
        };
        let size: f64 = known.effects.iter().flatten().map(|y| y.abs()).fold(0.0, f64::max);
        prop_assume!(length.is_finite() && size > 0.0);
        for j in 0..m {
            let (a, b) = (known.space.low()[j], known.space.high()[j]);
            let away = noise * length * (b - a);
            let (from, to) = (a.max(centre[j] - away), b.min(centre[j] + away));
            let expected = from + draws[j] * (to - from);
            // The systems' condition is 1e6 at most, and steps are at most the whole range.
            prop_assert!((command[j] - expected).abs() <= 1e-8 * (b - a) + 1e-14, "{j}: {command:?} {expected}");
        }
    }

    #[test]
    fn whatever_was_observed_a_command_is_in_the_box(
        m in 1..=5_usize, s in 1..=4_usize, n in 1..30_usize, seed: u64,
        effects in prop_oneof![Just(0.0), Just(1e-320), Just(1e-200), Just(1e150), Just(1e308)],
        motor in prop_oneof![Just(1e-320), Just(1e-290), Just(1.0), Just(8e307)],
        used in 1..20_usize, ridge in prop_oneof![Just(1e-300), Just(0.01), Just(1e300)],
    ) {
        let mut stream = Stream(seed);
        let space = Bounds::new(vec![-motor; m], vec![motor; m]).unwrap();
        let commands: Vec<f64> = (0..n).flat_map(|_| space.sample(&mut || stream.unit())).collect();
        let points: Vec<f64> = (0..n * s).map(|_| effects * stream.between(-1.0, 1.0)).collect();
        let goal: Vec<f64> = (0..s).map(|_| effects * stream.between(-1.0, 1.0)).collect();
        let mut history = past(&space, None, s, &commands, &points);
        let model = LocalJacobian::new(50, used, ridge, 1.0, 0.3).unwrap();
        let command = command(&model, &goal, &mut history, &mut || stream.unit()).unwrap();
        prop_assert!(space.check("command", &command).is_ok());
    }

    #[test]
    fn a_model_remembers_nothing(
        m in 1..=8_usize, s in 1..=3_usize, n in 2..80_usize, used in 1..12_usize, seed: u64,
    ) {
        let mut stream = Stream(seed);
        let mut known = known(m, s, n, 1.0, &mut stream);
        let fresh = LocalJacobian::new(50, used, 0.01, 0.1, 0.3).unwrap();
        let (mut model, mut found) = (fresh.clone(), vec![0.0; m]);
        for _ in 0..5 {
            let goal: Vec<f64> = (0..s).map(|_| stream.between(-20.0, 20.0)).collect();
            model.command(&goal, &mut known.history, &mut || 0.3, &mut found).unwrap();
            let expected = command(&fresh, &goal, &mut known.history, &mut || 0.3).unwrap();
            prop_assert_eq!(&found, &expected);
        }
    }
}

#[test]
fn a_linear_map_is_inverted_in_one_step() {
    // y = 2 a - b: the least step to 0.6 more is (0.24, -0.12); commands nearby tell the slopes.
    let space = Bounds::new(vec![-1.0; 2], vec![1.0; 2]).unwrap();
    let commands = [0.0, 0.0, 0.1, 0.0, 0.0, 0.1];
    let mut history = past(&space, None, 1, &commands, &[0.0, 0.2, -0.1]);
    let model = LocalJacobian::new(50, 10, 1e-10, 1.0, 0.0).unwrap();
    // From (0.1, 0), whose effect is 0.2, another 0.6: (0.1 + 0.24, -0.12).
    let command = command(&model, &[0.8], &mut history, &mut || 0.5).unwrap();
    assert!((command[0] - 0.34).abs() < 1e-5 && (command[1] + 0.12).abs() < 1e-5, "{command:?}");
}

#[test]
fn where_no_step_can_be_told_the_nearest_command_is_perturbed() {
    let space = Bounds::new(vec![0.0, 3.0], vec![10.0, 3.0]).unwrap();
    let model = LocalJacobian::new(50, 10, 0.01, 0.1, 0.5).unwrap();
    // One effect; the same command again; other commands with the same effect.
    let cases: [(&[f64], &[f64]); 3] = [
        (&[5.0, 3.0], &[1.0]),
        (&[5.0, 3.0, 5.0, 3.0], &[1.0, 1.5]),
        (&[5.0, 3.0, 6.0, 3.0], &[1.0, 1.0]),
    ];
    for (commands, effects) in cases {
        let mut history = past(&space, None, 1, commands, effects);
        // Half of a tenth of 10 to either side of 5; a draw of 0.25 is half way down.
        let found = command(&model, &[0.0], &mut history, &mut || 0.25).unwrap();
        assert_eq!(found, [4.75, 3.0]);
    }
}

#[test]
fn a_refusal_draws_nothing() {
    let Known { space, mut history, .. } = known(3, 2, 10, 1.0, &mut Stream(1));
    let mut none = || panic!("nothing may be drawn");
    let mut model = LocalJacobian::new(5, 3, 0.1, 0.1, 0.1).unwrap();
    let mut ask = |goal: &[f64], history: &mut History, m: usize| {
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
}

#[test]
fn settings_are_checked() {
    let model = |k, used, ridge, reach, noise| {
        LocalJacobian::new(k, used, ridge, reach, noise).unwrap_err().to_string()
    };
    assert_eq!(model(0, 1, 0.1, 0.1, 0.1), "k must be at least 1, got 0");
    assert_eq!(model(1, 0, 0.1, 0.1, 0.1), "used must be at least 1, got 0");
    assert_eq!(model(1, 1, 0.0, 0.1, 0.1), "ridge must be positive and finite, got 0.0");
    assert_eq!(model(1, 1, 0.1, 1.1, 0.1), "reach must be in [0, 1], got 1.1");
    assert_eq!(model(1, 1, 0.1, 0.1, f64::NAN), "noise must be in [0, 1], got NaN");
}
