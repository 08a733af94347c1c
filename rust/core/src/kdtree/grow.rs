//! Growing the tree: inserting points, splitting leaves, building lopsided parts anew.

use super::search::larger;
use super::{Kind, LEAF, NearestNeighbors, Node, ROOT};

/// A subtree is built anew when one side holds more than this share of it.
const LOPSIDED: f64 = 0.7;

impl NearestNeighbors {
    /// Files the next point that is not yet in the tree.
    pub(super) fn file_next(&mut self) {
        let (index, dim) = (self.filed, self.dim);
        self.filed += 1;
        if index == 0 {
            self.build(&mut [0], ROOT);
            return;
        }

        // The highest subtree that this point makes too unequal. Only the side that grows can
        // become too large, so that its sibling need not be looked at.
        let mut lopsided = None;
        let (mut node, mut parent) = (ROOT, None);
        loop {
            self.grow_box(node, index);
            let Node { size, kind, .. } = &mut self.nodes[node as usize];
            *size += 1;
            if let Some((parent, share)) = parent
                && f64::from(*size) > share
            {
                lopsided = lopsided.or(Some(parent));
            }
            match *kind {
                Kind::Split { axis, at, left, right } => {
                    parent = Some((node, LOPSIDED * f64::from(*size) + LEAF as f64));
                    let x = self.points[index as usize * dim + axis as usize];
                    node = if x < at { left } else { right };
                }
                Kind::Leaf { slot } => {
                    let held = *size as usize - 1;
                    if held < LEAF {
                        self.put_in_leaf(slot, held, index);
                    } else {
                        let mut indices = [index; LEAF + 1];
                        indices[..LEAF].copy_from_slice(&self.leaf_indices[slot as usize]);
                        self.free_leaves.push(slot);
                        self.build(&mut indices, node);
                    }
                    break;
                }
            }
        }
        if let Some(node) = lopsided {
            let mut indices = Vec::with_capacity(self.nodes[node as usize].size as usize);
            self.dismantle(node, &mut indices);
            self.build(&mut indices, node);
        }
    }

    /// Collects the points below `node` and frees everything below it, but not the node.
    fn dismantle(&mut self, node: u32, indices: &mut Vec<u32>) {
        let Node { size, kind, .. } = self.nodes[node as usize];
        match kind {
            Kind::Leaf { slot } => {
                indices.extend_from_slice(&self.leaf_indices[slot as usize][..size as usize]);
                self.free_leaves.push(slot);
            }
            Kind::Split { left, right, .. } => {
                for child in [left, right] {
                    self.dismantle(child, indices);
                    self.free_nodes.push(child);
                }
            }
        }
    }

    /// Makes `node` the root of a balanced tree over `indices`, of which there is at least one.
    fn build(&mut self, indices: &mut [u32], node: u32) {
        let dim = self.dim;
        self.ensure_node(node);
        self.fit_box(node, indices);
        let earliest = indices.iter().copied().fold(u32::MAX, u32::min);
        let size = indices.len() as u32;
        let kind = if indices.len() <= LEAF {
            let slot = self.new_leaf();
            for (position, &index) in indices.iter().enumerate() {
                self.put_in_leaf(slot, position, index);
            }
            Kind::Leaf { slot }
        } else {
            let axis = self.widest_axis(node);
            let points = &self.points;
            let key = |index: u32| (points[index as usize * dim + axis], index);
            let middle = indices.len() / 2;
            let (_, &mut median, _) = indices.select_nth_unstable_by(middle, |&a, &b| {
                let ((a, i), (b, j)) = (key(a), key(b));
                a.total_cmp(&b).then(i.cmp(&j))
            });
            let at = key(median).0;
            let (below, above) = indices.split_at_mut(middle);
            let (left, right) = (self.new_node(), self.new_node());
            self.build(below, left);
            self.build(above, right);
            Kind::Split { axis: axis as u32, at, left, right }
        };
        self.nodes[node as usize] = Node { size, earliest, kind };
    }

    fn widest_axis(&self, node: u32) -> usize {
        let (low, high) =
            self.boxes[node as usize * 2 * self.dim..][..2 * self.dim].split_at(self.dim);
        let mut widest = 0;
        for j in 1..self.dim {
            if high[j] - low[j] > high[widest] - low[widest] {
                widest = j;
            }
        }
        widest
    }

    fn fit_box(&mut self, node: u32, indices: &[u32]) {
        let start = node as usize * 2 * self.dim;
        let first = indices[0] as usize * self.dim;
        for j in 0..self.dim {
            self.boxes[start + j] = self.points[first + j];
            self.boxes[start + self.dim + j] = self.points[first + j];
        }
        for &index in &indices[1..] {
            let from = index as usize * self.dim;
            let (points, boxes) = (&self.points[from..from + self.dim], &mut self.boxes);
            widen(&mut boxes[start..start + 2 * self.dim], points);
        }
    }

    fn grow_box(&mut self, node: u32, index: u32) {
        let (start, from) = (node as usize * 2 * self.dim, index as usize * self.dim);
        let point = &self.points[from..from + self.dim];
        widen(&mut self.boxes[start..start + 2 * self.dim], point);
    }

    fn put_in_leaf(&mut self, slot: u32, position: usize, index: u32) {
        let (from, to) = (index as usize * self.dim, (slot as usize * LEAF + position) * self.dim);
        self.leaf_points[to..to + self.dim].copy_from_slice(&self.points[from..from + self.dim]);
        self.leaf_indices[slot as usize][position] = index;
    }

    fn new_node(&mut self) -> u32 {
        let node = self.free_nodes.pop().unwrap_or(self.nodes.len() as u32);
        self.ensure_node(node);
        node
    }

    fn ensure_node(&mut self, node: u32) {
        if node as usize == self.nodes.len() {
            self.nodes.push(Node { size: 0, earliest: 0, kind: Kind::Leaf { slot: 0 } });
            self.boxes.resize(self.boxes.len() + 2 * self.dim, 0.0);
        }
    }

    fn new_leaf(&mut self) -> u32 {
        self.free_leaves.pop().unwrap_or_else(|| {
            let slot = self.leaf_indices.len() as u32;
            self.leaf_indices.push([0; LEAF]);
            self.leaf_points.resize(self.leaf_points.len() + LEAF * self.dim, 0.0);
            slot
        })
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
