//! Exposed arcs in order: which of them reach into a new disc, where thousands crowd together.
//!
//! Discs whose centres lie much closer together than a radius all overlap, and each that widens
//! the hull of the centres exposes a short arc: no box around those arcs, and no box around
//! their centres, tells the few that a new disc meets from the many that it barely misses.
//! Centre *and* direction do (`bound`), and order the arcs in a tree.

mod bound;

use parry2d_f64::math::Vector;

use super::Disc;
use super::grid::Live;
use bound::{Bound, Item, ranges};

#[derive(Debug, Clone)]
struct Node {
    bound: Bound,
    kind: Kind,
}

#[derive(Debug, Clone)]
enum Kind {
    Leaf(Vec<Item>),
    /// Items whose coordinate is below a value go into the first half.
    Inner {
        axis: usize,
        at: f64,
        built: usize,
        changes: usize,
        halves: Box<[Node; 2]>,
    },
}

/// What a search has found to be out of date.
#[derive(Debug, Clone, Copy, Default)]
struct Change {
    narrower: bool,
    gone: usize,
}

/// The exposed arcs of a cell's live discs.
#[derive(Debug, Clone)]
pub(crate) struct Crowd {
    tau: f64,
    root: Node,
    /// Places among the cell's discs where none is any more.
    vacant: Vec<u32>,
    /// What is being built anew, and what was found; kept for their memory.
    moving: Vec<Item>,
    found: Vec<u32>,
}

/// A leaf holds up to twice as many.
const LEAF: usize = 12;

impl Crowd {
    pub fn new(discs: &[Disc], tau: f64) -> Self {
        let mut items: Vec<Item> =
            discs.iter().enumerate().flat_map(|(place, disc)| Item::all_of(disc, place)).collect();
        let root = Node::build(&mut items, tau);
        Self { tau, root, vacant: Vec::new(), moving: items, found: Vec::new() }
    }

    /// How many of the `discs` are there.
    pub fn len(&self, discs: &[Disc]) -> usize {
        discs.len() - self.vacant.len()
    }

    /// Adds a disc to the others.
    pub fn insert(&mut self, disc: Disc, discs: &mut Live) {
        let place = self.vacant.pop().map_or(discs.len(), |place| place as usize);
        if place == discs.len() {
            discs.push(disc);
        } else {
            discs[place] = disc;
        }
        for item in Item::all_of(&discs[place], place) {
            self.root.insert(item, self.tau, discs, &mut self.moving);
        }
    }

    /// Marks the place of a disc that has lost its boundary.
    pub fn vacate(&mut self, place: usize, discs: &mut [Disc]) {
        (discs[place].x, discs[place].y) = (f64::NAN, f64::NAN);
        self.vacant.push(place as u32);
    }

    /// Lists the places of discs of which an arc may reach into the disc around `point`.
    pub fn reaching(&mut self, point: [f64; 2], discs: &[Disc]) -> &[u32] {
        self.found.clear();
        self.root.reaching(point.into(), self.tau, discs, &mut self.found);
        self.found.sort_unstable(); // several arcs may be of one disc
        self.found.dedup();
        &self.found
    }
}

impl Node {
    fn build(items: &mut [Item], tau: f64) -> Self {
        let bound = Bound::of(items, tau);
        let built = items.len();
        if built <= LEAF {
            return Self { bound, kind: Kind::Leaf(items.to_vec()) };
        }
        let [low, high] = ranges(items);
        let width = |axis: usize| {
            let width = high[axis] - low[axis];
            if axis < 2 { width / tau } else { width }
        };
        let axis = (1..4).fold(0, |wide, axis| if width(axis) > width(wide) { axis } else { wide });
        let half = built / 2;
        items.select_nth_unstable_by(half, |a, b| a.key(axis).total_cmp(&b.key(axis)));
        let at = items[half].key(axis);
        let (below, above) = items.split_at_mut(half);
        let halves = Box::new([Self::build(below, tau), Self::build(above, tau)]);
        Self { bound, kind: Kind::Inner { axis, at, built, changes: 0, halves } }
    }

    fn insert(&mut self, item: Item, tau: f64, discs: &[Disc], moving: &mut Vec<Item>) {
        match &mut self.kind {
            Kind::Leaf(items) if items.len() < 2 * LEAF => {
                items.push(item);
                if items.len() == 1 {
                    self.bound = Bound::of(items, tau);
                } else {
                    self.bound.include(&item, tau);
                }
            }
            Kind::Inner { axis, at, built, changes, halves } if *changes < *built => {
                *changes += 1;
                self.bound.include(&item, tau);
                let second = item.key(*axis) >= *at;
                halves[usize::from(second)].insert(item, tau, discs, moving);
            }
            _ => {
                moving.clear();
                moving.push(item);
                self.drain(moving);
                moving.retain_mut(|item| item.shorten(discs).is_some());
                *self = Self::build(moving, tau);
            }
        }
    }

    /// Takes all items out.
    fn drain(&mut self, into: &mut Vec<Item>) {
        match &mut self.kind {
            Kind::Leaf(items) => into.append(items),
            Kind::Inner { halves, .. } => halves.iter_mut().for_each(|half| half.drain(into)),
        }
    }

    /// Lists what may reach into the disc. What it meets of arcs that have become shorter is
    /// brought up to date on the way: each is met once before it is told from the rest again.
    fn reaching(
        &mut self,
        point: Vector,
        tau: f64,
        discs: &[Disc],
        found: &mut Vec<u32>,
    ) -> Change {
        let mut change = Change::default();
        if self.bound.is_outside(point, tau) {
            return change;
        }
        match &mut self.kind {
            Kind::Leaf(items) => {
                let before = items.len();
                items.retain_mut(|item| {
                    let shorter = item.shorten(discs);
                    change.narrower |= shorter != Some(false);
                    if shorter.is_some() && !item.is_outside(point, tau) {
                        found.push(item.place);
                    }
                    shorter.is_some()
                });
                change.gone = before - items.len();
                if change.narrower {
                    self.bound = Bound::of(items, tau);
                }
            }
            Kind::Inner { changes, halves, .. } => {
                for half in halves.iter_mut() {
                    let Change { narrower, gone } = half.reaching(point, tau, discs, found);
                    change.narrower |= narrower;
                    change.gone += gone;
                }
                if change.narrower {
                    self.bound.narrow(halves.iter().map(|half| &half.bound), tau);
                }
                *changes += change.gone;
            }
        }
        change
    }
}
