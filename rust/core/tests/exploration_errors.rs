//! What the engine and its strategies refuse is said in plain words, and nothing is lost by it.

use std::sync::atomic::{AtomicUsize, Ordering};

use crate::oracles::Stream;
use crate::runs::{LIMIT, Run, arm, cube, explored, gain, goal_babbling, message, mixed, nested};
use divbandit_core::bandits::Bandit;
use divbandit_core::bandits::estimators::EstimatorKind;
use divbandit_core::bandits::policies::{self, PolicyKind};
use divbandit_core::bandits::rewards::RewardKind;
use divbandit_core::goals::Uniform;
use divbandit_core::inverse::Nearest;
use divbandit_core::measures::{MeasureKind, PerCoordinate};
use divbandit_core::strategies::{
    Composite, GoalBabbling, Mixture, MotorBabbling, Schedule, Strategy,
};
use divbandit_core::{Composition, Environment, Error, Exploration, History, UniformStream};

#[test]
fn goal_babbling_without_commands_is_refused() {
    let (strategies, root) = nested(0.05, 0.1);
    assert!(strategies.needs_commands());
    let refused = Exploration::new(strategies, root, &crate::runs::history(3, false, 2));
    assert_eq!(message(refused), "commands must not be empty");
}

#[test]
fn room_for_too_many_steps_is_refused_and_nothing_lost() {
    for too_many in [u32::MAX as usize, usize::MAX / 16, usize::MAX] {
        let (strategies, root) = nested(0.05, 0.1);
        let whole = explored(strategies, root, 100);
        let (strategies, root) = nested(0.05, 0.1);
        let mut run = Run::new(strategies, root);
        let mut stream = Stream(1);
        run.go(50, &mut stream);
        assert!(message(run.history.reserve(too_many)).starts_with("n must be so few that"));
        let mut no_draws = || -> f64 { panic!("nothing is to be drawn") };
        let refused = run.exploration.run(&mut arm(3), &mut run.history, too_many, &mut no_draws);
        assert!(message(refused).starts_with("n must be so few that"));
        run.go(50, &mut stream);
        assert_eq!(run.into_log(), whole);
    }
}

#[test]
fn a_composition_refuses_parts_that_are_not_there_or_do_not_fit() {
    let mut strategies = Composition::default();
    let motor = strategies.add(MotorBabbling);
    let pair = || Mixture::new(vec![1.0; 2]).unwrap();
    let refused = strategies.compose(pair(), vec![motor, 1]);
    assert_eq!(message(refused), "part must be one of 1 parts, got 1");
    for parts in [vec![], vec![motor], vec![motor; 3]] {
        let expected = format!("parts must be 2 parts, got {}", parts.len());
        assert_eq!(message(strategies.compose(pair(), parts)), expected);
    }
    // Nothing was added.
    assert_eq!(strategies.compose(pair(), vec![motor; 2]), Ok(1));
    let refused = Exploration::new(strategies, 2, &crate::runs::history(3, true, 0));
    assert_eq!(message(refused), "part must be one of 2 parts, got 2");
}

#[test]
fn strategies_refuse_what_their_arguments_must_not_be() {
    let infinite = f64::INFINITY;
    assert_eq!(message(Mixture::new(vec![])), "weights must not be empty");
    for (weights, expected) in [
        (vec![1.0, -1.0], "weights[1] must be not negative, got -1.0"),
        (vec![infinite], "weights[0] must be finite, got inf"),
        (vec![0.0, 0.0], "the sum of weights must be positive and finite, got 0.0"),
        (vec![1e308; 2], "the sum of weights must be positive and finite, got inf"),
    ] {
        assert_eq!(message(Mixture::new(weights)), expected);
    }
    assert_eq!(message(Schedule::new(vec![1, 0])), "steps must be at least 1 each, got 0");
    for d in [-0.1, 1.1, f64::NAN] {
        assert!(message(Nearest::new(d)).starts_with("d must be in [0, 1], got"));
    }
    let begun = |parts, tau, size, head_start, alpha, power| {
        let estimator = EstimatorKind::Window { size, head_start };
        let policy = PolicyKind::Proportional { alpha, power };
        Bandit::new(parts, gain(tau), estimator, policy, Some(2))
    };
    assert!(begun(2, 0.1, 5, 5, 0.1, 8.0).is_ok());
    for (refused, expected) in [
        (begun(0, 0.1, 5, 1, 0.1, 1.0), "parts must be at least 1, got 0"),
        (begun(2, 0.0, 5, 1, 0.1, 1.0), "tau must be"),
        (begun(2, 0.1, 0, 0, 0.1, 1.0), "size must be from 1 to 1000000, got 0"),
        (begun(2, 0.1, 1_000_001, 0, 0.1, 1.0), "size must be from 1 to 1000000, got 1000001"),
        (begun(2, 0.1, 5, 6, 0.1, 1.0), "head_start must be at most"),
        (begun(2, 0.1, 5, 1, 1.5, 1.0), "alpha must be in [0, 1], got 1.5"),
        (begun(2, 0.1, 5, 1, 0.1, -1.0), "power must be finite and not negative, got -1.0"),
    ] {
        let found = message(refused);
        assert!(found.starts_with(expected), "{found}");
    }
}

/// The gain of a grid whose cells have `dim` coordinates.
fn grid_gain(dim: usize) -> RewardKind {
    let cell = PerCoordinate::Each(vec![0.1; dim]);
    RewardKind::Gain(MeasureKind::Grid { cell, origin: PerCoordinate::All(0.0) })
}

/// A bandit of one part that is paid so.
fn paid(reward: RewardKind, effect_dim: Option<usize>) -> Result<Bandit, Error> {
    Bandit::new(1, reward, EstimatorKind::WholePast, PolicyKind::Uniform, effect_dim)
}

/// Goals in a cube of `dim` dimensions.
fn within(dim: usize) -> GoalBabbling {
    let goals = Uniform::new(Some(cube(dim, 1.0))).unwrap();
    GoalBabbling::new(Box::new(goals), Box::new(Nearest::new(0.1).unwrap()))
}

#[test]
fn an_exploration_refuses_spaces_that_do_not_fit() {
    let plane = |sensory: bool| {
        History::new(cube(3, LIMIT), sensory.then(|| cube(2, 1.0)), true, 0).unwrap()
    };
    let begun = |strategy: Box<dyn FnOnce(&mut Composition) -> usize>, history: History| {
        let mut strategies = Composition::default();
        let root = strategy(&mut strategies);
        Exploration::new(strategies, root, &history).err().map(|error| error.to_string())
    };
    let goals = |dim| move |all: &mut Composition| all.add(within(dim));
    let anywhere = |all: &mut Composition| all.add(goal_babbling(0.1));
    let grid = |all: &mut Composition| {
        let parts = vec![all.add(MotorBabbling)];
        // As if nothing were known of the effects.
        all.compose(paid(grid_gain(3), None).unwrap(), parts).unwrap()
    };
    for (found, expected) in [
        (begun(Box::new(goals(2)), plane(true)), None),
        (begun(Box::new(goals(3)), plane(false)), None),
        (begun(Box::new(anywhere), plane(true)), None),
        (begun(Box::new(grid), plane(false)), None),
        (begun(Box::new(goals(3)), plane(true)), Some("goals must have length 2, got 3")),
        (begun(Box::new(anywhere), plane(false)), Some("goals must not be empty")),
        (begun(Box::new(grid), plane(true)), Some("cell must have length 2, got 3")),
    ] {
        assert_eq!(found.as_deref(), expected);
    }
    assert_eq!(message(paid(grid_gain(3), Some(2))), "cell must have length 2, got 3");
    for (joints, sensory, expected) in [
        (4, Some(cube(2, 1.0)), "motor_space must have length 4, got 3"),
        (3, Some(cube(3, 1.0)), "effect must have length 3, got 2"),
    ] {
        let mut strategies = Composition::default();
        let root = strategies.add(MotorBabbling);
        let mut history = History::new(cube(3, LIMIT), sensory, true, 0).unwrap();
        let mut run = Exploration::new(strategies, root, &history).unwrap();
        let mut no_draws = || -> f64 { panic!("nothing is to be drawn") };
        let refused = run.run(&mut arm(joints), &mut history, 1, &mut no_draws);
        assert_eq!(message(refused), expected);
    }
}

/// Until its first effect is taken, an exploration can be told one of any dimension.
#[test]
fn a_first_effect_of_a_dimension_that_a_part_refuses_is_not_recorded() {
    let mut strategies = Composition::default();
    let parts = vec![strategies.add(MotorBabbling), strategies.add(within(3))];
    let mixture = mixed(&mut strategies, parts);
    let root = strategies.compose(paid(grid_gain(3), None).unwrap(), vec![mixture]).unwrap();
    let history = History::new(cube(3, LIMIT), None, true, 1).unwrap();
    let exploration = Exploration::new(strategies, root, &history).unwrap();
    let mut run = Run { exploration, environment: Box::new(arm(3)), history };
    let mut stream = Stream(1);
    let (first, second) = (run.propose(&mut stream), run.propose(&mut stream));
    assert_eq!(message(run.observe(&first, &[0.0; 2])), "goals must have length 2, got 3");
    assert_eq!(message(run.observe(&first, &[])), "effect must not be empty");
    assert!(message(run.observe(&first, &[f64::NAN; 3])).starts_with("effect[0] must be finite"));
    assert_eq!((run.history.len(), run.history.effect_dim()), (0, None));
    run.observe(&second, &[0.0; 3]).unwrap();
    assert_eq!(message(run.observe(&first, &[0.0; 2])), "effect must have length 3, got 2");
    run.observe(&first, &[1.0; 3]).unwrap();
    assert_eq!((run.history.len(), run.exploration.estimates()), (2, Some(&[1.0][..])));
}

/// The effect stays, and no bandit on the way learns from it - also not one that could.
#[test]
fn no_part_learns_from_an_effect_that_one_cannot_reward() {
    let cell = PerCoordinate::All(1e-3);
    let fine = RewardKind::Gain(MeasureKind::Grid { cell, origin: PerCoordinate::All(0.0) });
    let coarse = RewardKind::Gain(MeasureKind::Grid {
        cell: PerCoordinate::All(1.0),
        origin: PerCoordinate::All(0.0),
    });
    for inner_is_fine in [true, false] {
        let (inner, outer) = if inner_is_fine { (&fine, &coarse) } else { (&coarse, &fine) };
        let mut strategies = Composition::default();
        let motor = strategies.add(MotorBabbling);
        let inner = strategies.compose(paid(inner.clone(), Some(2)).unwrap(), vec![motor]).unwrap();
        let root = strategies.compose(paid(outer.clone(), Some(2)).unwrap(), vec![inner]).unwrap();
        let mut run = Run::new(strategies, root);
        let mut stream = Stream(1);
        let (first, second) = (run.propose(&mut stream), run.propose(&mut stream));
        run.observe(&first, &[0.0, 0.0]).unwrap();
        let refused = message(run.observe(&second, &[1e307, 0.0]));
        assert!(refused.starts_with("effect[0] must be within 1.7e308 cells"), "{refused}");
        assert_eq!(run.history.len(), 2);
        assert_eq!(run.exploration.estimates(), Some(&[1.0][..]));
    }
}

#[test]
fn a_reward_that_could_not_be_summed_up_is_refused() {
    let mut strategies = Composition::default();
    let part = strategies.add(within(2));
    let bandit = paid(RewardKind::CompetenceProgress, Some(2)).unwrap();
    let root = strategies.compose(bandit, vec![part]).unwrap();
    let mut run = Run::new(strategies, root);
    let mut stream = Stream(1);
    let first = run.propose(&mut stream);
    run.observe(&first, &[1e307, 0.0]).unwrap();
    let second = run.propose(&mut stream);
    let refused = message(run.observe(&second, &[0.0, 0.0]));
    assert!(refused.starts_with("reward must be a finite number in [-1e+300, 1e+300], got"));
    assert_eq!(run.exploration.estimates(), Some(&[0.0][..]));
}

#[test]
fn a_reward_asked_about_another_history_says_so() {
    let history = |effects: &[[f64; 2]]| {
        crate::oracles::past::past(
            &cube(1, 1.0),
            None,
            2,
            &vec![0.5; effects.len()],
            effects.as_flattened(),
        )
    };
    let line = crate::oracles::past::past(&cube(1, 1.0), None, 1, &[0.5], &[0.5]);
    for kind in [gain(0.1), RewardKind::CompetenceProgress] {
        let mut reward = kind.start(2).unwrap();
        let goal = Some(&[0.0, 0.0][..]);
        assert_eq!(message(reward.newest(&history(&[]), goal)), "history must not be empty");
        assert_eq!(message(reward.newest(&line, goal)), "effect must have length 2, got 1");
        reward.newest(&history(&[[0.0, 0.0], [0.1, 0.0], [1.0, 1.0]]), goal).unwrap();
        let refused = message(reward.newest(&history(&[[0.0, 0.0]]), goal));
        assert!(refused.starts_with("history must be the one seen before, of at least"));
    }
}

#[test]
fn estimates_of_another_number_than_is_logged_are_refused() {
    let mut history = crate::runs::history(1, true, 2);
    let refused = history.record(&[0.0], &[0.0, 0.0], &[1], &[0.5]);
    assert_eq!(message(refused), "estimates must have length 2, got 1");
    assert!(history.is_empty());
    history.record(&[0.0], &[0.0, 0.0], &[1], &[0.5, 0.25]).unwrap();
    history.record(&[0.0], &[0.0, 0.0], &[], &[]).unwrap();
    let log = history.into_log().unwrap();
    assert_eq!((log.len, log.depth, log.paths), (2, 1, vec![1, -1]));
    assert_eq!(log.estimates[..2], [0.5, 0.25]);
    assert!(log.estimates[2..].iter().all(|x| x.is_nan()) && log.estimates.len() == 4);
}

/// An arm that gives something else at its tenth trial.
#[derive(Debug)]
struct Breaking(AtomicUsize, Result<f64, Error>);

impl Environment for Breaking {
    fn motor_dim(&self) -> usize {
        3
    }

    fn effect_dim(&self) -> usize {
        2
    }

    fn effect_into(&mut self, command: &[f64], effect: &mut [f64]) -> Result<(), Error> {
        effect.copy_from_slice(&arm(3).effect(command)?);
        if self.0.fetch_add(1, Ordering::Relaxed) == 9 {
            effect[1] = self.1.clone()?;
        }
        Ok(())
    }
}

#[test]
fn what_an_environment_breaks_leaves_the_steps_before() {
    let broken = Error::Number { name: "motor", must_be: "whole", got: 0.5 };
    let not_finite = "effect[1] must be finite, got";
    for (breaks, expected) in [
        (Err(broken), "motor must be whole, got 0.5".to_owned()),
        (Ok(f64::NAN), format!("{not_finite} NaN")),
        (Ok(f64::NEG_INFINITY), format!("{not_finite} -inf")),
    ] {
        let (strategies, root) = nested(0.05, 0.1);
        let mut run = Run::new(strategies, root);
        run.environment = Box::new(Breaking(AtomicUsize::new(0), breaks));
        let mut stream = Stream(1);
        assert_eq!(message(run.try_to_go(50, &mut stream)), expected);
        assert_eq!(run.history.len(), 9);
        // It can go on.
        run.go(20, &mut stream);
        assert_eq!(run.history.len(), 29);
        let log = run.into_log();
        let (strategies, root) = nested(0.05, 0.1);
        let whole = explored(strategies, root, 9);
        assert_eq!(log.commands[..27], whole.commands);
        assert_eq!(log.effects[..18], whole.effects);
        assert_eq!(log.estimates[..18], whole.estimates);
        assert_eq!(log.paths.len(), 29 * log.depth);
    }
}

/// Always the same command.
#[derive(Debug)]
struct Constant([f64; 3]);

impl Strategy for Constant {
    fn propose(
        &mut self,
        _history: &mut History,
        _draws: &mut dyn UniformStream,
        command: &mut [f64],
    ) -> Result<(), Error> {
        command.copy_from_slice(&self.0);
        Ok(())
    }

    fn needs_commands(&self) -> bool {
        false
    }
}

/// Always the same choice between two.
#[derive(Debug)]
struct Always(usize);

impl Composite for Always {
    fn parts(&self) -> usize {
        2
    }

    fn choose(&mut self, _draws: &mut dyn UniformStream) -> policies::Choice {
        policies::Choice::of(self.0)
    }
}

#[test]
fn strategies_are_held_to_their_promises() {
    for (choice, command, expected) in [
        (0, [0.1, 0.2, 0.3], None),
        (1, [0.0; 3], None),
        (0, [0.0, 2.6, 0.0], Some("command[1] must be within the joint's limit")),
        (0, [f64::NAN, 0.0, 0.0], Some("command[0] must be")),
        (2, [0.0; 3], Some("choice must be less than the number of parts, 2, got 2")),
        (usize::MAX, [0.0; 3], Some("choice must be less than the number of parts, 2, got")),
    ] {
        let mut strategies = Composition::default();
        let part = strategies.add(Constant(command));
        let root = strategies.compose(Always(choice), vec![part; 2]).unwrap();
        let mut run = Run::new(strategies, root);
        let found = run.try_to_go(2, &mut Stream(1)).map_err(|error| error.to_string());
        match (found, expected) {
            (Ok(()), None) => assert_eq!(run.into_log().paths, [choice as i64; 2]),
            (Err(found), Some(expected)) => {
                assert!(found.starts_with(expected), "{found}");
                assert!(run.history.is_empty());
            }
            other => panic!("{other:?}"),
        }
    }
}
