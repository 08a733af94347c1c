//! Each measure equals a slow and plain computation of the same thing, from all effects at once.

use crate::oracles::sums::on_paper;
use crate::oracles::{Stream, fixed};
use divbandit_core::Coverage;
use divbandit_core::coverage::Sampling;
use divbandit_core::elementary::log;
use divbandit_core::measures::{KEY, Measure, MeasureKind, PerCoordinate};
use proptest::prelude::*;
use proptest::sample::select;

use PerCoordinate::{All, Each};

const DIM: usize = 2;

/// Effects that lie anywhere, on borders of cells, or where another one does.
fn effects() -> impl Strategy<Value = Vec<[f64; DIM]>> {
    let quarter = (-8..=8).prop_map(|k| f64::from(k) / 4.0);
    let coordinate = prop_oneof![quarter, -2.0..2.0, select(vec![-0.0, 1e-300, -1e-300, 1e14])];
    prop::collection::vec([coordinate.clone(), coordinate], 0..60)
}

/// Adds effects one by one; what each gains must be what it was said to gain, and change the
/// measure by as much.
fn added(measure: &mut dyn Measure, effects: &[[f64; DIM]]) -> Vec<f64> {
    let mut gains = Vec::new();
    for effect in effects {
        measure.check("effect", effect).unwrap();
        let (before, len) = (measure.measure(), measure.len());
        let promised = measure.gain(effect);
        assert_eq!((measure.measure(), measure.len()), (before, len));
        let gain = measure.add(effect);
        assert_eq!(gain.to_bits(), promised.to_bits());
        assert_eq!(measure.len(), len + 1);
        gains.push(gain);
    }
    gains
}

/// How many effects lie in each cell, the cells in the order of their first effects.
fn histogram(effects: &[[f64; DIM]], edges: [f64; DIM], origin: [f64; DIM]) -> Vec<usize> {
    let mut counts: Vec<([f64; DIM], usize)> = Vec::new();
    for effect in effects {
        let cell = std::array::from_fn(|j| ((effect[j] - origin[j]) / edges[j]).floor());
        match counts.iter_mut().find(|(known, _)| *known == cell) {
            Some((_, count)) => *count += 1,
            None => counts.push((cell, 1)),
        }
    }
    counts.into_iter().map(|(_, count)| count).collect()
}

/// n H = n log n - the sum of c log c, exactly, by as many additions of each logarithm.
fn entropy(counts: &[usize]) -> f64 {
    let n: usize = counts.iter().sum();
    if n == 0 {
        return 0.0;
    }
    let mut terms = vec![log(n as f64); n];
    for &count in counts {
        terms.extend(vec![-log(count as f64); count]);
    }
    on_paper(&terms) / n as f64
}

fn sparseness(k: usize, before: &[[f64; DIM]], effect: [f64; DIM]) -> f64 {
    let distance = |other: &[f64; DIM]| {
        let along: [f64; DIM] = std::array::from_fn(|j| effect[j] - other[j]);
        (along[0] * along[0] + along[1] * along[1]).sqrt()
    };
    let mut distances: Vec<f64> = before.iter().map(distance).collect();
    distances.sort_by(f64::total_cmp);
    distances.truncate(k);
    if distances.is_empty() { 0.0 } else { on_paper(&distances) / distances.len() as f64 }
}

fn grids() -> impl Strategy<Value = ([f64; DIM], [f64; DIM])> {
    let edge = select(vec![0.25, 0.1, 1.0, 3.0]);
    let corner = select(vec![0.0, 0.25, -0.3]);
    ([edge.clone(), edge], [corner.clone(), corner])
}

proptest! {
    #![proptest_config(fixed(300))]

    #[test]
    fn grid_coverage_counts_cells(effects in effects(), (edges, origin) in grids()) {
        let (cell, corner) = (Each(edges.to_vec()), Each(origin.to_vec()));
        let mut grid = MeasureKind::Grid { cell, origin: corner }.start(DIM).unwrap();
        for (i, gain) in added(&mut *grid, &effects).into_iter().enumerate() {
            let occupied = |n: usize| histogram(&effects[..n], edges, origin).len();
            prop_assert_eq!(gain, (occupied(i + 1) - occupied(i)) as f64);
        }
        prop_assert_eq!(grid.measure(), histogram(&effects, edges, origin).len() as f64);
    }

    #[test]
    fn entropy_is_that_of_the_histogram(effects in effects(), (edges, origin) in grids()) {
        let (cell, corner) = (Each(edges.to_vec()), Each(origin.to_vec()));
        let mut measure = MeasureKind::Entropy { cell, origin: corner }.start(DIM).unwrap();
        for (i, gain) in added(&mut *measure, &effects).into_iter().enumerate() {
            let after = |n: usize| entropy(&histogram(&effects[..n], edges, origin));
            prop_assert_eq!(gain.to_bits(), (after(i + 1) - after(i)).to_bits());
            prop_assert!(gain <= measure.largest_gain());
        }
        let counts = histogram(&effects, edges, origin);
        prop_assert_eq!(measure.measure().to_bits(), entropy(&counts).to_bits());
        prop_assert!(measure.measure() >= 0.0);
        prop_assert_eq!(measure.measure() == 0.0, counts.len() < 2);
    }

    #[test]
    fn sparseness_is_the_mean_distance_to_the_nearest(effects in effects(), k in 1_usize..20) {
        let mut measure = MeasureKind::Sparseness { k }.start(DIM).unwrap();
        let gains = added(&mut *measure, &effects);
        for (i, gain) in gains.iter().enumerate() {
            let expected = sparseness(k, &effects[..i], effects[i]);
            prop_assert_eq!(gain.to_bits(), expected.to_bits());
        }
        prop_assert_eq!(measure.measure().to_bits(), on_paper(&gains).to_bits());
    }

    #[test]
    fn balls_cover_what_coverage_says(effects in effects(), tau in 0.05..0.5) {
        let mut balls = MeasureKind::Balls { tau, accuracy: 1e-3 }.start(DIM).unwrap();
        let mut coverage = Coverage::new(tau, DIM).unwrap();
        let gains = added(&mut *balls, &effects);
        for (effect, gain) in effects.iter().zip(gains) {
            prop_assert_eq!(gain.to_bits(), coverage.add(effect).unwrap().to_bits());
        }
        prop_assert_eq!(balls.measure().to_bits(), coverage.measure().to_bits());
        prop_assert_eq!(balls.largest_gain(), coverage.ball());
    }
}

/// From dimension 4 on gains are estimated, with the key that stands for a seed of 0.
#[test]
fn balls_of_many_dimensions() {
    let mut balls = MeasureKind::Balls { tau: 0.8, accuracy: 0.01 }.start(4).unwrap();
    let sampling = Sampling { accuracy: 0.01, key: KEY };
    let mut coverage = Coverage::sampled(0.8, 4, sampling).unwrap();
    let mut draws = Stream(1);
    for _ in 0..20 {
        let effect: [f64; 4] = std::array::from_fn(|_| draws.between(-1.0, 1.0));
        assert_eq!(balls.add(&effect).to_bits(), coverage.add(effect).unwrap().to_bits());
    }
}

/// All effects in one cell, and then one elsewhere: the two large terms of the sum cancel.
#[test]
fn entropy_of_many_effects_in_one_cell() {
    let kind = MeasureKind::Entropy { cell: All(1.0), origin: All(0.0) };
    let mut measure = kind.start(1).unwrap();
    for _ in 0..10_000 {
        assert_eq!(measure.add(&[0.5]), 0.0);
    }
    measure.add(&[1.5]);
    assert_eq!(measure.measure().to_bits(), entropy(&[10_000, 1]).to_bits());
}

/// Small whole numbers as f64 must not share a few places of the table.
#[test]
fn a_million_cells_are_found_fast() {
    let kind = MeasureKind::Grid { cell: All(1.0), origin: All(0.0) };
    let mut grid = kind.start(2).unwrap();
    for x in 0..1000 {
        for y in 0..1000 {
            assert_eq!(grid.add(&[f64::from(x), f64::from(y)]), 1.0);
        }
    }
    assert_eq!(grid.measure(), 1e6);
}

#[test]
fn what_cannot_be_placed_is_refused() {
    let cell = Each(vec![1.0, 1e-10]);
    let grid = MeasureKind::Grid { cell, origin: All(0.5) }.start(2).unwrap();
    assert_eq!(
        grid.check("effects", &[0.0, 0.0, 1e300, 1e300]).unwrap_err().to_string(),
        "effects[1, 1] must be within 1.7e308 cells of 0.5, got 1e300 with cell 1e-10"
    );
    let sparseness = MeasureKind::Sparseness { k: 1 }.start(2).unwrap();
    assert_eq!(
        sparseness.check("effect", &[0.0, -2e150]).unwrap_err().to_string(),
        "effect[1] must be within 1e150 of 0, got -2e150"
    );
}

#[test]
fn a_kind_says_what_is_wrong_with_it() {
    let grid = |cell, origin| MeasureKind::Grid { cell, origin };
    let entropy = |cell, origin| MeasureKind::Entropy { cell, origin };
    for (kind, dim, message) in [
        (grid(Each(vec![1.0]), All(0.0)), 2, "cell must have length 2, got 1"),
        (entropy(All(1.0), Each(vec![0.0; 3])), 2, "origin must have length 2, got 3"),
        (grid(Each(vec![1.0, -1.0]), All(0.0)), 2, "cell must be positive, got -1.0"),
        (entropy(All(0.0), All(0.0)), 2, "cell must be positive, got 0.0"),
        (grid(All(f64::NAN), All(0.0)), 2, "cell must be a finite number, got NaN"),
        (grid(All(1.0), Each(vec![0.0, f64::INFINITY])), 2, "origin[1] must be finite, got inf"),
        (grid(All(1.0), All(0.0)), 0, "dim must be from 1 to 1000000, got 0"),
        (MeasureKind::Sparseness { k: 1 }, 0, "dim must be from 1 to 1000000, got 0"),
        (MeasureKind::Sparseness { k: 0 }, 2, "k must be at least 1, got 0"),
        (MeasureKind::Balls { tau: 0.5, accuracy: 1e-3 }, 33, "dim must be from 1 to 32, got 33"),
    ] {
        assert_eq!(kind.start(dim).unwrap_err().to_string(), message);
    }
}
