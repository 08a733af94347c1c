//! UCB: the part with the largest upper confidence bound on its mean reward.

use super::ties::{best, one_of};
use super::{Choice, Estimates, Policy};
use crate::bounds::UniformStream;
use crate::elementary;
use crate::strategies::total_of;

/// The part j with the largest m_j + B sqrt(xi ln(n) / n_j).
///
/// m_j is its mean reward by the estimator, n_j the number of rewards behind that, n the sum of all
/// n_j, B the largest reward. With the whole past and xi = 2 it is UCB1 (Auer, Cesa-Bianchi and
/// Fischer 2002, "Finite-time Analysis of the Multiarmed Bandit Problem"); with the window of
/// recent rewards SW-UCB, with discounted ones and 4 xi D-UCB (Garivier and Moulines 2008, "On
/// Upper-Confidence Bound Policies for Non-Stationary Bandit Problems").
///
/// A pending trial counts as if it had earned its part's mean. Parts that were never tried come
/// first; ties are broken uniformly. Always one draw a choice.
#[derive(Debug)]
pub(super) struct Ucb {
    xi: f64,
    /// The number of pending trials of each part.
    asked: Vec<usize>,
    counts: Vec<f64>,
    bounds: Vec<f64>,
    ties: Vec<usize>,
}

impl Ucb {
    pub fn new(xi: f64, parts: usize) -> Self {
        let numbers = || Vec::with_capacity(parts);
        let ties = Vec::with_capacity(parts);
        Self { xi, asked: vec![0; parts], counts: numbers(), bounds: numbers(), ties }
    }

    /// The upper confidence bound of each part; infinite for those never tried.
    fn bounds(&mut self, estimates: &Estimates<'_>) -> &[f64] {
        let counts = estimates.counts.iter().zip(&self.asked);
        self.counts.clear();
        self.counts.extend(counts.map(|(count, &asked)| count + asked as f64));
        let known = self.xi * elementary::log(total_of(self.counts.iter().copied()).max(1.0));
        let bound = |(&mean, &count): (&f64, &f64)| {
            if count > 0.0 {
                mean + estimates.largest * (known / count).sqrt()
            } else {
                f64::INFINITY
            }
        };
        self.bounds.clear();
        self.bounds.extend(estimates.means.iter().zip(&self.counts).map(bound));
        &self.bounds
    }
}

impl Policy for Ucb {
    fn choose(&mut self, estimates: &Estimates<'_>, draws: &mut dyn UniformStream) -> Choice {
        self.bounds(estimates);
        best(&self.bounds, &mut self.ties);
        let part = one_of(&self.ties, draws.next());
        self.asked[part] += 1;
        Choice::with(part, 1.0 / self.ties.len() as f64)
    }

    fn learn(&mut self, part: usize, _reward: f64, _probability: Option<f64>) {
        self.asked[part] = self.asked[part].saturating_sub(1);
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Means 2, 4, 1 of 2, 1, 3 rewards of up to 4, and ln 6 = 1.791759469228055.
    const ESTIMATES: Estimates<'_> =
        Estimates { means: &[2.0, 4.0, 1.0], counts: &[2.0, 1.0, 3.0], largest: 4.0 };

    fn assert_near(got: &[f64], expected: &[f64]) {
        assert_eq!(got.len(), expected.len());
        for (got, expected) in got.iter().zip(expected) {
            assert!((got / expected - 1.0).abs() < 1e-14, "{got} is not {expected}");
        }
    }

    #[test]
    fn bounds_of_ucb1() {
        let mut policy = Ucb::new(2.0, 3);
        let known = 2.0 * 1.791759469228055_f64;
        let expected = [
            2.0 + 4.0 * (known / 2.0).sqrt(), // 7.3543
            4.0 + 4.0 * known.sqrt(),         // 11.5721
            1.0 + 4.0 * (known / 3.0).sqrt(), // 5.3718
        ];
        assert_near(policy.bounds(&ESTIMATES), &expected);
        let choice = policy.choose(&ESTIMATES, &mut || 0.99);
        assert_eq!(choice, Choice { part: 1, probability: Some(1.0) });
    }

    #[test]
    fn what_was_asked_counts_until_it_is_told() {
        let mut policy = Ucb::new(2.0, 3);
        policy.choose(&ESTIMATES, &mut || 0.5);
        let known = 2.0 * 1.9459101490553132_f64; // ln 7
        let once = [2.0 + 4.0 * (known / 2.0).sqrt(), 4.0 + 4.0 * (known / 2.0).sqrt()];
        assert_near(&policy.bounds(&ESTIMATES)[..2], &once);
        for _ in 0..2 {
            policy.learn(1, 4.0, None);
        }
        let before = Ucb::new(2.0, 3).bounds(&ESTIMATES).to_vec();
        assert_eq!(policy.bounds(&ESTIMATES), before);
    }

    #[test]
    fn bounds_of_parts_never_tried_are_infinite() {
        let estimates = Estimates { counts: &[1.0, 0.0, 3.0], ..ESTIMATES };
        let mut policy = Ucb::new(0.6, 3);
        let known = 0.6 * 1.3862943611198906_f64; // ln 4
        let bounds = policy.bounds(&estimates);
        assert_eq!(bounds[1], f64::INFINITY);
        assert_near(&bounds[..1], &[2.0 + 4.0 * known.sqrt()]);
    }
}
