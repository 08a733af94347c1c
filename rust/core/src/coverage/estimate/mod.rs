//! Gains of a growing union of equal balls in many dimensions, each with its standard error.
//!
//! From four dimensions on the boundary of a union has no practical closed form. What a new
//! ball adds is V E, the ball's measure times the mean over uniform directions of the share of
//! the ray from the new centre that no older ball covers. Along a ray that share is exact, so
//! only directions are sampled: randomised quasi-Monte Carlo, 32 independently rotated sets of
//! Sobol's points, doubled until the error is small enough.
//!
//! The sets are drawn once, from the key. Each gain turns the neighbours by a rotation of its
//! own, from the key and the number of effects so far: within a gain the sets stay
//! independent, and errors of different gains do not correlate, so that totals average them
//! out. Turning a few neighbours is also cheaper than turning all directions.
//!
//! All of it happens relative to the new centre, in units of the radius and of a ball.

mod directions;
mod lens;
mod nearby;
mod rays;
mod replicates;
mod rotation;
mod sobol;
mod stream;

use directions::{Directions, LANES, SETS};
use nearby::Nearby;
use rays::Shares;
use rotation::Rotation;
use stream::{Purpose, Stream};

use super::cubes::Cubes;
use crate::instructions::{Dispatch, Instructions};

/// Directions of each set that a gain begins with: 1024 rays in all.
const FEWEST: usize = LANES;

/// From this accuracy on, a gain is sampled with a few of the sets: 256 rays at first, of which
/// independent ones would have an error of 0.03 of a ball at most. A bandit averages many gains.
const COARSE: f64 = 0.05;

/// How many they are; of fewer, an error would not tell much.
const FEW_SETS: usize = 8;

/// Directions of each set that no gain goes beyond: 262,144 rays in all, 33 MB in 32 dimensions.
/// With a quarter of them the largest mean error among ten neighbours was 6.5e-4 of a ball.
const MOST: usize = 4096;

/// Beyond this sum of the single balls' shares the sum is not sampled. Up to 3 it would take a
/// fifth off the variance among ten neighbours in 6 to 12 dimensions, but powers for every ball
/// and no early end of covered rays make such gains take up to twice the time.
const CONTROL: f64 = 1.5;

/// What rounding can do to a share, in units of a ball, for each ball involved.
const ROUNDING: f64 = 1e-14;

/// A gain and how far to trust it.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Estimated {
    /// The measure that an effect adds.
    pub gain: f64,
    /// The gain's standard error; 0 where the gain is exact.
    pub standard_error: f64,
}

/// The union of the balls of radius tau around effects.
#[derive(Debug, Clone)]
pub struct Estimate {
    tau: f64,
    dim: usize,
    accuracy: f64,
    key: u64,
    /// How many effects have been added, stored or not: the counter of random numbers.
    len: u64,
    ball: f64,
    centres: Cubes,
    directions: Directions,
    dispatch: Dispatch,
    // Room for the work on one gain.
    nearby: Nearby,
    rotation: Rotation,
    pieces: Vec<(usize, f64, f64)>,
}

impl Estimate {
    /// The empty union of balls of radius `tau` in `dim` dimensions, 1 to 32. Each gain's
    /// standard error is to be `accuracy` of a ball, in (0, 1); `key` decides all randomness.
    #[must_use]
    pub fn new(tau: f64, dim: usize, accuracy: f64, key: u64) -> Self {
        debug_assert!((1..=sobol::DIMS).contains(&dim));
        Self {
            tau,
            dim,
            accuracy,
            key,
            len: 0,
            ball: lens::ball(tau, dim),
            centres: Cubes::new(dim, tau),
            directions: Directions::new(dim, key),
            dispatch: Dispatch::widest(),
            nearby: Nearby::new(dim),
            rotation: Rotation::default(),
            pieces: Vec::new(),
        }
    }

    /// The same union, measured with these vector instructions in place of the widest that the
    /// CPU has; None where it does not have them. Gains have the same bits with all of them.
    #[must_use]
    pub fn using(self, instructions: Instructions) -> Option<Self> {
        Dispatch::to(instructions).map(|dispatch| Self { dispatch, ..self })
    }

    /// The measure of one ball, which no gain exceeds.
    #[must_use]
    pub fn ball(&self) -> f64 {
        self.ball
    }

    /// What `effect` would add, without adding it.
    pub fn gain(&mut self, effect: &[f64]) -> Estimated {
        self.look_at(effect).unwrap_or(Estimated { gain: 0.0, standard_error: 0.0 })
    }

    /// Adds an effect and returns what it adds: the same numbers as [`gain`](Self::gain) would.
    pub fn insert(&mut self, effect: &[f64]) -> Estimated {
        let found = self.look_at(effect);
        self.len += 1;
        // A gain of 0 may be one that no ray met: only a known effect adds nothing for sure.
        if found.is_some() {
            self.centres.insert(effect);
        }
        found.unwrap_or(Estimated { gain: 0.0, standard_error: 0.0 })
    }

    /// Adds an effect whose gain is known: all later numbers are as after [`insert`](Self::insert).
    pub(crate) fn replay(&mut self, effect: &[f64]) {
        self.len += 1;
        if !self
            .centres
            .around(effect)
            .any(|rows| rows.chunks_exact(self.dim).any(|row| row == effect))
        {
            self.centres.insert(effect);
        }
    }

    /// What an effect adds; None if it is a known one.
    fn look_at(&mut self, effect: &[f64]) -> Option<Estimated> {
        self.nearby.clear();
        for centre in self.centres.around(effect).flat_map(|rows| rows.chunks_exact(self.dim)) {
            if centre == effect {
                return None;
            }
            self.nearby.consider(effect, centre, self.tau);
        }
        let alone = self.nearby.settle();
        let (share, error) = if self.nearby.len() > 0 {
            self.sample(alone)
        } else if alone > 0.0 {
            (1.0 - alone, ROUNDING)
        } else {
            (1.0, 0.0)
        };
        // A ball may be beyond all numbers; nothing of it is nothing.
        let scale = |share: f64| if share == 0.0 { 0.0 } else { share * self.ball };
        Some(Estimated { gain: scale(share.clamp(0.0, 1.0)), standard_error: scale(error) })
    }

    /// The free share by sampling, where balls that meet no other cover `alone`.
    fn sample(&mut self, alone: f64) -> (f64, f64) {
        let mut stream = Stream::new(self.key, Purpose::Effect, self.len);
        self.rotation.draw(self.dim, &mut stream);
        self.nearby.turn(&self.rotation);
        let (all, nearest) = self.nearby.lenses();
        let control = all < CONTROL;
        let mut sums = [Shares::default(); SETS];
        let mut means = sums;
        let sets = if self.accuracy < COARSE { SETS } else { FEW_SETS };
        let (mut done, mut next) = (0, FEWEST);
        loop {
            self.directions.reach(next);
            for (set, sum) in sums[..sets].iter_mut().enumerate() {
                let blocks = self.directions.blocks(set, done, next);
                let (near, pieces) = (&self.nearby, &mut self.pieces);
                let shares = self.dispatch.run(
                    #[inline(always)]
                    || rays::shares(near, blocks, control, pieces),
                );
                sum.free += shares.free;
                sum.covered += shares.covered;
            }
            done = next;
            let rays = (2 * done) as f64;
            for (mean, sum) in means.iter_mut().zip(&sums) {
                *mean = Shares { free: sum.free / rays, covered: sum.covered / rays };
            }
            let (share, error) = replicates::combine(&means[..sets], control.then_some(all));
            // What no ray has met may be there: three errors of half that make e^-4.5. But the
            // union is never less than its nearest ball, nor more than all balls' sum.
            let unseen = (1.5 / (rays * sets as f64)).min(all.min(1.0) - nearest);
            let error = error.max(unseen) + ROUNDING;
            if error <= self.accuracy || done >= MOST {
                return (share - alone, error);
            }
            next = 2 * done;
        }
    }
}
