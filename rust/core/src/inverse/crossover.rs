//! A command of which some coordinates are the nearest effect's, the others those of one nearby.

use super::InverseModel;
use crate::bounds::UniformStream;
use crate::error::{Error, check_count, check_share};
use crate::history::History;
use crate::kdtree::nearer;

/// Upper limit on the expected share of coordinates taken from the other command.
const MOST: f64 = 0.5;

/// The command of the nearest effect, crossed with that of another of the k nearest, perturbed.
///
/// Each coordinate is the other's with a probability that is uniform in [0, 1/2], the same for all
/// coordinates. Draws: the other effect, the probability, one a motor coordinate to choose, one to
/// perturb.
#[derive(Debug, Clone)]
pub struct Crossover {
    k: usize,
    d: f64,
    found: Vec<(f64, usize)>,
    crossed: Vec<f64>,
}

impl Crossover {
    /// Of the `k` nearest effects - of all where there are fewer -, perturbed by up to the share `d`
    /// of each motor range.
    ///
    /// # Errors
    /// If `k` is 0, or `d` is not in [0, 1].
    pub fn new(k: usize, d: f64) -> Result<Self, Error> {
        check_count("k", k)?;
        check_share("d", d)?;
        Ok(Self { k, d, found: Vec::new(), crossed: Vec::new() })
    }
}

impl InverseModel for Crossover {
    fn command(
        &mut self,
        goal: &[f64],
        history: &mut History,
        draws: &mut dyn UniformStream,
        command: &mut [f64],
    ) -> Result<(), Error> {
        let observed = history.observed()?;
        observed.check(goal, command)?;
        let k = self.k.min(observed.effects.len());
        observed.effects.nearest_k_squared(goal, k, &mut self.found)?;
        let nearest = self.found.iter().copied().min_by(nearer).map_or(0, |(_, index)| index);
        // In the order of their distances, not that in which the search finds them.
        let (_, &mut (_, other), _) = self.found.select_nth_unstable_by(draws.below(k), nearer);
        let (parent, other) = (observed.command(nearest), observed.command(other));
        let share = MOST * draws.next();
        self.crossed.resize(parent.len(), 0.0);
        draws.fill(&mut self.crossed);
        for (x, (&own, &others)) in self.crossed.iter_mut().zip(parent.iter().zip(other)) {
            *x = if *x < share { others } else { own };
        }
        observed.motor_space.perturb_into(command, &self.crossed, self.d, draws);
        Ok(())
    }
}
