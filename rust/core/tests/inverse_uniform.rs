//! Perturbed coordinates are uniform in the part of their range that the box leaves.
//!
//! Kolmogorov and Smirnov's test: if N numbers are uniform, sqrt(N) times the largest gap
//! between their empirical distribution and the uniform one exceeds 1.95 with probability
//! 0.001. The seeds are fixed, so the outcome is too.

use crate::oracles::Stream;
use divbandit_core::Bounds;

const N: usize = 20_000;
const CRITICAL: f64 = 1.95;

/// sqrt(N) times the largest gap to the distribution uniform in [`low`, `high`].
fn gap(mut values: Vec<f64>, low: f64, high: f64) -> f64 {
    values.sort_by(f64::total_cmp);
    let n = values.len() as f64;
    let gaps = values.iter().enumerate().map(|(i, value)| {
        let (i, expected) = (i as f64, ((value - low) / (high - low)).clamp(0.0, 1.0));
        (expected - i / n).max((i + 1.0) / n - expected)
    });
    gaps.fold(0.0, f64::max) * n.sqrt()
}

/// N perturbations, coordinate by coordinate.
fn perturbed(space: &Bounds, parent: &[f64], d: f64, seed: u64) -> Vec<Vec<f64>> {
    let mut stream = Stream(seed);
    let mut columns = vec![Vec::with_capacity(N); space.dim()];
    for _ in 0..N {
        let command = space.perturb(parent, d, &mut || stream.unit()).unwrap();
        columns.iter_mut().zip(command).for_each(|(column, x)| column.push(x));
    }
    columns
}

#[test]
fn in_the_interior_and_at_the_edges_of_the_box() {
    // Of width 4, 2, 10, 1 and 1: nowhere clipped, clipped above, below, on a corner's edges.
    let space = Bounds::new(vec![-2.0, 0.0, 5.0, 0.0, -1.0], vec![2.0, 2.0, 15.0, 1.0, 0.0]);
    let (space, parent, d) = (space.unwrap(), [0.5, 1.9, 5.5, 0.0, 0.0], 0.1);
    let left = [(0.1, 0.9), (1.7, 2.0), (5.0, 6.5), (0.0, 0.1), (-0.1, 0.0)];
    for (j, (values, (low, high))) in
        perturbed(&space, &parent, d, 11).into_iter().zip(left).enumerate()
    {
        assert!(gap(values.clone(), low, high) < CRITICAL, "coordinate {j}");
        // The test would see an end misplaced by 3 % of the width.
        let slack = 0.03 * (high - low);
        assert!(gap(values.clone(), low - slack, high) > CRITICAL, "coordinate {j}: no power");
        assert!(gap(values, low, high + slack) > CRITICAL, "coordinate {j}: no power");
    }
}

#[test]
fn in_the_whole_box_for_the_largest_d() {
    let space = Bounds::new(vec![-2.0, 3.0], vec![2.0, 3.5]).unwrap();
    for (parent, seed) in [([0.0, 3.25], 1), ([-2.0, 3.5], 2), ([1.7, 3.01], 3)] {
        let columns = perturbed(&space, &parent, 1.0, seed);
        assert!(gap(columns[0].clone(), -2.0, 2.0) < CRITICAL, "{parent:?}");
        assert!(gap(columns[1].clone(), 3.0, 3.5) < CRITICAL, "{parent:?}");
    }
}

#[test]
fn without_a_link_between_coordinates() {
    let space = Bounds::new(vec![0.0, 0.0], vec![1.0, 1.0]).unwrap();
    let columns = perturbed(&space, &[0.5, 0.5], 0.5, 5);
    // x + y modulo 1 of two independent uniform numbers is uniform, as is x - y modulo 1.
    let folded = |sign: f64| -> Vec<f64> {
        columns[0].iter().zip(&columns[1]).map(|(x, y)| (x + sign * y).rem_euclid(1.0)).collect()
    };
    assert!(gap(folded(1.0), 0.0, 1.0) < CRITICAL);
    assert!(gap(folded(-1.0), 0.0, 1.0) < CRITICAL);
}

#[test]
fn and_babbled_commands_are_uniform_in_the_box() {
    let space = Bounds::new(vec![-2.0, 3.0], vec![2.0, 3.5]).unwrap();
    let mut stream = Stream(7);
    let samples: Vec<Vec<f64>> = (0..N).map(|_| space.sample(&mut || stream.unit())).collect();
    let column = |j: usize| samples.iter().map(|sample| sample[j]).collect();
    assert!(gap(column(0), -2.0, 2.0) < CRITICAL);
    assert!(gap(column(1), 3.0, 3.5) < CRITICAL);
}
