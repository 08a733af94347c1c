//! Insertion one by one and the nearest point, beside parry's tree of bounding boxes.

use std::hint::black_box;

use criterion::{BenchmarkId, Criterion, Throughput, criterion_group, criterion_main};
use divbandit_core::NearestNeighbors;
use parry2d_f64::bounding_volume::Aabb;
use parry2d_f64::math::Vector;
use parry2d_f64::partitioning::{Bvh, BvhBuildStrategy};

#[path = "../tests/oracles/mod.rs"]
mod oracles;
mod settings;

const QUERIES: usize = 1000;

/// `n` points in [-1, 1]^dim: everywhere, or within 1e-6 of fifty places.
fn points(n: usize, dim: usize, clustered: bool) -> Vec<f64> {
    let mut stream = oracles::Stream(1);
    let centres: Vec<f64> = (0..50 * dim).map(|_| stream.between(-1.0, 1.0)).collect();
    let mut coordinate = |i: usize| match clustered {
        true => centres[i / dim % 50 * dim + i % dim] + stream.between(-1e-6, 1e-6),
        false => stream.between(-1.0, 1.0),
    };
    (0..n * dim).map(&mut coordinate).collect()
}

fn tree(points: &[f64], dim: usize) -> NearestNeighbors {
    let mut tree = NearestNeighbors::new(dim).unwrap();
    for point in points.chunks_exact(dim) {
        tree.add(point).unwrap();
    }
    tree
}

fn leaves(points: &[f64]) -> Vec<Aabb> {
    let leaf = |point: &[f64]| {
        let at = Vector::new(point[0], point[1]);
        Aabb::new(at, at)
    };
    points.chunks_exact(2).map(leaf).collect()
}

fn grown(leaves: &[Aabb]) -> Bvh {
    let mut bvh = Bvh::new();
    for (i, &leaf) in leaves.iter().enumerate() {
        bvh.insert(leaf, i as u32);
    }
    bvh
}

fn nearest(bvh: &Bvh, leaves: &[Aabb], query: Vector) -> Option<(u32, f64)> {
    bvh.find_best(
        f64::MAX,
        |node, _| {
            let outside = (node.mins() - query).max(query - node.maxs()).max(Vector::ZERO);
            outside.length_squared()
        },
        |leaf, _| Some((leaves[leaf as usize].mins - query).length_squared()),
    )
}

fn trees(criterion: &mut Criterion) {
    for (n, dim, clustered) in [100, 10_000, 100_000]
        .into_iter()
        .flat_map(|n| [2, 3, 8].into_iter().flat_map(move |dim| [(n, dim, false), (n, dim, true)]))
    {
        let family = if clustered { "clustered" } else { "uniform" };
        let id = |name: &str| BenchmarkId::new(name, format!("{family}/dim {dim}/{n}"));
        let points = points(n, dim, clustered);
        let mut stream = oracles::Stream(2);
        let queries: Vec<f64> = (0..QUERIES * dim).map(|_| stream.between(-1.0, 1.0)).collect();

        let mut group = criterion.benchmark_group("kdtree");
        group.throughput(Throughput::Elements(n as u64));
        group.bench_function(id("add"), |b| b.iter(|| tree(black_box(&points), dim)));
        let tree = tree(&points, dim);
        group.throughput(Throughput::Elements(QUERIES as u64));
        group.bench_function(id("nearest"), |bencher| {
            bencher.iter(|| {
                queries.chunks_exact(dim).fold(0, |sum, query| sum ^ tree.nearest(query).unwrap().1)
            });
        });
        if dim != 2 {
            continue;
        }
        let leaves = leaves(&points);
        group.throughput(Throughput::Elements(n as u64));
        group.bench_function(id("parry add"), |b| b.iter(|| grown(black_box(&leaves))));
        group.throughput(Throughput::Elements(QUERIES as u64));
        let built = Bvh::from_leaves(BvhBuildStrategy::Binned, &leaves);
        for (name, bvh) in [("parry nearest", grown(&leaves)), ("parry built nearest", built)] {
            group.bench_function(id(name), |bencher| {
                bencher.iter(|| {
                    let each = queries.chunks_exact(2).map(|q| Vector::new(q[0], q[1]));
                    each.fold(0, |sum, query| sum ^ nearest(&bvh, &leaves, query).unwrap().0)
                });
            });
        }
    }
}

criterion_group!(name = benches; config = settings::quick(); targets = trees);
criterion_main!(benches);
