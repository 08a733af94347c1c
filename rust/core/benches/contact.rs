//! Obstructed motions: an arm of 20 links that stops at what it touches.

#[path = "../tests/oracles/mod.rs"]
mod oracles;
mod settings;

use std::hint::black_box;

use criterion::{Criterion, criterion_group, criterion_main};
use divbandit_core::{Obstacle, ObstructedArm, PlanarArm};
use oracles::Stream;

const LIMIT: f64 = 150.0 / 180.0 * std::f64::consts::PI;

/// Discs, squares and walls, in turn, in the ring that the arm at rest does not reach.
fn scene(count: usize) -> Vec<Obstacle> {
    let mut stream = Stream(1);
    let mut draws = || stream.unit();
    let size = 0.3 / (count as f64).sqrt();
    let mut obstacles = Vec::new();
    while obstacles.len() < count {
        let [x, y]: [f64; 2] = [2.0 * draws() - 1.0, 2.0 * draws() - 1.0];
        if y.abs() < size + 0.02 || x.hypot(y) > 1.0 {
            continue;
        }
        obstacles.push(match obstacles.len() % 3 {
            0 => Obstacle::disc([x, y], size / 2.0).unwrap(),
            1 => {
                Obstacle::rectangle([x - size / 2.0, y - size / 2.0], [x + size / 2.0, y]).unwrap()
            }
            _ => Obstacle::wall([x, y], [x + size / 2.0, y + size / 2.0], 0.001).unwrap(),
        });
    }
    obstacles
}

fn motions(criterion: &mut Criterion) {
    let mut group = criterion.benchmark_group("a motion of 20 links");
    let mut stream = Stream(2);
    let mut draws = || stream.unit();
    let commands: Vec<[f64; 20]> =
        (0..500).map(|_| std::array::from_fn(|_| LIMIT * (2.0 * draws() - 1.0))).collect();
    for (count, self_contact) in [(0, false), (10, false), (100, false), (1000, false), (10, true)]
    {
        let arm = PlanarArm::new(20, LIMIT).unwrap();
        let arm = ObstructedArm::new(arm, 0.01, scene(count), self_contact).unwrap();
        let mut moving = arm.moving();
        let stopped = commands.iter().filter(|each| moving.progress(*each).unwrap() < 1.0).count();
        let mut next = commands.iter().cycle();
        let also = if self_contact { ", links stop each other" } else { "" };
        let name = format!("{count} obstacles{also}; {stopped} of 500 stopped");
        group.bench_function(name, |bencher| {
            bencher.iter(|| moving.effect(black_box(next.next().unwrap())).unwrap());
        });
    }
}

criterion_group! { name = benches; config = settings::quick(); targets = motions }
criterion_main!(benches);
