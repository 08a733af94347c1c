//! What a new disc would change: the arcs that it exposes and swallows, and the area that it adds.

use smallvec::SmallVec;

use super::circle::{Arc, Contact, Direction, Neighbour};
use super::grid::{Entry, Grid};

/// What a new disc would change. Kept between calls for its memory alone.
#[derive(Debug, Clone, Default)]
pub(crate) struct Survey {
    /// The stored discs that may overlap the new one.
    neighbours: Vec<Neighbour>,
    /// The parts of the new circle that lie in older discs, in any order.
    covered: Vec<Arc>,
    /// The parts that lie in none.
    pub own: SmallVec<[Arc; 2]>,
    /// Older discs of which arcs are swallowed, and the part of their circle inside the new disc.
    pub swallowing: Vec<(u32, Direction, Direction)>,
    /// Twice the area added, in squared radii.
    pub twice_gain: f64,
}

impl Survey {
    /// Finds out what a disc at (`x`, `y`) would change.
    pub fn of_disc(
        &mut self,
        (x, y): (f64, f64),
        tau: f64,
        grid: &Grid,
        exposed: &[SmallVec<[Arc; 2]>],
    ) {
        self.clear();
        self.find_neighbours(grid, tau, (x, y));
        if self.neighbours.iter().any(|near| near.squared < f64::MIN_POSITIVE) {
            return; // a duplicate: nothing changes
        }
        for index in 0..self.neighbours.len() {
            let other = self.neighbours[index];
            let Some(contact) = Contact::with(&other, (x, y), tau) else { continue };
            self.cover(contact);
            let arcs = &exposed[other.disc as usize];
            if !arcs.is_empty() {
                self.swallow(other.disc, arcs, contact, (other.dx, other.dy));
            }
        }
        self.expose();
    }

    /// Whether the union's boundary would change at all.
    pub fn changes_boundary(&self) -> bool {
        !self.own.is_empty() || !self.swallowing.is_empty()
    }

    fn clear(&mut self) {
        self.neighbours.clear();
        self.covered.clear();
        self.own.clear();
        self.swallowing.clear();
        self.twice_gain = 0.0;
    }

    /// Collects the stored discs that overlap a new one, or nearly do.
    ///
    /// Two in three centres in the cells around lie too far away, in no predictable order:
    /// each is written, and the place kept only if it is near.
    fn find_neighbours(&mut self, grid: &Grid, tau: f64, (x, y): (f64, f64)) {
        for cell in grid.around(x, y) {
            let start = self.neighbours.len();
            self.neighbours.resize(start + cell.len(), Neighbour::default());
            let mut end = start;
            for entry in cell {
                let (dx, dy) = ((entry.x - x) / tau, (entry.y - y) / tau);
                let squared = dx * dx + dy * dy;
                let Entry { x, y, disc } = *entry;
                self.neighbours[end] = Neighbour { disc, x, y, dx, dy, squared };
                // 4 but for rounding; what lies between, the contact decides precisely.
                end += usize::from(squared <= 4.000_000_000_001);
            }
            self.neighbours.truncate(end);
        }
    }

    /// Notes the part of the new circle that an older disc covers.
    #[inline]
    fn cover(&mut self, contact: Contact) {
        let (one, other) = Arc::between(contact.from, contact.to);
        self.covered.push(one);
        self.covered.extend(other);
    }

    /// Notes which of an older disc's exposed `arcs` lie in the new disc, and their integral.
    #[inline]
    fn swallow(&mut self, disc: u32, arcs: &[Arc], contact: Contact, centre: (f64, f64)) {
        let (from, to) = contact.swallowed();
        let (one, other) = Arc::between(from, to);
        let mut touched = false;
        for &arc in arcs {
            for part in [Some(one), other].into_iter().flatten() {
                if let Some(stretch) = arc.common(part) {
                    self.twice_gain -= twice_area_under(stretch, centre);
                    touched = true;
                }
            }
        }
        if touched {
            self.swallowing.push((disc, from, to));
        }
    }

    /// Finds the gaps that the covered parts leave on the new circle.
    fn expose(&mut self) {
        self.covered.sort_unstable_by(|a, b| a.from.turn.total_cmp(&b.from.turn));
        let mut reached = Direction::START;
        for arc in &self.covered {
            if arc.from.turn > reached.turn {
                self.own.push(Arc { from: reached, to: arc.from });
            }
            if arc.to.turn > reached.turn {
                reached = arc.to;
            }
        }
        if reached.turn < Direction::END.turn {
            self.own.push(Arc { from: reached, to: Direction::END });
        }
        for &arc in &self.own {
            self.twice_gain += arc.angle();
        }
    }
}

/// The integral of x dy - y dx along an arc of the unit circle around `(cx, cy)`.
#[inline]
pub(crate) fn twice_area_under(arc: Arc, (cx, cy): (f64, f64)) -> f64 {
    arc.angle() + (cx * (arc.to.y - arc.from.y) - cy * (arc.to.x - arc.from.x))
}
