//! Explorations of small arms, ready to run.

#![allow(dead_code, reason = "each test takes the part that it needs")]

use divbandit_core::bandits::Adapt;
use divbandit_core::exploration::Log;
use divbandit_core::goals::Uniform;
use divbandit_core::inverse::Nearest;
use divbandit_core::strategies::{GoalBabbling, Mixture, MotorBabbling};
use divbandit_core::{Bounds, Composition, Coverage, Error, Exploration, History, PlanarArm};

use crate::oracles::Stream;

/// The limit of the joints, in radians.
pub const LIMIT: f64 = 2.5;

pub fn arm(joints: usize) -> PlanarArm {
    PlanarArm::new(joints, LIMIT).unwrap()
}

pub fn cube(dim: usize, half: f64) -> Bounds {
    Bounds::new(vec![-half; dim], vec![half; dim]).unwrap()
}

pub fn history(joints: usize, keep_commands: bool) -> History {
    History::new(cube(joints, LIMIT), Some(cube(2, 1.0)), 2, keep_commands).unwrap()
}

pub fn goal_babbling(d: f64) -> GoalBabbling {
    let (goals, inverse) = (Uniform::new(None).unwrap(), Nearest::new(d).unwrap());
    GoalBabbling::new(Box::new(goals), Box::new(inverse))
}

pub fn adapt(parts: usize, tau: f64, window: usize) -> Adapt {
    Adapt::new(parts, Coverage::new(tau, 2).unwrap(), window, 0.1, 1).unwrap()
}

/// A mixture of parts that are all as likely.
pub fn mixed(strategies: &mut Composition, parts: Vec<usize>) -> usize {
    strategies.compose(Mixture::new(vec![1.0; parts.len()]).unwrap(), parts).unwrap()
}

/// Ready to explore an arm of three joints, all of whose commands are kept.
pub fn ready(strategies: Composition, root: usize) -> Exploration {
    Exploration::new(Box::new(arm(3)), history(3, true), strategies, root).unwrap()
}

pub fn go(run: &mut Exploration, n: usize, stream: &mut Stream) {
    run.run(n, &mut || stream.unit()).unwrap();
}

/// What `n` steps leave.
pub fn explored(strategies: Composition, root: usize, n: usize) -> Log {
    let mut run = ready(strategies, root);
    go(&mut run, n, &mut Stream(1));
    run.into_log().unwrap()
}

/// ADAPT over motor babbling and an inner ADAPT over motor and goal babbling, with their radii.
pub fn nested(outer: f64, inner: f64) -> (Composition, usize) {
    let mut strategies = Composition::default();
    let motor = strategies.add(MotorBabbling);
    let goal = strategies.add(goal_babbling(0.05));
    let inner = strategies.compose(adapt(2, inner, 5), vec![motor, goal]).unwrap();
    let root = strategies.compose(adapt(2, outer, 10), vec![motor, inner]).unwrap();
    (strategies, root)
}

/// What is said of an argument that is refused.
pub fn message<T>(result: Result<T, Error>) -> String {
    result.err().expect("refused").to_string()
}

pub fn bits(numbers: &[f64]) -> Vec<u64> {
    numbers.iter().map(|x| x.to_bits()).collect()
}
