//! Untried goals equal a plain search, and the local model's steps a plain solution of its
//! equations; whatever was observed, commands stay in the box and cost one draw a coordinate.

mod oracles;

use divbandit_core::goals::Untried;
use divbandit_core::inverse::{LocalJacobian, Observed};
use divbandit_core::{Bounds, Error, NearestNeighbors};
use nalgebra::{DMatrix, DVector};
use oracles::{Stream, by_distance, fixed};
use proptest::prelude::*;

/// What an exploration knows.
struct Known {
    space: Bounds,
    effects: Vec<Vec<f64>>,
    tree: NearestNeighbors,
    commands: Vec<f64>,
}

impl Known {
    fn observed(&self) -> Observed<'_> {
        Observed { effects: &self.tree, commands: &self.commands, motor_space: &self.space }
    }
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
    let mut tree = NearestNeighbors::new(s).unwrap();
    tree.extend(&effects.concat()).unwrap();
    Known { space, effects, tree, commands }
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
        let known = known(m, s, n, scale, &mut stream);
        let goal: Vec<f64> = (0..s).map(|_| scale * stream.between(-20.0, 20.0)).collect();
        let model = LocalJacobian::new(k, used, 0.01, reach, noise).unwrap();
        let mut draws = Vec::new();
        let mut count = || { draws.push(stream.unit()); draws[draws.len() - 1] };
        let command = model.command(&goal, &known.observed(), &mut count).unwrap();

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
        let mut tree = NearestNeighbors::new(s).unwrap();
        tree.extend(&points).unwrap();
        let goal: Vec<f64> = (0..s).map(|_| effects * stream.between(-1.0, 1.0)).collect();
        let observed = Observed { effects: &tree, commands: &commands, motor_space: &space };
        let model = LocalJacobian::new(50, used, ridge, 1.0, 0.3).unwrap();
        let command = model.command(&goal, &observed, &mut || stream.unit()).unwrap();
        prop_assert!(space.check("command", &command).is_ok());
    }

    #[test]
    fn an_untried_goal_is_that_of_a_plain_search(
        s in 1..=3_usize, n in 1..40_usize, candidates in 1..8_usize, tries in 1..6_usize,
        reach in 1.0..5.0, tau in prop_oneof![Just(0.05), 0.01..1.0], seed: u64,
    ) {
        let mut stream = Stream(seed);
        let effects: Vec<Vec<f64>> =
            (0..n).map(|_| (0..s).map(|_| stream.between(-1.5, 1.5)).collect()).collect();
        let mut tree = NearestNeighbors::new(s).unwrap();
        tree.extend(&effects.concat()).unwrap();
        let goals = Bounds::new(vec![-1.0; s], vec![1.0; s]).unwrap();
        let search = Untried::new(tau, candidates, tries, reach).unwrap();
        let mut counts = vec![0_u32; n + 3];
        let mut plain_counts = counts.clone();
        let start = stream.0;
        let mut plain = Stream(start);
        for _ in 0..20 {
            let goal = search.sample(&goals, &tree, &mut counts, &mut || stream.unit()).unwrap();

            let mut best: Option<(u32, Vec<f64>, usize)> = None;
            for _ in 0..candidates {
                let mut draw = || goals.sample(&mut || plain.unit());
                let mut candidate = draw();
                for _ in 1..tries {
                    if by_distance(&effects, &candidate)[0].0 > tau { break; }
                    candidate = draw();
                }
                let (distance, i) = by_distance(&effects, &candidate)[0];
                if distance > reach * tau {
                    for (x, y) in candidate.iter_mut().zip(&effects[i]) {
                        *x = (y + (*x - y) * (reach * tau / distance)).clamp(-1.0, 1.0);
                    }
                }
                if best.as_ref().is_none_or(|best| plain_counts[i] < best.0) {
                    best = Some((plain_counts[i], candidate, i));
                }
                if plain_counts[i] == 0 { break; }
            }
            let (_, expected, i) = best.unwrap();
            plain_counts[i] += 1;
            prop_assert_eq!(&goal, &expected);
            prop_assert_eq!(&counts, &plain_counts);
            prop_assert_eq!(stream.0, plain.0);
        }
    }
}

#[test]
fn a_linear_map_is_inverted_in_one_step() {
    // y = 2 a - b: the least step to 0.6 more is (0.24, -0.12); commands nearby tell the slopes.
    let space = Bounds::new(vec![-1.0; 2], vec![1.0; 2]).unwrap();
    let commands = [0.0, 0.0, 0.1, 0.0, 0.0, 0.1];
    let mut tree = NearestNeighbors::new(1).unwrap();
    tree.extend(&[0.0, 0.2, -0.1]).unwrap();
    let observed = Observed { effects: &tree, commands: &commands, motor_space: &space };
    let model = LocalJacobian::new(50, 10, 1e-10, 1.0, 0.0).unwrap();
    // From (0.1, 0), whose effect is 0.2, another 0.6: (0.1 + 0.24, -0.12).
    let command = model.command(&[0.8], &observed, &mut || 0.5).unwrap();
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
        let mut tree = NearestNeighbors::new(1).unwrap();
        tree.extend(effects).unwrap();
        let observed = Observed { effects: &tree, commands, motor_space: &space };
        // Half of a tenth of 10 to either side of 5; a draw of 0.25 is half way down.
        assert_eq!(model.command(&[0.0], &observed, &mut || 0.25).unwrap(), [4.75, 3.0]);
    }
}

#[test]
fn a_refusal_draws_and_counts_nothing() {
    let known = known(3, 2, 10, 1.0, &mut Stream(1));
    let observed = known.observed();
    let mut draws = 0;
    let mut count = || {
        draws += 1;
        0.5
    };
    let message = |refused: Result<Vec<f64>, Error>| refused.unwrap_err().to_string();
    let model = LocalJacobian::new(5, 3, 0.1, 0.1, 0.1).unwrap();
    let empty = NearestNeighbors::new(2).unwrap();
    let nothing = Observed { effects: &empty, commands: &[], ..observed };
    let cut = Observed { commands: &known.commands[1..], ..observed };
    let outside = Observed { commands: &[99.0; 30], ..observed };
    let goal = [0.0, 0.0];
    assert_eq!(
        message(model.command(&goal, &nothing, &mut count)),
        "the set of effects must not be empty"
    );
    assert_eq!(
        message(model.command(&[0.0], &observed, &mut count)),
        "goal must have length 2, got 1"
    );
    assert_eq!(
        message(model.command(&[0.0, f64::NAN], &observed, &mut count)),
        "goal[1] must be finite, got NaN"
    );
    assert_eq!(
        message(model.command(&goal, &cut, &mut count)),
        "commands must have length 30, got 29"
    );
    assert!(
        message(model.command(&goal, &outside, &mut count)).starts_with("parent[0] must be in")
    );

    let search = Untried::new(0.1, 3, 3, 2.0).unwrap();
    let goals = Bounds::new(vec![0.0; 2], vec![1.0; 2]).unwrap();
    let line = Bounds::new(vec![0.0], vec![1.0]).unwrap();
    let mut counts = [0; 10];
    assert_eq!(
        message(search.sample(&line, &known.tree, &mut counts, &mut count)),
        "goals must have length 2, got 1"
    );
    assert_eq!(
        message(search.sample(&goals, &empty, &mut counts, &mut count)),
        "the set of effects must not be empty"
    );
    assert_eq!(
        message(search.sample(&goals, &known.tree, &mut counts[1..], &mut count)),
        "counts must have length 10, got 9"
    );
    assert_eq!((draws, counts), (0, [0; 10]));
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
    let search = |tau, candidates, tries, reach| {
        Untried::new(tau, candidates, tries, reach).unwrap_err().to_string()
    };
    assert_eq!(search(0.0, 1, 1, 1.0), "tau must be positive and finite, got 0.0");
    assert_eq!(search(0.1, 0, 1, 1.0), "candidates must be at least 1, got 0");
    assert_eq!(search(0.1, 1, 0, 1.0), "tries must be at least 1, got 0");
    assert_eq!(search(0.1, 1, 1, 0.9), "reach must be at least 1, finite, got 0.9");
}
