//! Laws of the boundary's loops: closed, on the right side, as many as there are parts and
//! holes, around the area that is the measure; and what they must not depend on.

use std::f64::consts::TAU;

use crate::oracles::loops::{
    boundary, check, components, counts, euler_characteristic, overlap, ring,
};
use crate::oracles::{Stream, fixed, scatter};
use proptest::prelude::*;

proptest! {
    #![proptest_config(fixed(1000))]

    #[test]
    fn holds_the_measure_in_as_many_loops_as_there_are_parts(
        n in 1..80_usize, spread in -12.0..1.2_f64, lattice: bool, tau in 0.001..3.0_f64, seed: u64,
    ) {
        let tau = if lattice { 0.25 } else { tau }; // whether discs touch is told exactly
        let effects = scatter(n, 10_f64.powf(spread), lattice, tau, seed);
        let (outers, _) = check("scatter", &effects, tau);
        let unit: Vec<_> = effects.iter().map(|c| c.map(|x| x / tau)).collect();
        prop_assert_eq!(outers, components(&unit, overlap));
    }

    #[test]
    fn has_a_loop_for_every_hole(n in 1..15_usize, spread in -9.0..0.7_f64, seed: u64) {
        let effects = scatter(n, 10_f64.powf(spread), false, 1.0, seed);
        let (outers, holes) = check("scatter", &effects, 1.0);
        prop_assert_eq!(outers as i64 - holes as i64, euler_characteristic(&effects));
    }

    #[test]
    fn has_a_loop_for_every_hole_of_a_ring(n in 6..13_usize, radius in 1.0..2.5_f64, seed: u64) {
        let mut stream = Stream(seed);
        let mut wobble = |x| x + stream.between(-0.2, 0.2);
        let effects: Vec<_> = ring(n, radius).iter().map(|c| c.map(&mut wobble)).collect();
        let (outers, holes) = check("ring", &effects, 1.0);
        prop_assert_eq!(outers, components(&effects, overlap));
        prop_assert_eq!(outers as i64 - holes as i64, euler_characteristic(&effects));
    }
}

/// Sponges: hundreds of discs, about as many as leave the most holes.
#[test]
fn has_a_loop_for_every_hole_of_a_sponge() {
    let (mut stream, mut all) = (Stream(12), 0);
    for case in 0..60 {
        let side = 300.0_f64.sqrt() * stream.between(1.2, 2.2);
        let place = |_| [stream.between(0.0, side), stream.between(0.0, side)];
        let effects: Vec<_> = (0..300).map(place).collect();
        let (outers, holes) = check("sponge", &effects, 1.0);
        assert_eq!(outers, components(&effects, overlap), "case {case}");
        let expected = euler_characteristic(&effects);
        assert_eq!(outers as i64 - holes as i64, expected, "case {case}");
        all += holes;
    }
    assert!(all > 1000, "{all}");
}

/// Two that nearly coincide and nearly touch a third: crossings as ill-conditioned as they get.
#[test]
fn of_discs_that_nearly_coincide_and_nearly_touch() {
    let mut stream = Stream(20);
    let step = |[x, y]: [f64; 2], length: f64, angle: f64| {
        [x + length * angle.cos(), y + length * angle.sin()]
    };
    for case in 0..20_000 {
        let mut tiny = || {
            let size = 10_f64.powf(stream.between(-16.0, -1.0));
            [0.0, size, -size, size][stream.below(4)]
        };
        let (a, b, c, d) = (tiny(), tiny(), tiny(), tiny());
        let angle = [0.0, TAU / 4.0, TAU / 6.0, stream.between(0.0, TAU)][stream.below(4)];
        let first = [[0.0, 0.0], [0.3, -0.7]][stream.below(2)];
        let touching = step(first, 2.0 + a, angle);
        let set = [
            first,
            touching,
            step(first, b, stream.between(0.0, TAU)),
            step(touching, c, [angle, angle + TAU / 4.0][stream.below(2)]),
            step(first, 2.0 + d, angle + TAU / 6.0),
        ];
        check(&format!("case {case}"), &set[..3 + stream.below(3)], 1.0);
    }
}

#[test]
fn is_the_same_far_away() {
    // Multiples of 2^-6 stay exact 2^46 away.
    let round = |x: f64| (x * 64.0).round() / 64.0;
    let set: Vec<_> = scatter(60, 4.0, false, 1.0, 5).iter().map(|c| c.map(round)).collect();
    let (_, near) = boundary(&set, 1.0);
    for far in [2.0_f64.powi(30), 2.0_f64.powi(46)] {
        let moved: Vec<_> = set.iter().map(|[x, y]| [x + far, y - far]).collect();
        let (_, loops) = boundary(&moved, 1.0);
        assert_eq!(counts("far", &loops, 1.0).0, counts("near", &near, 1.0).0);
        assert_eq!(loops.len(), near.len());
        for (a, b) in loops.iter().flatten().zip(near.iter().flatten()) {
            assert_eq!([a.x - far, a.y + far], [b.x, b.y]);
            assert!((a.from - b.from).abs() < 1e-12 && (a.to - b.to).abs() < 1e-12);
        }
    }
}

#[test]
fn does_not_depend_on_the_order() {
    let mut set = scatter(200, 5.0, false, 1.0, 8);
    let (_, loops) = boundary(&set, 1.0);
    assert_eq!(boundary(&set, 1.0).1, loops);
    Stream(1).shuffle(&mut set);
    let (_, shuffled) = boundary(&set, 1.0);
    assert_eq!(loops.len(), shuffled.len());
    for (a, b) in loops.iter().flatten().zip(shuffled.iter().flatten()) {
        assert_eq!([a.x, a.y], [b.x, b.y]);
        assert!((a.from - b.from).abs() < 1e-12 && (a.to - b.to).abs() < 1e-12);
    }
}

#[test]
fn of_whatever_is_finite_is_closed() {
    let values =
        [0.0, -0.0, 5e-324, 1e-300, 1.0, 1.0 + 1e-15, 1e15, 1e16, 1e19, 1e300, -f64::MAX, f64::MAX];
    let set: Vec<_> = values.iter().flat_map(|&x| values.map(|y| [x, y])).collect();
    for tau in [1e-100, 1e-16, 1.0, 1e15, 1e100] {
        let (_, loops) = boundary(&set, tau);
        assert!(loops.iter().all(|arcs| !arcs.is_empty()));
        counts(&format!("tau {tau:e}"), &loops, tau);
    }
}

#[test]
fn of_a_hundred_thousand_arcs_in_one_place_is_one_loop() {
    let (_, loops) = boundary(&ring(100_000, 1e-3), 1.0);
    assert_eq!(loops.iter().map(Vec::len).collect::<Vec<_>>(), [100_000]);
    assert_eq!(check("crowd", &ring(100_000, 1e-6), 1.0), (1, 0));
}
