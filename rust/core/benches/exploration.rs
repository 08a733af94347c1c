//! Whole explorations: what a step costs, and what each of its parts costs by itself.
//!
//! A table of processor time, the best of five runs each: ADAPT over motor and goal babbling on
//! the paper's arm, and beside it the very same draws, kinematics, searches and insertions made
//! one kind after the other. A plain arm with the standard library's sines is the yardstick.

use std::hint::black_box;

use cpu_time::ProcessTime;
use divbandit_core::bandits::{Adapt, GainWindow};
use divbandit_core::goals::Uniform;
use divbandit_core::inverse::Nearest;
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

fn adapt(d: f64, n: usize, keep_commands: bool) -> Exploration {
    let space = Bounds::new(vec![-LIMIT; JOINTS], vec![LIMIT; JOINTS]).unwrap();
    let goals = Bounds::new(vec![-1.0; 2], vec![1.0; 2]).unwrap();
    let mut strategies = Composition::default();
    let (uniform, nearest) = (Uniform::new(None).unwrap(), Nearest::new(d).unwrap());
    let babbling = GoalBabbling::new(Box::new(uniform), Box::new(nearest));
    let parts = vec![strategies.add(MotorBabbling), strategies.add(babbling)];
    let bandit = Adapt::new(2, Coverage::new(TAU, 2).unwrap(), WINDOW, 0.1, 1).unwrap();
    let root = strategies.compose(bandit, parts).unwrap();
    let history = History::new(space, Some(goals), 2, keep_commands).unwrap();
    let arm = Box::new(PlanarArm::new(JOINTS, LIMIT).unwrap());
    let mut run = Exploration::new(arm, history, strategies, root).unwrap();
    run.reserve(n).unwrap();
    run
}

fn explore(d: f64, n: usize, seed: u64) -> divbandit_core::exploration::Log {
    let mut stream = Stream(seed);
    let mut run = adapt(d, n, true);
    run.run(n, &mut || stream.unit()).unwrap();
    run.into_log().unwrap()
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
        let mut windows = [0, 1].map(|_| GainWindow::new(WINDOW, coverage.ball(), 1));
        for (&gain, &choice) in gains.iter().zip(&run.choices) {
            windows[choice].add(gain);
            black_box(windows[choice].mean());
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
