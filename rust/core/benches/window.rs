//! The window of rewards: a reward added and the mean read, for windows of several sizes.

use std::hint::black_box;

use criterion::{BenchmarkId, Criterion, Throughput, criterion_group, criterion_main};
use divbandit_core::bandits::estimators::EstimatorKind;

#[path = "../tests/oracles/mod.rs"]
mod oracles;
mod settings;

const GAINS: usize = 10_000;

fn add_and_mean(criterion: &mut Criterion) {
    let mut stream = oracles::Stream(1);
    let gains: Vec<f64> =
        (0..GAINS).map(|_| 1.26e-3 * 10_f64.powf(-16.0 * stream.unit())).collect();
    let mut group = criterion.benchmark_group("window");
    group.throughput(Throughput::Elements(GAINS as u64));
    for size in [1, 50, 1_000_000] {
        // Full from the start.
        let mut window =
            EstimatorKind::Window { size, head_start: size }.start(1, 1.26e-3).unwrap();
        group.bench_function(BenchmarkId::from_parameter(size), |bencher| {
            bencher.iter(|| {
                for &gain in &gains {
                    window.add(0, gain);
                    black_box(window.means()[0]);
                }
            });
        });
    }
}

criterion_group!(name = benches; config = settings::quick(); targets = add_and_mean);
criterion_main!(benches);
