//! Which parts of a new circle are exposed, where rounding hides who crosses whom.
//!
//! Where circles meet in common points - on lattices, say - a crossing may lie at the very end
//! of an exposed arc. Then what each older disc near covers of the new circle, also those without
//! boundary, is laid side by side, and what is left over is exposed. It costs a look at all of
//! them, and needs no decision: an error in a crossing moves an end by as much.

use smallvec::SmallVec;

use super::circle::{Arc, Contact, Direction, Neighbour};
use super::grid::Grid;

/// The parts of the circle around `centre` that lie in no disc.
#[cold]
pub(crate) fn exposed(centre: (f64, f64), tau: f64, grid: &Grid) -> SmallVec<[Arc; 2]> {
    let mut covered = Vec::new();
    for stored in grid.stored_around(centre.0, centre.1) {
        let other = Neighbour::new(stored, centre, tau);
        if other.is_same() {
            return SmallVec::new();
        }
        if other.is_near()
            && let Some(contact) = Contact::with(&other, centre, tau)
        {
            let (one, rest) = Arc::between(contact.from, contact.to);
            covered.push(one);
            covered.extend(rest);
        }
    }
    covered.sort_unstable_by(|a, b| a.from.turn.total_cmp(&b.from.turn));
    let mut exposed = SmallVec::new();
    let mut reached = Direction::START;
    for arc in covered {
        if arc.from.turn > reached.turn {
            exposed.push(Arc { from: reached, to: arc.from });
        }
        if arc.to.turn > reached.turn {
            reached = arc.to;
        }
    }
    if reached.turn < Direction::END.turn {
        exposed.push(Arc { from: reached, to: Direction::END });
    }
    exposed
}
