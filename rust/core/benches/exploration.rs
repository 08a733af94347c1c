//! Whole explorations: what a step costs, and what each of its parts costs by itself.
//!
//! A table of processor time, the best of five runs each: ADAPT over motor and goal babbling on
//! the paper's arm, and beside it the very same draws, kinematics, searches and insertions made
//! one kind after the other. A plain arm with the standard library's sines is the yardstick. Then
//! the composition of `default_strategy` on the same arm.

use std::hint::black_box;

use cpu_time::ProcessTime;
use divbandit_core::bandits::Bandit;
use divbandit_core::bandits::estimators::EstimatorKind;
use divbandit_core::bandits::policies::PolicyKind;
use divbandit_core::bandits::rewards::RewardKind;
use divbandit_core::goals::{Uniform, Untried};
use divbandit_core::history::Log;
use divbandit_core::inverse::{Crossover, InverseModel, LineVariation, LocalJacobian, Nearest};
use divbandit_core::measures::MeasureKind;
use divbandit_core::strategies::{GoalBabbling, MotorBabbling};
use divbandit_core::{
    Bounds, Composition, Coverage, Exploration, History, NearestNeighbors, PlanarArm,
};

#[path = "../tests/oracles/mod.rs"]
mod oracles;

use oracles::Stream;

const JOINTS: usize = 20;
const LIMIT: f64 = 2.617_993_877_991_494;
const TAU: f64 = 0.02;
const WINDOW: usize = 50;

/// An exploration, made of `n` steps.
struct Run {
    commands: Vec<f64>,
    effects: Vec<f64>,
    goals: Vec<Option<[f64; 2]>>,
    choices: Vec<usize>,
}

/// Explores with a bandit over motor babbling and these goal babblings.
fn explored(
    babblings: Vec<GoalBabbling>,
    estimator: EstimatorKind,
    policy: PolicyKind,
    n: usize,
    seed: u64,
) -> Log {
    let space = Bounds::new(vec![-LIMIT; JOINTS], vec![LIMIT; JOINTS]).unwrap();
    let reachable = Bounds::new(vec![-1.0; 2], vec![1.0; 2]).unwrap();
    let mut strategies = Composition::default();
    let mut parts = vec![strategies.add(MotorBabbling)];
    parts.extend(babblings.into_iter().map(|each| strategies.add(each)));
    let count = parts.len();
    let reward = RewardKind::Gain(MeasureKind::Balls { tau: TAU, accuracy: 1e-3 });
    let bandit = Bandit::new(count, reward, estimator, policy, Some(2)).unwrap();
    let root = strategies.compose(bandit, parts).unwrap();
    let mut history = History::new(space, Some(reachable), true, count).unwrap();
    let mut run = Exploration::new(strategies, root, &history).unwrap();
    let (mut arm, mut stream) = (PlanarArm::new(JOINTS, LIMIT).unwrap(), Stream(seed));
    run.run(&mut arm, &mut history, n, &mut || stream.unit()).unwrap();
    history.into_log().unwrap()
}

/// ADAPT as in the paper.
fn explore(d: f64, n: usize, seed: u64) -> Log {
    let (goals, inverse) = (Uniform::new(None).unwrap(), Nearest::new(d).unwrap());
    let babbling = GoalBabbling::new(Box::new(goals), Box::new(inverse));
    let estimator = EstimatorKind::Window { size: WINDOW, head_start: 1 };
    explored(
        vec![babbling],
        estimator,
        PolicyKind::Proportional { alpha: 0.1, power: 1.0 },
        n,
        seed,
    )
}

/// What `default_strategy` makes in Python.
fn explore_by_default(n: usize, seed: u64) -> Log {
    let models: [Box<dyn InverseModel>; 4] = [
        Box::new(LocalJacobian::new(50, 10, 0.01, 0.2, 0.3).unwrap()),
        Box::new(LocalJacobian::new(50, 10, 0.01, 0.015, 0.3).unwrap()),
        Box::new(LineVariation::new(0.005, 0.2).unwrap()),
        Box::new(Crossover::new(100, 0.01).unwrap()),
    ];
    let goals = || Box::new(Untried::new(TAU, 12, 20, 4.0, None).unwrap());
    let babblings = models.into_iter().map(|model| GoalBabbling::new(goals(), model)).collect();
    let estimator = EstimatorKind::Discounted { gamma: 0.995, head_start: 1 };
    explored(babblings, estimator, PolicyKind::Proportional { alpha: 0.05, power: 16.0 }, n, seed)
}

/// The best of several times of `work`, in ns a step.
fn best<T>(times: usize, n: usize, mut work: impl FnMut() -> T) -> f64 {
    let time = |work: &mut dyn FnMut() -> T| {
        let start = ProcessTime::now();
        black_box(work());
        start.elapsed().as_secs_f64() * 1e9 / n as f64
    };
    (0..times).map(|_| time(&mut work)).fold(f64::INFINITY, f64::min)
}

fn skip(stream: &mut Stream, count: usize) {
    for _ in 0..count {
        black_box(stream.unit());
    }
}

/// What an exploration did, found out by drawing as it did.
fn replay(d: f64, n: usize, seed: u64) -> Run {
    let log = explore(d, n, seed);
    let choices: Vec<usize> = log.paths.iter().map(|&choice| choice as usize).collect();
    let mut stream = Stream(seed);
    let mut goals = Vec::with_capacity(n);
    for (step, &choice) in choices.iter().enumerate() {
        skip(&mut stream, 2);
        let goal = (choice == 1 && step > 0)
            .then(|| [stream.between(-1.0, 1.0), stream.between(-1.0, 1.0)]);
        skip(&mut stream, JOINTS);
        goals.push(goal);
    }
    Run { commands: log.commands, effects: log.effects, goals, choices }
}

/// The tip of the arm with the standard library's sine and cosine, one joint after the other.
fn plain_tip(command: &[f64]) -> [f64; 2] {
    let (mut angle, mut x, mut y) = (0.0_f64, 0.0, 0.0);
    for bend in command {
        angle += bend;
        let (sine, cosine) = angle.sin_cos();
        x += cosine;
        y += sine;
    }
    [x / command.len() as f64, y / command.len() as f64]
}

fn main() {
    let plain = best(5, 10_000, || {
        let mut stream = Stream(3);
        let commands: Vec<f64> =
            (0..10_000 * JOINTS).map(|_| stream.between(-LIMIT, LIMIT)).collect();
        let start = ProcessTime::now();
        for command in commands.chunks_exact(JOINTS) {
            black_box(plain_tip(black_box(command)));
        }
        start.elapsed()
    });
    println!("plain arm with its draws, ns: {plain:.0}");
    println!("ns a step          |  whole | draws |   arm | grow | find | cover | window | sum");
    for (n, times) in [(10_000, 5), (1_000_000, 1)] {
        for d in [0.001, 0.05, 0.5] {
            row(d, n, times);
        }
    }
    println!("default_strategy, ns a step");
    for (n, times) in [(10_000, 5), (100_000, 1)] {
        println!("n = {n:>7}: {:>6.0}", best(times, n, || explore_by_default(n, 1)));
    }
}

fn row(d: f64, n: usize, times: usize) {
    let whole = best(times, n, || explore(d, n, 1));
    let run = replay(d, n, 1);
    let draws = best(times, n, || {
        let mut stream = Stream(1);
        let mut command = [0.0; JOINTS];
        for goal in &run.goals {
            black_box((stream.unit(), stream.unit()));
            if goal.is_some() {
                black_box((stream.unit(), stream.unit()));
            }
            command.iter_mut().for_each(|x| *x = stream.unit());
            black_box(&command);
        }
    });
    let arm = PlanarArm::new(JOINTS, LIMIT).unwrap();
    let tips = best(times, n, || {
        for command in run.commands.chunks_exact(JOINTS) {
            black_box(arm.effect(black_box(command)).unwrap());
        }
    });
    let grow = best(times, n, || grown(&run, n, false));
    let find = best(times, n, || grown(&run, n, true)) - grow;
    let cover = best(times, n, || {
        let mut coverage = Coverage::new(TAU, 2).unwrap();
        for effect in run.effects.chunks_exact(2) {
            black_box(coverage.add(effect).unwrap());
        }
        coverage
    });
    let mut coverage = Coverage::new(TAU, 2).unwrap();
    let mut gains = vec![0.0; n];
    coverage.extend(&run.effects, &mut gains).unwrap();
    let window = best(times, n, || {
        let kind = EstimatorKind::Window { size: WINDOW, head_start: 1 };
        let mut windows = kind.start(2, coverage.ball()).unwrap();
        for (&gain, &choice) in gains.iter().zip(&run.choices) {
            windows.add(choice, gain);
            black_box(windows.means());
        }
    });
    let sum = draws + tips + grow + find + cover + window;
    println!(
        "n = {n:>7}, d = {d:<5}| {whole:>6.0} | {draws:>5.0} | {tips:>5.0} | {grow:>4.0} | {find:>4.0} | {cover:>5.0} | {window:>6.0} | {sum:>4.0}"
    );
}

/// The tree of all effects, grown and, if `find`, searched at each goal.
fn grown(run: &Run, n: usize, find: bool) -> NearestNeighbors {
    let mut tree = NearestNeighbors::new(2).unwrap();
    for step in 0..n {
        if find && let Some(goal) = &run.goals[step] {
            black_box(tree.nearest(goal).unwrap());
        }
        tree.add(&run.effects[2 * step..2 * step + 2]).unwrap();
    }
    tree
}
