//! The exact length of a growing union of equal intervals on a line.
//!
//! A new interval is cut short only by the nearest centre on either side. Centres are kept in
//! order, but for those whose interval lay in the union when it came.

use std::collections::BTreeSet;

/// A finite number in the order of its value.
#[derive(Debug, Clone, Copy, PartialEq)]
struct Centre(f64);

impl Eq for Centre {}

impl PartialOrd for Centre {
    fn partial_cmp(&self, other: &Self) -> Option<std::cmp::Ordering> {
        Some(self.cmp(other))
    }
}

impl Ord for Centre {
    fn cmp(&self, other: &Self) -> std::cmp::Ordering {
        self.0.total_cmp(&other.0)
    }
}

/// The union of the intervals of half-length tau around effects on a line.
#[derive(Debug, Clone)]
pub(crate) struct Intervals {
    tau: f64,
    centres: BTreeSet<Centre>,
}

impl Intervals {
    pub fn new(tau: f64) -> Self {
        Self { tau, centres: BTreeSet::new() }
    }

    /// The length that an interval around `effect` would add.
    pub fn gain(&self, effect: f64) -> f64 {
        let centre = Centre(effect + 0.0); // zeros are equal, but not in order
        let before = self.centres.range(..=centre).next_back();
        let after = self.centres.range(centre..).next();
        // How far the free part reaches on either side; negative where it begins on the other.
        let free = |distance: f64| self.tau.min(distance - self.tau);
        let left = before.map_or(self.tau, |before| free(effect - before.0));
        let right = after.map_or(self.tau, |after| free(after.0 - effect));
        (left + right).max(0.0)
    }

    /// Adds an interval; returns the length that it adds.
    pub fn insert(&mut self, effect: f64) -> f64 {
        let gain = self.gain(effect);
        if gain > 0.0 {
            self.centres.insert(Centre(effect + 0.0));
        }
        gain
    }
}
