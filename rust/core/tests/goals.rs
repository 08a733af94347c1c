//! Goals that are drawn by what is known are those of a plain search over the same draws.

mod oracles;

use divbandit_core::{Bounds, Error, NearestNeighbors, goals};
use oracles::{Stream, by_distance, fixed};
use proptest::prelude::*;

fn known(dim: usize, n: usize, stream: &mut Stream) -> (Bounds, Vec<Vec<f64>>, NearestNeighbors) {
    let low: Vec<f64> = (0..dim).map(|_| stream.between(-2.0, 2.0)).collect();
    let high = low.iter().map(|a| a + [0.0, 1.0, 2.0][stream.below(3)]).collect();
    let space = Bounds::new(low.clone(), high).unwrap();
    let effects: Vec<Vec<f64>> =
        (0..n).map(|_| low.iter().map(|a| a + stream.between(-0.2, 2.2)).collect()).collect();
    let mut tree = NearestNeighbors::new(dim).unwrap();
    tree.extend(&effects.concat()).unwrap();
    (space, effects, tree)
}

proptest! {
    #![proptest_config(fixed(300))]

    #[test]
    fn uncovered_goals_are_the_first_beyond_tau(
        dim in 1..=5_usize, n in 1..40_usize, tries in 1..8_usize, seed: u64,
        tau in prop_oneof![Just(1e-6), Just(0.2), Just(1.0)],
    ) {
        let mut stream = Stream(seed);
        let (space, effects, tree) = known(dim, n, &mut stream);
        let mut plain = Stream(stream.0);
        let goal = goals::uncovered(&space, tau, tries, &tree, &mut || stream.unit()).unwrap();
        let mut expected = Vec::new();
        for _ in 0..tries {
            expected = space.sample(&mut || plain.unit());
            if by_distance(&effects, &expected)[0].0 > tau {
                break;
            }
        }
        prop_assert_eq!(goal, expected);
        prop_assert_eq!(stream.0, plain.0);
    }

    #[test]
    fn novel_goals_are_the_farthest(
        dim in 1..=5_usize, n in 1..40_usize, candidates in 1..8_usize, seed: u64,
    ) {
        let mut stream = Stream(seed);
        let (space, effects, tree) = known(dim, n, &mut stream);
        let mut plain = Stream(stream.0);
        let goal = goals::novel(&space, candidates, &tree, &mut || stream.unit()).unwrap();
        let drawn: Vec<_> =
            (0..candidates).map(|_| space.sample(&mut || plain.unit())).collect();
        let far = |goal: &[f64]| by_distance(&effects, goal)[0].0;
        prop_assert!(drawn.contains(&goal));
        prop_assert!(drawn.iter().all(|other| far(other) <= far(&goal)));
        prop_assert_eq!(stream.0, plain.0);
    }

    #[test]
    fn frontier_goals_are_uncovered_unless_all_tries_failed(
        dim in 1..=5_usize, n in 1..40_usize, seed: u64, reach in 1.0..5.0,
    ) {
        let (tries, tau) = (6, 0.3);
        let mut stream = Stream(seed);
        let (space, effects, tree) = known(dim, n, &mut stream);
        let mut draws = 0;
        let mut count = || { draws += 1; stream.unit() };
        let goal = goals::frontier(&space, tau, reach, tries, &tree, &mut count).unwrap();
        prop_assert!(space.check("goal", &goal).is_ok());
        prop_assert!(draws % (dim + 2) == 0 && draws <= tries * (dim + 2));
        if draws < tries * (dim + 2) {
            prop_assert!(by_distance(&effects, &goal)[0].0 > tau);
        }
    }
}

#[test]
fn what_does_not_fit_is_refused_and_nothing_drawn() {
    let plane = Bounds::new(vec![0.0; 2], vec![1.0; 2]).unwrap();
    let line = Bounds::new(vec![0.0], vec![1.0]).unwrap();
    let empty = NearestNeighbors::new(2).unwrap();
    let mut tree = empty.clone();
    tree.add(&[0.5, 0.5]).unwrap();
    let mut none = || panic!("nothing may be drawn");
    let length = Error::Length { name: "goals", must_be: 2, got: 1 };
    assert_eq!(goals::uncovered(&line, 0.1, 3, &tree, &mut none), Err(length.clone()));
    assert_eq!(goals::frontier(&line, 0.1, 2.0, 3, &tree, &mut none), Err(length.clone()));
    assert_eq!(goals::novel(&line, 3, &tree, &mut none), Err(length));
    let nothing = Error::Empty { name: "the set of effects" };
    assert_eq!(goals::uncovered(&plane, 0.1, 3, &empty, &mut none), Err(nothing.clone()));
    assert_eq!(goals::novel(&plane, 3, &empty, &mut none), Err(nothing));
    for bad in [0.0, -1.0, f64::NAN, f64::INFINITY] {
        assert!(goals::uncovered(&plane, bad, 3, &tree, &mut none).is_err());
        assert!(goals::frontier(&plane, 0.1, bad, 3, &tree, &mut none).is_err());
    }
    assert!(goals::uncovered(&plane, 0.1, 0, &tree, &mut none).is_err());
    assert!(goals::novel(&plane, 0, &tree, &mut none).is_err());
}
