//! One gain among ten neighbours, and a thousand insertions, by dimension and accuracy.

use std::hint::black_box;

use criterion::{BenchmarkId, Criterion, criterion_group, criterion_main};
use divbandit_core::coverage::estimate::Estimate;

#[path = "../tests/oracles/mod.rs"]
mod oracles;
mod settings;

/// A point in a random direction, `length` from the origin.
fn point(dim: usize, length: f64, stream: &mut oracles::Stream) -> Vec<f64> {
    let x: Vec<f64> = (0..dim).map(|_| stream.normals()[0]).collect();
    let norm = x.iter().map(|x| x * x).sum::<f64>().sqrt();
    x.iter().map(|x| x / norm * length).collect()
}

/// Twelve draws of ten neighbours each, 0.4 to 1.4 radii away; what one gain costs.
fn gain(criterion: &mut Criterion) {
    let mut group = criterion.benchmark_group("estimate/gain");
    for dim in [4, 8, 16] {
        for accuracy in [1e-2, 1e-3] {
            let mut stream = oracles::Stream(1);
            let mut estimates: Vec<Estimate> = (0..12)
                .map(|key| {
                    let mut estimate = Estimate::new(1.0, dim, accuracy, key);
                    for _ in 0..10 {
                        let length = stream.between(0.4, 1.4);
                        estimate.insert(&point(dim, length, &mut stream));
                    }
                    estimate
                })
                .collect();
            let origin = vec![0.0; dim];
            group.bench_function(BenchmarkId::new(format!("{dim}d"), accuracy), |bencher| {
                let mut which = 0;
                bencher.iter(|| {
                    which = (which + 1) % 12;
                    black_box(estimates[which].gain(&origin))
                });
            });
        }
    }
    group.finish();
}

/// A thousand effects of an exploration: normal steps around places seen before.
fn grow(criterion: &mut Criterion) {
    let mut group = criterion.benchmark_group("estimate/thousand");
    for dim in [4, 8, 16] {
        let mut stream = oracles::Stream(2);
        let mut effects: Vec<Vec<f64>> = vec![vec![0.0; dim]];
        while effects.len() < 1000 {
            let step = point(dim, stream.between(0.0, 2.0), &mut stream);
            let from = &effects[stream.below(effects.len())];
            effects.push(from.iter().zip(step).map(|(a, b)| a + b).collect());
        }
        group.bench_function(BenchmarkId::new(format!("{dim}d"), 1e-2), |bencher| {
            bencher.iter(|| {
                let mut estimate = Estimate::new(1.0, dim, 1e-2, 1);
                effects.iter().map(|effect| estimate.insert(effect).gain).sum::<f64>()
            });
        });
    }
    group.finish();
}

criterion_group! { name = benches; config = settings::quick(); targets = gain, grow }
criterion_main!(benches);
