//! Which exposed arc follows which: where one ends, another begins.
//!
//! Two arcs that meet share one computation of their crossing, so that the places of end and
//! start agree to some 1e-15 of a radius. Starts are filed by place in a grid of cells little
//! wider than that, and each end takes what it finds there; whatever is left over, in wider and
//! wider cells. Where several starts are as near - vertices closer together than can be told, or
//! loops that touch - the exterior decides: around a vertex it is what lies outside of
//! all discs, a single wedge, and it lies between the way back along the arc that ends and the
//! arc that follows, counter-clockwise.
//!
//! Far from the origin the sum of a centre and a direction has lost its digits, but not the
//! difference of two centres: distances are taken from that, and a place is filed as a whole
//! number of units and the rest.

use rustc_hash::FxHashMap;
use smallvec::SmallVec;

use super::boundary::Exposed;
use super::circle::Direction;

/// For each arc, the index of the one that follows it on its loop. Each follows one other.
pub(crate) fn following(arcs: &[Exposed], tau: f64) -> Vec<usize> {
    let mut next = vec![NONE; arcs.len()];
    let mut begun = vec![false; arcs.len()];
    let mut open = Vec::new();
    for (index, arc) in arcs.iter().enumerate() {
        if arc.is_circle() {
            (next[index], begun[index]) = (index, true);
        } else {
            open.push(index);
        }
    }
    for width in 0..WIDTHS {
        if open.is_empty() {
            break;
        }
        let mut starts = Starts::new(arcs, tau, width);
        (0..arcs.len()).filter(|&start| !begun[start]).for_each(|start| starts.file(start));
        open.retain(|&end| {
            let Some(start) = starts.take(end) else { return true };
            (next[end], begun[start]) = (start, true);
            false
        });
    }
    // Chains that nothing continues are closed by a jump.
    for start in (0..arcs.len()).filter(|&start| !begun[start]) {
        let mut last = start;
        while next[last] != NONE {
            last = next[last];
        }
        next[last] = start;
    }
    next
}

const NONE: usize = usize::MAX;

/// An end and a start may be 2^-46 radii apart, then 8 times as far, and so on up to 1/1024.
const WIDTHS: u32 = 13;
const NARROWEST: i32 = -46;

/// How many starts in a cell are looked at: so many meet nowhere, and the cost stays linear.
const LOOKS: usize = 64;

/// The arcs' beginnings by place.
struct Starts<'a> {
    arcs: &'a [Exposed],
    tau: f64,
    /// How far apart an end and a start may be, in radii, and that squared.
    near_squared: f64,
    /// A power of two, at most the radius and more than half of it, ...
    unit: f64,
    /// ... and how many cells it holds. A cell is at least twice as wide as `near`.
    cells_in_unit: i64,
    cells: FxHashMap<(i64, i64), SmallVec<[u32; 2]>>,
}

impl<'a> Starts<'a> {
    fn new(arcs: &'a [Exposed], tau: f64, width: u32) -> Self {
        let near = libm::ldexp(1.0, NARROWEST + 3 * width as i32);
        Self {
            arcs,
            tau,
            near_squared: near * near,
            unit: f64::from_bits(tau.to_bits() & f64::INFINITY.to_bits()),
            cells_in_unit: 1 << (-2 - NARROWEST - 3 * width as i32),
            cells: FxHashMap::default(),
        }
    }

    /// The cell in which the point of a circle lies.
    fn cell(&self, x: f64, y: f64, direction: Direction) -> (i64, i64) {
        let along = |x: f64, direction: f64| {
            let quotient = x / self.unit; // exact
            let whole = quotient.floor();
            let (whole, rest) = if whole.abs() < 4e18 {
                (whole as i64, quotient - whole)
            } else {
                (x.to_bits() as i64, 0.0) // only circles with the same x meet here
            };
            let rest = rest + direction * (self.tau / self.unit);
            let cells = (rest * self.cells_in_unit as f64).floor() as i64;
            // Wrapped numbers bring far places together; their distance tells them apart.
            whole.wrapping_mul(self.cells_in_unit).wrapping_add(cells)
        };
        (along(x, direction.x), along(y, direction.y))
    }

    fn file(&mut self, start: usize) {
        let Exposed { arc, from, .. } = self.arcs[start];
        self.cells.entry(self.cell(arc.x, arc.y, from)).or_default().push(start as u32);
    }

    /// Takes out the start that follows an end, if there is one.
    fn take(&mut self, end: usize) -> Option<usize> {
        let Exposed { arc, to, .. } = self.arcs[end];
        let (i, j) = self.cell(arc.x, arc.y, to);
        let mut best: Option<(f64, (i64, i64), usize)> = None;
        for step in 0..9 {
            let cell = (i.wrapping_add(step % 3 - 1), j.wrapping_add(step / 3 - 1));
            let Some(starts) = self.cells.get(&cell) else { continue };
            for (place, &start) in starts.iter().enumerate().take(LOOKS) {
                let start = &self.arcs[start as usize];
                if self.squared_distance(&self.arcs[end], start) > self.near_squared {
                    continue;
                }
                let turn = exterior(to, start.from);
                if best.is_none_or(|(least, ..)| turn < least) {
                    best = Some((turn, cell, place));
                }
            }
        }
        let (_, cell, place) = best?;
        Some(self.cells.get_mut(&cell)?.swap_remove(place) as usize)
    }

    /// How far one arc's end is from another's start, in radii, squared.
    fn squared_distance(&self, end: &Exposed, start: &Exposed) -> f64 {
        let dx = (start.arc.x - end.arc.x) / self.tau + (start.from.x - end.to.x);
        let dy = (start.arc.y - end.arc.y) / self.tau + (start.from.y - end.to.y);
        dx * dx + dy * dy
    }
}

/// The turn from the way back along the arc that ends at `end` to the one that begins at `start`.
fn exterior(end: Direction, start: Direction) -> f64 {
    let along = -(end.x * start.x + end.y * start.y);
    let across = -(end.x * start.y - end.y * start.x);
    let turn = Direction::new(along, across).turn;
    // A wedge that is but a cusp may be less than none by rounding.
    if turn > 4.0 - CUSP { turn - 4.0 } else { turn }
}

const CUSP: f64 = 1e-6;

#[cfg(test)]
mod tests {
    use super::super::boundary::BoundaryArc;
    use super::*;

    /// An arc of the unit circle around (x, y), between directions given by turns.
    fn arc(x: f64, y: f64, from: f64, to: f64) -> Exposed {
        // The angles play no part but for whole circles.
        let arc = BoundaryArc { x, y, from: 0.0, to: 1.0 };
        Exposed { arc, from: Direction::at(from), to: Direction::at(to) }
    }

    #[test]
    fn ends_and_starts_may_be_some_way_apart() {
        for gap in [0.0, 1e-15, 1e-12, 1e-9, 1e-6, 5e-4] {
            for far in [0.0, 1e3, 2.0_f64.powi(40)] {
                // The outer halves of two discs side by side, pulled apart.
                let gap = if far > 1e6 { 0.0 } else { gap };
                let arcs = [
                    arc(far, 0.0, 2.0, 4.0),
                    arc(far + 9.0, 0.0, 1.0, 3.0),
                    arc(far, gap, 0.0, 2.0),
                    arc(far + 9.0, gap, 3.0, 1.0),
                ];
                assert_eq!(following(&arcs, 1.0), [2, 3, 0, 1], "{gap} {far}");
            }
        }
    }

    #[test]
    fn what_nothing_continues_is_closed() {
        let arcs = [arc(0.0, 0.0, 0.5, 1.0), arc(0.0, 0.0, 1.0, 1.5), arc(9.0, 0.0, 3.0, 3.5)];
        assert_eq!(following(&arcs, 1.0), [1, 0, 2]);
        assert_eq!(following(&arcs[..1], 1.0), [0]);
        assert_eq!(following(&[], 1.0), [0; 0]);
    }

    #[test]
    fn where_several_begin_the_exterior_decides() {
        // Four circles through the origin. The first one's arc comes in upwards: counter-clockwise
        // from below it meets the last one, which leaves to the right, before the second one, to
        // the left. The third one's comes in downwards.
        let arcs = [
            arc(-1.0, 0.0, 3.0, 4.0),
            arc(0.0, -1.0, 1.0, 2.0),
            arc(1.0, 0.0, 1.0, 2.0),
            arc(0.0, 1.0, 3.0, 4.0),
        ];
        let next = following(&arcs, 1.0);
        assert_eq!((next[0], next[2]), (3, 1));
    }

    #[test]
    fn far_places_are_told_apart() {
        // Cells so far away have numbers beyond 2^63.
        let far = 2.0_f64.powi(40);
        let pair = |i| {
            let x = far + 4.0 * f64::from(i);
            [arc(x, 0.0, 1.0, 2.0), arc(x - 1.0, 1.0, 3.0, 3.5)]
        };
        let arcs: Vec<_> = (0..500).flat_map(pair).collect();
        let next = following(&arcs, 1.0);
        assert!((0..arcs.len()).all(|index| next[index] == index ^ 1));
    }

    #[test]
    fn thousands_that_begin_in_one_place_are_each_followed_once() {
        let arcs: Vec<_> = (0..30_000).map(|_| arc(0.0, 0.0, 1.0, 1.0)).collect();
        let mut next = following(&arcs, 1.0);
        next.sort_unstable();
        assert!(next.into_iter().eq(0..arcs.len()));
    }
}
