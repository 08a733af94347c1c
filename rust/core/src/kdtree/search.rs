//! Searching the tree: the nearest point, the k nearest, or all within a radius.

use std::cmp::Ordering;

use smallvec::SmallVec;

use super::{Kind, NearestNeighbors, Node};
use crate::error::{Error, check_finite, check_length};

/// A point found: its squared distance, which is neither -0.0 nor NaN, and its index.
type Found = (f64, u32);

/// What any point is nearer than.
const NOTHING: Found = (f64::INFINITY, u32::MAX);

/// The order of what was found: the nearer, then the earlier first.
pub(crate) fn nearer(a: &(f64, usize), b: &(f64, usize)) -> Ordering {
    a.0.total_cmp(&b.0).then(a.1.cmp(&b.1))
}

impl NearestNeighbors {
    /// The distance to, and the index of, the point nearest to `query`; the earliest of
    /// several at the same distance.
    ///
    /// # Errors
    /// If there are no points, or `query` is not `dim` finite numbers.
    pub fn nearest(&self, query: &[f64]) -> Result<(f64, usize), Error> {
        let (squared, index) = self.nearest_squared(query)?;
        Ok((squared.sqrt(), index))
    }

    /// What [`nearest`](Self::nearest) finds, with the square of the distance.
    pub(crate) fn nearest_squared(&self, query: &[f64]) -> Result<(f64, usize), Error> {
        self.nearest_or_within(query, f64::NEG_INFINITY)
    }

    /// The squared distance and the index of the nearest point - or of any whose squared distance is
    /// at most `enough`, where there is one: the search then ends there.
    pub(crate) fn nearest_or_within(
        &self,
        query: &[f64],
        enough: f64,
    ) -> Result<(f64, usize), Error> {
        self.check_query(query)?;
        let mut best = NOTHING;
        self.search(query, best, |found| {
            best = found;
            if found.0 <= enough { (f64::NEG_INFINITY, 0) } else { found }
        });
        Ok((best.0, best.1 as usize))
    }

    /// The `k` nearest points, nearest first and, at the same distance, earliest first.
    ///
    /// # Errors
    /// If `k` is 0 or more than there are points, or `query` is not `dim` finite numbers.
    pub fn nearest_k(&self, query: &[f64], k: usize) -> Result<Vec<(f64, usize)>, Error> {
        let mut found = Vec::new();
        self.nearest_k_into(query, k, &mut found)?;
        Ok(found)
    }

    /// Writes what [`nearest_k`](Self::nearest_k) returns over what `found` held.
    ///
    /// # Errors
    /// As [`nearest_k`](Self::nearest_k).
    pub fn nearest_k_into(
        &self,
        query: &[f64],
        k: usize,
        found: &mut Vec<(f64, usize)>,
    ) -> Result<(), Error> {
        self.nearest_k_squared(query, k, found)?;
        found.sort_unstable_by(nearer);
        for (distance, _) in found {
            *distance = distance.sqrt();
        }
        Ok(())
    }

    /// Writes the squared distances and the indices of the `k` nearest points, in no order.
    pub(crate) fn nearest_k_squared(
        &self,
        query: &[f64],
        k: usize,
        found: &mut Vec<(f64, usize)>,
    ) -> Result<(), Error> {
        self.check_query(query)?;
        if k == 0 || k > self.len() {
            return Err(Error::Count {
                name: "k",
                must_be: format!("from 1 to the number of points, {}", self.len()),
                got: k,
            });
        }
        // The nearest so far, in no order, and some more: now and then the farthest of them are
        // thrown away. For 51 of 10,000 that takes 3.3 us, a heap took 4.0 (bench `towards`).
        let room = k.saturating_add(k / 2).saturating_add(8).min(self.len());
        found.clear();
        found.reserve(room);
        let mut bound = NOTHING;
        self.search(query, bound, |(squared, index)| {
            found.push((squared, index as usize));
            if found.len() == room && room > k {
                let (_, farthest, _) = found.select_nth_unstable_by(k - 1, nearer);
                bound = (farthest.0, farthest.1 as u32);
                found.truncate(k);
            }
            bound
        });
        if found.len() > k {
            found.select_nth_unstable_by(k - 1, nearer);
            found.truncate(k);
        }
        Ok(())
    }

    /// The points no farther than `radius` away, in no particular order.
    ///
    /// # Errors
    /// If there are no points, or `query` is not `dim` finite numbers.
    pub fn within(&self, query: &[f64], radius: f64) -> Result<Vec<usize>, Error> {
        self.check_query(query)?;
        let bound = (radius * radius, u32::MAX);
        let mut found = Vec::new();
        self.search(query, bound, |(_, index)| {
            found.push(index as usize);
            bound
        });
        Ok(found)
    }

    fn check_query(&self, query: &[f64]) -> Result<(), Error> {
        check_length("query", query, self.dim)?;
        check_finite("query", query, self.dim)?;
        if self.is_empty() { Err(Error::Empty { name: "the set of points" }) } else { Ok(()) }
    }

    /// Offers to `accept` every point below the current bound, in a good order; `accept`
    /// answers with the new bound.
    fn search(&self, query: &[f64], bound: Found, accept: impl FnMut(Found) -> Found) {
        // With the dimension known to the compiler its loops unroll: among 10,000 points a query
        // takes 114 ns in the plane instead of 253, 206 ns in space instead of 436 (bench `kdtree`).
        match self.dim {
            1 => self.search_in::<1>(query, bound, accept),
            2 => self.search_in::<2>(query, bound, accept),
            3 => self.search_in::<3>(query, bound, accept),
            _ => self.search_in::<0>(query, bound, accept),
        }
    }

    /// The search for dimension `DIM`, or for `self.dim` if `DIM` is 0.
    #[inline(always)]
    fn search_in<const DIM: usize>(
        &self,
        query: &[f64],
        mut bound: Found,
        mut accept: impl FnMut(Found) -> Found,
    ) {
        let dim = if DIM == 0 { self.dim } else { DIM };
        let query = &query[..dim];
        // Nodes still to visit, each with the bound that its box gives: at most one a level.
        let mut waiting = SmallVec::<[(&Node, Found); 32]>::new();
        let mut next = self.root.as_ref().map(|root| (root, root.bound(query, dim)));
        while let Some((node, lower)) = next {
            if lower < bound {
                match &node.kind {
                    Kind::Leaf { points, indices } => {
                        for (point, &index) in points.chunks_exact(dim).zip(indices) {
                            let found = (squared_distance(query, point), index);
                            if found < bound {
                                bound = accept(found);
                            }
                        }
                    }
                    Kind::Split { halves, .. } => {
                        let [a, b] = halves.each_ref().map(|half| (half, half.bound(query, dim)));
                        let (near, far) = if b.1 < a.1 { (b, a) } else { (a, b) };
                        if far.1 < bound {
                            waiting.push(far);
                        }
                        next = Some(near);
                        continue;
                    }
                }
            }
            next = waiting.pop();
        }
    }
}

impl Node {
    /// A bound from below on all that its points could be found as.
    #[inline(always)]
    fn bound(&self, query: &[f64], dim: usize) -> Found {
        let (low, high) = self.bounds[..2 * dim].split_at(dim);
        let mut squared = 0.0;
        for j in 0..dim {
            // Same operations in the same order as squared_distance().
            let outside = larger(larger(low[j] - query[j], query[j] - high[j]), 0.0);
            squared += outside * outside;
        }
        (squared, self.earliest)
    }
}

/// The larger number: a single instruction, as `f64::max`, which looks for NaN, is not.
#[inline(always)]
pub(super) fn larger(a: f64, b: f64) -> f64 {
    if a > b { a } else { b }
}

#[inline(always)]
fn squared_distance(query: &[f64], point: &[f64]) -> f64 {
    let mut squared = 0.0;
    for (x, y) in query.iter().zip(point) {
        let along = x - y;
        squared += along * along;
    }
    squared
}
