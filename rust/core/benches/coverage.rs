//! The gains of 10,000 effects, beside what finding their neighbours alone would cost in
//! parry's tree of bounding boxes.

use std::f64::consts::TAU;
use std::hint::black_box;

use criterion::{BenchmarkId, Criterion, Throughput, criterion_group, criterion_main};
use divbandit_core::Coverage;
use parry2d_f64::bounding_volume::Aabb;
use parry2d_f64::math::Vector;
use parry2d_f64::partitioning::Bvh;

#[path = "../tests/oracles/mod.rs"]
mod oracles;
mod settings;

const N: usize = 10_000;

/// Effects uniform in the unit disc, or normal around thirty places in it.
fn effects(clustered: bool) -> Vec<[f64; 2]> {
    let mut stream = oracles::Stream(1);
    let in_disc = |stream: &mut oracles::Stream| {
        let (radius, angle) = (stream.unit().sqrt(), stream.between(0.0, TAU));
        [radius * angle.cos(), radius * angle.sin()]
    };
    let centres: Vec<_> = (0..30).map(|_| in_disc(&mut stream)).collect();
    let mut effect = |i: usize| {
        if clustered {
            let ([x, y], [dx, dy]) = (centres[i % 30], stream.normals());
            [x + 0.02 * dx, y + 0.02 * dy]
        } else {
            in_disc(&mut stream)
        }
    };
    (0..N).map(&mut effect).collect()
}

fn cover(effects: &[[f64; 2]], tau: f64) -> Coverage {
    let mut coverage = Coverage::new(tau, 2).unwrap();
    for &effect in effects {
        black_box(coverage.add(effect).unwrap());
    }
    coverage
}

/// Counts the centres within 2 tau of each effect, among those that gained something: the
/// boxes find what lies in a square, the distance decides.
fn search(effects: &[[f64; 2]], stored: &[bool], tau: f64) -> usize {
    let (mut bvh, mut neighbours) = (Bvh::new(), 0);
    for (i, &[x, y]) in effects.iter().enumerate() {
        let (centre, reach) = (Vector::new(x, y), Vector::splat(2.0 * tau));
        let square = Aabb::new(centre - reach, centre + reach);
        let near = |&j: &u32| {
            let [u, v] = effects[j as usize];
            (u - x).powi(2) + (v - y).powi(2) < 4.0 * tau * tau
        };
        neighbours += bvh.intersect_aabb(&square).filter(near).count();
        if stored[i] {
            bvh.insert(Aabb::new(centre, centre), i as u32);
        }
    }
    neighbours
}

/// Which effects gain something: the others lie wholly in the union of those before.
fn stored(effects: &[[f64; 2]], tau: f64) -> Vec<bool> {
    cover(effects, tau).gains().iter().map(|&gain| gain > 0.0).collect()
}

fn gains(criterion: &mut Criterion) {
    let mut group = criterion.benchmark_group("coverage");
    group.throughput(Throughput::Elements(N as u64));
    for (family, clustered) in [("uniform", false), ("clustered", true)] {
        let effects = effects(clustered);
        for tau in [0.005, 0.02, 0.1] {
            let id = |name| BenchmarkId::new(name, format!("{family}/tau {tau}"));
            group.bench_function(id("add"), |b| b.iter(|| cover(black_box(&effects), tau)));
            let stored = stored(&effects, tau);
            group.bench_function(id("search alone: parry"), |bencher| {
                bencher.iter(|| search(black_box(&effects), &stored, tau));
            });
        }
    }
}

criterion_group!(name = benches; config = settings::quick(); targets = gains);
criterion_main!(benches);
