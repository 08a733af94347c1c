//! What keeps a set of exposed arcs outside of a new disc, as far as can be told at once.
//!
//! The point of an arc in direction u from its centre c lies outside the disc around p if
//! (c - p).u + |c - p|^2 / 2 > 0, in radii, and for a set of arcs whose directions are within rho
//! of a common one, v, and whose centres are within r of a common one, m, the left side is at
//! least
//!
//! (m - p).v + min (c - m).v - (|m - p| + r) rho + max(|m - p| - r, 0)^2 / 2.
//!
//! The terms that cancel are of the size of the crowd, not of the radius. On a circle of centres
//! a set that spans an angle is told apart from as far away as it is wide, so that a search
//! visits a logarithmic number of sets. The other way round, where circles with centres far apart
//! crowd through a narrow hole, the arcs themselves lie close together, and a disc around them
//! tells.

use super::super::Disc;
use super::super::circle::{Direction, Span};

/// An exposed arc: the centre of its disc, and a direction that all of its points are near.
#[derive(Debug, Clone, Copy)]
pub(super) struct Item {
    pub(super) place: u32,
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
pub(super) struct Bound {
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

impl Item {
    fn new(place: u32, centre: [f64; 2], arc: Span) -> Self {
        let (along, spread) = directions(arc);
        Self { place, centre, arc, along, spread }
    }

    pub(super) fn all_of(disc: &Disc, place: usize) -> impl Iterator<Item = Self> {
        let centre = [disc.x, disc.y];
        disc.arcs.iter().map(move |&arc| Self::new(place as u32, centre, arc))
    }

    /// Makes it what is left of the arc; None if nothing is. `true` if that is less than before.
    pub(super) fn left(&self, discs: &[Disc]) -> Option<(Self, bool)> {
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

    pub(super) fn key(&self, axis: usize) -> f64 {
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
pub(super) fn ranges(items: &[Item]) -> [[f64; 2]; 4] {
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
    pub(super) fn of(items: &[Item], tau: f64) -> Self {
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

    pub(super) fn include(&mut self, item: &Item, tau: f64) {
        let away = relative(item.centre, self.centre, tau);
        let point = item.point(self.centre, tau);
        let aside = [point[0] - self.middle[0], point[1] - self.middle[1]];
        self.reach = self.reach.max(length(aside) + item.spread);
        let turned = [item.along[0] - self.along[0], item.along[1] - self.along[1]];
        self.radius = self.radius.max(length(away));
        self.spread = self.spread.max(length(turned) + item.spread);
        self.least = self.least.min(dot(away, self.along));
    }

    /// Takes the bounds of two halves for its own, where they are narrower.
    pub(super) fn narrow<'a>(&mut self, halves: impl Iterator<Item = &'a Self>, tau: f64) {
        let (mut radius, mut spread, mut least) = (0.0_f64, 0.0_f64, f64::INFINITY);
        let mut reach = 0.0_f64;
        for half in halves {
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
    pub(super) fn is_outside(&self, point: [f64; 2], tau: f64) -> bool {
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

impl Item {
    pub(super) fn is_outside(&self, point: [f64; 2], tau: f64) -> bool {
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
