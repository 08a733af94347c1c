//! Estimators: the mean rewards of a bandit's strategies, over all or recent rewards.
//!
//! ```
//! use divbandit_core::bandits::estimators::EstimatorKind;
//!
//! let mut window = EstimatorKind::Window { size: 3, head_start: 1 }.start(2, 6.0).unwrap();
//! for reward in [0.0, 3.0, 3.0] {
//!     window.add(0, reward);
//! }
//! assert_eq!(window.means(), [2.0, 6.0]);
//! assert_eq!(window.counts(), [3.0, 1.0]);
//! ```

mod discounted;
mod largest;
mod recent_window;
mod window;

use std::fmt;

use super::{check_above_0_to_1, check_start};
use crate::error::Error;
use crate::exact_sum::ExactSum;

use discounted::Discounted;
pub(super) use largest::Largest;
use recent_window::RecentWindow;
use window::Window;

/// Upper limit on the window, all of whose rewards are stored.
const LONGEST: usize = 1_000_000;

/// The mean reward of each part, and its weight.
pub trait Estimator: fmt::Debug + Send + Sync {
    /// The mean reward of each part; 0 where none is remembered.
    fn means(&self) -> &[f64];

    /// The number of rewards behind each mean, or their total weight; 0 for a part that counts as
    /// never tried.
    fn counts(&self) -> &[f64];

    /// Upper bound of the rewards; where there is none, the largest absolute reward so far.
    fn largest(&self) -> f64;

    /// Remembers a finite reward of a part.
    ///
    /// # Panics
    /// If there is no such part.
    fn add(&mut self, part: usize, reward: f64);
}

/// What an estimator keeps of the rewards, besides the means and counts that follow from it.
trait Memory: fmt::Debug + Send + Sync {
    /// Remembers a reward of a part.
    fn add(&mut self, part: usize, reward: f64, means: &mut [f64], counts: &mut [f64]);
}

/// An estimator at work.
#[derive(Debug)]
struct Running<M> {
    means: Vec<f64>,
    counts: Vec<f64>,
    largest: Largest,
    memory: M,
}

impl<M: Memory + 'static> Running<M> {
    /// Begins with `head_start` rewards of each part, in order, all the largest possible.
    fn begin(memory: M, head_start: usize, parts: usize, largest: f64) -> Box<dyn Estimator> {
        let (means, counts) = (vec![0.0; parts], vec![0.0; parts]);
        let mut begun = Self { means, counts, largest: Largest::new(largest), memory };
        for _ in 0..head_start {
            (0..parts).for_each(|part| begun.add(part, largest));
        }
        Box::new(begun)
    }
}

impl<M: Memory> Estimator for Running<M> {
    fn means(&self) -> &[f64] {
        &self.means
    }

    fn counts(&self) -> &[f64] {
        &self.counts
    }

    fn largest(&self) -> f64 {
        self.largest.value()
    }

    fn add(&mut self, part: usize, reward: f64) {
        self.memory.add(part, reward, &mut self.means, &mut self.counts);
        self.largest.see(reward);
    }
}

/// Which estimator, and its parameters.
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum EstimatorKind {
    /// The mean of the last `size` rewards of each part, whenever it earned them (Benureau and
    /// Oudeyer 2015).
    Window {
        /// From 1 to a million.
        size: usize,
        /// How many fictitious rewards, each the largest possible, come first in each window; at
        /// most `size`.
        head_start: usize,
    },
    /// The mean of each part's rewards among the last `size` rewards of all of them, as in SW-UCB
    /// (Garivier and Moulines 2008).
    RecentWindow {
        /// From 1 to a million.
        size: usize,
    },
    /// The mean of each part's rewards, one that is k rewards old weighing gamma^k, as in D-UCB
    /// (Kocsis and Szepesvari 2006).
    Discounted {
        /// In (0, 1].
        gamma: f64,
        /// How many fictitious rewards, each the largest possible, each part begins with; at most
        /// a million.
        head_start: usize,
    },
    /// The mean of all rewards that each part ever earned.
    WholePast,
}

impl EstimatorKind {
    /// Starts the estimator for so many parts; no reward exceeds `largest`, if that is not 0.
    ///
    /// # Errors
    /// If there are no parts, `largest` is negative or not finite, or a parameter is out of range.
    pub fn start(&self, parts: usize, largest: f64) -> Result<Box<dyn Estimator>, Error> {
        check_start(parts, largest)?;
        Ok(match *self {
            Self::Window { size, head_start } => {
                check_size(size)?;
                check_head_start(head_start, size)?;
                Running::begin(Window::new(size, parts), head_start, parts, largest)
            }
            Self::RecentWindow { size } => {
                check_size(size)?;
                Running::begin(RecentWindow::new(Some(size), parts), 0, parts, largest)
            }
            Self::Discounted { gamma, head_start } => {
                check_above_0_to_1("gamma", gamma)?;
                check_head_start(head_start, LONGEST)?;
                Running::begin(Discounted { gamma }, head_start, parts, largest)
            }
            Self::WholePast => Running::begin(RecentWindow::new(None, parts), 0, parts, largest),
        })
    }
}

fn check_size(size: usize) -> Result<(), Error> {
    if (1..=LONGEST).contains(&size) {
        return Ok(());
    }
    Err(Error::Count { name: "size", must_be: format!("from 1 to {LONGEST}"), got: size })
}

fn check_head_start(head_start: usize, most: usize) -> Result<(), Error> {
    if head_start <= most {
        return Ok(());
    }
    Err(Error::Count { name: "head_start", must_be: format!("at most {most}"), got: head_start })
}

/// The mean of `count` rewards of this sum; 0 if there is none.
#[inline]
fn mean_of(sum: &ExactSum, count: f64) -> f64 {
    if count == 0.0 { 0.0 } else { sum.value() / count }
}
