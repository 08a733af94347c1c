//! The gains of 10,000 balls in space: even, with some twenty neighbours each, and in crowds.

use std::hint::black_box;

use criterion::{BenchmarkId, Criterion, Throughput, criterion_group, criterion_main};
use divbandit_core::coverage::space::Balls;

#[path = "../tests/oracles/mod.rs"]
mod oracles;
mod settings;

const N: usize = 10_000;

/// Effects uniform in a cube so wide that each has `neighbours` others within two radii when
/// all are there, but for those near its sides.
fn uniform(neighbours: f64) -> Vec<[f64; 3]> {
    let mut stream = oracles::Stream(1);
    let ball_of_radius_2 = 32.0 / 3.0 * std::f64::consts::PI;
    let width = (N as f64 * ball_of_radius_2 / neighbours).cbrt();
    (0..N).map(|_| [0; 3].map(|_| stream.between(0.0, width))).collect()
}

/// Effects normal around one place.
fn cluster(sigma: f64) -> Vec<[f64; 3]> {
    let mut stream = oracles::Stream(2);
    (0..2 * N).map(|_| [0; 3].map(|_| sigma * stream.normals()[0])).collect()
}

fn cover(effects: &[[f64; 3]]) -> Balls {
    let mut balls = Balls::new(1.0);
    for &effect in effects {
        black_box(balls.insert(effect));
    }
    balls
}

fn gains(criterion: &mut Criterion) {
    let mut group = criterion.benchmark_group("space");
    let mut measure = |name: String, effects: Vec<[f64; 3]>| {
        group.throughput(Throughput::Elements(effects.len() as u64));
        let id = BenchmarkId::new(name, format!("{} stored", cover(&effects).stored()));
        group.bench_function(id, |b| b.iter(|| cover(black_box(&effects))));
    };
    for neighbours in [5.0, 20.0, 80.0] {
        measure(format!("uniform, {neighbours} neighbours"), uniform(neighbours));
    }
    for sigma in [1e-6, 0.1, 1.0] {
        measure(format!("normal, sigma {sigma} tau"), cluster(sigma));
    }
}

criterion_group!(name = benches; config = settings::quick(); targets = gains);
criterion_main!(benches);
