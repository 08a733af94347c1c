//! Untried goals and the local model's steps towards them, over the number of effects that they
//! led to, beside the searches for neighbours that they are made of.

use std::hint::black_box;

use criterion::{BenchmarkId, Criterion, Throughput, criterion_group, criterion_main};
use divbandit_core::goals::Untried;
use divbandit_core::inverse::{LocalJacobian, Observed};
use divbandit_core::{Bounds, NearestNeighbors, PlanarArm};

#[path = "../tests/oracles/mod.rs"]
mod oracles;
mod settings;

const JOINTS: usize = 20;
const LIMIT: f64 = 2.6;
const TAU: f64 = 0.02;
const GOALS: usize = 1000;
const NEIGHBOURS: usize = 51;

fn steps(criterion: &mut Criterion) {
    let arm = PlanarArm::new(JOINTS, LIMIT).unwrap();
    let space = Bounds::new(vec![-LIMIT; JOINTS], vec![LIMIT; JOINTS]).unwrap();
    let reachable = Bounds::new(vec![-1.0; 2], vec![1.0; 2]).unwrap();
    let search = Untried::new(TAU, 12, 20, 4.0).unwrap();
    let model = LocalJacobian::new(NEIGHBOURS - 1, 10, 0.01, 0.015, 0.3).unwrap();
    let mut group = criterion.benchmark_group("towards");
    group.throughput(Throughput::Elements(GOALS as u64));
    for n in [1000, 10_000] {
        let mut stream = oracles::Stream(1);
        let mut unit = || stream.unit();
        let mut effects = NearestNeighbors::new(2).unwrap();
        let (mut commands, mut counts) = (Vec::new(), vec![0; n]);
        let mut goals = Vec::new();
        for i in 0..n {
            let command = if i % 10 == 0 {
                space.sample(&mut unit)
            } else {
                let goal = search.sample(&reachable, &effects, &mut counts, &mut unit).unwrap();
                let observed =
                    Observed { effects: &effects, commands: &commands, motor_space: &space };
                let command = model.command(&goal, &observed, &mut unit).unwrap();
                goals.push(goal);
                command
            };
            effects.add(&arm.effect(&command).unwrap()).unwrap();
            commands.extend(command);
        }
        let goals = &goals[goals.len().saturating_sub(GOALS)..];

        group.bench_function(BenchmarkId::new("goal", n), |bencher| {
            bencher.iter_batched_ref(
                || counts.clone(),
                |counts| {
                    for _ in 0..GOALS {
                        black_box(search.sample(&reachable, &effects, counts, &mut unit).unwrap());
                    }
                },
                criterion::BatchSize::LargeInput,
            );
        });
        let observed = Observed { effects: &effects, commands: &commands, motor_space: &space };
        group.bench_function(BenchmarkId::new("command", n), |bencher| {
            bencher.iter(|| {
                for goal in goals {
                    black_box(model.command(goal, &observed, &mut unit).unwrap());
                }
            });
        });
        group.bench_function(BenchmarkId::new("neighbours", n), |bencher| {
            bencher.iter(|| {
                for goal in goals {
                    black_box(effects.nearest_k(goal, NEIGHBOURS).unwrap());
                }
            });
        });
    }
}

criterion_group!(name = benches; config = settings::quick(); targets = steps);
criterion_main!(benches);
