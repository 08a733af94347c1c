//! The laws in space: those of any dimension, and the volume by slices.

use super::sequence::{Sequence, decode};
use super::{Passed, Tolerance, check, near};
use crate::oracles::space::union_volume;

/// Gains below 1e-13 of a ball count as none, which order decides; the rest is rounding. Over 700
/// sequences that a fuzzer kept the worst were 2e-14, 4e-16 and 7e-17.
const TOLERANCE: Tolerance =
    Tolerance { order: 1.1e-13, contribution: 1.1e-13, submodular: 1.1e-13, same: 0.0 };

/// How far slices may be off, in balls: 8e-11 was seen where two balls all but touch, and there
/// the lens's closed form agrees with the kernel to 1e-15.
const SLICES: f64 = 1e-9;

/// The most effects whose volume is also found by slices, and how far from the origin.
const FEW: usize = 4;
const MODERATE: f64 = 100.0;

/// Decodes a sequence of effects in space and checks all laws.
pub fn check_bytes(bytes: &[u8]) {
    check_sequence(&decode(bytes));
}

pub fn check_sequence(sequence: &Sequence<3>) {
    let Passed { tau, effects, coverage } = check(sequence, TOLERANCE);
    let far = effects.as_flattened().iter().fold(0.0, |far: f64, x| far.max((x / tau).abs()));
    let n = effects.len();
    if n <= FEW && far <= MODERATE {
        let expected = union_volume(&effects, tau);
        near("the volume by slices", expected, coverage.measure(), coverage.ball(), n, SLICES);
    }
}
