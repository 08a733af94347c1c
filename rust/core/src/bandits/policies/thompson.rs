//! Thompson: each part as often as it is likely to be the best.

use super::{Choice, Estimates, Policy};
use crate::bounds::UniformStream;

/// The part with the largest of numbers drawn from N(m_j, B^2 / (n_j + 1)), one for each.
///
/// Thompson sampling with Gaussian posteriors (Agrawal and Goyal 2013, "Further Optimal Regret
/// Bounds for Thompson Sampling", AISTATS, 99-107), where m_j is the mean reward of part j and n_j
/// of how many rewards; theirs divides the sum of rewards by n_j + 1. B is the largest reward, 1
/// while there is none. Each choice draws once for each part, in order.
#[derive(Debug)]
pub(super) struct Thompson;

impl Policy for Thompson {
    fn choose(&mut self, estimates: &Estimates<'_>, draws: &mut dyn UniformStream) -> Choice {
        let scale = if estimates.largest == 0.0 { 1.0 } else { estimates.largest };
        let (mut part, mut largest) = (0, f64::NEG_INFINITY);
        for (index, (mean, count)) in estimates.means.iter().zip(estimates.counts).enumerate() {
            let sampled = mean + scale / (count + 1.0).sqrt() * draws.normal();
            if sampled > largest {
                (part, largest) = (index, sampled);
            }
        }
        Choice { part, probability: None }
    }
}
