//! The tree answers exactly as a search through all points does, in every dimension and for
//! every arrangement of the points.

use crate::oracles::{Stream, by_distance, fixed};
use divbandit_core::NearestNeighbors;
use proptest::prelude::*;

/// An arrangement of points; each is easy for some trees and hard for others.
#[derive(Debug, Clone, Copy)]
enum Family {
    Uniform,
    /// Around four centres, this wide.
    Clustered(f64),
    /// Five distinct points only.
    Duplicated,
    /// Every coordinate grows with the index.
    Sorted,
    /// Integers: very many equal distances.
    Grid,
    /// Integers along the first axis.
    Collinear,
}

fn family() -> impl Strategy<Value = Family> {
    prop_oneof![
        Just(Family::Uniform),
        prop_oneof![Just(1e-3), Just(1e-9), Just(1e-15)].prop_map(Family::Clustered),
        Just(Family::Duplicated),
        Just(Family::Sorted),
        Just(Family::Grid),
        Just(Family::Collinear),
    ]
}

fn arrange(family: Family, dim: usize, n: usize, stream: &mut Stream) -> Vec<Vec<f64>> {
    let mut uniform = |low, high| (0..dim).map(|_| stream.between(low, high)).collect::<Vec<_>>();
    let centres: Vec<_> = (0..5).map(|_| uniform(-1.0, 1.0)).collect();
    let mut point = |i: usize| match family {
        Family::Uniform => uniform(-1.0, 1.0),
        Family::Clustered(width) => {
            let offset = uniform(-width, width);
            centres[i % 4].iter().zip(offset).map(|(c, o)| c + o).collect()
        }
        Family::Duplicated => centres[(i * i) % 5].clone(),
        Family::Sorted => uniform(0.0, 1.0).iter().map(|x| i as f64 + x).collect(),
        Family::Grid => uniform(-1.5, 1.5).iter().map(|x| x.round()).collect(),
        Family::Collinear => {
            let along = uniform(-9.0, 9.0)[0].round();
            (0..dim).map(|j| if j == 0 { along } else { 0.5 }).collect()
        }
    };
    (0..n).map(&mut point).collect()
}

/// A point, a point beside one, half way between two, or somewhere.
fn query(points: &[Vec<f64>], stream: &mut Stream) -> Vec<f64> {
    let (a, b) = (&points[stream.below(points.len())], &points[stream.below(points.len())]);
    match stream.below(4) {
        0 => a.clone(),
        1 => a.iter().map(|x| x + stream.between(-1e-9, 1e-9)).collect(),
        2 => a.iter().zip(b).map(|(x, y)| (x + y) / 2.0).collect(),
        _ => a.iter().map(|_| stream.between(-2.0, 2.0)).collect(),
    }
}

proptest! {
    #![proptest_config(fixed(400))]

    #[test]
    fn answers_are_those_of_a_search_through_all_points(
        dim in 1..=16_usize, family in family(), n in 1..250_usize, seed: u64,
    ) {
        let mut stream = Stream(seed);
        let points = arrange(family, dim, n, &mut stream);
        let mut tree = NearestNeighbors::new(dim).unwrap();
        // Points come one by one or several at a time, and questions in between.
        while tree.len() < n {
            let more = if stream.below(8) == 0 { 1 + stream.below(30) } else { 1 };
            let next = &points[tree.len()..n.min(tree.len() + more)];
            if next.len() == 1 {
                tree.add(&next[0]).unwrap();
            } else {
                tree.extend(&next.concat()).unwrap();
            }
            let known = &points[..tree.len()];
            prop_assert_eq!(tree.points(), known.concat());

            let query = query(known, &mut stream);
            let expected = by_distance(known, &query);
            prop_assert_eq!(tree.nearest(&query).unwrap(), expected[0]);
            let k = [1, 2, 1 + stream.below(known.len()), known.len()][stream.below(4)];
            let k = k.min(known.len());
            prop_assert_eq!(tree.nearest_k(&query, k).unwrap(), &expected[..k]);
        }
    }
}

#[test]
fn an_equal_distance_goes_to_the_earliest_point() {
    let mut tree = NearestNeighbors::new(1).unwrap();
    // 0 and 2 are equally far from 1; the first 2 is the earliest, whatever is added later.
    tree.extend(&[5.0, 2.0, 0.0, 2.0, 0.0]).unwrap();
    assert_eq!(tree.nearest(&[1.0]).unwrap(), (1.0, 1));
    tree.extend(&[0.0; 100]).unwrap();
    assert_eq!(tree.nearest(&[1.0]).unwrap(), (1.0, 1));
    assert_eq!(tree.nearest(&[0.0]).unwrap(), (0.0, 2));
    let found = tree.nearest_k(&[1.0], 4).unwrap();
    assert_eq!(found, [(1.0, 1), (1.0, 2), (1.0, 3), (1.0, 4)]);
}
