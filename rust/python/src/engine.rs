//! Binding of the engine: a composition of the library's own strategies that explores.

use std::collections::HashMap;
use std::time::{Duration, Instant};

use divbandit_core::{Environment, Error, Exploration, History, Proposal};
use pyo3::exceptions::{PyRuntimeError, PyValueError};
use pyo3::prelude::*;
use pyo3::types::PyTuple;

use crate::arrays::{count, read_only};
use crate::composition::Reader;
use crate::environments::{BlackBox, environment_of};
use crate::errors::value_error;
use crate::history::PyHistory;
use crate::parts::class_of;
use crate::random::{Draws, NumpyStream};
use crate::trial::PyTrial;

/// How long the engine runs before it lets Python look for Ctrl-C: seldom enough to cost nothing.
const AT_ONCE: Duration = Duration::from_millis(50);

/// Steps between two looks at the clock.
const STEPS: usize = 64;

/// A composition of the library's own strategies, which explores with a history.
///
/// A trial is known by the number of trials before it. A user-defined part raises a
/// NotBuiltInError.
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
/// >>> from divbandit._core import Bounds, Engine, History
/// >>> history = History(Bounds([-1], [1]), None)
/// >>> engine = Engine(db.Mixture([db.MotorBabbling()]), history)
/// >>> trial = engine.ask(history, np.random.default_rng(0))
/// >>> trial.goal, trial.path, trial.number, engine.asked
/// (None, (0,), 0, 1)
/// >>> engine.tell(0, history, [1.0, 2.0])
/// >>> len(history)
/// 1
#[pyclass(module = "divbandit._core", name = "Engine")]
pub(crate) struct PyEngine {
    exploration: Exploration,
    /// The pending trials, by number.
    open: HashMap<usize, Proposal>,
    /// One that is not in use.
    spare: Proposal,
    asked: usize,
    /// Whether trials tell how probable the outermost choice was: that of a policy, as in Python.
    tells_probability: bool,
    /// Whether the newest effect was recorded, but could not be rewarded.
    refused: bool,
}

#[pymethods]
impl PyEngine {
    #[new]
    fn new(strategy: &Bound<'_, PyAny>, history: PyRef<'_, PyHistory>) -> PyResult<Self> {
        let mut reader = Reader::new(&history.0);
        let root = reader.place("strategy", strategy)?;
        let exploration =
            Exploration::new(reader.composition, root, &history.0).map_err(value_error)?;
        let spare = Proposal::new(history.0.motor_space().dim());
        let tells_probability = class_of(strategy)?.as_deref() == Some("Bandit");
        let open = HashMap::new();
        Ok(Self { exploration, open, spare, asked: 0, tells_probability, refused: false })
    }

    /// How many trials were asked for.
    #[getter]
    fn asked(&self) -> usize {
        self.asked
    }

    /// Whether a strategy looks at the commands of the history.
    #[getter]
    fn needs_commands(&self) -> bool {
        self.exploration.needs_commands()
    }

    /// Whether the newest effect was recorded, but could not be rewarded.
    #[getter]
    fn refused(&self) -> bool {
        self.refused
    }

    /// A bandit's estimates of its strategies; None for any other strategy.
    #[getter]
    fn estimates<'py>(&self, py: Python<'py>) -> PyResult<Option<Bound<'py, PyTuple>>> {
        self.exploration.estimates().map(|means| PyTuple::new(py, means)).transpose()
    }

    /// Let the strategy propose a trial.
    fn ask(
        slf: &Bound<'_, Self>,
        history: &Bound<'_, PyHistory>,
        rng: &Bound<'_, PyAny>,
    ) -> PyResult<PyTrial> {
        let (this, mut log) = (&mut *idle(slf)?, writable(history)?);
        let mut stream = NumpyStream::lock(rng)?;
        this.exploration.propose(&mut log.0, &mut stream, &mut this.spare).map_err(value_error)?;
        drop(stream);
        this.open.insert(this.asked, this.spare.clone());
        this.asked += 1;
        this.proposed(rng.py(), this.asked - 1)
    }

    /// Return a pending trial.
    fn proposed(&self, py: Python<'_>, number: usize) -> PyResult<PyTrial> {
        let proposal = self.open.get(&number).ok_or_else(unknown)?;
        let goal = proposal.goal().map(|goal| read_only(py, goal)).transpose()?;
        let command = read_only(py, proposal.command())?;
        let path = PyTuple::new(py, proposal.path())?;
        let probability = proposal.probability().filter(|_| self.tells_probability);
        Ok(PyTrial::numbered(command, goal, path, probability, number))
    }

    /// Record the effect of a trial, and let the strategy learn from it.
    ///
    /// An effect that is refused is not recorded, and its trial stays under way.
    fn tell(
        slf: &Bound<'_, Self>,
        number: usize,
        history: &Bound<'_, PyHistory>,
        effect: &Bound<'_, PyAny>,
    ) -> PyResult<()> {
        let mut numbers = Vec::new();
        BlackBox::read(effect, history.try_borrow()?.0.effect_dim(), &mut numbers)?;
        let (this, mut log) = (&mut *idle(slf)?, writable(history)?);
        let proposal = this.open.remove(&number).ok_or_else(unknown)?;
        let known = log.0.len();
        let told = this.exploration.observe(&mut log.0, &proposal, &numbers);
        if told.is_err() && log.0.len() == known {
            this.open.insert(number, proposal);
        } else {
            this.spare = proposal;
        }
        told.map_err(value_error)
    }

    /// Let the strategy learn that a trial has failed.
    fn fail(slf: &Bound<'_, Self>, number: usize) -> PyResult<()> {
        let this = &mut *idle(slf)?;
        let proposal = this.open.remove(&number).ok_or_else(unknown)?;
        this.exploration.fail(&proposal);
        Ok(())
    }

    /// Explore an environment for n evaluations.
    ///
    /// `between` is called again and again - after each step where the environment is called back,
    /// every twentieth of a second elsewhere; what it raises ends the run, and so does Ctrl-C. A
    /// trial whose evaluation raises stays pending.
    #[pyo3(signature = (environment, history, n, rng, between))]
    fn run(
        slf: &Bound<'_, Self>,
        environment: &Bound<'_, PyAny>,
        history: &Bound<'_, PyHistory>,
        n: &Bound<'_, PyAny>,
        rng: &Bound<'_, PyAny>,
        between: Option<&Bound<'_, PyAny>>,
    ) -> PyResult<()> {
        // Held until it ends: what is called in between cannot ask or tell.
        let (py, this) = (slf.py(), &mut *idle(slf)?);
        let n = count("n", n)?;
        this.refused = false;
        match environment_of(environment)? {
            Some(kernel) => {
                writable(history)?.0.reserve(n).map_err(value_error)?;
                this.run_in_rust(py, kernel, history, n, rng, between)
            }
            None => this.run_in_python(&BlackBox::of(environment)?, history, n, rng, between),
        }
    }
}

impl PyEngine {
    /// Explores a black box, which is called back for each effect.
    fn run_in_python(
        &mut self,
        black_box: &BlackBox<'_>,
        history: &Bound<'_, PyHistory>,
        n: usize,
        rng: &Bound<'_, PyAny>,
        between: Option<&Bound<'_, PyAny>>,
    ) -> PyResult<()> {
        let py = history.py();
        writable(history)?.0.check_room(n).map_err(value_error)?;
        let mut effect = Vec::new();
        for _ in 0..n {
            {
                // Locked for each step alone: the environment may draw from the same generator.
                let mut stream = NumpyStream::lock(rng)?;
                let log = &mut writable(history)?.0;
                self.exploration.propose(log, &mut stream, &mut self.spare).map_err(value_error)?;
            }
            let number = self.asked;
            self.asked += 1;
            if let Err(error) = self.evaluate(black_box, history, &mut effect) {
                if !self.refused {
                    self.open.insert(number, self.spare.clone());
                }
                return Err(error);
            }
            py.check_signals()?;
            if let Some(between) = between {
                between.call0()?;
            }
        }
        Ok(())
    }

    /// Finds the effect of the trial proposed last, and records it.
    fn evaluate(
        &mut self,
        black_box: &BlackBox<'_>,
        history: &Bound<'_, PyHistory>,
        effect: &mut Vec<f64>,
    ) -> PyResult<()> {
        let dim = history.try_borrow()?.0.effect_dim();
        black_box.evaluate(history.py(), self.spare.command(), dim, effect)?;
        let log = &mut writable(history)?.0;
        let known = log.len();
        let observed = self.exploration.observe(log, &self.spare, effect);
        self.refused = observed.is_err() && log.len() > known;
        observed.map_err(value_error)
    }

    /// Explores an environment in Rust, detached from Python for a while at a time.
    fn run_in_rust(
        &mut self,
        py: Python<'_>,
        mut environment: Box<dyn Environment>,
        history: &Bound<'_, PyHistory>,
        n: usize,
        rng: &Bound<'_, PyAny>,
        between: Option<&Bound<'_, PyAny>>,
    ) -> PyResult<()> {
        let mut left = n;
        while left > 0 {
            {
                // Locked for a while alone: what handles a signal may draw from the same generator.
                let mut stream = NumpyStream::lock(rng)?;
                let draws = stream.draws();
                let log = &mut writable(history)?.0;
                let known = log.len();
                let exploration = &mut self.exploration;
                let done =
                    py.detach(|| for_a_while(exploration, &mut *environment, log, left, draws));
                let made = log.len() - known;
                left -= made;
                self.asked += made;
                if let Err(error) = done {
                    self.refused = true;
                    return Err(value_error(error));
                }
            }
            py.check_signals()?;
            if let Some(between) = between {
                between.call0()?;
            }
        }
        Ok(())
    }
}

/// Runs on for about [`AT_ONCE`], `left` steps at most.
fn for_a_while(
    exploration: &mut Exploration,
    environment: &mut dyn Environment,
    history: &mut History,
    left: usize,
    draws: &mut Draws,
) -> Result<(), Error> {
    let (end, all) = (Instant::now() + AT_ONCE, history.len() + left);
    while history.len() < all && Instant::now() < end {
        let steps = STEPS.min(all - history.len());
        exploration.run(environment, history, steps, draws)?;
    }
    Ok(())
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
