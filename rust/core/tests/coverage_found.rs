//! What fuzzing found once: few effects, and the kernel was wrong.

use crate::oracles::{Stream, union_area};
use divbandit_core::Coverage;

fn total<const D: usize>(effects: &[[f64; D]], tau: f64) -> f64 {
    let mut coverage = Coverage::new(tau, D).unwrap();
    coverage.extend(effects.as_flattened(), &mut vec![f64::NAN; effects.len()]).unwrap();
    coverage.measure()
}

#[test]
fn a_circle_through_the_points_where_discs_touch() {
    // The corners touch in pairs in (0, 2) and (2, 2), through which the last circle passes: it
    // leaves one disc and enters another there. Taken for the other way round, it gained a disc.
    let mut effects =
        [[2.0, 3.0], [0.0, 1.0], [0.0, 3.0], [2.0, 1.0], [1.0, 1.0], [1.0, 3.0], [1.0, 2.0]];
    let expected = union_area(&effects, 1.0);
    let mut stream = Stream(7);
    for _ in 0..5000 {
        let measure = total(&effects, 1.0);
        assert!((measure - expected).abs() < 1e-12, "{measure} {expected} {effects:?}");
        stream.shuffle(&mut effects);
    }
}

#[test]
fn lattices_as_wide_as_the_radius_in_any_order() {
    let mut stream = Stream(8);
    for tau in [1.0, 0.1, 0.02] {
        let mut effects: Vec<_> =
            (0..36).map(|i| [f64::from(i % 6) * tau, f64::from(i / 6) * tau]).collect();
        let expected = union_area(&effects, tau);
        for _ in 0..500 {
            stream.shuffle(&mut effects);
            let n = 7 + stream.below(30);
            let [some, all] = [&effects[..n], &effects].map(|effects| total(effects, tau));
            assert!((all / expected - 1.0).abs() < 1e-12, "{all} {expected} {effects:?}");
            let expected = union_area(&effects[..n], tau);
            assert!((some / expected - 1.0).abs() < 1e-12, "{some} {expected} {effects:?}");
        }
    }
}

#[test]
fn a_disc_without_boundary_once_more_gains_nothing() {
    // The second lost its boundary to noise in its neighbours': once more it gained 4e-17.
    let sets: [&[[f64; 2]]; 3] = [
        &[
            [0.500_000_000_000_000_2, 1.625],
            [0.500_000_000_000_000_1, 1.625],
            [0.5, 1.625],
            [0.510_000_000_000_000_1, 1.625],
        ],
        &[
            [2.489_043_790_736_545_7, -0.584_056_926_535_308_7],
            [2.489_043_790_736_545_7, -0.584_056_926_535_308_9],
            [2.489_043_790_736_545_7, -0.584_056_926_535_309_5],
        ],
        &[
            [0.9, 0.425_000_000_000_000_04],
            [0.0, -1e-30],
            [0.0, -0.811_523_437_5],
            [0.0, 0.0],
            [-4.768_371_582_031_25e-7, -4.768_371_582_031_25e-7],
        ],
    ];
    for effects in sets {
        let mut coverage = Coverage::new(1.0, 2).unwrap();
        coverage.extend(effects.as_flattened(), &mut vec![0.0; effects.len()]).unwrap();
        let boundary = coverage.boundary_integral();
        for &effect in effects {
            assert_eq!(coverage.add(effect).unwrap(), 0.0, "{effect:?}");
        }
        assert_eq!(coverage.boundary_integral(), boundary);
    }
}

#[test]
fn balls_beyond_all_cubes_gain_what_they_gain_elsewhere() {
    // There the cubes around are one, and each neighbour in it was counted several times.
    let mut stream = Stream(9);
    for far in [1e150, -1e300] {
        for axis in 0..3 {
            let mut place = || {
                let mut place = [0; 3].map(|_| stream.between(-1.0, 1.0));
                place[axis] = 0.0;
                place
            };
            let here: Vec<_> = (0..20).map(|_| place()).collect();
            let mut there = here.clone();
            there.iter_mut().for_each(|effect| effect[axis] = far);
            assert!((total(&there, 1.0) / total(&here, 1.0) - 1.0).abs() < 1e-13);
        }
    }
}
