//! Proposals under way: told in any order, failed, and the dimension that the first effect tells.

use crate::oracles::{Stream, fixed};
use crate::runs::{
    LIMIT, Run, adapt, arm, bits, cube, explored, gain, goal_babbling, mixed, nested,
};
use divbandit_core::bandits::Bandit;
use divbandit_core::bandits::estimators::EstimatorKind;
use divbandit_core::bandits::policies::PolicyKind;
use divbandit_core::strategies::{MotorBabbling, Schedule};
use divbandit_core::{Composition, Coverage, Exploration, History, Proposal};
use proptest::prelude::*;

/// The mean of the last `size` rewards, by plain lists.
fn mean_of_last(size: usize, rewards: &[f64]) -> f64 {
    let last = &rewards[rewards.len().saturating_sub(size)..];
    crate::oracles::sums::in_parts(last) / last.len() as f64
}

fn path(proposal: &Proposal) -> Vec<i64> {
    proposal.path().map(|part| part as i64).collect()
}

#[test]
fn proposing_and_observing_in_turn_is_a_run() {
    let (strategies, root) = nested(0.05, 0.1);
    let whole = explored(strategies, root, 200);
    let (strategies, root) = nested(0.05, 0.1);
    let mut run = Run::new(strategies, root);
    let mut stream = Stream(1);
    for _ in 0..200 {
        let proposal = run.propose(&mut stream);
        let effect = arm(3).effect(proposal.command()).unwrap();
        run.observe(&proposal, &effect).unwrap();
    }
    assert_eq!(run.into_log(), whole);
}

proptest! {
    #![proptest_config(fixed(60))]

    /// The log is in the order of telling, and so are gains; a failure earns 0 and is not logged.
    #[test]
    fn several_are_under_way_and_told_in_any_order(
        steps in prop::collection::vec((0..4_usize, 0..100_usize), 1..120), seed: u64,
    ) {
        let mut strategies = Composition::default();
        let parts = vec![strategies.add(MotorBabbling), strategies.add(goal_babbling(0.1))];
        let root = strategies.compose(adapt(2, 0.1, 5), parts).unwrap();
        let mut run = Run::new(strategies, root);
        let mut stream = Stream(seed);
        let mut coverage = Coverage::new(0.1, 2).unwrap();
        let mut rewards = [0, 1].map(|_| vec![coverage.ball()]);
        // Proposals with what was believed; then the rows of the log.
        let mut open: Vec<(Proposal, [f64; 2])> = Vec::new();
        let (mut commands, mut effects) = (Vec::new(), Vec::new());
        let (mut paths, mut estimates) = (Vec::new(), Vec::new());
        for (step, which) in steps {
            if step < 2 || open.is_empty() {
                let believed = rewards.each_ref().map(|rewards| mean_of_last(5, rewards));
                prop_assert_eq!(bits(run.exploration.estimates().unwrap()), bits(&believed));
                let proposal = run.propose(&mut stream);
                let has_goal = path(&proposal) == [1] && !run.history.is_empty();
                prop_assert_eq!(proposal.goal().is_some(), has_goal);
                open.push((proposal, believed));
                continue;
            }
            let (proposal, believed) = open.remove(which % open.len());
            let part = proposal.path().next().unwrap();
            if step == 2 {
                run.exploration.fail(&proposal);
                rewards[part].push(0.0);
                continue;
            }
            let effect = arm(3).effect(proposal.command()).unwrap();
            run.observe(&proposal, &effect).unwrap();
            rewards[part].push(coverage.add(effect).unwrap());
            commands.extend_from_slice(proposal.command());
            effects.extend(effect);
            paths.push(part as i64);
            estimates.extend(believed);
        }
        let log = run.into_log();
        prop_assert_eq!(log.len, paths.len());
        prop_assert_eq!(log.depth, usize::from(!paths.is_empty()));
        prop_assert_eq!(log.commands, commands);
        prop_assert_eq!(log.effects, effects);
        prop_assert_eq!(log.paths, paths);
        prop_assert_eq!(bits(&log.estimates), bits(&estimates));
    }
}

/// Only what was told counts: a longer path that is under way, or has failed, is none of the log.
#[test]
fn a_path_that_was_not_told_does_not_lengthen_the_log() {
    let mut strategies = Composition::default();
    let motor = strategies.add(MotorBabbling);
    let inner = mixed(&mut strategies, vec![motor, motor]);
    let schedule = Schedule::new(vec![1]).unwrap();
    let root = strategies.compose(schedule, vec![motor, inner]).unwrap();
    let mut run = Run::new(strategies, root);
    let mut stream = Stream(1);
    let [first, failed, _under_way] = [0; 3].map(|_| run.propose(&mut stream));
    assert_eq!((path(&first).len(), path(&failed).len()), (1, 2));
    run.observe(&first, &[0.0, 0.0]).unwrap();
    run.exploration.fail(&failed);
    let log = run.into_log();
    assert_eq!((log.len, log.depth, log.paths), (1, 1, vec![0]));
}

/// ADAPT that knows nothing of the effects yet, over motor babbling twice.
fn unknowing(strategies: &mut Composition, window: usize) -> usize {
    let parts = vec![strategies.add(MotorBabbling); 2];
    let estimator = EstimatorKind::Window { size: window, head_start: 1 };
    let policy = PolicyKind::Proportional { alpha: 0.1, power: 1.0 };
    let bandit = Bandit::new(2, gain(0.1), estimator, policy, None).unwrap();
    strategies.compose(bandit, parts).unwrap()
}

/// A disc is taken for the largest gain until then; what failed before is remembered.
#[test]
fn the_first_effect_tells_its_dimension() {
    for dim in 1..=4 {
        let mut strategies = Composition::default();
        let root = unknowing(&mut strategies, 3);
        let mut history = History::new(cube(3, LIMIT), None, true, 2).unwrap();
        let mut run = Exploration::new(strategies, root, &history).unwrap();
        let disc = Coverage::new(0.1, 2).unwrap().ball();
        assert_eq!(run.estimates(), Some(&[disc; 2][..]));
        let (mut stream, mut proposal) = (Stream(1), Proposal::new(3));
        let mut propose = |run: &mut Exploration, history: &mut History| {
            run.propose(history, &mut || stream.unit(), &mut proposal).unwrap();
            proposal.clone()
        };
        let failed = propose(&mut run, &mut history);
        run.fail(&failed);
        let first = propose(&mut run, &mut history);
        run.observe(&mut history, &first, &vec![0.5; dim]).unwrap();
        assert_eq!(history.effect_dim(), Some(dim));
        let mut coverage = Coverage::new(0.1, dim).unwrap();
        let mut rewards = [0, 1].map(|_| vec![coverage.ball()]);
        rewards[failed.path().next().unwrap()].push(0.0);
        let gain = coverage.add(vec![0.5; dim]).unwrap();
        rewards[first.path().next().unwrap()].push(gain);
        let expected = rewards.each_ref().map(|rewards| mean_of_last(3, rewards));
        let found = run.estimates().unwrap();
        for (found, expected) in found.iter().zip(expected) {
            assert!((found - expected).abs() <= 1e-2 * expected, "{dim}: {found} {expected}");
        }
        // An effect of another dimension is refused, and changes nothing.
        let found = found.to_vec();
        let second = propose(&mut run, &mut history);
        assert!(run.observe(&mut history, &second, &vec![0.5; dim + 1]).is_err());
        assert_eq!((history.len(), run.estimates()), (1, Some(&found[..])));
    }
}

/// A nested bandit learns the dimension with its own first reward, as it does in Python.
#[test]
fn a_dimension_known_before_or_told_makes_the_same_run() {
    let known = |known: bool| {
        let mut strategies = Composition::default();
        let motor = strategies.add(MotorBabbling);
        let inner = unknowing(&mut strategies, 5);
        let root = mixed(&mut strategies, vec![motor, inner]);
        let goals = known.then(|| cube(2, 1.0));
        let mut history = History::new(cube(3, LIMIT), goals, true, 0).unwrap();
        let mut run = Exploration::new(strategies, root, &history).unwrap();
        let mut stream = Stream(1);
        run.run(&mut arm(3), &mut history, 100, &mut || stream.unit()).unwrap();
        history.into_log().unwrap()
    };
    assert_eq!(known(true), known(false));
}
