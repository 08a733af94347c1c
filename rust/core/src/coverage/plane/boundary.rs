//! The union's boundary as closed loops of arcs.
//!
//! Each disc knows its exposed arcs; which arc follows which, the places of their ends tell
//! ([`following`]). Every arc runs counter-clockwise around its own centre, and so the union lies
//! on the left of each loop. Arcs are put in order at first, and loops are begun at their first
//! arc: nothing depends on the order of insertion, but for the rounding of arcs' ends.

use std::cmp::Ordering;
use std::f64::consts::TAU;

use super::circle::{Direction, Span};
use super::joints::following;
use super::{Disc, Discs};

/// Part of the circle of radius tau around an effect, counter-clockwise, that no other disc covers.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct BoundaryArc {
    /// The first coordinate of the circle's centre, as the effect was given.
    pub x: f64,
    /// The second coordinate.
    pub y: f64,
    /// Where the arc begins: an angle from +x, in radians, in [0, 2 pi).
    pub from: f64,
    /// Where it ends: more than `from`, by 2 pi at most - then it is the whole circle.
    pub to: f64,
}

/// An exposed arc, and where it begins and ends as seen from its centre.
#[derive(Debug, Clone, Copy)]
pub(crate) struct Exposed {
    pub arc: BoundaryArc,
    pub from: Direction,
    pub to: Direction,
}

/// Shorter loops, in radii, are what rounding leaves where circles meet in a point.
const SHORTEST: f64 = 1e-9;

impl Discs {
    /// The boundary's loops: outer ones counter-clockwise, holes clockwise; a disc on its own is a
    /// loop of one arc. Loops shorter than a billionth of a radius are left out.
    ///
    /// A loop begins with the least of its arcs by (`x`, `y`, `from`), and loops are in the order of
    /// these. Costs one pass over the boundary, and sorting it.
    pub fn boundary(&self) -> Vec<Vec<BoundaryArc>> {
        let mut exposed: Vec<Exposed> = self.grid.discs().flat_map(exposed_arcs).collect();
        // Adding 0 makes -0 a 0.
        let key = |Exposed { arc, .. }: &Exposed| [arc.x, arc.y, arc.from].map(|x| x + 0.0);
        exposed.sort_unstable_by(|a, b| {
            let mut orders = key(a).into_iter().zip(key(b)).map(|(a, b)| a.total_cmp(&b));
            orders.find(|order| order.is_ne()).unwrap_or(Ordering::Equal)
        });
        let next = following(&exposed, self.tau);
        let mut told = vec![false; exposed.len()];
        let mut loops = Vec::new();
        for start in 0..exposed.len() {
            let (mut arcs, mut length, mut index) = (Vec::new(), 0.0, start);
            while !told[index] {
                told[index] = true;
                let arc = exposed[index].arc;
                arcs.push(arc);
                length += arc.to - arc.from;
                index = next[index];
            }
            if length >= SHORTEST {
                loops.push(arcs);
            }
        }
        loops
    }
}

/// A disc's exposed arcs. Those that meet where the circle begins and ends are one.
fn exposed_arcs(disc: &Disc) -> impl Iterator<Item = Exposed> {
    let mut spans = disc.arcs.clone();
    spans.retain(|span| span.from < span.to);
    spans.sort_unstable_by(|a, b| a.from.total_cmp(&b.from));
    let mut first = 0;
    if let [begin, .., end] = &mut spans[..]
        && begin.from == 0.0
        && end.to == 4.0
    {
        end.to = begin.to;
        first = 1;
    }
    let (x, y) = (disc.x, disc.y);
    spans.into_iter().skip(first).filter_map(move |span| exposed_arc(x, y, span))
}

/// An arc that passes over turn 0 if it ends before it begins. None if it has no length in radians.
fn exposed_arc(x: f64, y: f64, span: Span) -> Option<Exposed> {
    let (begin, end) = (Direction::at(span.from), Direction::at(span.to));
    let (mut from, mut to) = (angle(begin), angle(end));
    if span.to <= span.from {
        to += TAU;
    }
    if from >= TAU {
        (from, to) = (from - TAU, to - TAU);
    }
    let arc = BoundaryArc { x, y, from, to: to.min(from + TAU) };
    (arc.to > arc.from).then_some(Exposed { arc, from: begin, to: end })
}

/// A direction's angle: 0 at turn 0, 2 pi at turn 4.
fn angle(Direction { turn, x, y }: Direction) -> f64 {
    let angle = libm::atan2(y, x);
    if turn > 2.0 { angle + TAU } else { angle }
}

impl Exposed {
    /// Whether it is all of its circle, and so a loop of its own.
    pub fn is_circle(&self) -> bool {
        self.arc.to >= self.arc.from + TAU
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use smallvec::smallvec;
    use std::f64::consts::{FRAC_PI_2, PI};

    fn arcs(spans: &[(f64, f64)]) -> Vec<(f64, f64)> {
        let arcs = spans.iter().map(|&(from, to)| Span { from, to }).collect();
        let disc = Disc { x: 1.0, y: 2.0, arcs };
        exposed_arcs(&disc).map(|exposed| (exposed.arc.from, exposed.arc.to)).collect()
    }

    #[test]
    fn arcs_that_meet_at_turn_0_are_one() {
        assert_eq!(arcs(&[(0.0, 4.0)]), [(0.0, TAU)]);
        assert_eq!(arcs(&[(3.0, 4.0), (0.0, 1.0)]), [(1.5 * PI, 2.5 * PI)]);
        assert_eq!(
            arcs(&[(3.0, 4.0), (1.0, 2.0), (0.0, 0.5)]),
            [(FRAC_PI_2, PI), (1.5 * PI, 2.25 * PI)]
        );
        assert_eq!(arcs(&[(2.0, 4.0), (0.0, 2.0)]), [(PI, 3.0 * PI)]);
        assert_eq!(arcs(&[(0.0, 1.0), (3.0, 3.5)]), [(0.0, FRAC_PI_2), (1.5 * PI, 1.75 * PI)]);
        assert_eq!(arcs(&[(3.0, 4.0)]), [(1.5 * PI, TAU)]);
    }

    #[test]
    fn angles_stay_in_range_beside_turn_0() {
        let below = 4.0_f64.next_down();
        for spans in [&[(below, 4.0), (0.0, 1.0)][..], &[(below, 4.0)], &[(0.0, 1e-300)]] {
            for (from, to) in arcs(spans) {
                assert!((0.0..TAU).contains(&from) && from < to && to <= from + TAU, "{from} {to}");
            }
        }
        assert_eq!(arcs(&[(1.0, 1.0), (4.0, 4.0), (0.0, 0.0)]), []);
        let whole = Disc { x: 0.0, y: 0.0, arcs: smallvec![Span { from: 0.0, to: 4.0 }] };
        assert!(exposed_arcs(&whole).all(|exposed| exposed.is_circle()));
    }
}
