//! History: the log of an exploration - commands, effects, who proposed them - and the k-d tree.
//!
//! The log is the state. The tree is brought up to date from it when a nearest effect is searched.

use crate::bounds::Bounds;
use crate::error::{Error, check_finite, check_length, reserve};
use crate::inverse::Observed;
use crate::kdtree::NearestNeighbors;
use crate::paths::Paths;

/// All commands tried so far, and their effects.
#[derive(Debug, Clone)]
pub struct History {
    motor_space: Bounds,
    sensory_space: Option<Bounds>,
    keeps_commands: bool,
    len: usize,
    /// Coordinate by coordinate.
    commands: Vec<f64>,
    /// The effects, up to date as of the last search; None until their dimension is known.
    effects: Option<NearestNeighbors>,
    paths: Paths,
    /// The path of each step, by its end.
    ends: Vec<u32>,
    /// A bandit's estimates of its strategies when it chose, step by step.
    estimates: Vec<f64>,
    /// The length of a row of these; 0 for any other strategy.
    width: usize,
}

/// A history as arrays, row by row.
#[derive(Debug, Clone, PartialEq)]
pub struct Log {
    /// How many commands have been tried.
    pub len: usize,
    /// The motor commands; empty if they were not kept.
    pub commands: Vec<f64>,
    /// The effects.
    pub effects: Vec<f64>,
    /// Who proposed each command: indices of strategies, outermost first, -1 beyond the innermost.
    pub paths: Vec<i64>,
    /// The length of a row of `paths`: that of the longest path recorded.
    pub depth: usize,
    /// A bandit's estimates of its strategies when it chose; empty for any other strategy.
    pub estimates: Vec<f64>,
}

impl History {
    /// Nothing tried yet. Goals are drawn from `sensory_space` where a strategy has no box of its
    /// own; without `keeps_commands`, commands are discarded when they are recorded. `width` is the
    /// number of estimates logged with each step.
    ///
    /// # Errors
    /// Never at present: a box has at least one dimension.
    pub fn new(
        motor_space: Bounds,
        sensory_space: Option<Bounds>,
        keeps_commands: bool,
        width: usize,
    ) -> Result<Self, Error> {
        let dim = sensory_space.as_ref().map(Bounds::dim);
        Ok(Self {
            motor_space,
            sensory_space,
            keeps_commands,
            len: 0,
            commands: Vec::new(),
            effects: dim.map(NearestNeighbors::new).transpose()?,
            paths: Paths::default(),
            ends: Vec::new(),
            estimates: Vec::new(),
            width,
        })
    }

    /// Decides, while nothing has been tried, whether commands are kept and how many estimates
    /// are logged with each step.
    ///
    /// # Errors
    /// If something has been tried.
    pub fn begin(&mut self, keeps_commands: bool, width: usize) -> Result<(), Error> {
        if self.len > 0 {
            return Err(Error::Count { name: "history", must_be: "empty".into(), got: self.len });
        }
        (self.keeps_commands, self.width) = (keeps_commands, width);
        Ok(())
    }

    /// M, the box of all motor commands.
    #[must_use]
    pub fn motor_space(&self) -> &Bounds {
        &self.motor_space
    }

    /// A box in S to draw goals from.
    #[must_use]
    pub fn sensory_space(&self) -> Option<&Bounds> {
        self.sensory_space.as_ref()
    }

    /// The dimension of the effects; without a sensory space, None until the first of them.
    #[must_use]
    pub fn effect_dim(&self) -> Option<usize> {
        self.effects.as_ref().map(NearestNeighbors::dim)
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
        self.effects.as_ref().map_or(&[], NearestNeighbors::points)
    }

    /// The paths taken, and each step's among them.
    #[must_use]
    pub fn paths(&self) -> (&Paths, &[u32]) {
        (&self.paths, &self.ends)
    }

    /// The paths, to be extended by a choice.
    pub(crate) fn paths_mut(&mut self) -> &mut Paths {
        &mut self.paths
    }

    /// The estimates logged with each step, and how many there are in a row.
    #[must_use]
    pub fn estimates(&self) -> (&[f64], usize) {
        (&self.estimates, self.width)
    }

    /// Whether commands are kept, or discarded when they are recorded.
    #[must_use]
    pub fn keeps_commands(&self) -> bool {
        self.keeps_commands
    }

    /// All that was observed, to be searched.
    ///
    /// # Errors
    /// If nothing was observed yet.
    pub fn observed(&mut self) -> Result<Observed<'_>, Error> {
        let Some(effects) = self.effects.as_mut().filter(|effects| !effects.is_empty()) else {
            return Err(Error::Empty { name: "history" });
        };
        effects.file_all();
        Ok(Observed { effects, commands: &self.commands, motor_space: &self.motor_space })
    }

    /// Checks that so many more evaluations can be counted.
    ///
    /// # Errors
    /// If they would be 2^32 or more.
    pub fn check_room(&self, n: usize) -> Result<(), Error> {
        if self.len.saturating_add(n) < u32::MAX as usize {
            return Ok(());
        }
        let must_be = "so few that all evaluations together are fewer than 2^32".to_owned();
        Err(Error::Count { name: "n", must_be, got: n })
    }

    /// Allocates memory for so many more evaluations.
    ///
    /// # Errors
    /// If there is no memory for them, or they would be 2^32 or more; nothing has changed then.
    pub fn reserve(&mut self, n: usize) -> Result<(), Error> {
        self.check_room(n)?;
        if self.keeps_commands {
            reserve(&mut self.commands, n, self.motor_space.dim())?;
        }
        reserve(&mut self.ends, n, 1)?;
        reserve(&mut self.estimates, n, self.width)?;
        self.effects.as_mut().map_or(Ok(()), |effects| effects.reserve(n))
    }

    /// Records one evaluation, proposed by the strategy at the end of `path`, and the bandit's
    /// estimates when it chose: NaN where that is empty.
    ///
    /// # Errors
    /// If the command is not a point of the motor space, the effect is not finite or of another
    /// dimension than those before, or there are estimates, but not as many as are logged; nothing
    /// is recorded then.
    pub fn record(
        &mut self,
        command: &[f64],
        effect: &[f64],
        path: &[u32],
        estimates: &[f64],
    ) -> Result<(), Error> {
        self.motor_space.check("command", command)?;
        self.check_effect(effect)?;
        if !estimates.is_empty() {
            check_length("estimates", estimates, self.width)?;
        }
        let end = self.paths.of(path);
        self.log(command, effect, end, estimates)
    }

    /// Checks that an effect is finite and of the dimension of those before.
    pub(crate) fn check_effect(&self, effect: &[f64]) -> Result<(), Error> {
        match self.effect_dim() {
            Some(dim) => check_length("effect", effect, dim)?,
            None if effect.is_empty() => return Err(Error::Empty { name: "effect" }),
            None => {}
        }
        check_finite("effect", effect, effect.len())
    }

    /// Does what [`record`](Self::record) does, without checks.
    pub(crate) fn log(
        &mut self,
        command: &[f64],
        effect: &[f64],
        end: u32,
        estimates: &[f64],
    ) -> Result<(), Error> {
        if self.effects.is_none() {
            self.effects = Some(NearestNeighbors::new(effect.len())?);
        }
        let Some(effects) = &mut self.effects else { return Ok(()) };
        effects.log(effect);
        if self.keeps_commands {
            self.commands.extend_from_slice(command);
        }
        if estimates.len() == self.width {
            self.estimates.extend_from_slice(estimates);
        } else {
            self.estimates.resize(self.estimates.len() + self.width, f64::NAN);
        }
        self.ends.push(end);
        self.len += 1;
        Ok(())
    }

    /// The log, taken out of it.
    ///
    /// # Errors
    /// If there is no memory for the paths.
    pub fn into_log(self) -> Result<Log, Error> {
        let lengths = self.ends.iter().map(|&end| self.paths.length(end));
        let depth = lengths.max().unwrap_or(0);
        let mut paths = Vec::new();
        reserve(&mut paths, self.len, depth)?;
        paths.resize(self.len * depth, -1);
        for (&end, row) in self.ends.iter().zip(paths.chunks_exact_mut(depth.max(1))) {
            self.paths.write(end, row);
        }
        let effects = self.effects.map_or(Vec::new(), NearestNeighbors::into_points);
        let (len, commands, estimates) = (self.len, self.commands, self.estimates);
        Ok(Log { len, commands, effects, paths, depth, estimates })
    }
}
