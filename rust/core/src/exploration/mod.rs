//! Exploration: the engine, which runs a composition of the library's own strategies.
//!
//! [`propose`](Exploration::propose) lets the strategies choose down to the one that writes a
//! command; [`observe`](Exploration::observe) and [`fail`](Exploration::fail) tell those on the way
//! the outcome; [`run`](Exploration::run) is the whole loop for an environment in Rust. The loop in
//! Python does the same, draw for draw and bit for bit: tests hold the two equal.
//!
//! ```
//! use divbandit_core::bandits::Bandit;
//! use divbandit_core::bandits::estimators::EstimatorKind;
//! use divbandit_core::bandits::policies::PolicyKind;
//! use divbandit_core::bandits::rewards::RewardKind;
//! use divbandit_core::goals::Uniform;
//! use divbandit_core::inverse::Nearest;
//! use divbandit_core::measures::MeasureKind;
//! use divbandit_core::strategies::{GoalBabbling, MotorBabbling};
//! use divbandit_core::{Bounds, Composition, Exploration, History, PlanarArm};
//!
//! # fn main() -> Result<(), divbandit_core::Error> {
//! let mut arm = PlanarArm::new(20, 2.6)?;
//! let motor_space = Bounds::new(vec![-2.6; 20], vec![2.6; 20])?;
//! let goals = Bounds::new(vec![-1.0; 2], vec![1.0; 2])?;
//! let mut history = History::new(motor_space, Some(goals), true, 2)?;
//!
//! let mut strategies = Composition::default();
//! let motor = strategies.add(MotorBabbling);
//! let goal = strategies.add(GoalBabbling::new(
//!     Box::new(Uniform::new(None)?),
//!     Box::new(Nearest::new(0.05)?),
//! ));
//! let adapt = Bandit::new(
//!     2,
//!     RewardKind::Gain(MeasureKind::Balls { tau: 0.02, accuracy: 1e-3 }),
//!     EstimatorKind::Window { size: 50, head_start: 1 },
//!     PolicyKind::Proportional { alpha: 0.1, power: 1.0 },
//!     Some(2),
//! )?;
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
//! let mut exploration = Exploration::new(strategies, root, &history)?;
//! exploration.run(&mut arm, &mut history, 1000, &mut draws)?;
//! let log = history.into_log()?;
//! assert_eq!((log.commands.len(), log.effects.len()), (20_000, 2000));
//! assert_eq!((log.paths.len(), log.estimates.len()), (1000, 2000));
//! # Ok(())
//! # }
//! ```

mod composition;
mod proposal;
mod rewards;

use crate::bounds::{Bounds, UniformStream};
use crate::environment::Environment;
use crate::error::{Error, check_length};
use crate::history::History;
use crate::paths::ROOT;
pub use composition::Composition;
use composition::Part;
pub use proposal::Proposal;
use rewards::Rewards;

/// A composition of strategies that explores.
#[derive(Debug)]
pub struct Exploration {
    parts: Vec<Part>,
    root: usize,
    /// For each part, where its rewards come from, if it is a bandit.
    rewarded: Vec<Option<usize>>,
    rewards: Rewards,
    needs_commands: bool,
    /// Whether the dimension of the effects is known, and the rewards started.
    has_begun: bool,
    /// What each of those who chose has earned with the newest effect.
    earned: Vec<f64>,
    /// Whether the newest effect was recorded, but could not be rewarded.
    unrewarded: bool,
    /// What `run` proposes and observes.
    proposal: Proposal,
    effect: Vec<f64>,
}

impl Exploration {
    /// Of the part `root` of `strategies`, with this history.
    ///
    /// # Errors
    /// If a strategy cannot explore its spaces, or needs commands that the history does not keep,
    /// or there is no part `root`.
    pub fn new(strategies: Composition, root: usize, history: &History) -> Result<Self, Error> {
        strategies.check(root)?;
        let needs_commands = strategies.needs_commands();
        if needs_commands && !history.keeps_commands() {
            return Err(Error::Empty { name: "commands" });
        }
        let parts = strategies.parts;
        let mut rewards = Rewards::default();
        let mut rewarded = Vec::with_capacity(parts.len());
        for part in &parts {
            rewarded.push(match part {
                Part::Composite(composite, _) => {
                    composite.reward().map(|kind| rewards.place_of(kind))
                }
                Part::Strategy(strategy) => {
                    strategy.check(history.effect_dim(), history.sensory_space())?;
                    None
                }
            });
        }
        let (proposal, effect) = (Proposal::new(history.motor_space().dim()), Vec::new());
        let mut new = Self {
            parts,
            root,
            rewarded,
            rewards,
            needs_commands,
            has_begun: false,
            earned: Vec::new(),
            unrewarded: false,
            proposal,
            effect,
        };
        if let Some(dim) = history.effect_dim() {
            new.begin(dim, history.sensory_space())?;
        }
        Ok(new)
    }

    /// Learns the dimension of the effects: all of it, or nothing if some part refuses it.
    fn begin(&mut self, dim: usize, sensory_space: Option<&Bounds>) -> Result<(), Error> {
        for part in &self.parts {
            if let Part::Strategy(strategy) = part {
                strategy.check(Some(dim), sensory_space)?;
            }
        }
        self.rewards.start(dim)?;
        self.has_begun = true;
        Ok(())
    }

    /// Lets the strategies choose down to the one that proposes a command; all randomness comes
    /// from `draws`.
    ///
    /// # Errors
    /// If a strategy cannot propose.
    pub fn propose(
        &mut self,
        history: &mut History,
        draws: &mut dyn UniformStream,
        proposal: &mut Proposal,
    ) -> Result<(), Error> {
        self.unrewarded = false;
        proposal.estimates.clear();
        proposal.estimates.extend_from_slice(self.estimates().unwrap_or(&[]));
        proposal.choices.clear();
        let (mut place, mut end) = (self.root, ROOT);
        loop {
            match &mut self.parts[place] {
                Part::Composite(composite, parts) => {
                    let choice = composite.choose(draws);
                    let Some(&chosen) = parts.get(choice.part) else {
                        let must_be = format!("less than the number of parts, {}", parts.len());
                        return Err(Error::Count { name: "choice", must_be, got: choice.part });
                    };
                    proposal.choices.push((place, choice));
                    end = history.paths_mut().child(end, choice.part as u32);
                    place = chosen;
                }
                Part::Strategy(strategy) => {
                    strategy.propose(history, draws, &mut proposal.command)?;
                    proposal.goal.clear();
                    let goal = strategy.goal();
                    proposal.has_goal = goal.is_some();
                    proposal.goal.extend_from_slice(goal.unwrap_or(&[]));
                    proposal.end = end;
                    return Ok(());
                }
            }
        }
    }

    /// Records the effect of a proposal of this exploration, and rewards the bandits on the way to it.
    ///
    /// # Errors
    /// If the effect is not finite, of another dimension than those before, or of one that a part
    /// refuses: nothing is recorded then. If it cannot be rewarded, it is recorded, and no part
    /// learns from it.
    pub fn observe(
        &mut self,
        history: &mut History,
        proposal: &Proposal,
        effect: &[f64],
    ) -> Result<(), Error> {
        self.unrewarded = false;
        history.check_effect(effect)?;
        if !self.has_begun {
            self.begin(effect.len(), history.sensory_space())?;
        }
        history.log(&proposal.command, effect, proposal.end, &proposal.estimates)?;
        self.unrewarded = true;
        self.earned.clear();
        for &(place, _) in &proposal.choices {
            self.earned.push(match self.rewarded[place] {
                Some(reward) => self.rewards.newest(reward, history, proposal.goal())?,
                None => 0.0,
            });
        }
        for (&(place, choice), &reward) in proposal.choices.iter().zip(&self.earned).rev() {
            if let (Some(_), Part::Composite(composite, _)) =
                (self.rewarded[place], &mut self.parts[place])
            {
                composite.begin(effect.len())?;
                composite.learn(choice, reward);
            }
        }
        self.unrewarded = false;
        Ok(())
    }

    /// Whether the newest effect was recorded, but could not be rewarded.
    #[must_use]
    pub fn is_unrewarded(&self) -> bool {
        self.unrewarded
    }

    /// Tells the composites on the way to a proposal that it has failed.
    pub fn fail(&mut self, proposal: &Proposal) {
        for &(place, choice) in proposal.choices.iter().rev() {
            if let Part::Composite(composite, _) = &mut self.parts[place] {
                composite.fail(choice);
            }
        }
    }

    /// The outermost strategy's estimates of its parts, if it is a bandit.
    #[must_use]
    pub fn estimates(&self) -> Option<&[f64]> {
        match &self.parts[self.root] {
            Part::Composite(composite, _) => composite.estimates(),
            Part::Strategy(_) => None,
        }
    }

    /// Whether one of the strategies looks at the commands of the history.
    #[must_use]
    pub fn needs_commands(&self) -> bool {
        self.needs_commands
    }

    /// What [`run`](Self::run) proposed last.
    #[must_use]
    pub fn newest(&self) -> &Proposal {
        &self.proposal
    }

    /// Explores `environment` for `n` more evaluations.
    ///
    /// # Errors
    /// If it does not lead from the motor space to the effects of the history, or there is no memory
    /// for `n` more evaluations; nothing has been drawn then. If it refuses a command, or a part
    /// breaks its promise; the steps before are recorded then.
    pub fn run(
        &mut self,
        environment: &mut dyn Environment,
        history: &mut History,
        n: usize,
        draws: &mut dyn UniformStream,
    ) -> Result<(), Error> {
        check_length("motor_space", history.motor_space().low(), environment.motor_dim())?;
        if let Some(must_be) = history.effect_dim().filter(|&dim| dim != environment.effect_dim()) {
            return Err(Error::Length { name: "effect", must_be, got: environment.effect_dim() });
        }
        history.reserve(n)?;
        let mut proposal = std::mem::replace(&mut self.proposal, Proposal::new(0));
        let mut effect = std::mem::take(&mut self.effect);
        effect.resize(environment.effect_dim(), 0.0);
        let done = (0..n).try_for_each(|_| {
            self.propose(history, draws, &mut proposal)?;
            environment.effect_into(&proposal.command, &mut effect)?;
            self.observe(history, &proposal, &effect)
        });
        (self.proposal, self.effect) = (proposal, effect);
        done
    }
}
