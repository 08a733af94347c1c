//! Goals that are drawn by what is known are those of a plain search over the same draws.

use crate::oracles::past::past;
use crate::oracles::{Stream, by_distance, fixed};
use divbandit_core::goals::{Frontier, GoalSampler, Grid, Novel, Uncovered, Uniform, Untried};
use divbandit_core::{Bounds, Error, History, Shape, UniformStream};
use proptest::prelude::*;

/// Effects in and around a box, and their history.
struct Known {
    space: Bounds,
    effects: Vec<Vec<f64>>,
    history: History,
}

fn line() -> Bounds {
    Bounds::new(vec![0.0], vec![1.0]).unwrap()
}

fn known(dim: usize, n: usize, stream: &mut Stream) -> Known {
    let low: Vec<f64> = (0..dim).map(|_| stream.between(-2.0, 2.0)).collect();
    let high = low.iter().map(|a| a + [0.0, 1.0, 2.0][stream.below(3)]).collect();
    let space = Bounds::new(low, high).unwrap();
    let effects: Vec<Vec<f64>> = (0..n).map(|_| around(&space, stream)).collect();
    let history = past(&line(), Some(&space), dim, &vec![0.5; n], &effects.concat());
    Known { space, effects, history }
}

fn around(space: &Bounds, stream: &mut Stream) -> Vec<f64> {
    space.low().iter().map(|a| a + stream.between(-0.2, 2.2)).collect()
}

impl Known {
    /// Ten times draws a goal by `sampler` and by `plainly`, from the same stream, and another
    /// effect is observed.
    fn compare(
        &mut self,
        sampler: &mut dyn GoalSampler,
        stream: &mut Stream,
        mut plainly: impl FnMut(&[Vec<f64>], &Bounds, &mut dyn UniformStream) -> Vec<f64>,
    ) -> Result<(), TestCaseError> {
        let (mut plain, mut goal) = (Stream(stream.0), Vec::new());
        for _ in 0..10 {
            sampler.sample(&mut self.history, &mut || stream.unit(), &mut goal).unwrap();
            let expected = plainly(&self.effects, &self.space, &mut || plain.unit());
            prop_assert_eq!(&goal, &expected);
            prop_assert_eq!(stream.0, plain.0);
            let effect = around(&self.space, stream);
            self.history.record(&[0.5], &effect, &[], &[]).unwrap();
            self.effects.push(effect);
            plain.0 = stream.0;
        }
        Ok(())
    }
}

fn far(effects: &[Vec<f64>], goal: &[f64]) -> f64 {
    by_distance(effects, goal)[0].0
}

proptest! {
    #![proptest_config(fixed(300))]

    #[test]
    fn uncovered_goals_are_the_first_beyond_tau(
        dim in 1..=5_usize, n in 1..40_usize, tries in 1..8_usize, seed: u64,
        tau in prop_oneof![Just(1e-6), Just(0.05), Just(0.2), Just(1.0)],
    ) {
        let mut stream = Stream(seed);
        let mut known = known(dim, n, &mut stream);
        let mut sampler = Uncovered::new(tau, tries, None).unwrap();
        known.compare(&mut sampler, &mut stream, |effects, space, draws| {
            let mut expected = space.sample(draws);
            for _ in 1..tries {
                if far(effects, &expected) > tau {
                    break;
                }
                expected = space.sample(draws);
            }
            expected
        })?;
    }

    #[test]
    fn novel_goals_are_the_farthest(
        dim in 1..=5_usize, n in 1..40_usize, candidates in 1..8_usize, seed: u64,
    ) {
        let mut stream = Stream(seed);
        let mut known = known(dim, n, &mut stream);
        let mut sampler = Novel::new(candidates, None).unwrap();
        known.compare(&mut sampler, &mut stream, |effects, space, draws| {
            let mut best = space.sample(draws);
            for _ in 1..candidates {
                let goal = space.sample(draws);
                if far(effects, &goal) > far(effects, &best) {
                    best = goal;
                }
            }
            best
        })?;
    }

    #[test]
    fn frontier_goals_are_uncovered_unless_all_tries_failed(
        dim in 1..=5_usize, n in 1..40_usize, seed: u64, reach in 1.0..5.0,
    ) {
        let (tries, tau) = (6, 0.3);
        let mut stream = Stream(seed);
        let Known { space, effects, mut history } = known(dim, n, &mut stream);
        let mut sampler = Frontier::new(tau, reach, tries, None).unwrap();
        let mut goal = Vec::new();
        for _ in 0..5 {
            let mut draws = 0;
            let mut count = || { draws += 1; stream.unit() };
            sampler.sample(&mut history, &mut count, &mut goal).unwrap();
            prop_assert!(space.check("goal", &goal).is_ok());
            prop_assert!(draws % (dim + 2) == 0 && draws <= tries * (dim + 2));
            if draws < tries * (dim + 2) {
                prop_assert!(far(&effects, &goal) > tau);
            }
        }
    }

    #[test]
    fn a_round_of_a_grid_has_a_goal_in_each_cell(
        counts in proptest::collection::vec(1..5_usize, 1..4), rounds in 1..4_usize, seed: u64,
    ) {
        let mut stream = Stream(seed);
        let dim = counts.len();
        let space = Bounds::new(vec![-1.0; dim], vec![1.0; dim]).unwrap();
        let mut history = past(&line(), None, dim, &[], &[]);
        let mut sampler = Grid::new(Shape::Each(counts.clone()), Some(space.clone())).unwrap();
        let (total, mut goal) = (counts.iter().product(), Vec::new());
        for _ in 0..rounds {
            let mut seen = vec![false; total];
            for _ in 0..total {
                let before = stream.0;
                sampler.sample(&mut history, &mut || stream.unit(), &mut goal).unwrap();
                let mut plain = Stream(before);
                (0..=dim).for_each(|_| { plain.unit(); });
                prop_assert_eq!(plain.0, stream.0);
                let cell = goal.iter().zip(&counts).rev().fold(0, |cell, (x, &count)| {
                    cell * count + ((x + 1.0) / 2.0 * count as f64) as usize
                });
                prop_assert!(!seen[cell]);
                seen[cell] = true;
            }
        }
    }
}

/// All samplers that need a box, in one of their own or not.
fn every(goals_box: Option<&Bounds>) -> Vec<Box<dyn GoalSampler>> {
    let goals = || goals_box.cloned();
    vec![
        Box::new(Uniform::new(goals()).unwrap()),
        Box::new(Grid::new(Shape::Alike(3), goals()).unwrap()),
        Box::new(Uncovered::new(0.1, 3, goals()).unwrap()),
        Box::new(Frontier::new(0.1, 2.0, 3, goals()).unwrap()),
        Box::new(Novel::new(3, goals()).unwrap()),
    ]
}

#[test]
fn what_does_not_fit_is_refused_and_nothing_drawn() {
    let mut none = || panic!("nothing may be drawn");
    let plane = Bounds::new(vec![0.0; 2], vec![1.0; 2]).unwrap();
    let length = Err(Error::Length { name: "goals", must_be: 2, got: 1 });
    let missing = Err(Error::Empty { name: "goals" });
    let mut observed = past(&line(), None, 2, &[0.5], &[0.5, 0.5]);
    for mut sampler in every(None) {
        assert_eq!(sampler.sample(&mut observed, &mut none, &mut Vec::new()), missing);
        assert_eq!(sampler.check(Some(2), None), missing);
        assert_eq!(sampler.check(None, None), missing);
        assert_eq!(sampler.check(Some(2), Some(&line())), length);
        assert_eq!(sampler.check(Some(2), Some(&plane)), Ok(()));
    }
    for sampler in every(Some(&line())) {
        assert_eq!(sampler.check(Some(2), Some(&plane)), length);
        assert_eq!(sampler.check(Some(1), Some(&plane)), Ok(()));
        assert_eq!(sampler.check(None, None), Ok(()));
    }
    for mut sampler in every(Some(&line())).into_iter().skip(2) {
        assert_eq!(sampler.sample(&mut observed, &mut none, &mut Vec::new()), length);
    }
}

#[test]
fn with_nothing_observed_goals_are_uniform() {
    let mut empty = past(&line(), Some(&line()), 1, &[], &[]);
    for mut sampler in every(None).into_iter().filter(|each| !format!("{each:?}").contains("Grid"))
    {
        let (mut stream, mut goal) = (Stream(1), Vec::new());
        sampler.sample(&mut empty, &mut || stream.unit(), &mut goal).unwrap();
        assert_eq!(goal, line().sample(&mut || Stream(1).unit()));
    }
}

#[test]
fn settings_are_checked() {
    let positive = |got| Error::Number { name: "tau", must_be: "positive and finite", got };
    for bad in [0.0, -1.0, f64::INFINITY] {
        assert_eq!(Uncovered::new(bad, 3, None).unwrap_err(), positive(bad));
        assert_eq!(Frontier::new(bad, 2.0, 3, None).unwrap_err(), positive(bad));
        assert_eq!(Untried::new(bad, 1, 1, 1.0, None).unwrap_err(), positive(bad));
    }
    for bad in [0.9, f64::NAN, f64::INFINITY] {
        let expected = format!("reach must be at least 1, finite, got {bad:?}");
        assert_eq!(Frontier::new(0.1, bad, 3, None).unwrap_err().to_string(), expected);
        assert_eq!(Untried::new(0.1, 1, 1, bad, None).unwrap_err().to_string(), expected);
    }
    let none = |name| Error::Count { name, must_be: "at least 1".into(), got: 0 };
    assert_eq!(Uncovered::new(0.1, 0, None).unwrap_err(), none("tries"));
    assert_eq!(Frontier::new(0.1, 2.0, 0, None).unwrap_err(), none("tries"));
    assert_eq!(Novel::new(0, None).unwrap_err(), none("candidates"));
    assert_eq!(Untried::new(0.1, 0, 1, 1.0, None).unwrap_err(), none("candidates"));
    assert_eq!(Untried::new(0.1, 1, 0, 1.0, None).unwrap_err(), none("tries"));
    assert_eq!(Grid::new(Shape::Alike(0), None).unwrap_err(), none("cells"));
    assert_eq!(Grid::new(Shape::Each(vec![2, 0]), None).unwrap_err(), none("cells"));
    assert_eq!(Grid::new(Shape::Each(vec![]), None).unwrap_err(), Error::Empty { name: "cells" });
    let two = Grid::new(Shape::Each(vec![2, 2]), Some(line())).unwrap_err();
    assert_eq!(two, Error::Length { name: "cells", must_be: 1, got: 2 });
    let many = Grid::new(Shape::Alike(10_000_001), Some(line())).unwrap_err();
    assert_eq!(many.to_string(), "cells must be at most 10000000 altogether, got 10000001");
}

/// Where cells of the raster border on each other, or on tau, a point is covered if the search
/// says so.
#[test]
fn borders_of_cells_and_balls_are_no_exception() {
    let mut stream = Stream(5);
    for (tau, width) in [(0.25, 1.0), (0.1, 3.0), (0.02, 1.0 / 3.0), (1.0, 1e-3), (1e-3, 1e9)] {
        let space = Bounds::new(vec![-width; 2], vec![width; 2]).unwrap();
        let at = |stream: &mut Stream| -> f64 {
            let whole = (stream.between(-width, width) / (tau / 4.0)).round() * (tau / 4.0);
            whole.clamp(-width, width)
        };
        let effects: Vec<Vec<f64>> =
            (0..200).map(|_| vec![at(&mut stream), at(&mut stream)]).collect();
        let mut history = past(&line(), Some(&space), 2, &[0.5; 200], &effects.concat());
        let mut sampler = Uncovered::new(tau, 2, None).unwrap();
        for _ in 0..500 {
            // The first goal lies on a lattice of cells; the second is the middle of the box.
            let mut draws: Vec<f64> =
                (0..2).map(|_| (at(&mut stream) + width) / (2.0 * width)).collect();
            draws.iter_mut().for_each(|u| *u = u.min(1.0_f64.next_down()));
            draws.extend([0.5; 2]);
            let (mut again, mut rest) = (draws.clone().into_iter(), draws.into_iter());
            let first = space.sample(&mut || again.next().unwrap());
            let mut goal = Vec::new();
            sampler.sample(&mut history, &mut || rest.next().unwrap(), &mut goal).unwrap();
            assert_eq!(rest.next().is_some(), far(&effects, &first) > tau, "{first:?}");
        }
    }
}
