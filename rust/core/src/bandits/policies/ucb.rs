//! UCB: the part whose mean reward could be the best, given how little is known of it.

use super::ties::{best, one_of};
use super::{Choice, Estimates, Policy};
use crate::bounds::UniformStream;
use crate::elementary;
use crate::strategies::total_of;

/// The part j with the largest m_j + B sqrt(xi ln(n) / n_j).
///
/// m_j is the mean reward that is remembered of it and n_j of how many rewards that is, n the sum
/// of all n_j, B the largest reward. With the whole past and xi = 2 it is UCB1 (Auer, Cesa-Bianchi
/// and Fischer 2002, "Finite-time Analysis of the Multiarmed Bandit Problem"); with the window of
/// recent rewards SW-UCB, with discounted ones and 4 xi D-UCB (Garivier and Moulines 2008, "On
/// Upper-Confidence Bound Policies for Non-Stationary Bandit Problems").
///
/// A part that was asked and has not been told of yet counts as if it had earned its mean once
/// more. Parts that were never tried come first; of several best ones each is as likely. One draw
/// a choice, always.
#[derive(Debug)]
pub(super) struct Ucb {
    xi: f64,
    /// How often each part was asked without being told of.
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
