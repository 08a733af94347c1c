//! A tree refuses what it cannot hold or answer, names the argument, and stays as it was.

use divbandit_core::{Error, NearestNeighbors};

/// The message of a refusal.
fn refused<T: std::fmt::Debug>(result: Result<T, Error>) -> String {
    result.unwrap_err().to_string()
}

/// A tree with 40 points, and everything in it as text.
fn tree() -> (NearestNeighbors, String) {
    let mut tree = NearestNeighbors::new(2).unwrap();
    tree.extend(&(0..80).map(|i| f64::from(i * i % 17)).collect::<Vec<_>>()).unwrap();
    let inside = format!("{tree:?}");
    (tree, inside)
}

#[test]
fn a_tree_needs_a_dimension() {
    assert_eq!(refused(NearestNeighbors::new(0)), "dim must be at least 1, got 0");
}

#[test]
fn points_are_whole_and_finite() {
    let (mut tree, before) = tree();
    assert_eq!(refused(tree.add(&[1.0])), "point must have length 2, got 1");
    assert_eq!(refused(tree.add(&[1.0; 3])), "point must have length 2, got 3");
    assert_eq!(refused(tree.add(&[0.0, f64::NAN])), "point[1] must be finite, got NaN");
    assert_eq!(refused(tree.add(&[f64::INFINITY, 0.0])), "point[0] must be finite, got inf");
    assert_eq!(
        refused(tree.extend(&[1.0, 2.0, 3.0])),
        "points must be whole rows of 2 numbers, got 3"
    );
    assert_eq!(
        refused(tree.extend(&[1.0, 2.0, 3.0, 4.0, f64::NEG_INFINITY, 5.0])),
        "points[2, 0] must be finite, got -inf"
    );
    assert_eq!(format!("{tree:?}"), before);
    tree.extend(&[]).unwrap();
    assert_eq!(tree.len(), 40);
}

#[test]
fn queries_are_whole_and_finite() {
    let (tree, _) = tree();
    for k in [1, 3] {
        let ask = |query: &[f64]| refused(tree.nearest_k(query, k));
        assert_eq!(ask(&[1.0]), "query must have length 2, got 1");
        assert_eq!(ask(&[f64::NAN, 1.0]), "query[0] must be finite, got NaN");
    }
    assert_eq!(refused(tree.nearest(&[1.0; 3])), "query must have length 2, got 3");
    assert_eq!(refused(tree.nearest(&[1.0, f64::INFINITY])), "query[1] must be finite, got inf");
}

#[test]
fn there_are_as_many_neighbours_as_points() {
    let (tree, _) = tree();
    let ask = |k| refused(tree.nearest_k(&[0.0, 0.0], k));
    assert_eq!(ask(0), "k must be from 1 to the number of points, 40, got 0");
    assert_eq!(ask(41), "k must be from 1 to the number of points, 40, got 41");
    let empty = NearestNeighbors::new(2).unwrap();
    assert_eq!(refused(empty.nearest(&[0.0, 0.0])), "the set of points must not be empty");
    assert_eq!(refused(empty.nearest_k(&[0.0, 0.0], 1)), "the set of points must not be empty");
    assert_eq!((empty.len(), empty.is_empty(), empty.depth()), (0, true, 0));
}
