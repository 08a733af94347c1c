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

use parry2d_f64::math::Vector;

use super::super::Disc;
use super::super::circle::{Direction, Span};

/// An exposed arc: the centre of its disc, and a direction that all of its points are near.
#[derive(Debug, Clone, Copy)]
pub(super) struct Item {
    pub(super) place: u32,
    /// The disc's centre.
    centre: Vector,
    arc: Span,
    /// A direction, not of unit length, ...
    along: Vector,
    /// ... and how far from it the arc's are at most.
    spread: f64,
}

/// What all items below a node obey.
#[derive(Debug, Clone, Copy)]
pub(super) struct Bound {
    centre: Vector,
    /// How far the centres are from it at most, in radii.
    radius: f64,
    along: Vector,
    /// How far the directions are from it at most.
    spread: f64,
    /// The least product of a centre, relative to the common one and in radii, with `along`.
    least: f64,
    /// The middle of the arcs' points, relative to `centre` and in radii, ...
    middle: Vector,
    /// ... and how far from it they are at most.
    reach: f64,
}

impl Item {
    fn new(place: u32, centre: Vector, arc: Span) -> Self {
        let (along, spread) = directions(arc);
        Self { place, centre, arc, along, spread }
    }

    pub(super) fn all_of(disc: &Disc, place: usize) -> impl Iterator<Item = Self> {
        let centre = Vector::new(disc.x, disc.y);
        disc.arcs.iter().map(move |&arc| Self::new(place as u32, centre, arc))
    }

    /// Makes it what is left of the arc, and tells whether that is less than before; None if nothing is left.
    pub(super) fn shorten(&mut self, discs: &[Disc]) -> Option<bool> {
        let disc = &discs[self.place as usize];
        if Vector::new(disc.x, disc.y) != self.centre {
            return None; // another disc has its place
        }
        let parts = disc.arcs.iter().filter_map(|&arc| arc.common(self.arc));
        let arc = parts
            .reduce(|all, part| Span { from: all.from.min(part.from), to: all.to.max(part.to) })?;
        let shorter = arc != self.arc;
        if shorter {
            *self = Self::new(self.place, self.centre, arc);
        }
        Some(shorter)
    }

    /// A point in the middle of the arc, but for its spread, relative to `origin` and in radii.
    fn point(&self, origin: Vector, tau: f64) -> Vector {
        (self.centre - origin) / tau + self.along
    }

    pub(super) fn key(&self, axis: usize) -> f64 {
        self.keys()[axis]
    }

    fn keys(&self) -> [f64; 4] {
        [self.centre.x, self.centre.y, self.along.x, self.along.y]
    }

    /// Whether all points of the arc surely lie outside of the disc around `point`.
    pub(super) fn is_outside(&self, point: Vector, tau: f64) -> bool {
        let away = (self.centre - point) / tau;
        let distance = away.length();
        let outside = away.dot(self.along) - distance * self.spread + 0.5 * distance * distance;
        outside > ROUNDING * distance
    }
}

/// The middle of the box around an arc's directions, and the distance of its corners.
fn directions(arc: Span) -> (Vector, f64) {
    let [from, to] = [arc.from, arc.to].map(|turn| {
        let Direction { x, y, .. } = Direction::at(turn);
        Vector::new(x, y)
    });
    let (mut low, mut high) = (from.min(to), from.max(to));
    // Arcs do not pass turn 0; at turns 1, 2 and 3 they point along an axis.
    for (turn, axis) in [(1.0, Vector::Y), (2.0, -Vector::X), (3.0, -Vector::Y)] {
        if arc.from < turn && turn < arc.to {
            (low, high) = (low.min(axis), high.max(axis));
        }
    }
    let half = 0.5 * (high - low);
    (low + half, half.length())
}

/// The least and the greatest keys of some items, along each axis.
pub(super) fn ranges(items: &[Item]) -> [[f64; 4]; 2] {
    let mut ranges = [[f64::INFINITY; 4], [f64::NEG_INFINITY; 4]];
    for (axis, key) in items.iter().flat_map(|item| item.keys().into_iter().enumerate()) {
        ranges[0][axis] = ranges[0][axis].min(key);
        ranges[1][axis] = ranges[1][axis].max(key);
    }
    ranges
}

impl Bound {
    /// The bound of some items; of none, one that is no number and means nothing.
    pub(super) fn of(items: &[Item], tau: f64) -> Self {
        let [low, high] = ranges(items);
        let [x, y, u, v] = std::array::from_fn(|axis| low[axis] + 0.5 * (high[axis] - low[axis]));
        let mut bound = Self {
            centre: Vector::new(x, y),
            radius: 0.0,
            along: Vector::new(u, v),
            spread: 0.0,
            least: f64::INFINITY,
            middle: Vector::ZERO,
            reach: 0.0,
        };
        // The middle of the box around the items' points, roughly: all else is relative to it.
        let ends = (Vector::INFINITY, Vector::NEG_INFINITY);
        let points = items.iter().map(|item| item.point(bound.centre, tau));
        let (low, high) = points.fold(ends, |(low, high), at| (low.min(at), high.max(at)));
        bound.middle = low + 0.5 * (high - low);
        items.iter().for_each(|item| bound.include(item, tau));
        bound
    }

    pub(super) fn include(&mut self, item: &Item, tau: f64) {
        let away = (item.centre - self.centre) / tau;
        let aside = away + item.along - self.middle;
        self.reach = self.reach.max(aside.length() + item.spread);
        self.radius = self.radius.max(away.length());
        self.spread = self.spread.max((item.along - self.along).length() + item.spread);
        self.least = self.least.min(away.dot(self.along));
    }

    /// Takes the bounds of two halves for its own, where they are narrower.
    pub(super) fn narrow<'a>(&mut self, halves: impl Iterator<Item = &'a Self>, tau: f64) {
        let (mut radius, mut spread, mut reach) = (0.0_f64, 0.0_f64, 0.0_f64);
        let mut least = f64::INFINITY;
        for half in halves {
            let away = (half.centre - self.centre) / tau;
            let turned = (half.along - self.along).length();
            reach = reach.max((away + half.middle - self.middle).length() + half.reach);
            radius = radius.max(away.length() + half.radius);
            spread = spread.max(turned + half.spread);
            least = least.min(away.dot(self.along) + half.least - half.radius * turned);
        }
        self.reach = self.reach.min(reach);
        self.radius = self.radius.min(radius);
        self.spread = self.spread.min(spread);
        self.least = self.least.max(least);
    }

    /// Whether all points of the arcs surely lie outside of the disc around `point`.
    #[inline]
    pub(super) fn is_outside(&self, point: Vector, tau: f64) -> bool {
        let away = (self.centre - point) / tau;
        let beyond = 1.0 + self.reach + ROUNDING;
        if (away + self.middle).length_squared() > beyond * beyond {
            return true;
        }
        let distance = away.length();
        let gap = (distance - self.radius).max(0.0);
        let size = distance + self.radius;
        let outside = away.dot(self.along) + self.least - size * self.spread + 0.5 * gap * gap;
        outside > ROUNDING * size
    }
}

/// What rounding may add to a bound, as a share of the crowd's size.
const ROUNDING: f64 = 1e-12;
