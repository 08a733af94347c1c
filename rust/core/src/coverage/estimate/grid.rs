//! Which balls may overlap a given one: a hash grid over the first three coordinates.
//!
//! Cells are as wide as a ball, so that all centres closer than that lie in the 3 x 3 x 3
//! cells around; further coordinates would multiply the cells to look into by three each.

use rustc_hash::FxHashMap;

type Cell = [i64; 3];

/// Centres by cell, those of a cell beside each other in memory.
#[derive(Debug, Clone)]
pub(super) struct Grid {
    dim: usize,
    width: f64,
    cells: FxHashMap<Cell, Vec<f64>>,
}

impl Grid {
    pub fn new(dim: usize, width: f64) -> Self {
        Self { dim, width, cells: FxHashMap::default() }
    }

    pub fn insert(&mut self, centre: &[f64]) {
        self.cells.entry(self.cell(centre)).or_default().extend_from_slice(centre);
    }

    /// The centres in the cells around a point, cell by cell and in the order of insertion.
    pub fn around(&self, point: &[f64]) -> impl Iterator<Item = &[f64]> {
        let [x, y, z] = self.cell(point);
        let span = |axis: usize| if axis < self.dim { -1..=1 } else { 0..=0 };
        let steps =
            span(0).flat_map(move |i| span(1).flat_map(move |j| span(2).map(move |k| (i, j, k))));
        steps
            .filter_map(move |(i, j, k)| {
                let cell = [x.saturating_add(i), y.saturating_add(j), z.saturating_add(k)];
                self.cells.get(&cell)
            })
            .flat_map(|rows| rows.chunks_exact(self.dim))
    }

    /// Far beyond the integers all coordinates share the outermost cells, and with that
    /// nothing is missed: the cast saturates and stays monotone.
    fn cell(&self, point: &[f64]) -> Cell {
        std::array::from_fn(|k| point.get(k).map_or(0, |x| (x / self.width).floor() as i64))
    }
}
