//! Explorations of small arms, ready to run.

#![allow(dead_code, reason = "each test takes the part that it needs")]

use divbandit_core::bandits::Bandit;
use divbandit_core::bandits::estimators::EstimatorKind;
use divbandit_core::bandits::policies::PolicyKind;
use divbandit_core::bandits::rewards::RewardKind;
use divbandit_core::goals::Uniform;
use divbandit_core::history::Log;
use divbandit_core::inverse::Nearest;
use divbandit_core::measures::MeasureKind;
use divbandit_core::strategies::{GoalBabbling, Mixture, MotorBabbling};
use divbandit_core::{
    Bounds, Composition, Environment, Error, Exploration, History, PlanarArm, Proposal,
};

use crate::oracles::Stream;

/// The limit of the joints, in radians.
pub const LIMIT: f64 = 2.5;

pub fn arm(joints: usize) -> PlanarArm {
    PlanarArm::new(joints, LIMIT).unwrap()
}

pub fn cube(dim: usize, half: f64) -> Bounds {
    Bounds::new(vec![-half; dim], vec![half; dim]).unwrap()
}

/// Goals in a square; with each step `width` estimates are logged.
pub fn history(joints: usize, keeps_commands: bool, width: usize) -> History {
    History::new(cube(joints, LIMIT), Some(cube(2, 1.0)), keeps_commands, width).unwrap()
}

pub fn goal_babbling(d: f64) -> GoalBabbling {
    let (goals, inverse) = (Uniform::new(None).unwrap(), Nearest::new(d).unwrap());
    GoalBabbling::new(Box::new(goals), Box::new(inverse))
}

/// The gain of discs, or balls, of this radius.
pub fn gain(tau: f64) -> RewardKind {
    RewardKind::Gain(MeasureKind::Balls { tau, accuracy: 1e-3 })
}

/// ADAPT where effects have two dimensions, with a head start of one gain.
pub fn adapt(parts: usize, tau: f64, window: usize) -> Bandit {
    let estimator = EstimatorKind::Window { size: window, head_start: 1 };
    let policy = PolicyKind::Proportional { alpha: 0.1, power: 1.0 };
    Bandit::new(parts, gain(tau), estimator, policy, Some(2)).unwrap()
}

/// A mixture of parts that are all as likely.
pub fn mixed(strategies: &mut Composition, parts: Vec<usize>) -> usize {
    strategies.compose(Mixture::new(vec![1.0; parts.len()]).unwrap(), parts).unwrap()
}

/// An exploration, with all that it needs.
pub struct Run {
    pub exploration: Exploration,
    pub environment: Box<dyn Environment>,
    pub history: History,
}

impl Run {
    /// Of an arm of three joints, all of whose commands are kept.
    pub fn new(strategies: Composition, root: usize) -> Self {
        let exploration = Exploration::new(strategies, root, &history(3, true, 0)).unwrap();
        let width = exploration.estimates().map_or(0, <[f64]>::len);
        Self { exploration, environment: Box::new(arm(3)), history: history(3, true, width) }
    }

    pub fn go(&mut self, n: usize, stream: &mut Stream) {
        self.try_to_go(n, stream).unwrap();
    }

    pub fn try_to_go(&mut self, n: usize, stream: &mut Stream) -> Result<(), Error> {
        let Self { exploration, environment, history } = self;
        exploration.run(&mut **environment, history, n, &mut || stream.unit())
    }

    pub fn propose(&mut self, stream: &mut Stream) -> Proposal {
        let mut proposal = Proposal::new(self.history.motor_space().dim());
        let mut draws = || stream.unit();
        self.exploration.propose(&mut self.history, &mut draws, &mut proposal).unwrap();
        proposal
    }

    pub fn observe(&mut self, proposal: &Proposal, effect: &[f64]) -> Result<(), Error> {
        self.exploration.observe(&mut self.history, proposal, effect)
    }

    pub fn into_log(self) -> Log {
        self.history.into_log().unwrap()
    }
}

/// What `n` steps leave.
pub fn explored(strategies: Composition, root: usize, n: usize) -> Log {
    let mut run = Run::new(strategies, root);
    run.go(n, &mut Stream(1));
    run.into_log()
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
