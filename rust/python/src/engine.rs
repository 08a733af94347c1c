//! Binding of the engine: a composition of the library's own strategies that explores.

use std::collections::HashMap;
use std::time::{Duration, Instant};

use divbandit_core::{Environment, Error, Exploration, History, Proposal};
use numpy::{PyArrayMethods, PyReadonlyArray2};
use pyo3::exceptions::{PyRuntimeError, PyValueError};
use pyo3::prelude::*;
use pyo3::types::{PyString, PyTuple};

use crate::arrays::{Any, Floats, count, read_only};
use crate::composition::Reader;
use crate::environments::{BlackBox, environment_of};
use crate::errors::Result;
use crate::history::PyHistory;
use crate::journal::PyJournal;
use crate::parts::class_of;
use crate::random::{Draws, NumpyStream};
use crate::trial::PyTrial;

/// How long the engine runs before it lets Python look for Ctrl-C: seldom enough to cost nothing.
const AT_ONCE: Duration = Duration::from_millis(50);

/// Steps between two looks at the clock.
const STEPS: usize = 64;

/// A composition of the library's own strategies, which explores with a history.
///
/// Each call changes its state, the history and the journal together, or none of them. A
/// user-defined part raises a NotBuiltInError.
///
/// Parameters
/// ----------
/// strategy : Strategy
/// history : History
///
/// Examples
/// --------
/// >>> import numpy as np
/// >>> import divbandit as db
/// >>> from divbandit._core import Bounds, Engine, History, Journal
/// >>> history, journal = History(Bounds([-1], [1]), None), Journal()
/// >>> engine = Engine(db.Mixture([db.MotorBabbling()]), history)
/// >>> trial = engine.ask(history, journal, np.random.default_rng(0))
/// >>> trial.goal, trial.path, trial.number, journal.asked
/// (None, (0,), 0, 1)
/// >>> engine.tell(trial, [1.0, 2.0], history, journal)
/// >>> len(history)
/// 1
#[pyclass(module = "divbandit._core", name = "Engine")]
pub(crate) struct PyEngine {
    exploration: Exploration,
    /// The pending trials, by number.
    open: HashMap<usize, Proposal>,
    /// One that is not in use; after `run`, that of its last trial in Python.
    spare: Proposal,
    /// Whether trials tell how probable the outermost choice was: that of a policy, as in Python.
    tells_probability: bool,
}

#[pymethods]
impl PyEngine {
    #[new]
    fn new(strategy: &Any<'_>, history: PyRef<'_, PyHistory>) -> Result<Self> {
        let mut reader = Reader::new(&history.0);
        let root = reader.place("strategy", strategy)?;
        let exploration = Exploration::new(reader.composition, root, &history.0)?;
        let spare = Proposal::new(history.0.motor_space().dim());
        let tells_probability = class_of(strategy)?.as_deref() == Some("Bandit");
        Ok(Self { exploration, open: HashMap::new(), spare, tells_probability })
    }

    /// Whether a strategy looks at the commands of the history.
    #[getter]
    fn needs_commands(&self) -> bool {
        self.exploration.needs_commands()
    }

    /// A bandit's estimates of its strategies; None for any other strategy.
    #[getter]
    fn estimates<'py>(&self, py: Python<'py>) -> PyResult<Option<Bound<'py, PyTuple>>> {
        self.exploration.estimates().map(|means| PyTuple::new(py, means)).transpose()
    }

    /// Let the strategy propose a trial.
    fn ask<'py>(
        slf: &Bound<'py, Self>,
        history: &Bound<'py, PyHistory>,
        journal: &Bound<'py, PyJournal>,
        rng: &Any<'py>,
    ) -> Result<Bound<'py, PyTrial>> {
        let (this, mut log) = (&mut *idle(slf)?, writable(history)?);
        this.propose(&mut log.0, journal, rng)?;
        this.give_out(journal)
    }

    /// Record the effect of a trial, and let the strategy learn from it.
    ///
    /// An effect that is refused is not recorded, and its trial stays under way.
    fn tell(
        slf: &Bound<'_, Self>,
        trial: &Bound<'_, PyTrial>,
        effect: &Any<'_>,
        history: &Bound<'_, PyHistory>,
        journal: &Bound<'_, PyJournal>,
    ) -> Result<()> {
        let number = journal.try_borrow()?.find(trial)?;
        let dim = history.try_borrow()?.0.effect_dim();
        let effect = Floats::finite_point("effect", effect, dim)?;
        let (this, mut log) = (&mut *idle(slf)?, writable(history)?);
        let mut journal = journal.try_borrow_mut()?;
        let proposal = this.open.remove(&number).ok_or_else(unknown)?;
        let known = log.0.len();
        let told = this.exploration.observe(&mut log.0, &proposal, &effect);
        if log.0.len() == known {
            this.open.insert(number, proposal);
        } else {
            this.spare = proposal;
            journal.told(trial)?;
            if told.is_err() {
                journal.raised(false);
            }
        }
        Ok(told?)
    }

    /// Let the strategy learn that a trial has failed.
    fn fail(
        slf: &Bound<'_, Self>,
        trial: &Bound<'_, PyTrial>,
        reason: Py<PyString>,
        history: &Bound<'_, PyHistory>,
        journal: &Bound<'_, PyJournal>,
    ) -> Result<()> {
        let this = &mut *idle(slf)?;
        let mut journal = journal.try_borrow_mut()?;
        let number = journal.find(trial)?;
        let proposal = this.open.remove(&number).ok_or_else(unknown)?;
        journal.failed(trial, reason, history.try_borrow()?.0.len())?;
        this.exploration.fail(&proposal);
        Ok(())
    }

    /// Explore an environment for at most n evaluations, and at most about so many seconds.
    ///
    /// At least one is made. A trial whose evaluation raises stays under way.
    fn run(
        slf: &Bound<'_, Self>,
        environment: &Any<'_>,
        n: &Any<'_>,
        seconds: f64,
        history: &Bound<'_, PyHistory>,
        journal: &Bound<'_, PyJournal>,
        rng: &Any<'_>,
    ) -> Result<()> {
        // Held until it ends: what is called in between cannot ask or tell.
        let this = &mut *idle(slf)?;
        let n = count("n", n)?;
        let end = Duration::try_from_secs_f64(seconds).ok().map(|time| Instant::now() + time);
        match environment_of(environment)? {
            Some(kernel) => {
                writable(history)?.0.reserve(n)?;
                let done = this.run_in_rust(kernel, n, end, history, journal, rng);
                this.spare.clone_from(this.exploration.newest());
                done
            }
            None => {
                let black_box = BlackBox::of(environment)?;
                this.run_in_python(&black_box, n, end, history, journal, rng)
            }
        }
    }

    /// The trial that `run` evaluated last.
    fn newest<'py>(&self, journal: &Bound<'py, PyJournal>) -> Result<Option<Bound<'py, PyTrial>>> {
        let asked = journal.try_borrow()?.asked();
        asked.checked_sub(1).map(|number| self.trial(journal.py(), number)).transpose()
    }

    /// Propose commands and learn from effects as before: all, or up to another command.
    ///
    /// Returns how many were repeated.
    fn repeat(
        slf: &Bound<'_, Self>,
        commands: PyReadonlyArray2<'_, f64>,
        effects: PyReadonlyArray2<'_, f64>,
        history: &Bound<'_, PyHistory>,
        journal: &Bound<'_, PyJournal>,
        rng: &Any<'_>,
    ) -> Result<usize> {
        let this = &mut *idle(slf)?;
        let (m, s) = (commands.dims()[1].max(1), effects.dims()[1].max(1));
        let rows = commands.as_slice()?.chunks_exact(m).zip(effects.as_slice()?.chunks_exact(s));
        for (row, (command, effect)) in rows.enumerate() {
            this.propose(&mut writable(history)?.0, journal, rng)?;
            let proposed = this.spare.command();
            if !proposed.iter().map(|x| x.to_bits()).eq(command.iter().map(|x| x.to_bits())) {
                return Ok(row);
            }
            this.observe(effect, history, journal)?;
            if row % STEPS == 0 {
                history.py().check_signals()?;
            }
        }
        Ok(commands.dims()[0])
    }
}

impl PyEngine {
    /// Lets the strategy propose a trial, in `spare`.
    fn propose(
        &mut self,
        log: &mut History,
        journal: &Bound<'_, PyJournal>,
        rng: &Any<'_>,
    ) -> Result<()> {
        // Locked for each step alone: an environment may draw from the same generator.
        let mut stream = NumpyStream::lock(rng)?;
        let proposed = self.exploration.propose(log, stream.draws(), &mut self.spare);
        if proposed.is_err() {
            journal.try_borrow_mut()?.refused(false);
        }
        Ok(proposed?)
    }

    /// The trial in `spare`.
    fn trial<'py>(&self, py: Python<'py>, number: usize) -> Result<Bound<'py, PyTrial>> {
        let proposal = &self.spare;
        let goal = proposal.goal().map(|goal| read_only(py, goal)).transpose()?;
        let command = read_only(py, proposal.command())?;
        let path = PyTuple::new(py, proposal.path())?;
        let probability = proposal.probability().filter(|_| self.tells_probability);
        Ok(Bound::new(py, PyTrial::numbered(command, goal, path, probability, number))?)
    }

    /// Notes that the trial in `spare` is under way, and returns it.
    fn give_out<'py>(&mut self, journal: &Bound<'py, PyJournal>) -> Result<Bound<'py, PyTrial>> {
        let (py, mut journal) = (journal.py(), journal.try_borrow_mut()?);
        let number = journal.asked();
        let trial = self.trial(py, number)?;
        self.open.insert(number, self.spare.clone());
        journal.give_out(trial.clone().unbind());
        Ok(trial)
    }

    /// Records the effect of the trial in `spare`, which was not given out.
    fn observe(
        &mut self,
        effect: &[f64],
        history: &Bound<'_, PyHistory>,
        journal: &Bound<'_, PyJournal>,
    ) -> Result<()> {
        let (log, mut journal) = (&mut writable(history)?.0, journal.try_borrow_mut()?);
        let known = log.len();
        let observed = self.exploration.observe(log, &self.spare, effect);
        journal.made(log.len() - known);
        if self.exploration.is_unrewarded() {
            journal.raised(false);
        }
        Ok(observed?)
    }

    /// Explores a black box, which is called back for each effect.
    fn run_in_python(
        &mut self,
        black_box: &BlackBox<'_>,
        n: usize,
        end: Option<Instant>,
        history: &Bound<'_, PyHistory>,
        journal: &Bound<'_, PyJournal>,
        rng: &Any<'_>,
    ) -> Result<()> {
        let py = history.py();
        writable(history)?.0.check_room(n)?;
        for _ in 0..n {
            self.propose(&mut writable(history)?.0, journal, rng)?;
            let dim = history.try_borrow()?.0.effect_dim();
            let known = history.try_borrow()?.0.len();
            let evaluated = black_box.effect(py, self.spare.command(), dim).map_err(Into::into);
            let told = evaluated.and_then(|effect| self.observe(&effect, history, journal));
            if let Err(error) = told {
                if history.try_borrow()?.0.len() == known {
                    self.give_out(journal)?;
                }
                return Err(error);
            }
            py.check_signals()?;
            if end.is_some_and(|end| Instant::now() >= end) {
                break;
            }
        }
        Ok(())
    }

    /// Explores an environment in Rust, detached from Python for a while at a time.
    fn run_in_rust(
        &mut self,
        mut environment: Box<dyn Environment>,
        n: usize,
        end: Option<Instant>,
        history: &Bound<'_, PyHistory>,
        journal: &Bound<'_, PyJournal>,
        rng: &Any<'_>,
    ) -> Result<()> {
        let (py, mut left) = (history.py(), n);
        while left > 0 {
            {
                // Locked for a while alone: what handles a signal may draw from the same generator.
                let mut stream = NumpyStream::lock(rng)?;
                let draws = stream.draws();
                let (log, mut journal) = (&mut writable(history)?.0, journal.try_borrow_mut()?);
                let known = log.len();
                let pause = Instant::now() + AT_ONCE;
                let pause = end.map_or(pause, |end| pause.min(end));
                let exploration = &mut self.exploration;
                let done = py
                    .detach(|| run_until(pause, exploration, &mut *environment, log, left, draws));
                let made = log.len() - known;
                left -= made;
                journal.made(made);
                if done.is_err() && self.exploration.is_unrewarded() {
                    journal.raised(false);
                }
                done?;
            }
            py.check_signals()?;
            if end.is_some_and(|end| Instant::now() >= end) {
                break;
            }
        }
        Ok(())
    }
}

/// Runs on until a time, `left` steps at most and one at least.
fn run_until(
    end: Instant,
    exploration: &mut Exploration,
    environment: &mut dyn Environment,
    history: &mut History,
    left: usize,
    draws: &mut Draws,
) -> Result<(), Error> {
    let all = history.len() + left;
    loop {
        let steps = STEPS.min(all - history.len());
        exploration.run(environment, history, steps, draws)?;
        if history.len() == all || Instant::now() >= end {
            return Ok(());
        }
    }
}

/// The engine, unless it is running: an environment that calls it back is refused.
fn idle<'py>(engine: &Bound<'py, PyEngine>) -> PyResult<PyRefMut<'py, PyEngine>> {
    engine.try_borrow_mut().map_err(|_| {
        PyRuntimeError::new_err("an exploration must not be asked or told while it runs")
    })
}

/// The history, unless another thread is reading it.
fn writable<'py>(history: &Bound<'py, PyHistory>) -> PyResult<PyRefMut<'py, PyHistory>> {
    history
        .try_borrow_mut()
        .map_err(|_| PyRuntimeError::new_err("history must not be in use by another thread"))
}

fn unknown() -> PyErr {
    PyValueError::new_err("trial must be pending: asked for, not told and not failed")
}
