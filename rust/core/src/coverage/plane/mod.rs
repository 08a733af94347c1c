//! The exact area of a growing union of equal discs in the plane.
//!
//! The union is known by its boundary: each disc keeps those arcs of its circle that lie in no
//! other. What a new disc adds is the area of its part outside of the union, and Green's theorem
//! gives it from that part's boundary alone: the new circle's own exposed arcs, minus the
//! stretches of older arcs that the new disc swallows. Discs without boundary - the new one, if
//! it exposes none, and older ones that have lost theirs - are not met again, so that a step
//! costs what the boundary nearby costs, not what has piled up below it.
//!
//! All of it happens in coordinates relative to the new centre, in units of the radius: the
//! result does not depend on where the discs lie, and its error is some 1e-16 of a disc's
//! area for each arc involved. Both circles of a crossing share one computation of it, so the
//! boundary closes: own arcs and swallowed stretches meet end to end.

mod area;
mod boundary;
mod circle;
mod covers;
mod crowd;
mod grid;
mod joints;
mod sectors;
mod survey;

use smallvec::SmallVec;

use crate::exact_sum::ExactSum;
use area::TwiceArea;
pub use boundary::BoundaryArc;
use circle::{Arc, Direction, Span};
use grid::Grid;
use survey::{Survey, Swallowing};

/// A disc and its exposed arcs; none once it has lost its boundary.
#[derive(Debug, Clone)]
struct Disc {
    x: f64,
    y: f64,
    arcs: SmallVec<[Span; 2]>,
}

impl Disc {
    /// Takes the part of the circle that lies inside another disc from the arcs.
    fn lose(&mut self, inside: Span) {
        let mut index = 0;
        while let Some(&arc) = self.arcs.get(index) {
            match arc.without(inside) {
                [None, None] => {
                    self.arcs.swap_remove(index);
                    continue;
                }
                [Some(left), None] | [None, Some(left)] => self.arcs[index] = left,
                [Some(left), Some(right)] => {
                    self.arcs[index] = left;
                    // Beside it, where this loop does not come by again.
                    self.arcs.insert(index, right);
                    index += 1;
                }
            }
            index += 1;
        }
    }
}

/// The union of the discs of radius tau around effects in the plane.
#[derive(Debug, Clone)]
pub(crate) struct Discs {
    tau: f64,
    grid: Grid,
    survey: Survey,
    /// What areas that came out negative have not yet been made up for: 0 or less.
    owed: f64,
}

impl Discs {
    pub fn new(tau: f64) -> Self {
        Self { tau, grid: Grid::new(tau), survey: Survey::default(), owed: 0.0 }
    }

    /// The area that a disc would add.
    ///
    /// What tiny areas lose by not being negative is taken from the next ones: a hundred thousand discs that add next
    /// to nothing would add up to 1e-12 of all.
    pub fn gain(&mut self, effect: [f64; 2]) -> f64 {
        self.survey.of_disc((effect[0], effect[1]), self.tau, &mut self.grid);
        let (area, is_noise) = self.surveyed();
        let owed = if is_noise { self.owed } else { 0.0 };
        (area + owed).clamp(0.0, std::f64::consts::PI * self.tau * self.tau)
    }

    /// Adds a disc; returns the area that it adds.
    pub fn insert(&mut self, effect: [f64; 2]) -> f64 {
        let gain = self.gain(effect);
        let (area, is_noise) = self.surveyed();
        if is_noise {
            self.owed = (self.owed + area).min(0.0);
        }
        let Survey { own, swallowing, .. } = &self.survey;
        if self.survey.changes_boundary() {
            // Backwards: where a disc is set aside, one behind it may take its place.
            for &Swallowing { cell, place, inside } in swallowing.iter().rev() {
                self.grid.cells[cell as usize].swallow(place as usize, inside);
            }
            let arcs = own.iter().map(|arc| arc.span()).collect();
            self.grid.insert(Disc { x: effect[0], y: effect[1], arcs });
        }
        gain
    }

    /// The surveyed area, and whether it may be made of rounding alone: that may carry it a few 1e-16 of a disc's area
    /// beyond what is possible.
    fn surveyed(&self) -> (f64, bool) {
        let area = 0.5 * self.survey.twice_gain * self.tau * self.tau;
        (area, area.abs() < 1e-12 * self.tau * self.tau)
    }

    /// The area enclosed by the exposed arcs, from scratch: what the gains add up to, step by
    /// step. Costs one pass over the boundary.
    pub fn boundary_integral(&self) -> f64 {
        let mut twice = ExactSum::default();
        for disc in self.grid.discs() {
            let centre = (disc.x / self.tau, disc.y / self.tau);
            for arc in &disc.arcs {
                let (from, to) = (Direction::at(arc.from), Direction::at(arc.to));
                let mut area = TwiceArea::default();
                area.add(Arc { from, to }, centre, 1.0);
                twice.add(area.total());
            }
        }
        0.5 * twice.value() * self.tau * self.tau
    }
}
