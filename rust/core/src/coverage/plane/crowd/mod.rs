//! Exposed arcs in order: which of them reach into a new disc, where thousands crowd together.
//!
//! Discs whose centres lie much closer together than a radius all overlap, and each that widens
//! the hull of the centres exposes a short arc: no box around those arcs, and no box around
//! their centres, tells the few that a new disc meets from the many that it barely misses.
//! Centre *and* direction do (`bound`), and order the arcs in a tree.

mod bound;

use super::Disc;
use super::grid::Live;
use bound::{Bound, Item, ranges};

#[derive(Debug, Clone)]
enum Node {
    Leaf { bound: Bound, items: Vec<Item> },
    Inner { bound: Bound, split: Split, built: usize, changes: usize, halves: Box<[Node; 2]> },
}

/// What a search has found to be out of date.
#[derive(Debug, Clone, Copy, Default)]
struct Change {
    narrower: bool,
    gone: usize,
}

/// Which items go into the first half: those whose coordinate is below a value.
#[derive(Debug, Clone, Copy)]
struct Split {
    axis: usize,
    at: f64,
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
        self.root.reaching(point, self.tau, discs, &mut self.found);
        self.found.sort_unstable(); // several arcs may be of one disc
        self.found.dedup();
        &self.found
    }
}

impl Node {
    fn build(items: &mut [Item], tau: f64) -> Self {
        let bound = Bound::of(items, tau);
        if items.len() <= LEAF {
            return Self::Leaf { bound, items: items.to_vec() };
        }
        let ranges = ranges(items);
        let width = |axis: usize| {
            let width = ranges[axis][1] - ranges[axis][0];
            if axis < 2 { width / tau } else { width }
        };
        let axis = (1..4).fold(0, |wide, axis| if width(axis) > width(wide) { axis } else { wide });
        let half = items.len() / 2;
        items.select_nth_unstable_by(half, |a, b| a.key(axis).total_cmp(&b.key(axis)));
        let split = Split { axis, at: items[half].key(axis) };
        let built = items.len();
        let (below, above) = items.split_at_mut(half);
        let halves = Box::new([Self::build(below, tau), Self::build(above, tau)]);
        Self::Inner { bound, split, built, changes: 0, halves }
    }

    fn insert(&mut self, item: Item, tau: f64, discs: &[Disc], moving: &mut Vec<Item>) {
        let rebuild = match self {
            Self::Leaf { bound, items } => {
                items.push(item);
                if items.len() == 1 {
                    *bound = Bound::of(items, tau);
                } else {
                    bound.include(&item, tau);
                }
                items.len() > 2 * LEAF
            }
            Self::Inner { bound, split, built, changes, halves } => {
                *changes += 1;
                if *changes <= *built {
                    bound.include(&item, tau);
                    let second = item.key(split.axis) >= split.at;
                    return halves[usize::from(second)].insert(item, tau, discs, moving);
                }
                true
            }
        };
        if rebuild {
            moving.clear();
            if matches!(self, Self::Inner { .. }) {
                moving.push(item);
            }
            self.drain(moving);
            moving.retain_mut(|item| {
                item.left(discs).is_some_and(|(left, _)| {
                    *item = left;
                    true
                })
            });
            *self = Self::build(moving, tau);
        }
    }

    /// Takes all items out.
    fn drain(&mut self, into: &mut Vec<Item>) {
        match self {
            Self::Leaf { items, .. } => into.append(items),
            Self::Inner { halves, .. } => halves.iter_mut().for_each(|half| half.drain(into)),
        }
    }

    /// Lists what may reach into the disc. What it meets of arcs that have become shorter is
    /// brought up to date on the way: each is met once before it is told from the rest again.
    fn reaching(
        &mut self,
        point: [f64; 2],
        tau: f64,
        discs: &[Disc],
        found: &mut Vec<u32>,
    ) -> Change {
        match self {
            Self::Leaf { bound, items } => {
                if items.is_empty() || bound.is_outside(point, tau) {
                    return Change::default();
                }
                let before = items.len();
                let mut narrower = false;
                items.retain_mut(|item| {
                    let left = item.left(discs);
                    narrower |= left.is_none_or(|(_, shorter)| shorter);
                    left.is_some_and(|(left, _)| {
                        *item = left;
                        if !item.is_outside(point, tau) {
                            found.push(item.place);
                        }
                        true
                    })
                });
                if narrower {
                    *bound = Bound::of(items, tau);
                }
                Change { narrower, gone: before - items.len() }
            }
            Self::Inner { bound, changes, halves, .. } => {
                if bound.is_outside(point, tau) {
                    return Change::default();
                }
                let [below, above] = &mut **halves;
                let below = below.reaching(point, tau, discs, found);
                let above = above.reaching(point, tau, discs, found);
                let narrower = below.narrower || above.narrower;
                if narrower {
                    bound.narrow(halves.iter().filter_map(Self::bound), tau);
                }
                let gone = below.gone + above.gone;
                *changes += gone;
                Change { narrower, gone }
            }
        }
    }

    fn bound(&self) -> Option<&Bound> {
        match self {
            Self::Leaf { items, .. } if items.is_empty() => None,
            Self::Leaf { bound, .. } | Self::Inner { bound, .. } => Some(bound),
        }
    }
}
