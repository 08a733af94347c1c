//! What a new disc would change: the arcs that it exposes and swallows, and the area that it adds.
//!
//! Along the new circle the union is entered and left only where exposed arcs are crossed. So
//! the discs with exposed arcs are all that is looked at, however many others lie below, and
//! the crossings alone tell which parts of the new circle are exposed: from where it leaves the
//! union to where it enters it again.

use smallvec::SmallVec;

use super::area::TwiceArea;
use super::circle::{Arc, Contact, Direction, Neighbour, Span};
use super::covers;
use super::grid::Grid;

/// What a new disc would change. Kept between calls for its memory alone.
#[derive(Debug, Clone, Default)]
pub(crate) struct Survey {
    /// The cells and places of discs whose exposed arcs may reach into the new one, ...
    met: Vec<(u32, u32)>,
    /// ... and what is seen of those that may overlap it, with cell and place.
    neighbours: Vec<(Neighbour, u32, u32)>,
    /// Where the new circle crosses exposed arcs.
    crossings: SmallVec<[Crossing; 8]>,
    /// The parts of the new circle that lie in no older disc.
    pub own: SmallVec<[Arc; 2]>,
    /// Older discs of which arcs are swallowed.
    pub swallowing: Vec<Swallowing>,
    area: TwiceArea,
    /// Twice the area added, in squared radii.
    pub twice_gain: f64,
}

/// An older disc - its cell and place - and the part of its circle inside the new disc.
#[derive(Debug, Clone, Copy)]
pub(crate) struct Swallowing {
    pub cell: u32,
    pub place: u32,
    pub inside: Span,
}

/// Where the new circle leaves the union, or enters it.
#[derive(Debug, Clone, Copy, Default)]
struct Crossing {
    at: Direction,
    leaves: bool,
}

impl Survey {
    /// Finds out what a disc at (`x`, `y`) would change.
    pub fn of_disc(&mut self, (x, y): (f64, f64), tau: f64, grid: &mut Grid) {
        self.clear();
        self.find_neighbours(grid, tau, (x, y));
        if self.neighbours.iter().any(|(near, ..)| near.is_same()) {
            return; // a duplicate: nothing changes
        }
        let (mut overlaps, mut unclear) = (false, false);
        for index in 0..self.neighbours.len() {
            let (other, cell, place) = self.neighbours[index];
            let Some(contact) = Contact::with(&other, (x, y), tau) else { continue };
            overlaps = true;
            let arcs = &grid.cells[cell as usize].live[place as usize].arcs;
            let (touched, hidden) = self.meet(&other, arcs, contact);
            unclear |= hidden;
            if touched {
                let inside = contact.swallowed().span();
                self.swallowing.push(Swallowing { cell, place, inside });
            }
        }
        if unclear || !self.expose() {
            self.own = covers::exposed((x, y), tau, grid);
        } else if self.crossings.is_empty() && !overlaps && !grid.is_inside(x, y) {
            self.own.push(Arc::CIRCLE);
        }
        for &arc in &self.own {
            self.area.add(arc, (0.0, 0.0), 1.0);
        }
        self.twice_gain = self.area.total();
        let noise = self.twice_gain.abs() < NOISE && self.changes_boundary();
        if noise && grid.has_buried([x, y]) {
            self.clear(); // a disc that has lost its boundary comes again: all else is rounding
        }
    }

    /// Whether the union's boundary would change at all.
    pub fn changes_boundary(&self) -> bool {
        !self.own.is_empty() || !self.swallowing.is_empty()
    }

    fn clear(&mut self) {
        self.crossings.clear();
        self.own.clear();
        self.swallowing.clear();
        self.area = TwiceArea::default();
        self.twice_gain = 0.0;
    }

    /// Collects the discs whose exposed arcs may reach into a new one.
    fn find_neighbours(&mut self, grid: &mut Grid, tau: f64, (x, y): (f64, f64)) {
        grid.meeting(x, y, &mut self.met);
        self.neighbours.resize(self.met.len(), Default::default());
        let mut count = 0;
        for &(cell, place) in &self.met {
            let disc = &grid.cells[cell as usize].live[place as usize];
            let near = Neighbour::new([disc.x, disc.y], (x, y), tau);
            self.neighbours[count] = (near, cell, place);
            count += usize::from(near.is_near());
        }
        self.neighbours.truncate(count);
    }

    /// Notes where the new circle crosses an older disc's exposed `arcs`. Tells whether any of these lie in the new disc,
    /// and whether a crossing is too close to an arc's end to tell.
    #[inline]
    fn meet(&mut self, other: &Neighbour, arcs: &[Span], contact: Contact) -> (bool, bool) {
        let inside = contact.swallowed();
        let (one, rest) = Arc::between(inside.from, inside.to);
        let Span { from, to } = inside.span();
        let (mut touched, mut unclear) = (false, false);
        // Whether the crossings at the beginning and at the end of what lies inside are exposed.
        let (mut begins, mut ends) = (false, false);
        for &arc in arcs {
            for part in [Some(one), rest].into_iter().flatten() {
                if let Some(stretch) = arc.part_of(part) {
                    self.area.add(stretch, (other.dx, other.dy), -1.0);
                    touched = true;
                }
            }
            let at_begin = (from - arc.from).min(arc.to - from);
            let at_end = (to - arc.from).min(arc.to - to);
            begins |= at_begin > 0.0;
            ends |= at_end > 0.0;
            unclear |= (at_begin.abs() < UNSURE) | (at_end.abs() < UNSURE);
        }
        // Seen from the new centre, the crossings change sides.
        if begins {
            self.crossings.push(Crossing { at: contact.to, leaves: true });
        }
        if ends {
            self.crossings.push(Crossing { at: contact.from, leaves: false });
        }
        (touched, unclear)
    }

    /// Finds the exposed parts from the crossings; `false` if those don't fit together, or if
    /// rounding hides which of two comes first: a circle through the point where two discs touch
    /// leaves one and enters the other there, and the other way round all else were exposed.
    fn expose(&mut self) -> bool {
        let crossings = &mut self.crossings;
        if crossings.is_empty() {
            return true;
        }
        crossings.sort_by(|a, b| a.at.turn.total_cmp(&b.at.turn));
        let mut before = crossings[crossings.len() - 1];
        let mut before_turn = before.at.turn - 4.0;
        for &crossing in crossings.iter() {
            let gap = crossing.at.turn - before_turn;
            before_turn = crossing.at.turn;
            if before.leaves == crossing.leaves || gap < UNSURE {
                self.own.clear();
                return false;
            }
            if before.leaves {
                let (one, rest) = Arc::between(before.at, crossing.at);
                self.own.push(one);
                self.own.extend(rest);
            }
            before = crossing;
        }
        true
    }
}

/// How close to an arc's end, in turns, a crossing must be to be told by other means. Ends are
/// right to some 1e-15.
const UNSURE: f64 = 1e-12;

/// Twice the area, in squared radii, up to which a gain may be rounding alone. What was measured
/// of a repeated disc is 1e-14.
const NOISE: f64 = 1e-12;
