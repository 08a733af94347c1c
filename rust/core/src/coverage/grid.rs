//! Which discs may touch a given one: a hash grid of square cells.
//!
//! Cells are as wide as a disc, so that all centres closer than that lie in the 3 x 3 cells
//! around. Each cell keeps its centres beside each other in memory.

use rustc_hash::FxHashMap;

/// A disc's centre and its number.
#[derive(Debug, Clone, Copy)]
pub(crate) struct Entry {
    pub x: f64,
    pub y: f64,
    pub disc: u32,
}

/// Centres by cell.
#[derive(Debug, Clone)]
pub(crate) struct Grid {
    cell: f64,
    cells: FxHashMap<(i64, i64), Vec<Entry>>,
}

impl Grid {
    pub fn new(cell: f64) -> Self {
        Self { cell, cells: FxHashMap::default() }
    }

    pub fn insert(&mut self, entry: Entry) {
        let key = (self.column(entry.x), self.column(entry.y));
        self.cells.entry(key).or_default().push(entry);
    }

    /// The centres in the 3 x 3 cells around a point, cell by cell.
    pub fn around(&self, x: f64, y: f64) -> impl Iterator<Item = &[Entry]> {
        let (column, row) = (self.column(x), self.column(y));
        let steps = (-1..=1).flat_map(|i| (-1..=1).map(move |j| (i, j)));
        steps
            .filter_map(move |(i, j)| {
                self.cells.get(&(column.saturating_add(i), row.saturating_add(j)))
            })
            .map(Vec::as_slice)
    }

    /// All centres, in no particular order.
    pub fn entries(&self) -> impl Iterator<Item = &Entry> {
        self.cells.values().flatten()
    }

    /// Far beyond the integers all coordinates share the outermost cells, and with that
    /// nothing is missed: the cast saturates and stays monotone.
    fn column(&self, x: f64) -> i64 {
        (x / self.cell).floor() as i64
    }
}
