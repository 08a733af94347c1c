//! The diversity measure: what a growing set of effects covers.
//!
//! C_tau(E) is the measure of the union of the balls of radius tau around the effects E, and an
//! effect's gain what it adds to that (Benureau and Oudeyer, ICDL-EpiRob 2015). [`Coverage`] is
//! the one interface; behind it stands a kernel for each kind of space: intervals (`line`), discs
//! (`plane`) and balls ([`space`]) exactly, more dimensions by an [`estimate`] that knows its
//! error.

mod cubes;
pub mod estimate;
mod line;
mod plane;
pub mod space;
mod union;

use crate::error::{
    Error, check_each, check_finite, check_length, check_number, check_rows, place,
};
use crate::exact_sum::ExactSum;
use crate::kdtree::NearestNeighbors;
pub use estimate::Estimated;
pub use plane::BoundaryArc;
use union::HIGHEST;
pub use union::Sampling;
pub(crate) use union::Union;

/// The union of the balls of radius tau around effects, and what each effect added to it.
#[derive(Debug, Clone)]
pub struct Coverage {
    tau: f64,
    dim: usize,
    sampling: Sampling,
    union: Union,
    /// All effects, to be searched once somebody asks where they lie.
    effects: NearestNeighbors,
    /// What each gained and, if estimated, its error.
    gains: Vec<f64>,
    errors: Vec<f64>,
    measure: ExactSum,
    variance: ExactSum,
}

impl Coverage {
    /// The empty union of balls of radius `tau` in `dim` dimensions; with more than three,
    /// estimated to the default accuracy.
    ///
    /// # Errors
    /// See [`sampled`](Self::sampled).
    pub fn new(tau: f64, dim: usize) -> Result<Self, Error> {
        Self::sampled(tau, dim, Sampling::default())
    }

    /// The empty union of balls of radius `tau` in `dim` dimensions.
    ///
    /// # Errors
    /// If `tau` is not in [1e-100, 1e100], so that its square and cube are normal numbers; or
    /// `dim` is not in 1..=32, a ball has no normal measure in so many dimensions, or the
    /// accuracy is not in (0, 1).
    pub fn sampled(tau: f64, dim: usize, sampling: Sampling) -> Result<Self, Error> {
        let is_right = (1e-100..=1e100).contains(&tau);
        check_number("tau", tau, is_right, "a positive radius in [1e-100, 1e100]")?;
        if !(1..=HIGHEST).contains(&dim) {
            let must_be = format!("from 1 to {HIGHEST}");
            return Err(Error::Count { name: "dim", must_be, got: dim });
        }
        let accuracy = sampling.accuracy;
        let must_be = "a share of a ball's measure, greater than 0 and less than 1";
        check_number("accuracy", accuracy, accuracy > 0.0 && accuracy < 1.0, must_be)?;
        let union = Union::new(tau, dim, sampling);
        let must_be = "a radius whose balls have a measure that a number can hold";
        check_number("tau", tau, union.ball(tau).is_normal(), must_be)?;
        Ok(Self {
            tau,
            dim,
            sampling,
            union,
            effects: NearestNeighbors::new(dim)?,
            gains: Vec::new(),
            errors: Vec::new(),
            measure: ExactSum::default(),
            variance: ExactSum::default(),
        })
    }

    /// The union that a log of effects, gains and - where gains are estimated - standard errors
    /// came from, ready to go on where that stopped.
    ///
    /// # Errors
    /// As [`sampled`](Self::sampled), or if the log is not one of such a union.
    pub fn restored(
        tau: f64,
        dim: usize,
        sampling: Sampling,
        effects: &[f64],
        gains: &[f64],
        errors: &[f64],
    ) -> Result<Self, Error> {
        let mut coverage = Self::sampled(tau, dim, sampling)?;
        check_rows("effects", effects, dim)?;
        check_finite("effects", effects, dim)?;
        let len = effects.len() / dim;
        check_length("gains", gains, len)?;
        let exact = coverage.is_exact();
        check_length("standard_errors", errors, if exact { 0 } else { len })?;
        let ball = coverage.ball();
        for (name, logged) in [("gains", gains), ("standard_errors", errors)] {
            let must_be = format_args!("from 0 to a ball's measure, {ball:?}");
            check_each(name, logged, len, must_be, |x| (0.0..=ball).contains(&x))?;
        }
        for (i, (effect, &gain)) in effects.chunks_exact(dim).zip(gains).enumerate() {
            let known = Estimated { gain, standard_error: errors.get(i).copied().unwrap_or(0.0) };
            let found = coverage.union.replay(effect, known);
            if found != known {
                return Err(Error::Element {
                    name: "gains",
                    at: place(i, len, len),
                    must_be: format!("{:?}, what its effect gains", found.gain),
                    got: gain,
                });
            }
            coverage.record(effect, known);
        }
        Ok(coverage)
    }

    /// The union that it began with.
    pub(crate) fn empty_union(&self) -> Union {
        Union::new(self.tau, self.dim, self.sampling)
    }

    /// The radius of the balls.
    #[must_use]
    pub fn tau(&self) -> f64 {
        self.tau
    }

    /// The dimension of the effects.
    #[must_use]
    pub fn dim(&self) -> usize {
        self.dim
    }

    /// How gains are estimated, where they are.
    #[must_use]
    pub fn sampling(&self) -> Sampling {
        self.sampling
    }

    /// Whether gains are exact: up to three dimensions.
    #[must_use]
    pub fn is_exact(&self) -> bool {
        !matches!(self.union, Union::Many(_))
    }

    /// How many effects have been added.
    #[must_use]
    pub fn len(&self) -> usize {
        self.gains.len()
    }

    /// Whether none has.
    #[must_use]
    pub fn is_empty(&self) -> bool {
        self.gains.is_empty()
    }

    /// The measure of the union.
    #[must_use]
    pub fn measure(&self) -> f64 {
        self.measure.value()
    }

    /// The standard error of the measure: 0 where it is exact.
    #[must_use]
    pub fn standard_error(&self) -> f64 {
        self.variance.value().sqrt() * self.ball()
    }

    /// The measure of one ball, which no gain exceeds.
    #[must_use]
    pub fn ball(&self) -> f64 {
        self.union.ball(self.tau)
    }

    /// All effects, coordinate by coordinate.
    #[must_use]
    pub fn effects(&self) -> &[f64] {
        self.effects.points()
    }

    /// What each effect gained when it came.
    #[must_use]
    pub fn gains(&self) -> &[f64] {
        &self.gains
    }

    /// The standard error of each gain; empty where gains are exact.
    #[must_use]
    pub fn standard_errors(&self) -> &[f64] {
        &self.errors
    }

    /// What `effect` would add, without adding it.
    ///
    /// # Errors
    /// If `effect` has another dimension or is not finite.
    pub fn gain(&mut self, effect: impl AsRef<[f64]>) -> Result<f64, Error> {
        self.estimate(effect).map(|estimated| estimated.gain)
    }

    /// What `effect` would add, and how far to trust that; nothing is added.
    ///
    /// # Errors
    /// As [`gain`](Self::gain).
    pub fn estimate(&mut self, effect: impl AsRef<[f64]>) -> Result<Estimated, Error> {
        let effect = effect.as_ref();
        self.check("effect", effect)?;
        Ok(self.union.gain(effect))
    }

    /// Adds an effect and returns its gain, the measure that it adds.
    ///
    /// # Errors
    /// As [`gain`](Self::gain); nothing is added then.
    pub fn add(&mut self, effect: impl AsRef<[f64]>) -> Result<f64, Error> {
        let effect = effect.as_ref();
        self.check("effect", effect)?;
        Ok(self.insert(effect))
    }

    /// Adds effects, one after the other in one slice, and writes the gain of each.
    ///
    /// # Errors
    /// If one of them is not finite, `effects` does not hold whole ones or `gains` not one
    /// number for each; nothing is added then.
    pub fn extend(&mut self, effects: &[f64], gains: &mut [f64]) -> Result<(), Error> {
        check_rows("effects", effects, self.dim)?;
        check_length("gains", gains, effects.len() / self.dim)?;
        check_finite("effects", effects, self.dim)?;
        for (gain, effect) in gains.iter_mut().zip(effects.chunks_exact(self.dim)) {
            *gain = self.insert(effect);
        }
        Ok(())
    }

    /// What would be lost without effect `index`: the measure of the part of its ball that lies
    /// in no other. It takes as long as adding all effects around it.
    ///
    /// # Errors
    /// If there is no such effect.
    pub fn contribution(&mut self, index: usize) -> Result<Estimated, Error> {
        if index >= self.len() {
            let must_be = format!("less than the number of effects, {}", self.len());
            return Err(Error::Count { name: "index", must_be, got: index });
        }
        self.file_effects()?;
        let effect = self.effect(index);
        // A little more than the reach: what only touches takes nothing away.
        let mut near = self.effects.within(effect, 2.000_001 * self.tau)?;
        near.retain(|&other| other != index);
        near.sort_unstable();
        let mut others = Union::new(self.tau, self.dim, self.sampling);
        for other in near {
            others.insert(self.effect(other));
        }
        Ok(others.gain(effect))
    }

    /// Whether `point` lies in the union: no farther than tau from some effect.
    ///
    /// # Errors
    /// If `point` has another dimension or is not finite.
    pub fn contains(&mut self, point: impl AsRef<[f64]>) -> Result<bool, Error> {
        let point = point.as_ref();
        self.check("point", point)?;
        self.file_effects()?;
        Ok(!self.is_empty() && self.effects.nearest(point)?.0 <= self.tau)
    }

    /// In the plane, the union's boundary as closed loops of arcs, counter-clockwise each around
    /// its own centre: outer loops come out counter-clockwise, holes clockwise. None in other
    /// dimensions.
    ///
    /// An arc ends where the next one of its loop begins; a disc on its own is a loop of one arc. A
    /// loop begins with the least of its arcs by (`x`, `y`, `from`), and loops are in the order of
    /// these. Loops shorter than a billionth of tau are left out.
    #[must_use]
    pub fn boundary(&self) -> Option<Vec<Vec<BoundaryArc>>> {
        match &self.union {
            Union::Plane(discs) => Some(discs.boundary()),
            _ => None,
        }
    }

    /// The measure from scratch, in the plane: the area that the boundary encloses. It costs a
    /// pass over the boundary, and is what the gains add up to. None in other dimensions.
    ///
    /// Unlike the gains it depends on where the discs lie: its error grows with their distance
    /// from the origin, and 1e150 radii away it may be no number.
    #[must_use]
    pub fn boundary_integral(&self) -> Option<f64> {
        match &self.union {
            Union::Plane(discs) => Some(discs.boundary_integral()),
            _ => None,
        }
    }

    fn effect(&self, index: usize) -> &[f64] {
        &self.effects()[index * self.dim..][..self.dim]
    }

    fn check(&self, name: &'static str, point: &[f64]) -> Result<(), Error> {
        check_length(name, point, self.dim)?;
        check_finite(name, point, self.dim)
    }

    fn insert(&mut self, effect: &[f64]) -> f64 {
        let estimated = self.union.insert(effect);
        self.record(effect, estimated);
        estimated.gain
    }

    fn record(&mut self, effect: &[f64], Estimated { gain, standard_error }: Estimated) {
        self.effects.log(effect);
        self.gains.push(gain);
        self.measure.add(gain);
        if !self.is_exact() {
            // In balls: the square of a measure may be no number.
            let share = standard_error / self.ball();
            self.errors.push(standard_error);
            self.variance.add(share * share);
        }
    }

    /// Lets all effects be searched.
    fn file_effects(&mut self) -> Result<(), Error> {
        self.effects.check_room(0)?;
        self.effects.file_all();
        Ok(())
    }
}
