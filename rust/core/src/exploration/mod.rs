//! Exploration: the engine, the whole loop - propose, try, observe - for built-in parts.
//!
//! It does what the loop in Python does, draw for draw and bit for bit: that one is the
//! specification, and tests hold this one equal to it.
//!
//! ```
//! use divbandit_core::bandits::Adapt;
//! use divbandit_core::strategies::{GoalBabbling, MotorBabbling};
//! use divbandit_core::{Bounds, Composition, Coverage, Exploration, History, PlanarArm};
//!
//! # fn main() -> Result<(), divbandit_core::Error> {
//! let arm = PlanarArm::new(20, 2.6)?;
//! let motor_space = Bounds::new(vec![-2.6; 20], vec![2.6; 20])?;
//! let goals = Bounds::new(vec![-1.0; 2], vec![1.0; 2])?;
//! let history = History::new(motor_space, Some(goals), 2, true)?;
//!
//! let mut strategies = Composition::default();
//! let motor = strategies.add(MotorBabbling);
//! let goal = strategies.add(GoalBabbling::new(0.05, None)?);
//! let adapt = Adapt::new(2, Coverage::new(0.02, 2)?, 50, 0.1, 1)?;
//! let root = strategies.compose(adapt, vec![motor, goal])?;
//!
//! // Any generator will do; this is Marsaglia's xorshift.
//! let mut state = 1_u64;
//! let mut draws = || {
//!     state ^= state << 13;
//!     state ^= state >> 7;
//!     state ^= state << 17;
//!     (state >> 11) as f64 / (1_u64 << 53) as f64
//! };
//! let mut run = Exploration::new(Box::new(arm), history, strategies, root)?;
//! run.run(1000, &mut draws)?;
//! let log = run.into_log()?;
//! assert_eq!((log.commands.len(), log.effects.len()), (20_000, 2000));
//! assert_eq!((log.paths.len(), log.diversities.len()), (1000, 2000));
//! # Ok(())
//! # }
//! ```

mod composition;
mod gains;
mod paths;

use crate::bounds::UniformStream;
use crate::environment::Environment;
use crate::error::{Error, check_finite, check_length, reserve};
use crate::history::History;
pub use composition::Composition;
use composition::Part;
use gains::Gains;
use paths::{Paths, ROOT};

/// An exploration under way.
#[derive(Debug)]
pub struct Exploration {
    environment: Box<dyn Environment>,
    parts: Vec<Part>,
    /// For each part, where its gains come from.
    measures: Vec<Option<usize>>,
    history: History,
    gains: Gains,
    paths: Paths,
    /// The path of each step, by its end.
    ends: Vec<u32>,
    /// What the outermost strategy believed when it chose, step by step, if it is a bandit.
    diversities: Vec<f64>,
    command: Vec<f64>,
    effect: Vec<f64>,
}

/// What is left of an exploration: arrays, row by row.
#[derive(Debug, Clone, PartialEq)]
pub struct Log {
    /// The motor commands; empty if they were not kept.
    pub commands: Vec<f64>,
    /// The effects.
    pub effects: Vec<f64>,
    /// Who chose each command: indices of strategies, outermost first, -1 beyond the innermost.
    pub paths: Vec<i64>,
    /// The length of a row of `paths`.
    pub depth: usize,
    /// What the outermost strategy believed of each of its parts when it chose; empty if it is no
    /// bandit.
    pub diversities: Vec<f64>,
}

impl Exploration {
    /// Of `environment`, with the part `root` of `strategies`. The history is empty.
    ///
    /// # Errors
    /// If the environment does not lead from the motor space to the effects of the history, a
    /// strategy cannot explore it, or needs commands that the history does not keep, or there is
    /// no part `root`.
    pub fn new(
        environment: Box<dyn Environment>,
        history: History,
        strategies: Composition,
        root: usize,
    ) -> Result<Self, Error> {
        strategies.check(root)?;
        let command = vec![0.0; environment.motor_dim()];
        let effect = vec![0.0; environment.effect_dim()];
        check_length("motor_space", history.motor_space().low(), command.len())?;
        check_length("effect", &effect, history.effect_dim())?;
        if strategies.needs_commands() && !history.keeps_commands() {
            return Err(Error::Empty { name: "commands" });
        }
        let parts = strategies.parts;
        let mut gains = Gains::default();
        let mut measures = Vec::with_capacity(parts.len());
        for part in &parts {
            measures.push(match part {
                Part::Composite(composite, _) => {
                    composite.measure().map(|by| gains.of(by, effect.len())).transpose()?
                }
                Part::Strategy(strategy) => {
                    strategy.check(&history)?;
                    None
                }
            });
        }
        let paths = Paths::new(root);
        let (ends, diversities) = (Vec::new(), Vec::new());
        Ok(Self {
            environment,
            parts,
            measures,
            history,
            gains,
            paths,
            ends,
            diversities,
            command,
            effect,
        })
    }

    /// Makes room for the log of so many more steps.
    ///
    /// # Errors
    /// If there is no memory for it.
    pub fn reserve(&mut self, n: usize) -> Result<(), Error> {
        let beliefs = self.beliefs().map_or(0, <[f64]>::len);
        self.history.reserve(n)?;
        reserve(&mut self.ends, n, 1)?;
        reserve(&mut self.diversities, n, beliefs)
    }

    /// Makes so many more steps; all randomness comes from `draws`.
    ///
    /// # Errors
    /// If `n` is more than can be logged; nothing has changed then. Or if the environment refuses a
    /// command, or a part of one's own breaks its promise: the steps before are made then, and
    /// of the one that failed nothing is left but the draws and choices made for it.
    pub fn run(&mut self, n: usize, draws: &mut dyn UniformStream) -> Result<(), Error> {
        self.history.check_room(n)?;
        (0..n).try_for_each(|_| self.step(draws))
    }

    /// How many steps have been made.
    #[must_use]
    pub fn len(&self) -> usize {
        self.history.len()
    }

    /// Whether none has.
    #[must_use]
    pub fn is_empty(&self) -> bool {
        self.history.is_empty()
    }

    fn step(&mut self, draws: &mut dyn UniformStream) -> Result<(), Error> {
        let proposer = self.propose(draws)?;
        self.history.motor_space().check("command", &self.command)?;
        self.environment.effect_into(&self.command, &mut self.effect)?;
        check_finite("effect", &self.effect, self.effect.len())?;
        if let Part::Composite(outermost, _) = &self.parts[self.paths.part(ROOT)]
            && let Some(diversities) = outermost.diversities()
        {
            self.diversities.extend_from_slice(diversities);
        }
        self.history.record(&self.command, &self.effect);
        self.ends.push(proposer);
        self.observe(proposer);
        Ok(())
    }

    /// Lets the strategies choose down to the one that writes the command; returns its node.
    fn propose(&mut self, draws: &mut dyn UniformStream) -> Result<u32, Error> {
        let mut node = ROOT;
        loop {
            match &mut self.parts[self.paths.part(node)] {
                Part::Composite(composite, parts) => {
                    let index = composite.choose(draws);
                    if index >= parts.len() {
                        let must_be = format!("less than the number of parts, {}", parts.len());
                        return Err(Error::Count { name: "choice", must_be, got: index });
                    }
                    node = self.paths.child(node, index, parts);
                }
                Part::Strategy(strategy) => {
                    strategy.propose(&mut self.history, draws, &mut self.command)?;
                    return Ok(node);
                }
            }
        }
    }

    /// Tells those who had a part in proposing the newest effect what it has gained.
    fn observe(&mut self, mut node: u32) {
        while let Some((parent, index)) = self.paths.parent(node) {
            let part = self.paths.part(parent);
            if let (Some(place), Part::Composite(composite, _)) =
                (self.measures[part], &mut self.parts[part])
            {
                composite.credit(index, self.gains.newest(place, &self.history));
            }
            node = parent;
        }
    }

    /// What the outermost strategy believes, if it is a bandit.
    fn beliefs(&self) -> Option<&[f64]> {
        match &self.parts[self.paths.part(ROOT)] {
            Part::Composite(composite, _) => composite.diversities(),
            Part::Strategy(_) => None,
        }
    }

    /// What is left of it.
    ///
    /// # Errors
    /// If there is no memory for the paths.
    pub fn into_log(self) -> Result<Log, Error> {
        let depth = self.paths.depth();
        let mut paths = Vec::new();
        reserve(&mut paths, self.ends.len(), depth)?;
        paths.resize(self.ends.len() * depth, -1);
        for (&end, row) in self.ends.iter().zip(paths.chunks_exact_mut(depth.max(1))) {
            self.paths.write(end, row);
        }
        let (commands, effects) = self.history.into_log();
        Ok(Log { commands, effects, paths, depth, diversities: self.diversities })
    }
}
