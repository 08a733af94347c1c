//! The laws in the plane: those of any dimension, the boundary's integral, and the area by slabs.

use divbandit_core::Coverage;

use super::sequence::{Sequence, decode};
use super::{Passed, Tolerance, check, near};
use crate::oracles::union_area;

/// Over 2400 sequences that a fuzzer kept the worst were 1.4e-16, 1.1e-16 and 3e-17.
const TOLERANCE: Tolerance =
    Tolerance { order: 2e-15, contribution: 2e-15, submodular: 2e-15, same: 1e-13 };

/// Up to so many radii from the origin other ways to the area are asked, which work there.
const MODERATE: f64 = 1e4;

/// The most effects whose area is also found by slabs, which takes the cube of their number.
const FEW: usize = 24;

/// Decodes a sequence of effects in the plane and checks all laws.
pub fn check_bytes(bytes: &[u8]) {
    check_sequence(&decode(bytes));
}

pub fn check_sequence(sequence: &Sequence<2>) {
    let Passed { tau, effects, coverage } = check(sequence, TOLERANCE);
    let far = effects.as_flattened().iter().fold(0.0, |far: f64, x| far.max((x / tau).abs()));
    if far > MODERATE {
        return;
    }
    let (n, ball, measure) = (effects.len(), coverage.ball(), coverage.measure());
    let boundary = boundary(&coverage);
    // Both see places rounded as the effects' coordinates, in radii, are.
    let rounding = 2e-15 * (1.0 + far);
    near("the boundary's integral", boundary, measure, ball, n, rounding);
    if n <= FEW {
        near("the area by slabs", union_area(&effects, tau), measure, ball, n, 1e-13 + rounding);
    }
}

fn boundary(coverage: &Coverage) -> f64 {
    coverage.boundary_integral().unwrap()
}
