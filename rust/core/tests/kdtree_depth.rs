//! The tree stays shallow for any order of arrival, and right where it is large.

use crate::oracles::{Stream, by_distance};
use divbandit_core::NearestNeighbors;

const N: usize = 100_000;

/// Adds the points one by one; the depth must stay in bounds all the way.
fn grow(dim: usize, point: impl FnMut(usize) -> Vec<f64>) {
    let points: Vec<Vec<f64>> = (0..N).map(point).collect();
    let mut tree = NearestNeighbors::new(dim).unwrap();
    for (i, point) in points.iter().enumerate() {
        tree.add(point).unwrap();
        let n = i + 1;
        if n.is_power_of_two() || n % 10_000 == 0 {
            let bound = 3.0 * (n as f64).log2() + 10.0;
            assert!((tree.depth() as f64) < bound, "{} levels for {n} points", tree.depth());
        }
    }
    for query in [&points[0], &points[N / 3], &vec![0.1; dim]] {
        let expected = by_distance(&points, query);
        assert_eq!(tree.nearest(query).unwrap(), expected[0]);
        assert_eq!(tree.nearest_k(query, 20).unwrap(), &expected[..20]);
    }
}

#[test]
fn for_sorted_points() {
    grow(2, |i| vec![i as f64, (i as f64).sqrt()]);
}

#[test]
fn for_points_sorted_downwards() {
    grow(1, |i| vec![-(i as f64)]);
}

#[test]
fn for_equal_points() {
    grow(2, |_| vec![0.3, -0.7]);
}

#[test]
fn for_a_cluster_far_smaller_than_the_space() {
    let mut stream = Stream(3);
    grow(3, |i| {
        let width = if i < 100 { 1.0 } else { 1e-9 };
        (0..3).map(|_| 0.5 + width * stream.between(-1.0, 1.0)).collect()
    });
}

#[test]
fn for_points_closing_in_on_one() {
    // Each half as far from the origin as the one before, over and over.
    grow(2, |i| vec![0.5_f64.powi((i % 1000) as i32), 0.0]);
}
