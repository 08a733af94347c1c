//! Rewards as shares of the largest, for policies that need them in [0, 1].

use crate::bandits::estimators::Largest;

/// Turns rewards into numbers in [0, 1].
#[derive(Debug)]
pub(super) struct Shares(Largest);

impl Shares {
    /// Upper bound of the rewards; if there is none, 0, the largest so far.
    pub fn new(largest: f64) -> Self {
        Self(Largest::new(largest))
    }

    /// A reward's share of the largest, 0 if it is negative.
    pub fn of(&mut self, reward: f64) -> f64 {
        self.0.see(reward);
        if reward <= 0.0 { 0.0 } else { (reward / self.0.value()).min(1.0) }
    }
}

/// What Exp3 and Exp3.S make of a share that a part earned, when it had been chosen with this
/// probability: the logarithm of what its weight is multiplied by. Always finite.
pub(super) fn growth(gamma: f64, share: f64, probability: f64, parts: usize) -> f64 {
    gamma * (share / probability).min(f64::MAX) / parts as f64
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn shares_of_a_known_largest() {
        let mut shares = Shares::new(4.0);
        assert_eq!([1.0, 5.0, -1.0].map(|reward| shares.of(reward)), [0.25, 1.0, 0.0]);
    }

    #[test]
    fn shares_of_the_largest_so_far() {
        let mut shares = Shares::new(0.0);
        assert_eq!([0.0, 1.0, 0.5, -4.0, 1.0].map(|r| shares.of(r)), [0.0, 1.0, 0.5, 0.0, 0.25]);
    }

    #[test]
    fn growth_is_finite_where_a_probability_is_tiny() {
        assert_eq!(growth(0.5, 0.75, 0.25, 2), 0.75);
        assert!(growth(1.0, 1.0, 5e-324, 1).is_finite());
    }
}
