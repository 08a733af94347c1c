//! Exposed arcs in order: which of them reach into a new disc, where thousands crowd together.
//!
//! Discs whose centres lie much closer together than a radius all overlap, and each that widens
//! the hull of the centres exposes a short arc: no box around those arcs, and no box around
//! their centres, tells the few that a new disc meets from the many that it barely misses.
//! Centre *and* direction do. The point of an arc in direction u from its centre c lies outside
//! the disc around p if (c - p).u + |c - p|^2 / 2 > 0, in radii, and for a set of arcs whose
//! directions are within rho of a common one, v, and whose centres are within r of a common
//! one, m, the left side is at least
//!
//! (m - p).v + min (c - m).v - (|m - p| + r) rho + max(|m - p| - r, 0)^2 / 2.
//!
//! The terms that cancel are of the size of the crowd, not of the radius. On a circle of centres
//! a set that spans an angle is told apart from as far away as it is wide, so that a search
//! visits a logarithmic number of sets. The other way round, where circles with centres far apart
//! crowd through a narrow hole, the arcs themselves lie close together, and a disc around them
//! tells.

use super::Disc;
use super::circle::{Direction, Span};

/// An exposed arc: the centre of its disc, and a direction that all of its points are near.
#[derive(Debug, Clone, Copy)]
struct Item {
    place: u32,
    /// The disc's centre.
    centre: [f64; 2],
    arc: Span,
    /// A direction, not of unit length, ...
    along: [f64; 2],
    /// ... and how far from it the arc's are at most.
    spread: f64,
}

/// What all items below a node obey.
#[derive(Debug, Clone, Copy)]
struct Bound {
    centre: [f64; 2],
    /// How far the centres are from it at most, in radii.
    radius: f64,
    along: [f64; 2],
    /// How far the directions are from it at most.
    spread: f64,
    /// The least product of a centre, relative to the common one and in radii, with `along`.
    least: f64,
    /// The middle of the arcs' points, relative to `centre` and in radii, ...
    middle: [f64; 2],
    /// ... and how far from it they are at most.
    reach: f64,
}

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
    pub fn insert(&mut self, disc: Disc, discs: &mut Vec<Disc>) {
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

impl Item {
    fn new(place: u32, centre: [f64; 2], arc: Span) -> Self {
        let (along, spread) = directions(arc);
        Self { place, centre, arc, along, spread }
    }

    fn all_of(disc: &Disc, place: usize) -> impl Iterator<Item = Self> {
        let centre = [disc.x, disc.y];
        disc.arcs.iter().map(move |&arc| Self::new(place as u32, centre, arc))
    }

    /// Makes it what is left of the arc; None if nothing is. `true` if that is less than before.
    fn left(&self, discs: &[Disc]) -> Option<(Self, bool)> {
        let disc = &discs[self.place as usize];
        if [disc.x, disc.y] != self.centre {
            return None; // another disc has its place
        }
        let mut parts = disc.arcs.iter().filter_map(|&arc| arc.common(self.arc));
        let first = parts.next()?;
        let arc = parts.fold(first, |all, part| Span {
            from: all.from.min(part.from),
            to: all.to.max(part.to),
        });
        if arc == self.arc {
            Some((*self, false))
        } else {
            Some((Self::new(self.place, self.centre, arc), true))
        }
    }

    /// A point in the middle of the arc, but for its spread, relative to `origin` and in radii.
    fn point(&self, origin: [f64; 2], tau: f64) -> [f64; 2] {
        let away = relative(self.centre, origin, tau);
        [away[0] + self.along[0], away[1] + self.along[1]]
    }

    fn key(&self, axis: usize) -> f64 {
        if axis < 2 { self.centre[axis] } else { self.along[axis - 2] }
    }
}

/// The middle of the box around an arc's directions, and the distance of its corners.
fn directions(arc: Span) -> ([f64; 2], f64) {
    let (from, to) = (Direction::at(arc.from), Direction::at(arc.to));
    let mut low = [from.x.min(to.x), from.y.min(to.y)];
    let mut high = [from.x.max(to.x), from.y.max(to.y)];
    // Arcs do not pass turn 0; at turns 1, 2 and 3 they point along an axis.
    for (turn, axis, value) in [(1.0, 1, 1.0), (2.0, 0, -1.0), (3.0, 1, -1.0_f64)] {
        if arc.from < turn && turn < arc.to {
            low[axis] = low[axis].min(value);
            high[axis] = high[axis].max(value);
        }
    }
    let half = [0.5 * (high[0] - low[0]), 0.5 * (high[1] - low[1])];
    ([low[0] + half[0], low[1] + half[1]], length(half))
}

/// The least and the greatest key of some items along each axis.
fn ranges(items: &[Item]) -> [[f64; 2]; 4] {
    let mut ranges = [[f64::INFINITY, f64::NEG_INFINITY]; 4];
    for item in items {
        for (axis, range) in ranges.iter_mut().enumerate() {
            let key = item.key(axis);
            *range = [range[0].min(key), range[1].max(key)];
        }
    }
    ranges
}

impl Bound {
    /// The bound of some items; of none, one that means nothing.
    fn of(items: &[Item], tau: f64) -> Self {
        let ranges = ranges(items);
        let middle = |axis: usize| ranges[axis][0] + 0.5 * (ranges[axis][1] - ranges[axis][0]);
        let mut bound = Self {
            centre: [middle(0), middle(1)],
            radius: 0.0,
            along: [middle(2), middle(3)],
            spread: 0.0,
            least: f64::INFINITY,
            middle: [0.0; 2],
            reach: 0.0,
        };
        bound.middle = bound.middle_of(items, tau);
        items.iter().for_each(|item| bound.include(item, tau));
        bound
    }

    /// The middle of the box around the items' points, roughly: all else is relative to it.
    fn middle_of(&self, items: &[Item], tau: f64) -> [f64; 2] {
        let (mut low, mut high) = ([f64::INFINITY; 2], [f64::NEG_INFINITY; 2]);
        for item in items {
            let point = item.point(self.centre, tau);
            for axis in 0..2 {
                low[axis] = low[axis].min(point[axis]);
                high[axis] = high[axis].max(point[axis]);
            }
        }
        [low[0] + 0.5 * (high[0] - low[0]), low[1] + 0.5 * (high[1] - low[1])]
    }

    fn include(&mut self, item: &Item, tau: f64) {
        let away = relative(item.centre, self.centre, tau);
        let point = item.point(self.centre, tau);
        let aside = [point[0] - self.middle[0], point[1] - self.middle[1]];
        self.reach = self.reach.max(length(aside) + item.spread);
        let turned = [item.along[0] - self.along[0], item.along[1] - self.along[1]];
        self.radius = self.radius.max(length(away));
        self.spread = self.spread.max(length(turned) + item.spread);
        self.least = self.least.min(dot(away, self.along));
    }

    /// Takes the bounds of two halves for their own, where they are narrower.
    fn narrow(&mut self, halves: &[Node; 2], tau: f64) {
        let (mut radius, mut spread, mut least) = (0.0_f64, 0.0_f64, f64::INFINITY);
        let mut reach = 0.0_f64;
        for half in halves.iter().filter_map(Node::bound) {
            let away = relative(half.centre, self.centre, tau);
            let turned = [half.along[0] - self.along[0], half.along[1] - self.along[1]];
            let aside = [0, 1].map(|axis| away[axis] + half.middle[axis] - self.middle[axis]);
            reach = reach.max(length(aside) + half.reach);
            radius = radius.max(length(away) + half.radius);
            spread = spread.max(length(turned) + half.spread);
            least = least.min(dot(away, self.along) + half.least - half.radius * length(turned));
        }
        self.reach = self.reach.min(reach);
        self.radius = self.radius.min(radius);
        self.spread = self.spread.min(spread);
        self.least = self.least.max(least);
    }

    /// Whether all points of the arcs surely lie outside of the disc around `point`.
    #[inline]
    fn is_outside(&self, point: [f64; 2], tau: f64) -> bool {
        let away = relative(self.centre, point, tau);
        let towards = [away[0] + self.middle[0], away[1] + self.middle[1]];
        let beyond = 1.0 + self.reach + ROUNDING;
        if dot(towards, towards) > beyond * beyond {
            return true;
        }
        let distance = length(away);
        let gap = (distance - self.radius).max(0.0);
        let size = distance + self.radius;
        let outside = dot(away, self.along) + self.least - size * self.spread + 0.5 * gap * gap;
        outside > ROUNDING * size
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
                    bound.narrow(halves, tau);
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

impl Item {
    fn is_outside(&self, point: [f64; 2], tau: f64) -> bool {
        let away = relative(self.centre, point, tau);
        let distance = length(away);
        let outside = dot(away, self.along) - distance * self.spread + 0.5 * distance * distance;
        outside > ROUNDING * distance
    }
}

/// What rounding may add to a bound, as a share of the crowd's size.
const ROUNDING: f64 = 1e-12;

fn relative(point: [f64; 2], origin: [f64; 2], tau: f64) -> [f64; 2] {
    [(point[0] - origin[0]) / tau, (point[1] - origin[1]) / tau]
}

fn dot(a: [f64; 2], b: [f64; 2]) -> f64 {
    a[0] * b[0] + a[1] * b[1]
}

fn length(a: [f64; 2]) -> f64 {
    dot(a, a).sqrt()
}
