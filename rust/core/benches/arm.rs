//! Forward kinematics: one command and many, beside the platform's sines and a chain of
//! rigid motions.

use std::f64::consts::PI;
use std::hint::black_box;

use criterion::{BenchmarkId, Criterion, Throughput, criterion_group, criterion_main};
use divbandit_core::PlanarArm;
use nalgebra::{Isometry2, Point2, Translation2, Vector2};

#[path = "../tests/oracles/mod.rs"]
mod oracles;
mod settings;

const LIMIT: f64 = 150.0 / 180.0 * PI;
const BATCH: usize = 10_000;

type Kinematics = fn(&[f64]) -> [f64; 2];

/// What one would write first.
fn plain(command: &[f64]) -> [f64; 2] {
    let (mut angle, mut x, mut y) = (0.0, 0.0, 0.0);
    for turn in command {
        angle += turn;
        let (sine, cosine) = f64::sin_cos(angle);
        x += cosine;
        y += sine;
    }
    [x / command.len() as f64, y / command.len() as f64]
}

/// What one would write with a library of geometry.
fn chain(command: &[f64]) -> [f64; 2] {
    let segment = Translation2::new(1.0 / command.len() as f64, 0.0);
    let pose = command.iter().fold(Isometry2::identity(), |pose, &angle| {
        pose * Isometry2::new(Vector2::zeros(), angle) * segment
    });
    (pose * Point2::origin()).coords.into()
}

fn kinematics(criterion: &mut Criterion) {
    for joints in [5, 20, 40] {
        let mut stream = oracles::Stream(1);
        let commands: Vec<f64> =
            (0..BATCH * joints).map(|_| stream.between(-LIMIT, LIMIT)).collect();
        let mut effects = vec![0.0; 2 * BATCH];
        let arm = PlanarArm::new(joints, LIMIT).unwrap();

        let mut group = criterion.benchmark_group("arm");
        group.throughput(Throughput::Elements(BATCH as u64));
        group.bench_function(BenchmarkId::new("batch", joints), |bencher| {
            bencher.iter(|| arm.effects(black_box(&commands), &mut effects).unwrap());
        });
        group.bench_function(BenchmarkId::new("single", joints), |bencher| {
            bencher.iter(|| {
                for command in commands.chunks_exact(joints) {
                    black_box(arm.effect(black_box(command)).unwrap());
                }
            });
        });
        let peers: [(&str, Kinematics); 2] = [("plain sin_cos", plain), ("nalgebra chain", chain)];
        for (name, peer) in peers {
            group.bench_function(BenchmarkId::new(name, joints), |bencher| {
                bencher.iter(|| {
                    for command in commands.chunks_exact(joints) {
                        black_box(peer(black_box(command)));
                    }
                });
            });
        }
    }
}

criterion_group!(name = benches; config = settings::quick(); targets = kinematics);
criterion_main!(benches);
