//! The largest reward: known beforehand, or found out as rewards come.

/// Upper bound of the rewards; where there is none, the largest absolute reward so far.
#[derive(Debug, Clone, Copy)]
pub(crate) struct Largest {
    value: f64,
    bounded: bool,
}

impl Largest {
    /// Upper bound of the rewards, if that is not 0.
    pub fn new(largest: f64) -> Self {
        Self { value: largest, bounded: largest > 0.0 }
    }

    /// The largest reward, as far as it is known.
    pub fn value(self) -> f64 {
        self.value
    }

    /// Takes note of a reward.
    #[inline]
    pub fn see(&mut self, reward: f64) {
        if !self.bounded {
            self.value = self.value.max(reward.abs());
        }
    }
}
