//! History: the log of an exploration - commands and effects - and what is derived from it.
//!
//! The log is the state. The k-d tree is brought up to date from it when somebody asks for a
//! nearest effect.

use crate::bounds::{Bounds, UniformStream, check_share};
use crate::error::{Error, check_length, reserve};
use crate::kdtree::NearestNeighbors;

/// All that has been tried so far, and what it led to.
#[derive(Debug, Clone)]
pub struct History {
    motor_space: Bounds,
    sensory_space: Option<Bounds>,
    effect_dim: usize,
    keeps_commands: bool,
    len: usize,
    /// Coordinate by coordinate.
    commands: Vec<f64>,
    /// The effects, filed as far as somebody asked for the nearest.
    effects: NearestNeighbors,
}

impl History {
    /// Nothing tried yet. Goals are drawn from `sensory_space` where a strategy has none of its
    /// own; without `keeps_commands`, commands are forgotten as soon as they are recorded.
    ///
    /// # Errors
    /// If `effect_dim` is 0 or not the dimension of the sensory space.
    pub fn new(
        motor_space: Bounds,
        sensory_space: Option<Bounds>,
        effect_dim: usize,
        keeps_commands: bool,
    ) -> Result<Self, Error> {
        if let Some(space) = &sensory_space {
            check_length("sensory_space", space.low(), effect_dim)?;
        }
        Ok(Self {
            motor_space,
            sensory_space,
            effect_dim,
            keeps_commands,
            len: 0,
            commands: Vec::new(),
            effects: NearestNeighbors::new(effect_dim)?,
        })
    }

    /// M, the box of all motor commands.
    #[must_use]
    pub fn motor_space(&self) -> &Bounds {
        &self.motor_space
    }

    /// A box in S from which goals make sense.
    #[must_use]
    pub fn sensory_space(&self) -> Option<&Bounds> {
        self.sensory_space.as_ref()
    }

    /// The dimension of the effects.
    #[must_use]
    pub fn effect_dim(&self) -> usize {
        self.effect_dim
    }

    /// How many commands have been tried.
    #[must_use]
    pub fn len(&self) -> usize {
        self.len
    }

    /// Whether none has.
    #[must_use]
    pub fn is_empty(&self) -> bool {
        self.len == 0
    }

    /// All commands in order, coordinate by coordinate; empty if they are not kept.
    #[must_use]
    pub fn commands(&self) -> &[f64] {
        &self.commands
    }

    /// All effects in order, coordinate by coordinate.
    #[must_use]
    pub fn effects(&self) -> &[f64] {
        self.effects.points()
    }

    /// Whether commands are kept, or forgotten as soon as they are recorded.
    #[must_use]
    pub fn keeps_commands(&self) -> bool {
        self.keeps_commands
    }

    /// Checks that so many more evaluations can be counted.
    pub(crate) fn check_room(&self, n: usize) -> Result<(), Error> {
        if self.len.saturating_add(n) < u32::MAX as usize {
            return Ok(());
        }
        let must_be = "so few that all evaluations together are fewer than 2^32".to_owned();
        Err(Error::Count { name: "n", must_be, got: n })
    }

    /// Makes room for so many more evaluations, so that recording them moves nothing.
    ///
    /// # Errors
    /// If there is no memory for them, or they would be 2^32 or more; nothing has changed then.
    pub fn reserve(&mut self, n: usize) -> Result<(), Error> {
        self.check_room(n)?;
        if self.keeps_commands {
            reserve(&mut self.commands, n, self.motor_space.dim())?;
        }
        self.effects.reserve(n)
    }

    /// Records one evaluation; both have the right length.
    pub(crate) fn record(&mut self, command: &[f64], effect: &[f64]) {
        if self.keeps_commands {
            self.commands.extend_from_slice(command);
        }
        self.effects.log(effect);
        self.len += 1;
    }

    /// Inverse_d(goal), the paper's inverse model: writes the command of the observed effect
    /// nearest to `goal`, perturbed.
    ///
    /// # Errors
    /// If nothing was observed yet, the commands are not kept, `goal` is not a finite point of
    /// the effects' dimension, `d` is not in [0, 1], or `command` has not the dimension of M;
    /// nothing is drawn then.
    pub fn inverse(
        &mut self,
        goal: &[f64],
        d: f64,
        draws: &mut dyn UniformStream,
        command: &mut [f64],
    ) -> Result<(), Error> {
        check_length("command", command, self.motor_space.dim())?;
        check_share("d", d)?;
        self.effects.file_all();
        let (_, index) = self.effects.nearest(goal)?;
        let m = self.motor_space.dim();
        let Some(parent) = self.commands.get(index * m..(index + 1) * m) else {
            return Err(Error::Empty { name: "commands" });
        };
        self.motor_space.perturb_into(command, parent, d, draws);
        Ok(())
    }

    /// The commands and the effects.
    pub(crate) fn into_log(self) -> (Vec<f64>, Vec<f64>) {
        (self.commands, self.effects.into_points())
    }
}
