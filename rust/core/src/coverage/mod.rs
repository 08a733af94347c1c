//! The exact area of a growing union of equal discs: the paper's diversity measure.
//!
//! The union is known by its boundary: each stored disc keeps those arcs of its circle that
//! lie in no other disc. What a new disc adds is the area of its part outside of the union,
//! and Green's theorem gives it from that part's boundary alone: the new circle's own exposed
//! arcs, minus the stretches of older arcs that the new disc swallows. A disc with no exposed
//! arc that swallows nothing changes nothing and is not stored, so crowded places stay cheap.
//!
//! All of it happens in coordinates relative to the new centre, in units of the radius: the
//! result does not depend on where the discs lie, and its error is some 1e-16 of a disc's
//! area for each arc involved. Both circles of a crossing share one computation of it, so the
//! boundary closes: own arcs and swallowed stretches meet end to end.

mod circle;
mod grid;
mod sum;
mod survey;

use smallvec::SmallVec;

use crate::error::{Error, check_finite, check_length, check_rows};
use circle::Arc;
use grid::{Entry, Grid};
use sum::CompensatedSum;
use survey::{Survey, twice_area_under};

/// The union of the discs of radius tau around effects in the plane.
#[derive(Debug, Clone)]
pub struct Coverage {
    tau: f64,
    len: usize,
    measure: CompensatedSum,
    /// The exposed arcs of each stored disc.
    exposed: Vec<SmallVec<[Arc; 2]>>,
    grid: Grid,
    survey: Survey,
}

impl Coverage {
    /// The empty union of discs of radius `tau`.
    ///
    /// # Errors
    /// If `tau` is not in [1e-100, 1e100]: its square must be a normal number.
    pub fn new(tau: f64) -> Result<Self, Error> {
        if !(1e-100..=1e100).contains(&tau) {
            return Err(Error::Number {
                name: "tau",
                must_be: "a positive radius in [1e-100, 1e100]",
                got: tau,
            });
        }
        Ok(Self {
            tau,
            len: 0,
            measure: CompensatedSum::default(),
            exposed: Vec::new(),
            grid: Grid::new(2.0 * tau),
            survey: Survey::default(),
        })
    }

    /// The radius of the discs.
    #[must_use]
    pub fn tau(&self) -> f64 {
        self.tau
    }

    /// How many effects have been added.
    #[must_use]
    pub fn len(&self) -> usize {
        self.len
    }

    /// Whether none has.
    #[must_use]
    pub fn is_empty(&self) -> bool {
        self.len == 0
    }

    /// How many discs had to be stored: the others lay wholly in the union.
    #[must_use]
    pub fn stored(&self) -> usize {
        self.exposed.len()
    }

    /// The area of the union.
    #[must_use]
    pub fn measure(&self) -> f64 {
        self.measure.total()
    }

    /// The area of one disc, which no gain exceeds.
    #[must_use]
    pub fn disc_area(&self) -> f64 {
        std::f64::consts::PI * self.tau * self.tau
    }

    /// The area that `effect` would add, without adding it.
    ///
    /// # Errors
    /// If `effect` is not finite.
    pub fn gain(&mut self, effect: [f64; 2]) -> Result<f64, Error> {
        check_finite("effect", &effect, 2)?;
        self.look_at(effect);
        Ok(self.surveyed_gain())
    }

    /// Adds an effect and returns its gain, the area that it adds.
    ///
    /// # Errors
    /// If `effect` is not finite; nothing is added then.
    pub fn add(&mut self, effect: [f64; 2]) -> Result<f64, Error> {
        check_finite("effect", &effect, 2)?;
        Ok(self.insert(effect))
    }

    /// Adds effects (x and y of each in turn) and writes the gain of each.
    ///
    /// # Errors
    /// If one of them is not finite, `effects` does not hold whole pairs or `gains` not one
    /// number for each; nothing is added then.
    pub fn extend(&mut self, effects: &[f64], gains: &mut [f64]) -> Result<(), Error> {
        check_rows("effects", effects, 2)?;
        check_length("gains", gains, effects.len() / 2)?;
        check_finite("effects", effects, 2)?;
        for (gain, effect) in gains.iter_mut().zip(effects.chunks_exact(2)) {
            *gain = self.insert([effect[0], effect[1]]);
        }
        Ok(())
    }

    fn insert(&mut self, effect: [f64; 2]) -> f64 {
        self.look_at(effect);
        let gain = self.surveyed_gain();
        self.len += 1;
        self.measure.add(gain);
        if self.survey.changes_boundary() {
            self.commit(effect);
        }
        gain
    }

    fn surveyed_gain(&self) -> f64 {
        // Rounding may carry the sum a few 1e-16 of a disc's area beyond what is possible.
        (0.5 * self.survey.twice_gain * self.tau * self.tau).clamp(0.0, self.disc_area())
    }

    fn look_at(&mut self, [x, y]: [f64; 2]) {
        self.survey.of_disc((x, y), self.tau, &self.grid, &self.exposed);
    }

    /// Makes the surveyed change.
    fn commit(&mut self, [x, y]: [f64; 2]) {
        for &(disc, from, to) in &self.survey.swallowing {
            let arcs = &mut self.exposed[disc as usize];
            // What the new disc leaves free goes the other way round the circle.
            let (one, other) = Arc::between(to, from);
            let left: SmallVec<[Arc; 2]> = arcs
                .iter()
                .flat_map(|&arc| [arc.common(one), other.and_then(|other| arc.common(other))])
                .flatten()
                .collect();
            *arcs = left;
        }
        let disc = self.exposed.len() as u32;
        self.exposed.push(std::mem::take(&mut self.survey.own));
        self.grid.insert(Entry { x, y, disc });
    }

    /// The area enclosed by the exposed arcs, from scratch: what [`measure`](Self::measure)
    /// has added up step by step. Costs one pass over all discs.
    #[must_use]
    pub fn boundary_integral(&self) -> f64 {
        let mut twice = CompensatedSum::default();
        for entry in self.grid.entries() {
            let (cx, cy) = (entry.x / self.tau, entry.y / self.tau);
            for &arc in &self.exposed[entry.disc as usize] {
                twice.add(twice_area_under(arc, (cx, cy)));
            }
        }
        0.5 * twice.total() * self.tau * self.tau
    }
}
