//! The engine, as a program in Rust uses it: it makes of ADAPT what the paper says, and keeps its
//! laws whatever strategies are made of.

use std::collections::BTreeSet;
use std::sync::{Arc, Mutex};

use crate::oracles::{Stream, fixed};
use crate::runs::{
    LIMIT, Run, adapt, arm, bits, explored, gain, goal_babbling, history, mixed, nested,
};
use divbandit_core::bandits::Bandit;
use divbandit_core::bandits::estimators::EstimatorKind;
use divbandit_core::bandits::policies::{Choice, PolicyKind};
use divbandit_core::bandits::rewards::RewardKind;
use divbandit_core::history::Log;
use divbandit_core::strategies::{Composite, Mixture, MotorBabbling, Schedule};
use divbandit_core::{Composition, Coverage, Error, Exploration, UniformStream};
use proptest::prelude::*;

proptest! {
    #![proptest_config(fixed(60))]

    /// Step by step, bit by bit; only an effect and a gain are the kernels' own.
    #[test]
    fn adapt_is_as_in_the_paper(
        m in 1..8_usize, d in 0.0..1.0_f64, tau in 0.01..0.3_f64, window in 1..60_usize,
        alpha in 0.0..1.0_f64, head_start in 0..3_usize, seed: u64,
    ) {
        let head_start = head_start.min(window);
        let plain = crate::oracles::adapt::Adapt { m, limit: LIMIT, d, tau, window, alpha, head_start };
        let f = |command: &[f64]| arm(m).effect(command).unwrap().to_vec();
        let steps = plain.explore(300, &mut Stream(seed), f);

        let mut strategies = Composition::default();
        let parts = vec![strategies.add(MotorBabbling), strategies.add(goal_babbling(d))];
        let estimator = EstimatorKind::Window { size: window, head_start };
        let policy = PolicyKind::Proportional { alpha, power: 1.0 };
        let bandit = Bandit::new(2, gain(tau), estimator, policy, Some(2)).unwrap();
        let root = strategies.compose(bandit, parts).unwrap();
        let mut history = history(m, true, 2);
        let mut run = Exploration::new(strategies, root, &history).unwrap();
        let mut stream = Stream(seed);
        run.run(&mut arm(m), &mut history, 300, &mut || stream.unit()).unwrap();
        let log = history.into_log().unwrap();
        prop_assert_eq!((log.len, log.depth), (300, 1));
        for (i, step) in steps.iter().enumerate() {
            prop_assert_eq!(log.paths[i], step.choice as i64, "step {}", i);
            prop_assert_eq!(bits(&log.estimates[2 * i..2 * i + 2]), bits(&step.estimates));
            prop_assert_eq!(bits(&log.commands[m * i..m * (i + 1)]), bits(&step.command));
            prop_assert_eq!(bits(&log.effects[2 * i..2 * i + 2]), bits(&step.effect));
        }
    }
}

#[test]
fn a_path_tells_who_chose_at_every_level() {
    let mut strategies = Composition::default();
    let motor = strategies.add(MotorBabbling);
    let innermost = mixed(&mut strategies, vec![motor, motor, motor]);
    let middle = mixed(&mut strategies, vec![innermost, motor]);
    let root = mixed(&mut strategies, vec![motor, middle]);
    let log = explored(strategies, root, 200);
    assert_eq!((log.depth, log.paths.len()), (3, 600));
    assert!(log.estimates.is_empty());
    let mut stream = Stream(1);
    let mut seen = BTreeSet::new();
    for row in log.paths.chunks(3) {
        // The very draws: a choice each, then one a joint.
        let mut choose = |n: usize| stream.below(n) as i64;
        let expected = match choose(2) {
            0 => [0, -1, -1],
            _ => match choose(2) {
                0 => [1, 0, choose(3)],
                _ => [1, 1, -1],
            },
        };
        (0..3).for_each(|_| _ = stream.unit());
        assert_eq!(row, expected);
        seen.insert(expected);
    }
    assert_eq!(seen.len(), 5);
}

#[test]
fn a_path_is_as_long_as_the_longest_that_was_taken() {
    for (n, depth) in [(0, 0), (5, 1), (6, 2)] {
        let mut strategies = Composition::default();
        let motor = strategies.add(MotorBabbling);
        let inner = mixed(&mut strategies, vec![motor, motor]);
        let schedule = Schedule::new(vec![5]).unwrap();
        let root = strategies.compose(schedule, vec![motor, inner]).unwrap();
        let log = explored(strategies, root, n);
        assert_eq!((log.depth, log.paths.len()), (depth, n * depth));
    }
    let mut strategies = Composition::default();
    let root = strategies.add(MotorBabbling);
    let log = explored(strategies, root, 5);
    assert_eq!((log.depth, log.paths, log.effects.len()), (0, vec![], 10));
}

/// The schedule is a part of the root twice, and of another mixture once more: it counts on.
#[test]
fn a_part_of_several_composites_is_one_part() {
    let mut strategies = Composition::default();
    let motor = strategies.add(MotorBabbling);
    let steps = Schedule::new(vec![4, 3]).unwrap();
    let schedule = strategies.compose(steps, vec![motor; 3]).unwrap();
    let inner = mixed(&mut strategies, vec![schedule, motor]);
    let root = mixed(&mut strategies, vec![schedule, inner, schedule]);
    let log = explored(strategies, root, 100);
    let of_schedule = |row: &[i64]| match row[..] {
        [0 | 2, phase, -1] => Some(phase),
        [1, 0, phase] => Some(phase),
        [1, 1, -1] => None,
        _ => panic!("{row:?}"),
    };
    let phases: Vec<i64> = log.paths.chunks(log.depth).filter_map(of_schedule).collect();
    let expected = [[0; 4].as_slice(), &[1; 3], &vec![2; phases.len() - 7]].concat();
    assert_eq!(phases, expected);
    for first in 0..3 {
        assert!(log.paths.chunks(3).any(|row| row[0] == first));
    }
}

/// A bandit, and the rewards that it was told.
#[derive(Debug)]
struct Spy(Bandit, Arc<Mutex<Vec<(usize, f64)>>>);

impl Composite for Spy {
    fn parts(&self) -> usize {
        self.0.parts()
    }

    fn choose(&mut self, draws: &mut dyn UniformStream) -> Choice {
        self.0.choose(draws)
    }

    fn reward(&self) -> Option<&RewardKind> {
        self.0.reward()
    }

    fn begin(&mut self, effect_dim: usize) -> Result<(), Error> {
        self.0.begin(effect_dim)
    }

    fn learn(&mut self, choice: Choice, reward: f64) {
        self.1.lock().unwrap().push((choice.part, reward));
        self.0.learn(choice, reward);
    }

    fn fail(&mut self, choice: Choice) {
        self.1.lock().unwrap().push((choice.part, f64::NEG_INFINITY));
        self.0.fail(choice);
    }
}

#[test]
fn a_nested_bandit_is_told_of_its_own_effects_measured_against_all() {
    let told = Arc::default();
    let mut strategies = Composition::default();
    let motor = strategies.add(MotorBabbling);
    let goal = strategies.add(goal_babbling(0.05));
    let spy = Spy(adapt(2, 0.1, 5), Arc::clone(&told));
    let inner = strategies.compose(spy, vec![motor, goal]).unwrap();
    let root = mixed(&mut strategies, vec![inner, motor]);
    let log = explored(strategies, root, 300);
    let mut coverage = Coverage::new(0.1, 2).unwrap();
    let mut expected = Vec::new();
    for (row, effect) in log.paths.chunks(2).zip(log.effects.chunks(2)) {
        let gain = coverage.add(effect).unwrap();
        if row[0] == 0 {
            expected.push((row[1] as usize, gain));
        }
    }
    assert!((100..200).contains(&expected.len()));
    assert_eq!(*told.lock().unwrap(), expected);
}

/// The mean of the last `size` gains.
fn mean_of_last(size: usize, gains: &[f64]) -> f64 {
    let last = &gains[gains.len().saturating_sub(size)..];
    crate::oracles::sums::in_parts(last) / last.len() as f64
}

/// Two bandits, one in the other: with other radii each is told in its own measure, with the same
/// one both are told the same.
#[test]
fn the_outermost_bandit_believes_the_means_of_its_gains() {
    for inner in [0.1, 0.05] {
        let (strategies, root) = nested(0.05, inner);
        let log = explored(strategies, root, 300);
        let mut coverage = Coverage::new(0.05, 2).unwrap();
        let mut gains = [0, 1].map(|_| vec![coverage.ball()]);
        for (i, effect) in log.effects.chunks(2).enumerate() {
            let believed = gains.each_ref().map(|gains| mean_of_last(10, gains));
            assert_eq!(bits(&log.estimates[2 * i..2 * i + 2]), bits(&believed), "step {i}");
            gains[log.paths[i * log.depth] as usize].push(coverage.add(effect).unwrap());
        }
    }
}

/// Draws that lie on an edge belong to what begins there; what has no weight is never chosen.
#[test]
fn a_draw_on_an_edge_goes_up() {
    let below = |x: f64| x.next_down();
    for (weights, draw, expected) in [
        (vec![1.0, 1.0], 0.5, 1),
        (vec![1.0, 1.0], below(0.5), 0),
        (vec![1.0, 2.0, 1.0], 0.25, 1),
        (vec![1.0, 2.0, 1.0], 0.75, 2),
        (vec![0.0, 1.0, 0.0], 0.0, 1),
        (vec![0.0, 1.0, 0.0], below(1.0), 1),
        (vec![1.0, 0.0, 1.0], 0.5, 2),
        (vec![0.1; 10], below(1.0), 9),
    ] {
        let mixture = || Mixture::new(weights.clone()).unwrap();
        assert_eq!(mixture().choose(&mut || draw), Choice::of(expected), "{weights:?} {draw}");
    }
    // ADAPT's first draw says whether the second one is uniform; no part has gained anything yet.
    let chosen = |one_gained: bool, draws: [f64; 2]| {
        let estimator = EstimatorKind::Window { size: 5, head_start: 0 };
        let policy = PolicyKind::Proportional { alpha: 0.5, power: 1.0 };
        let mut bandit = Bandit::new(3, gain(0.1), estimator, policy, Some(2)).unwrap();
        if one_gained {
            bandit.learn(Choice::of(1), 1.0);
        }
        let mut draws = draws.into_iter();
        bandit.choose(&mut || draws.next().unwrap()).part
    };
    for (first, second, expected) in
        [(below(0.5), 0.0, 0), (0.5, 0.0, 1), (below(0.5), below(1.0), 2), (0.5, below(1.0), 1)]
    {
        assert_eq!(chosen(true, [first, second]), expected);
        assert_eq!(chosen(false, [first, second]), (3.0 * second) as usize);
    }
}

#[test]
fn halves_make_a_whole_and_no_steps_make_nothing() {
    let (strategies, root) = nested(0.05, 0.1);
    let whole = explored(strategies, root, 200);
    let (strategies, root) = nested(0.05, 0.1);
    let mut run = Run::new(strategies, root);
    let mut stream = Stream(1);
    let mut no_draws = || -> f64 { panic!("nothing is to be drawn") };
    run.exploration.run(&mut arm(3), &mut run.history, 0, &mut no_draws).unwrap();
    assert!(run.history.is_empty());
    for n in [1, 0, 99, 100] {
        run.history.reserve(n).unwrap();
        run.go(n, &mut stream);
    }
    assert_eq!(run.history.len(), 200);
    assert_eq!(run.into_log(), whole);
    let (strategies, root) = nested(0.05, 0.1);
    let empty = Run::new(strategies, root).into_log();
    let (commands, effects, paths, estimates) = (vec![], vec![], vec![], vec![]);
    assert_eq!(empty, Log { len: 0, commands, effects, paths, depth: 0, estimates });
}

#[test]
fn commands_need_not_be_kept() {
    let log = |keeps_commands| {
        let mut strategies = Composition::default();
        let parts = vec![strategies.add(MotorBabbling); 2];
        let root = strategies.compose(adapt(2, 0.1, 9), parts).unwrap();
        assert!(!strategies.needs_commands());
        let mut run = Run::new(strategies, root);
        assert!(!run.exploration.needs_commands());
        run.history = history(3, keeps_commands, 2);
        run.go(100, &mut Stream(1));
        assert_eq!(run.history.len(), 100);
        run.into_log()
    };
    let (with, without) = (log(true), log(false));
    assert_eq!(with.commands.len(), 300);
    assert!(without.commands.is_empty());
    assert_eq!(Log { commands: vec![], ..with }, without);
}
