//! Untried goals and the local model's steps towards them, over the number of effects that they
//! led to, beside the searches for neighbours that they are made of.

use std::hint::black_box;

use criterion::{BatchSize, BenchmarkId, Criterion, Throughput, criterion_group, criterion_main};
use divbandit_core::goals::{GoalSampler, Untried};
use divbandit_core::inverse::{InverseModel, LocalJacobian};
use divbandit_core::{Bounds, PlanarArm};

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
    let mut group = criterion.benchmark_group("towards");
    group.throughput(Throughput::Elements(GOALS as u64));
    for n in [1000, 10_000] {
        let mut stream = oracles::Stream(1);
        let mut unit = || stream.unit();
        let mut search = Untried::new(TAU, 12, 20, 4.0, None).unwrap();
        let mut model = LocalJacobian::new(NEIGHBOURS - 1, 10, 0.01, 0.015, 0.3).unwrap();
        let mut history = oracles::past::past(&space, Some(&reachable), 2, &[], &[]);
        let (mut command, mut goal, mut goals) = (vec![0.0; JOINTS], Vec::new(), Vec::new());
        for i in 0..n {
            if i % 10 == 0 {
                command = space.sample(&mut unit);
            } else {
                search.sample(&mut history, &mut unit, &mut goal).unwrap();
                model.command(&goal, &mut history, &mut unit, &mut command).unwrap();
                goals.push(goal.clone());
            }
            history.record(&command, &arm.effect(&command).unwrap(), &[], &[]).unwrap();
        }
        let goals = &goals[goals.len().saturating_sub(GOALS)..];

        group.bench_function(BenchmarkId::new("goal", n), |bencher| {
            bencher.iter_batched_ref(
                || search.clone(),
                |search| {
                    for _ in 0..GOALS {
                        search.sample(&mut history, &mut unit, &mut goal).unwrap();
                        black_box(&goal);
                    }
                },
                BatchSize::LargeInput,
            );
        });
        group.bench_function(BenchmarkId::new("command", n), |bencher| {
            bencher.iter(|| {
                for goal in goals {
                    model.command(goal, &mut history, &mut unit, &mut command).unwrap();
                    black_box(&command);
                }
            });
        });
        let effects = history.observed().unwrap().effects;
        let mut found = Vec::new();
        group.bench_function(BenchmarkId::new("neighbours", n), |bencher| {
            bencher.iter(|| {
                for goal in goals {
                    effects.nearest_k_into(goal, NEIGHBOURS, &mut found).unwrap();
                    black_box(&found);
                }
            });
        });
    }
}

criterion_group!(name = benches; config = settings::quick(); targets = steps);
criterion_main!(benches);
