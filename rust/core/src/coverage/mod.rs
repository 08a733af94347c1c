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

use smallvec::SmallVec;

use crate::error::{Error, check_finite, check_length, check_rows};
use circle::{Arc, Contact, Direction, Neighbour};
use grid::{Entry, Grid};

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

/// What a new disc would change. Kept between calls for its memory alone.
#[derive(Debug, Clone, Default)]
struct Survey {
    /// The stored discs that may overlap the new one.
    neighbours: Vec<Neighbour>,
    /// The parts of the new circle that lie in older discs, in any order.
    covered: Vec<Arc>,
    /// The parts that lie in none.
    own: SmallVec<[Arc; 2]>,
    /// Older discs of which arcs are swallowed, and the part of their circle inside the new disc.
    swallowing: Vec<(u32, Direction, Direction)>,
    /// Twice the area added, in squared radii.
    twice_gain: f64,
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
        self.explore(effect);
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
        self.explore(effect);
        let gain = self.surveyed_gain();
        self.len += 1;
        self.measure.add(gain);
        if !self.survey.own.is_empty() || !self.survey.swallowing.is_empty() {
            self.commit(effect);
        }
        gain
    }

    fn surveyed_gain(&self) -> f64 {
        // Rounding may carry the sum a few 1e-16 of a disc's area beyond what is possible.
        (0.5 * self.survey.twice_gain * self.tau * self.tau).clamp(0.0, self.disc_area())
    }

    /// Finds out what a disc at `effect` would change.
    fn explore(&mut self, [x, y]: [f64; 2]) {
        let Self { tau, exposed, grid, survey, .. } = self;
        survey.clear();
        survey.find_neighbours(grid, *tau, (x, y));
        if survey.neighbours.iter().any(|near| near.squared < f64::MIN_POSITIVE) {
            return; // a duplicate: nothing changes
        }
        for index in 0..survey.neighbours.len() {
            let other = survey.neighbours[index];
            let Some(contact) = Contact::with(&other, (x, y), *tau) else { continue };
            survey.cover(contact);
            let arcs = &exposed[other.disc as usize];
            if !arcs.is_empty() {
                survey.swallow(other.disc, arcs, contact, (other.dx, other.dy));
            }
        }
        survey.expose();
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

impl Survey {
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
fn twice_area_under(arc: Arc, (cx, cy): (f64, f64)) -> f64 {
    arc.angle() + (cx * (arc.to.y - arc.from.y) - cy * (arc.to.x - arc.from.x))
}

/// A sum that carries its rounding error along (Neumaier), so that a million gains do not drift.
#[derive(Debug, Clone, Copy, Default)]
struct CompensatedSum {
    sum: f64,
    error: f64,
}

impl CompensatedSum {
    fn add(&mut self, value: f64) {
        let sum = self.sum + value;
        self.error += if self.sum.abs() >= value.abs() {
            (self.sum - sum) + value
        } else {
            (value - sum) + self.sum
        };
        self.sum = sum;
    }

    fn total(&self) -> f64 {
        self.sum + self.error
    }
}
