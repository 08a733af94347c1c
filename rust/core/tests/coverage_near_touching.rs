//! Discs that nearly coincide and nearly touch a third, where a crossing of two circles is
//! ill-conditioned: half of all digits of the distance are lost in the crossing's place.

use std::f64::consts::{PI, TAU};

use crate::oracles::{Stream, union_area};
use divbandit_core::Coverage;

/// 10^-1 to 10^-16, or nothing; of either sign.
fn tiny(stream: &mut Stream) -> f64 {
    let size = 10_f64.powf(stream.between(-16.0, -1.0));
    [0.0, size, -size, size][stream.below(4)]
}

/// Steps from `from` by `length` towards `angle`.
fn step([x, y]: [f64; 2], length: f64, angle: f64) -> [f64; 2] {
    [x + length * angle.cos(), y + length * angle.sin()]
}

#[test]
fn add_up_to_the_area_of_their_union() {
    let mut stream = Stream(20);
    for case in 0..20_000 {
        let tau = [1.0, 0.02][case % 2];
        let angle = [0.0, TAU / 4.0, TAU / 6.0, stream.between(0.0, TAU)][stream.below(4)];
        let beside = stream.between(0.0, TAU);
        let first = [[0.0, 0.0], [0.3, -0.7]][stream.below(2)];
        let touching = step(first, 2.0 + tiny(&mut stream), angle);
        let mut set = vec![
            first,
            touching,
            step(first, tiny(&mut stream), beside),
            step(touching, tiny(&mut stream), [beside, angle, angle + TAU / 4.0][stream.below(3)]),
            step(first, 2.0 + tiny(&mut stream), angle + TAU / 6.0),
        ];
        set.truncate(3 + stream.below(3));
        stream.shuffle(&mut set);
        let set: Vec<[f64; 2]> = set.iter().map(|c| c.map(|x| x * tau)).collect();

        let mut coverage = Coverage::new(tau, 2).unwrap();
        coverage.extend(set.as_flattened(), &mut vec![0.0; set.len()]).unwrap();
        let error = (coverage.measure() - union_area(&set, tau)).abs() / (PI * tau * tau);
        assert!(error < 1e-10, "case {case}: off by {error:e} discs, tau = {tau}\n{set:?}");
    }
}

#[test]
fn two_that_nearly_coincide_touch_a_third() {
    // The discs of radius 1 overlap by less than 1e-15 or by all but that: the area, computed
    // in sixty digits, is 2.000000000000000079 discs.
    let set = [
        [2.051948985515897, -1.6647148553587314],
        [0.29999999999999993, -0.7000000000000001],
        [0.3, -0.7],
    ];
    let mut coverage = Coverage::new(1.0, 2).unwrap();
    coverage.extend(set.as_flattened(), &mut [0.0; 3]).unwrap();
    let measure = coverage.measure();
    assert!((measure / PI - 2.0).abs() < 1e-14, "{} discs too many", measure / PI - 2.0);
}
