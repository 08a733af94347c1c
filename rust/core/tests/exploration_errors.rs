//! What the engine and its strategies refuse is said in plain words, and nothing is lost by it.

mod oracles;
mod runs;

use std::sync::atomic::{AtomicUsize, Ordering};

use divbandit_core::bandits::Adapt;
use divbandit_core::goals::Uniform;
use divbandit_core::inverse::Nearest;
use divbandit_core::strategies::{
    Composite, GoalBabbling, Mixture, MotorBabbling, Schedule, Strategy,
};
use divbandit_core::{
    Composition, Coverage, Environment, Error, Exploration, History, UniformStream,
};
use oracles::Stream;
use runs::{LIMIT, arm, cube, explored, go, goal_babbling, history, message, nested, ready};

#[test]
fn goal_babbling_without_commands_is_refused() {
    let (strategies, root) = nested(0.05, 0.1);
    assert!(strategies.needs_commands());
    let refused = Exploration::new(Box::new(arm(3)), history(3, false), strategies, root);
    assert_eq!(message(refused), "commands must not be empty");
}

#[test]
fn room_for_too_many_steps_is_refused_and_nothing_lost() {
    for too_many in [u32::MAX as usize, usize::MAX / 16, usize::MAX] {
        let (strategies, root) = nested(0.05, 0.1);
        let whole = explored(strategies, root, 100);
        let (strategies, root) = nested(0.05, 0.1);
        let mut run = ready(strategies, root);
        let mut stream = Stream(1);
        go(&mut run, 50, &mut stream);
        assert!(message(run.reserve(too_many)).starts_with("n must be so few that"));
        let refused = run.run(too_many, &mut || -> f64 { panic!("nothing is to be drawn") });
        assert!(message(refused).starts_with("n must be so few that"));
        go(&mut run, 50, &mut stream);
        assert_eq!(run.into_log().unwrap(), whole);
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
    let refused = Exploration::new(Box::new(arm(3)), history(3, true), strategies, 2);
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
    let refused = Schedule::new(vec![1, 0], 0, 0);
    assert_eq!(message(refused), "steps must be at least 1 each, got 0");
    assert_eq!(message(Schedule::new(vec![1], 2, 0)), "phase must be one of 2 parts, got 2");
    for d in [-0.1, 1.1, f64::NAN] {
        assert!(message(Nearest::new(d)).starts_with("d must be in [0, 1], got"));
    }
    let empty = || Coverage::new(0.1, 2).unwrap();
    let mut used = empty();
    used.add([0.0, 0.0]).unwrap();
    for (refused, expected) in [
        (Adapt::new(0, empty(), 5, 0.1, 1), "parts must be at least 1, got 0"),
        (Adapt::new(2, used, 5, 0.1, 1), "measure must be empty, got 1"),
        (Adapt::new(2, empty(), 0, 0.1, 0), "window must be from 1 to 1000000, got 0"),
        (
            Adapt::new(2, empty(), 1_000_001, 0.1, 0),
            "window must be from 1 to 1000000, got 1000001",
        ),
        (Adapt::new(2, empty(), 5, 1.5, 1), "alpha must be in [0, 1], got 1.5"),
        (
            Adapt::new(2, empty(), 5, 0.1, 1).and_then(|adapt| adapt.with_power(-1.0)),
            "power must be finite and not negative, got -1.0",
        ),
        (Adapt::new(2, empty(), 5, 0.1, 6), "head_start must be at most the window, got 6"),
    ] {
        assert_eq!(message(refused), expected);
    }
}

/// Explores with one strategy, or with ADAPT measuring in `measured` dimensions.
fn begun(strategy: impl Strategy + 'static, measured: usize, history: History) -> Option<String> {
    let mut strategies = Composition::default();
    let part = strategies.add(strategy);
    let measure = Coverage::new(0.1, measured).unwrap();
    let bandit = Adapt::new(1, measure, 5, 0.1, 1).unwrap();
    let root = strategies.compose(bandit, vec![part]).unwrap();
    let run = Exploration::new(Box::new(arm(3)), history, strategies, root);
    run.err().map(|error| error.to_string())
}

#[test]
fn an_exploration_refuses_spaces_that_do_not_fit() {
    let space = |m, s, effect_dim| History::new(cube(m, LIMIT), s, effect_dim, true);
    let plain = |m, effect_dim| space(m, None, effect_dim).unwrap();
    let within = |dim| {
        let goals = Uniform::new(Some(cube(dim, 1.0))).unwrap();
        GoalBabbling::new(Box::new(goals), Box::new(Nearest::new(0.1).unwrap()))
    };
    assert_eq!(begun(MotorBabbling, 2, plain(3, 2)), None);
    assert_eq!(begun(within(2), 2, plain(3, 2)), None);
    assert_eq!(begun(goal_babbling(0.1), 2, history(3, true)), None);
    for (found, expected) in [
        (begun(MotorBabbling, 2, plain(4, 2)), "motor_space must have length 3, got 4"),
        (begun(MotorBabbling, 2, plain(3, 3)), "effect must have length 3, got 2"),
        (begun(MotorBabbling, 3, plain(3, 2)), "measure must have length 2, got 3"),
        (begun(within(3), 2, plain(3, 2)), "goals must have length 2, got 3"),
        (begun(goal_babbling(0.1), 2, plain(3, 2)), "goals must not be empty"),
    ] {
        assert_eq!(found.as_deref(), Some(expected));
    }
    let refused = space(3, Some(cube(3, 1.0)), 2);
    assert_eq!(message(refused), "sensory_space must have length 2, got 3");
    assert!(message(space(3, None, 0)).contains("at least 1"));
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
        let environment = Box::new(Breaking(AtomicUsize::new(0), breaks));
        let mut run = Exploration::new(environment, history(3, true), strategies, root).unwrap();
        let mut stream = Stream(1);
        assert_eq!(message(run.run(50, &mut || stream.unit())), expected);
        assert_eq!(run.len(), 9);
        // It can go on.
        go(&mut run, 20, &mut stream);
        assert_eq!(run.len(), 29);
        let log = run.into_log().unwrap();
        let (strategies, root) = nested(0.05, 0.1);
        let whole = explored(strategies, root, 9);
        assert_eq!(log.commands[..27], whole.commands);
        assert_eq!(log.effects[..18], whole.effects);
        assert_eq!(log.diversities[..18], whole.diversities);
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
struct Choice(usize);

impl Composite for Choice {
    fn parts(&self) -> usize {
        2
    }

    fn choose(&mut self, _draws: &mut dyn UniformStream) -> usize {
        self.0
    }
}

#[test]
fn strategies_of_ones_own_are_held_to_their_promises() {
    for (choice, command, expected) in [
        (0, [0.1, 0.2, 0.3], None),
        (1, [0.0; 3], None),
        (0, [0.0, 2.6, 0.0], Some("command[1] must be in the range [-2.5, 2.5], got 2.6")),
        (0, [f64::NAN, 0.0, 0.0], Some("command[0] must be in the range [-2.5, 2.5], got NaN")),
        (2, [0.0; 3], Some("choice must be less than the number of parts, 2, got 2")),
        (usize::MAX, [0.0; 3], Some("choice must be less than the number of parts, 2, got")),
    ] {
        let mut strategies = Composition::default();
        let part = strategies.add(Constant(command));
        let root = strategies.compose(Choice(choice), vec![part; 2]).unwrap();
        let mut run = ready(strategies, root);
        let found = run.run(2, &mut || 0.0).map_err(|error| error.to_string());
        match (found, expected) {
            (Ok(()), None) => assert_eq!(run.into_log().unwrap().paths, [choice as i64; 2]),
            (Err(found), Some(expected)) => {
                assert!(found.starts_with(expected), "{found}");
                assert!(run.is_empty());
            }
            other => panic!("{other:?}"),
        }
    }
}
