//! The Shannon entropy, in nats, of the histogram of effects over a grid's cells.
//!
//! Delarboulas, Schoenauer and Sebag (2010, "Open-Ended Evolutionary Robotics: An Information
//! Theoretic Approach", PPSN XI, 334-343) reward the entropy of the states that a robot visits.
//!
//! With n effects, c of them in a cell, n H = n log n - sum of c log c. What is rounded are the
//! logarithms, to f64, then the sum and its quotient by n; the products and the sum are exact. So
//! the entropy depends on nothing but the counts, and as c log c <= c log n in f64, too, it is
//! never negative, and 0.0 if all effects lie in one cell. Its error is at most that of log n.

use super::Measure;
use super::cells::{Cells, PerCoordinate};
use crate::elementary::log;
use crate::error::Error;
use crate::exact_sum::ExactSum;

/// A histogram of effects.
#[derive(Debug)]
pub(super) struct Entropy {
    cells: Cells,
    /// How many effects lie in each cell.
    counts: Vec<usize>,
    len: usize,
    /// n log n minus the sum of c log c.
    sum: ExactSum,
    measure: f64,
}

impl Entropy {
    pub fn new(cell: &PerCoordinate, origin: &PerCoordinate, dim: usize) -> Result<Self, Error> {
        Ok(Self {
            cells: Cells::new(cell, origin, dim)?,
            counts: Vec::new(),
            len: 0,
            sum: ExactSum::default(),
            measure: 0.0,
        })
    }

    /// Changes the sum by one more effect in a cell of `count`: so far, for a `sign` of 1.0, or
    /// back again, for -1.0.
    fn shift(&mut self, count: usize, sign: f64) {
        for (times, sign) in
            [(self.len + 1, sign), (self.len, -sign), (count + 1, -sign), (count, sign)]
        {
            add_n_log_n(&mut self.sum, times, sign);
        }
    }

    /// The entropy that the sum makes with one more effect.
    fn next(&self) -> f64 {
        self.sum.value() / (self.len + 1) as f64
    }
}

impl Measure for Entropy {
    fn dim(&self) -> usize {
        self.cells.dim()
    }

    fn len(&self) -> usize {
        self.len
    }

    /// The gain of the second effect where it lies in another cell than the first.
    ///
    /// An effect that comes after n others gains at most the entropy of one part in n + 1
    /// against the rest, which is greatest for n = 1.
    fn largest_gain(&self) -> f64 {
        log(2.0)
    }

    fn measure(&self) -> f64 {
        self.measure
    }

    fn check(&self, name: &'static str, effects: &[f64]) -> Result<(), Error> {
        self.cells.check(name, effects)
    }

    fn gain(&mut self, effect: &[f64]) -> f64 {
        let count = self.cells.find(effect).map_or(0, |number| self.counts[number]);
        self.shift(count, 1.0);
        let next = self.next();
        self.shift(count, -1.0);
        next - self.measure
    }

    fn add(&mut self, effect: &[f64]) -> f64 {
        let (number, is_new) = self.cells.occupy(effect);
        if is_new {
            self.counts.push(0);
        }
        self.shift(self.counts[number], 1.0);
        let (before, next) = (self.measure, self.next());
        self.counts[number] += 1;
        self.len += 1;
        self.measure = next;
        next - before
    }
}

/// Adds `sign` times n log n, the product being exact up to n = 2^32.
fn add_n_log_n(sum: &mut ExactSum, n: usize, sign: f64) {
    if n < 2 {
        return;
    }
    let (times, mut rest) = (sign * n as f64, log(n as f64));
    // 53 bits in three parts of at most 21, so that each product has no more than 53.
    for _ in 0..3 {
        let part = f64::from_bits(rest.to_bits() & !0xFFFF_FFFF);
        sum.add(times * part);
        rest -= part;
    }
}
