//! What must hold of the coverage of any sequence of effects: checked by the fuzzers in `fuzz/`
//! and, on the committed seeds, by `fuzz_seeds.rs`.
//!
//! A law that fails panics, and says by how much.

#![allow(dead_code, reason = "each user takes the part that it needs")]

pub mod plane;
pub mod sequence;
pub mod space;

use divbandit_core::Coverage;
use divbandit_core::coverage::Sampling;
use sequence::{Sequence, Step};

/// How far results may be apart that are equal but for rounding, in balls, for each effect.
#[derive(Debug, Clone, Copy)]
pub struct Tolerance {
    pub order: f64,
    pub contribution: f64,
    pub submodular: f64,
    /// Effects nearer to each other than so many radii are one but for rounding: repeated among
    /// them, an effect may gain `NOISE` discs.
    pub same: f64,
}

/// What was measured is 2e-15.
const NOISE: f64 = 1e-14;

/// The effects, gains and total of a sequence after it has passed all laws that need no other
/// way to the measure.
#[derive(Debug)]
pub struct Passed<const D: usize> {
    pub tau: f64,
    pub effects: Vec<[f64; D]>,
    pub coverage: Coverage,
}

/// `a` and `b`, measures of `n` effects, are within `tolerance` balls for each of them.
pub fn near(what: &str, a: f64, b: f64, ball: f64, n: usize, tolerance: f64) {
    let off = (a - b).abs() / ball;
    assert!(
        off <= tolerance * n.max(1) as f64,
        "{what}: {a:e} and {b:e} are {off:e} balls apart, with {n} effects"
    );
}

pub fn check<const D: usize>(sequence: &Sequence<D>, tolerance: Tolerance) -> Passed<D> {
    let tau = sequence.tau;
    let (effects, mut coverage) = grow(sequence);
    let n = effects.len();
    let ball = coverage.ball();
    let measure = coverage.measure();

    let sum: f64 = coverage.gains().iter().sum();
    assert!((sum - measure).abs() <= 1e-13 * measure, "{measure:e} is not the gains' sum {sum:e}");
    assert!(n == 0 || measure >= ball, "{measure:e} is less than a ball");
    assert!(measure <= n as f64 * ball * (1.0 + 1e-15), "{measure:e} is more than {n} balls");

    assert_eq!(total(tau, &effects).to_bits(), measure.to_bits(), "all at once");
    again(&coverage, &effects, tolerance.same);
    restore(&coverage);
    orders(sequence, &effects, measure, ball, tolerance);
    contributions(sequence, &mut coverage, &effects, tolerance);
    submodular(sequence, &effects, ball, tolerance);
    Passed { tau, effects, coverage }
}

/// Adds what is to be added: each gain is announced, no more than a ball, and gained once.
fn grow<const D: usize>(sequence: &Sequence<D>) -> (Vec<[f64; D]>, Coverage) {
    let mut coverage = Coverage::new(sequence.tau, D).unwrap();
    let ball = coverage.ball();
    assert!(ball.is_normal());
    let mut effects = Vec::new();
    for step in &sequence.steps {
        let before = coverage.measure();
        match *step {
            Step::Peek(point) => {
                let gain = coverage.gain(point).unwrap();
                assert!((0.0..=ball).contains(&gain), "a peek at {point:?} of {gain:e}");
                assert_eq!(
                    coverage.measure().to_bits(),
                    before.to_bits(),
                    "a peek changes nothing"
                );
            }
            Step::Add(effect) => {
                let announced = coverage.gain(effect).unwrap();
                let gain = coverage.add(effect).unwrap();
                assert_eq!(announced.to_bits(), gain.to_bits(), "{announced:e} {gain:e}");
                assert!((0.0..=ball).contains(&gain), "{effect:?} gains {gain:e}");
                assert!(coverage.measure() >= before, "{effect:?} shrinks {before:e}");
                let more = coverage.gain(effect).unwrap();
                assert!(more == 0.0, "{effect:?} once more gains {more:e}");
                assert!(coverage.contains(effect).unwrap(), "{effect:?} lies in its own ball");
                effects.push(effect);
            }
        }
    }
    assert_eq!(coverage.len(), effects.len());
    assert!(coverage.measure().is_finite());
    (effects, coverage)
}

/// The measure of effects added in one call.
pub fn total<const D: usize>(tau: f64, effects: &[[f64; D]]) -> f64 {
    let mut coverage = Coverage::new(tau, D).unwrap();
    coverage.extend(effects.as_flattened(), &mut vec![f64::NAN; effects.len()]).unwrap();
    coverage.measure()
}

/// All effects once more gain exactly nothing.
fn again<const D: usize>(coverage: &Coverage, effects: &[[f64; D]], same: f64) {
    let mut coverage = coverage.clone();
    let (measure, boundary) = (coverage.measure(), coverage.boundary_integral());
    let crowded: Vec<bool> = effects
        .iter()
        .map(|a| {
            let apart = |b: &[f64; D]| {
                let away = a.iter().zip(b).map(|(a, b)| (a - b).abs());
                away.fold(0.0, f64::max) / coverage.tau()
            };
            effects.iter().map(apart).any(|apart| 0.0 < apart && apart < same)
        })
        .collect();
    for (&effect, &crowded) in effects.iter().zip(&crowded) {
        let gain = coverage.add(effect).unwrap();
        let most = if crowded { NOISE * coverage.ball() } else { 0.0 };
        assert!(gain <= most, "{effect:?} again gains {gain:e}");
        assert!(coverage.contains(effect).unwrap());
    }
    if crowded.contains(&true) {
        return;
    }
    assert_eq!(coverage.measure().to_bits(), measure.to_bits());
    let bits = |boundary: Option<f64>| boundary.map(f64::to_bits);
    assert_eq!(bits(coverage.boundary_integral()), bits(boundary), "a repeated disc changes it");
}

/// The log gives the same union again.
fn restore(coverage: &Coverage) {
    let (effects, gains) = (coverage.effects(), coverage.gains());
    let (tau, dim) = (coverage.tau(), coverage.dim());
    let again = Coverage::restored(tau, dim, Sampling::default(), effects, gains, &[]).unwrap();
    assert_eq!(again.measure().to_bits(), coverage.measure().to_bits());
    let bits = |coverage: &Coverage| coverage.boundary_integral().map(f64::to_bits);
    assert_eq!(bits(&again), bits(coverage));
}

/// Any order has the same total, and so have the mirror images of the effects.
fn orders<const D: usize>(
    sequence: &Sequence<D>,
    effects: &[[f64; D]],
    measure: f64,
    ball: f64,
    tolerance: Tolerance,
) {
    let check = |what: &str, effects: &[[f64; D]]| {
        let found = total(sequence.tau, effects);
        near(what, found, measure, ball, effects.len(), tolerance.order);
    };
    let mut ordered = effects.to_vec();
    ordered.reverse();
    check("backwards", &ordered);
    let mut state = sequence.key;
    for i in (1..ordered.len()).rev() {
        ordered.swap(i, below(&mut state, i + 1));
    }
    for effect in &mut ordered {
        effect[0] = -effect[0];
    }
    check("shuffled and reflected", &ordered);
    ordered.sort_by(|a, b| a[0].total_cmp(&b[0]));
    for effect in &mut ordered {
        effect.rotate_left(1);
    }
    check("sorted and with axes exchanged", &ordered);
}

/// What an effect contributes is what is lost without it.
fn contributions<const D: usize>(
    sequence: &Sequence<D>,
    coverage: &mut Coverage,
    effects: &[[f64; D]],
    tolerance: Tolerance,
) {
    let (n, ball, measure) = (effects.len(), coverage.ball(), coverage.measure());
    let mut state = !sequence.key;
    for index in (0..n.min(2)).map(|_| below(&mut state, n)).collect::<Vec<_>>() {
        let mut others = effects.to_vec();
        others.remove(index);
        let found = coverage.contribution(index).unwrap().gain;
        assert!((0.0..=ball).contains(&found), "{index} contributes {found:e}");
        let lost = measure - total(sequence.tau, &others);
        near("a contribution", found, lost, ball, n, tolerance.contribution);
        let gained = coverage.gains()[index] + tolerance.submodular * ball * n as f64;
        assert!(found <= gained, "{index} contributes {found:e}, more than {gained:e}");
    }
    assert!(n == 0 || coverage.contribution(n).is_err());
}

/// The gain of a point falls as others arrive.
fn submodular<const D: usize>(
    sequence: &Sequence<D>,
    effects: &[[f64; D]],
    ball: f64,
    tolerance: Tolerance,
) {
    let peeks = sequence.steps.iter().filter_map(|step| match step {
        Step::Peek(point) => Some(*point),
        Step::Add(_) => None,
    });
    let middle = effects.get(effects.len() / 2).copied();
    for probe in peeks.take(1).chain(middle) {
        let mut coverage = Coverage::new(sequence.tau, D).unwrap();
        let mut last = ball;
        for effect in effects {
            coverage.add(effect).unwrap();
            let gain = coverage.gain(probe).unwrap();
            let more = (gain - last) / ball;
            assert!(
                more <= tolerance.submodular * coverage.len() as f64,
                "{probe:?} gains {more:e} balls more with {} effects",
                coverage.len()
            );
            last = last.min(gain);
        }
    }
}

fn below(state: &mut u64, n: usize) -> usize {
    *state = state.wrapping_mul(6_364_136_223_846_793_005).wrapping_add(1_442_695_040_888_963_407);
    ((*state >> 33) as usize) % n
}
