//! Growing the tree: inserting points, splitting leaves, building lopsided parts anew.

use smallvec::SmallVec;

use super::search::larger;
use super::{Kind, LEAF, Node};

/// A subtree is built anew when one side holds more than this share of it.
const LOPSIDED: f64 = 0.7;

/// All points, row by row.
#[derive(Clone, Copy)]
pub(super) struct Rows<'a> {
    pub numbers: &'a [f64],
    pub dim: usize,
}

impl<'a> Rows<'a> {
    fn get(self, index: u32) -> &'a [f64] {
        &self.numbers[index as usize * self.dim..][..self.dim]
    }
}

impl Node {
    /// Files another point; rebuilds the highest subtree that it makes too unequal.
    pub fn insert(&mut self, index: u32, points: Rows) {
        let point = points.get(index);
        widen(&mut self.bounds, point);
        self.size += 1;
        let largest = LOPSIDED * f64::from(self.size) + LEAF as f64;
        match &mut self.kind {
            Kind::Split { axis, at, halves } => {
                let half = &mut halves[usize::from(point[*axis] >= *at)];
                // Only the half that grows can become too large.
                if f64::from(half.size + 1) <= largest {
                    return half.insert(index, points);
                }
            }
            Kind::Leaf { points: rows, indices } => {
                if indices.len() < LEAF {
                    rows.extend_from_slice(point);
                    indices.push(index);
                    return;
                }
            }
        }
        let mut indices = Vec::with_capacity(self.size as usize);
        self.collect(&mut indices);
        indices.push(index);
        *self = Self::build(&mut indices, points);
    }

    /// Collects its points.
    fn collect(&self, into: &mut Vec<u32>) {
        match &self.kind {
            Kind::Leaf { indices, .. } => into.extend_from_slice(indices),
            Kind::Split { halves, .. } => halves.iter().for_each(|half| half.collect(into)),
        }
    }

    /// A balanced tree over `indices`, of which there is at least one.
    pub fn build(indices: &mut [u32], points: Rows) -> Self {
        let first = points.get(indices[0]);
        let mut bounds: SmallVec<[f64; 6]> = first.iter().chain(first).copied().collect();
        indices[1..].iter().for_each(|&index| widen(&mut bounds, points.get(index)));
        let size = indices.len() as u32;
        let earliest = indices.iter().copied().fold(u32::MAX, u32::min);
        let kind = if indices.len() <= LEAF {
            let mut leaf = (Vec::with_capacity(LEAF * points.dim), Vec::with_capacity(LEAF));
            for &index in &*indices {
                leaf.0.extend_from_slice(points.get(index));
                leaf.1.push(index);
            }
            Kind::Leaf { points: leaf.0, indices: leaf.1 }
        } else {
            let width = |axis: usize| bounds[points.dim + axis] - bounds[axis];
            let wider = |widest, axis| if width(axis) > width(widest) { axis } else { widest };
            let axis = (1..points.dim).fold(0, wider);
            let key = |index: u32| points.get(index)[axis];
            let middle = indices.len() / 2;
            let (_, &mut median, _) = indices
                .select_nth_unstable_by(middle, |&a, &b| key(a).total_cmp(&key(b)).then(a.cmp(&b)));
            let (below, above) = indices.split_at_mut(middle);
            let halves = Box::new([Self::build(below, points), Self::build(above, points)]);
            Kind::Split { axis, at: key(median), halves }
        };
        Self { size, earliest, bounds, kind }
    }
}

/// Extends a box (lowest, then highest, coordinates) to hold `point`.
fn widen(bounds: &mut [f64], point: &[f64]) {
    let (low, high) = bounds.split_at_mut(point.len());
    for ((low, high), &x) in low.iter_mut().zip(high).zip(point) {
        *low = -larger(-*low, -x);
        *high = larger(*high, x);
    }
}
