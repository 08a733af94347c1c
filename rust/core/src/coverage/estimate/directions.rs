//! Sets of directions, each uniformly rotated as a whole, kept and extended on demand.
//!
//! Sobol's points, shifted digit by digit, go through the inverse normal distribution onto the
//! sphere. The shift spares every set the first points' regular places; the rotation makes
//! each single direction exactly uniform. Shifts and rotations of different sets are
//! independent. Directions lie side by side, LANES of them coordinate by coordinate, as the
//! rays' loop over lanes wants them.

use crate::elementary::normal_quantile;

use super::rotation::{Rotation, square};
use super::sobol::Sobol;
use super::stream::{Purpose, Stream};

/// How many directions are worked on at once.
pub(super) const LANES: usize = 16;

/// How many sets there are: by Student's distribution 5 in 1000 means of 32 lie beyond three of
/// their standard errors, of 16 it would be 9.
pub(super) const SETS: usize = 32;

#[derive(Debug, Clone)]
struct Set {
    shift: Vec<u32>,
    rotation: Rotation,
    /// Blocks of LANES directions: first coordinates, second coordinates, ...
    blocks: Vec<f64>,
}

/// SETS sets of as many directions each as were asked for so far.
#[derive(Debug, Clone)]
pub(super) struct Directions {
    dim: usize,
    sobol: Sobol,
    sets: Vec<Set>,
    /// Directions of each set.
    len: usize,
}

impl Directions {
    pub fn new(dim: usize, key: u64) -> Self {
        let set = |counter| {
            let mut stream = Stream::new(key, Purpose::Shift, counter);
            let shift = (0..dim).map(|_| (stream.bits() >> 32) as u32).collect();
            let mut rotation = Rotation::default();
            rotation.draw(dim, &mut Stream::new(key, Purpose::Set, counter));
            Set { shift, rotation, blocks: Vec::new() }
        };
        let sets = (0..SETS as u64).map(set).collect();
        Self { dim, sobol: Sobol::new(dim), sets, len: 0 }
    }

    /// The blocks of a set with its directions `from` to `to`, multiples of LANES.
    pub fn blocks(&self, set: usize, from: usize, to: usize) -> &[f64] {
        &self.sets[set].blocks[from * self.dim..to * self.dim]
    }

    /// Makes sure that there are `len` directions in each set.
    pub fn reach(&mut self, len: usize) {
        let (mut point, mut x) = (vec![0; self.dim], vec![0.0; self.dim]);
        while self.len < len {
            let lane = self.len % LANES;
            self.sobol.next_into(&mut point);
            for Set { shift, rotation, blocks } in &mut self.sets {
                if lane == 0 {
                    blocks.resize(blocks.len() + self.dim * LANES, 0.0);
                }
                for ((x, p), s) in x.iter_mut().zip(&point).zip(&*shift) {
                    // The middle of the digital point's interval: never 0, 1/2 or 1.
                    *x = normal_quantile((f64::from(p ^ s) + 0.5) / 4_294_967_296.0);
                }
                let length = square(&x).sqrt();
                x.iter_mut().for_each(|x| *x /= length);
                rotation.turn(&mut x);
                let start = blocks.len() - self.dim * LANES;
                for (k, x) in x.iter().enumerate() {
                    blocks[start + k * LANES + lane] = *x;
                }
            }
            self.len += 1;
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn directions_are_unit_vectors_and_the_same_however_far_one_went_at_once() {
        for dim in [1, 2, 5, 32] {
            let (mut once, mut twice) = (Directions::new(dim, 3), Directions::new(dim, 3));
            once.reach(4 * LANES);
            twice.reach(LANES);
            twice.reach(4 * LANES);
            for set in 0..SETS {
                let blocks = once.blocks(set, 0, 4 * LANES);
                assert_eq!(blocks, twice.blocks(set, 0, 4 * LANES));
                for block in blocks.chunks_exact(dim * LANES) {
                    for lane in 0..LANES {
                        let x: Vec<f64> = (0..dim).map(|k| block[k * LANES + lane]).collect();
                        assert!((square(&x) - 1.0).abs() < 1e-14, "{x:?}");
                    }
                }
            }
        }
    }
}
