//! The inverse model: from a goal to a command, over the number of effects observed.

use std::hint::black_box;

use criterion::{BenchmarkId, Criterion, Throughput, criterion_group, criterion_main};
use divbandit_core::inverse::{InverseModel, Nearest};
use divbandit_core::{Bounds, PlanarArm};

#[path = "../tests/oracles/mod.rs"]
mod oracles;
mod settings;

const JOINTS: usize = 20;
const LIMIT: f64 = 2.6;
const GOALS: usize = 1000;

fn goals_to_commands(criterion: &mut Criterion) {
    let arm = PlanarArm::new(JOINTS, LIMIT).unwrap();
    let space = Bounds::new(vec![-LIMIT; JOINTS], vec![LIMIT; JOINTS]).unwrap();
    let mut group = criterion.benchmark_group("inverse");
    group.throughput(Throughput::Elements(GOALS as u64));
    for n in [100, 1000, 10_000, 100_000] {
        let mut stream = oracles::Stream(1);
        let commands: Vec<f64> = (0..n * JOINTS).map(|_| stream.between(-LIMIT, LIMIT)).collect();
        let mut effects = vec![0.0; 2 * n];
        arm.effects(&commands, &mut effects).unwrap();
        let mut history = oracles::past::past(&space, None, 2, &commands, &effects);
        let (mut model, mut command) = (Nearest::new(0.05).unwrap(), [0.0; JOINTS]);
        let goals: Vec<f64> = (0..2 * GOALS).map(|_| stream.between(-1.0, 1.0)).collect();

        group.bench_function(BenchmarkId::from_parameter(n), |bencher| {
            let mut unit = || stream.unit();
            bencher.iter(|| {
                for goal in goals.chunks_exact(2) {
                    model.command(goal, &mut history, &mut unit, &mut command).unwrap();
                    black_box(&command);
                }
            });
        });
    }
}

criterion_group!(name = benches; config = settings::quick(); targets = goals_to_commands);
criterion_main!(benches);
