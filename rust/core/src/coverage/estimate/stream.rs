//! Random numbers that are a function of a key and a counter, and nothing else.
//!
//! SplitMix64 (Steele, Lea and Flood, OOPSLA 2014): an odd multiple of the position, mixed.
//! What is drawn for one counter does not depend on what was drawn before, so that asking
//! for a gain twice, or asking a copy, gives the same bits.

use crate::elementary::normal_quantile;

const STEP: u64 = 0x9E37_79B9_7F4A_7C15;

/// What a stream is for: two purposes never share one.
#[derive(Debug, Clone, Copy)]
pub(super) enum Purpose {
    /// The shift of a set of directions.
    Shift = 1,
    /// The rotation of a set of directions.
    Set = 2,
    /// The rotation of an effect's neighbours.
    Effect = 3,
}

/// An endless sequence of numbers.
#[derive(Debug, Clone)]
pub(super) struct Stream(u64);

impl Stream {
    pub fn new(key: u64, purpose: Purpose, counter: u64) -> Self {
        // Mixed in one after the other: neighbouring keys or counters have nothing in common,
        // and a key cannot stand in for a counter.
        let absorb = |state: u64, x: u64| mix(state.wrapping_add(x).wrapping_add(STEP));
        Self([key, purpose as u64, counter].into_iter().fold(0, absorb))
    }

    pub fn bits(&mut self) -> u64 {
        self.0 = self.0.wrapping_add(STEP);
        mix(self.0)
    }

    /// A standard normal number.
    pub fn normal(&mut self) -> f64 {
        // The middles of 2^52 equal parts of (0, 1): exact numbers, never 0 or 1.
        normal_quantile(((self.bits() >> 12) as f64 + 0.5) / (1_u64 << 52) as f64)
    }
}

fn mix(mut z: u64) -> u64 {
    z = (z ^ (z >> 30)).wrapping_mul(0xBF58_476D_1CE4_E5B9);
    z = (z ^ (z >> 27)).wrapping_mul(0x94D0_49BB_1331_11EB);
    z ^ (z >> 31)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn streams_differ_and_repeat() {
        let first = |key, purpose, counter| Stream::new(key, purpose, counter).bits();
        let mut seen: Vec<u64> = Vec::new();
        for key in 0..20 {
            for counter in 0..20 {
                for purpose in [Purpose::Shift, Purpose::Set, Purpose::Effect] {
                    seen.push(first(key, purpose, counter));
                    assert_eq!(first(key, purpose, counter), first(key, purpose, counter));
                }
            }
        }
        let all = seen.len();
        seen.sort_unstable();
        seen.dedup();
        assert_eq!(seen.len(), all);
    }

    #[test]
    fn normal_numbers_have_the_moments_of_a_normal_distribution() {
        let (n, mut stream) = (200_000, Stream::new(7, Purpose::Set, 3));
        let mut moments = [0.0; 4];
        for _ in 0..n {
            let x = stream.normal();
            let powers = [x, x * x, x * x * x, x * x * x * x];
            for (moment, power) in moments.iter_mut().zip(powers) {
                *moment += power / f64::from(n);
            }
        }
        // Five standard errors: sqrt(1, 2, 15, 96) / sqrt(n).
        for (i, (expected, spread)) in
            [(0.0, 1.0), (1.0, 2.0_f64), (0.0, 15.0), (3.0, 96.0)].into_iter().enumerate()
        {
            let tolerance = 5.0 * spread.sqrt() / f64::from(n).sqrt();
            assert!((moments[i] - expected).abs() < tolerance, "moment {}: {}", i + 1, moments[i]);
        }
    }
}
