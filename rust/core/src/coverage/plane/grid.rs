//! Which discs may touch a given one: a hash grid of square cells.
//!
//! Each cell keeps its discs beside each other in memory, and in front of them where they lie,
//! roughly: among a million discs nearly all of a step's time is spent waiting for memory, and
//! what lies together is waited for once. Discs that have lost all of their boundary are set
//! aside: no search meets them.

use std::hash::BuildHasher;

use hashbrown::HashTable;
use rustc_hash::FxBuildHasher;
use smallvec::SmallVec;

use super::Disc;
use super::circle::{Span, floor};
use super::crowd::Crowd;
use super::sectors::{self, Reach, Sectors};

/// Live discs beside each other; a single one lies in its cell.
pub(crate) type Live = SmallVec<[Disc; 1]>;

/// The discs whose centres lie in one cell.
///
/// Effects that hardly overlap have a cell each: 136 bytes with the disc, and 6 to 12 in the index.
#[derive(Debug, Clone, Default)]
pub(crate) struct Cell {
    /// The column and the row of the cell.
    at: (i64, i64),
    /// What is roughly known of the live discs: most of them cannot matter to a new one, and this
    /// tells so without a look at them. Empty in a crowd.
    rough: SmallVec<[Rough; 1]>,
    /// Discs with exposed arcs; in a crowd also places where one has been.
    pub live: Live,
    /// Centres of discs without: they matter where rounding decides, and nowhere else.
    dead: Vec<[f64; 2]>,
    /// The exposed arcs of the live discs in order, where there are many.
    crowd: Option<Box<Crowd>>,
}

/// A disc's place, as seen from the lower left corner of its cell and in radii, and the sectors
/// in which it has exposed arcs.
#[derive(Debug, Clone, Copy)]
struct Rough {
    place: [f32; 2],
    sectors: Sectors,
}

impl Rough {
    fn of(disc: &Disc, edge: f64) -> Self {
        let place = [disc.x, disc.y].map(|x| (EDGE * locate(x / edge).1) as f32);
        Self { place, sectors: sectors::of_arcs(&disc.arcs) }
    }
}

/// A cell's edge in radii. Among a million discs 4 takes twice the time, 6 half more, 12 as much.
const EDGE: f64 = 8.0;

/// How far to look, in radii: twice one, and what rounding may take.
const REACH: f64 = 2.000_001;

/// The squared distance up to which a rough centre is near.
const ROUGHLY_NEAR: f32 = 4.01;

/// From so many live discs on a cell keeps their arcs in order. A search through the order
/// costs as much as looking at some fifty discs.
const CROWDED: usize = 96;

/// Live and dead discs by cell.
#[derive(Debug, Clone)]
pub(crate) struct Grid {
    tau: f64,
    edge: f64,
    reach: Reach,
    /// Which cell is where: the cells know themselves.
    index: HashTable<u32>,
    pub cells: Vec<Cell>,
}

/// A coordinate's cell, and how far through it, in [0, 1).
///
/// Far beyond the integers all coordinates share the outermost cells, and with that nothing is
/// missed: the cast saturates and stays monotone.
#[inline]
fn locate(quotient: f64) -> (i64, f64) {
    let cell = floor(quotient);
    (cell, quotient - cell as f64)
}

/// The hash of a cell's column and row.
#[inline]
fn hash(at: (i64, i64)) -> u64 {
    FxBuildHasher.hash_one(at)
}

impl Grid {
    pub fn new(tau: f64) -> Self {
        Self {
            tau,
            edge: EDGE * tau,
            reach: Reach::new(),
            index: HashTable::new(),
            cells: Vec::new(),
        }
    }

    /// Which cell has this column and row, if any.
    #[inline]
    fn index_at(&self, at: (i64, i64)) -> Option<u32> {
        self.index.find(hash(at), |&index| self.cells[index as usize].at == at).copied()
    }

    /// The cells that hold all centres within 2 radii of a point, and where it lies as seen
    /// from the lower left corner of each, in radii; no number where that is not known well.
    #[inline]
    fn around(&self, x: f64, y: f64) -> [Option<(u32, [f32; 2])>; 4] {
        let reach = REACH * self.tau;
        // Far from the origin places in a cell are not told apart.
        let is_far = x.abs().max(y.abs()) / self.edge > 1e12;
        let unit = if is_far { f64::NAN } else { EDGE };
        let columns = |x: f64| {
            let quotient = x / self.edge;
            [x - reach, x + reach].map(|end| {
                let (column, _) = locate(end / self.edge);
                (column, (unit * (quotient - column as f64)) as f32)
            })
        };
        let ([left, right], [low, high]) = (columns(x), columns(y));
        let at = |(i, across): (i64, f32), (j, up): (i64, f32)| {
            self.index_at((i, j)).map(|index| (index, [across, up]))
        };
        let (wide, tall) = (left.0 < right.0, low.0 < high.0);
        [
            at(left, low),
            if wide { at(right, low) } else { None },
            if tall { at(left, high) } else { None },
            if wide && tall { at(right, high) } else { None },
        ]
    }

    /// Lists the discs, by cell and place, whose exposed arcs the disc around a point may meet.
    #[inline]
    pub fn meeting(&mut self, x: f64, y: f64, met: &mut Vec<(u32, u32)>) {
        met.clear();
        for (index, place) in self.around(x, y).into_iter().flatten() {
            let cell = &mut self.cells[index as usize];
            cell.settle(self.edge);
            let start = met.len();
            if let Some(crowd) = &mut cell.crowd {
                let places = crowd.reaching([x, y], &cell.live);
                met.extend(places.iter().map(|&place| (index, place)));
                continue;
            }
            met.resize(start + cell.rough.len(), (index, 0));
            let count = cell.near(place, self.reach, &mut met[start..]);
            met.truncate(start + count);
        }
    }

    /// Files a disc.
    pub fn insert(&mut self, disc: Disc) {
        let tau = self.tau;
        let at = (locate(disc.x / self.edge).0, locate(disc.y / self.edge).0);
        let index = self.index_at(at).unwrap_or_else(|| self.add_cell(at));
        let cell = &mut self.cells[index as usize];
        if disc.arcs.is_empty() {
            cell.dead.push([disc.x, disc.y]); // it fills the last hole nearby
        } else if let Some(crowd) = &mut cell.crowd {
            crowd.insert(disc, &mut cell.live);
        } else {
            cell.rough.push(Rough::of(&disc, self.edge));
            cell.live.push(disc);
            if cell.live.len() >= CROWDED {
                cell.crowd = Some(Box::new(Crowd::new(&cell.live, tau)));
                cell.rough.clear();
            }
        }
    }

    /// Makes an empty cell where none is yet.
    fn add_cell(&mut self, at: (i64, i64)) -> u32 {
        let (cells, index) = (&self.cells, self.cells.len() as u32);
        self.index.insert_unique(hash(at), index, |&index| hash(cells[index as usize].at));
        self.cells.push(Cell { at, ..Cell::default() });
        index
    }

    /// Whether a disc that crosses no exposed arc overlaps the union - and so lies in it.
    ///
    /// Inside, some centre is closer than a radius; outside, no centre is closer than two.
    pub fn is_inside(&self, x: f64, y: f64) -> bool {
        let near = |[cx, cy]: [f64; 2]| {
            (cx - x) * (cx - x) + (cy - y) * (cy - y) < 2.0 * self.tau * self.tau
        };
        let buried = |cell: &Cell| cell.dead.iter().copied().any(near);
        // Most are covered by a disc in the same cell and without boundary.
        self.cell([x, y]).is_some_and(buried)
            || self.cells_around(x, y).any(|cell| buried(cell) || cell.live().any(near))
    }

    /// Whether a disc without boundary has this very centre.
    #[cold]
    pub fn has_buried(&self, centre: [f64; 2]) -> bool {
        self.cell(centre).is_some_and(|cell| cell.dead.contains(&centre))
    }

    /// The cell of a place, if there is one.
    fn cell(&self, place: [f64; 2]) -> Option<&Cell> {
        let [i, j] = place.map(|x| locate(x / self.edge).0);
        self.index_at((i, j)).map(|index| &self.cells[index as usize])
    }

    /// The cells that hold all centres within 2 radii of a point.
    fn cells_around(&self, x: f64, y: f64) -> impl Iterator<Item = &Cell> {
        self.around(x, y).into_iter().flatten().map(|(index, _)| &self.cells[index as usize])
    }

    /// All discs that have boundary.
    pub fn discs(&self) -> impl Iterator<Item = &Disc> {
        self.cells.iter().flat_map(|cell| &cell.live).filter(|disc| !disc.arcs.is_empty())
    }

    /// The centres of all discs, live and dead, that may be within 2 radii.
    pub fn stored_around(&self, x: f64, y: f64) -> impl Iterator<Item = [f64; 2]> {
        self.cells_around(x, y).flat_map(|cell| cell.live().chain(cell.dead.iter().copied()))
    }
}

impl Cell {
    /// Lists the places of discs whose exposed arcs the disc around a point may meet.
    ///
    /// Without a branch for each, since nothing predicts which are listed.
    #[inline]
    fn near(&self, [x, y]: [f32; 2], reach: Reach, met: &mut [(u32, u32)]) -> usize {
        if x.is_nan() {
            (0..).zip(met.iter_mut()).for_each(|(place, met)| met.1 = place);
            return met.len();
        }
        let (mut near, mut count) = (0, 0);
        for (place, rough) in (0..).zip(&self.rough) {
            let (dx, dy) = (x - rough.place[0], y - rough.place[1]);
            met[near].1 = place;
            near += usize::from(dx * dx + dy * dy <= ROUGHLY_NEAR);
        }
        for index in 0..near {
            let place = met[index].1;
            let rough = self.rough[place as usize];
            let reached = reach.from(x - rough.place[0], y - rough.place[1]);
            met[count].1 = place;
            count += usize::from(reached & rough.sectors != 0);
        }
        count
    }

    /// Takes from a disc's arcs what lies inside another. A disc without any is set aside; out of
    /// a crowd, the last one takes its place.
    pub fn swallow(&mut self, place: usize, inside: Span) {
        let disc = &mut self.live[place];
        disc.lose(inside);
        if !disc.arcs.is_empty() {
            if self.crowd.is_none() {
                self.rough[place].sectors = sectors::of_arcs(&disc.arcs);
            }
            return;
        }
        self.dead.push([disc.x, disc.y]);
        if let Some(crowd) = &mut self.crowd {
            crowd.vacate(place, &mut self.live);
        } else {
            self.live.swap_remove(place);
            self.rough.swap_remove(place);
        }
    }

    /// The centres of discs that have boundary.
    fn live(&self) -> impl Iterator<Item = [f64; 2]> {
        let live = self.live.iter().filter(|disc| !disc.arcs.is_empty());
        live.map(|disc| [disc.x, disc.y])
    }

    /// Gives up a crowd that has scattered.
    fn settle(&mut self, edge: f64) {
        if self.crowd.as_ref().is_none_or(|crowd| crowd.len(&self.live) >= CROWDED / 2) {
            return;
        }
        self.crowd = None;
        self.live.retain(|disc| !disc.arcs.is_empty());
        self.rough = self.live.iter().map(|disc| Rough::of(disc, edge)).collect();
    }
}
