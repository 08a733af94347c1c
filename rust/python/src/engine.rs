//! Binding of the engine: explorations of built-in parts alone, from the first step to the last.

use std::time::{Duration, Instant};

use divbandit_core::bandits::Adapt;
use divbandit_core::exploration::Log;
use divbandit_core::obstructed_arm::Moving;
use divbandit_core::push_arm::Pushing;
use divbandit_core::strategies::{GoalBabbling, Mixture, MotorBabbling, Schedule};
use divbandit_core::{Bounds, Composition, Environment, Error, Exploration, History};
use numpy::{IntoPyArray, PyArray1, PyArray2, PyArrayMethods};
use pyo3::exceptions::PyValueError;
use pyo3::prelude::*;

use crate::arm::PyPlanarArm;
use crate::arrays::count;
use crate::bounds::PyBounds;
use crate::coverage::PyCoverage;
use crate::errors::value_error;
use crate::obstructed_arm::PyObstructedArm;
use crate::push_arm::PyPushArm;
use crate::random::{Draws, NumpyStream};

/// How long the engine runs before it lets Python look for Ctrl-C: seldom enough to cost nothing.
const AT_ONCE: Duration = Duration::from_millis(50);

/// Steps between two looks at the clock.
const STEPS: usize = 64;

/// Commands (if kept), effects, paths and, of a bandit, diversities: an array each.
type Arrays<'py> = (
    Option<Bound<'py, PyArray2<f64>>>,
    Bound<'py, PyArray2<f64>>,
    Bound<'py, PyArray2<i64>>,
    Option<Bound<'py, PyArray2<f64>>>,
);

/// An exploration to be: an environment and strategies, told one by one, then run at once.
///
/// Each strategy is known by the number that telling it returned.
///
/// Parameters
/// ----------
/// motor_space : Bounds
/// sensory_space : Bounds, optional
///
/// Examples
/// --------
/// >>> import numpy as np
/// >>> from divbandit._core import Bounds, Engine, PlanarArm
/// >>> engine = Engine(Bounds([-1], [1]), Bounds([-1, -1], [1, 1]))
/// >>> engine.planar_arm(PlanarArm(1, 1.0))
/// (1, 2)
/// >>> parts = [engine.motor_babbling(), engine.goal_babbling(0.05, None)]
/// >>> mixture = engine.mixture(parts, [0.5, 0.5])
/// >>> commands, effects, paths, _ = engine.explore(mixture, 4, np.random.default_rng(0), True, None)
/// >>> commands.shape, effects.shape, paths.ravel()
/// ((4, 1), (4, 2), array([1, 0, 1, 1]))
#[pyclass(module = "divbandit._core", name = "Engine")]
pub(crate) struct PyEngine {
    motor_space: Bounds,
    sensory_space: Option<Bounds>,
    environment: Option<Box<dyn Environment>>,
    strategies: Composition,
}

#[pymethods]
impl PyEngine {
    #[new]
    #[pyo3(signature = (motor_space, sensory_space))]
    fn new(motor_space: &Bound<'_, PyBounds>, sensory_space: Option<&Bound<'_, PyBounds>>) -> Self {
        Self {
            motor_space: motor_space.get().0.clone(),
            sensory_space: sensory_space.map(|space| space.get().0.clone()),
            environment: None,
            strategies: Composition::default(),
        }
    }

    /// Explore this arm; returns the dimensions of its commands and effects.
    fn planar_arm(&mut self, arm: &Bound<'_, PyPlanarArm>) -> (usize, usize) {
        self.explore_it(arm.get().0.clone())
    }

    /// Explore this arm among its obstacles; returns the dimensions of its commands and effects.
    fn obstructed_arm(&mut self, arm: &Bound<'_, PyObstructedArm>) -> (usize, usize) {
        self.explore_it(Moving::from(arm.get().0.clone()))
    }

    /// Explore this arm and its ball; returns the dimensions of its commands and effects.
    fn push_arm(&mut self, arm: &Bound<'_, PyPushArm>) -> (usize, usize) {
        self.explore_it(Pushing::from(arm.get().0.clone()))
    }

    /// Tell of motor babbling.
    fn motor_babbling(&mut self) -> usize {
        self.strategies.add(MotorBabbling)
    }

    /// Tell of goal babbling.
    #[pyo3(signature = (d, goals))]
    fn goal_babbling(&mut self, d: f64, goals: Option<&Bound<'_, PyBounds>>) -> PyResult<usize> {
        let goals = goals.map(|goals| goals.get().0.clone());
        Ok(self.strategies.add(GoalBabbling::new(d, goals).map_err(value_error)?))
    }

    /// Tell of a mixture.
    fn mixture(&mut self, parts: Vec<usize>, weights: Vec<f64>) -> PyResult<usize> {
        let mixture = Mixture::new(weights).map_err(value_error)?;
        self.strategies.compose(mixture, parts).map_err(value_error)
    }

    /// Tell of a schedule: the numbers of steps of all parts but the last, and how far it has got.
    fn schedule(
        &mut self,
        parts: Vec<usize>,
        steps: Vec<u64>,
        phase: usize,
        proposed: u64,
    ) -> PyResult<usize> {
        let schedule = Schedule::new(steps, phase, proposed).map_err(value_error)?;
        self.strategies.compose(schedule, parts).map_err(value_error)
    }

    /// Tell of ADAPT, whose gains an empty Coverage measures.
    fn adapt(
        &mut self,
        parts: Vec<usize>,
        measure: PyRef<'_, PyCoverage>,
        window: usize,
        alpha: f64,
        head_start: usize,
        power: f64,
    ) -> PyResult<usize> {
        let adapt = Adapt::new(parts.len(), measure.0.clone(), window, alpha, head_start)
            .and_then(|adapt| adapt.with_power(power))
            .map_err(value_error)?;
        self.strategies.compose(adapt, parts).map_err(value_error)
    }

    /// Explore with one of the strategies told, for n steps; the engine is then used up.
    ///
    /// Every twentieth of a second `between` is called, if given; what it raises ends the
    /// exploration, and so does Ctrl-C.
    ///
    /// Returns
    /// -------
    /// commands, effects, paths, diversities : arrays of n rows
    ///     No commands where they are not to be kept; no diversities where the strategy is no
    ///     bandit.
    #[pyo3(signature = (strategy, n, rng, keep_commands, between))]
    fn explore<'py>(
        &mut self,
        py: Python<'py>,
        strategy: usize,
        n: &Bound<'py, PyAny>,
        rng: &Bound<'py, PyAny>,
        keep_commands: bool,
        between: Option<&Bound<'py, PyAny>>,
    ) -> PyResult<Arrays<'py>> {
        let n = count("n", n)?;
        let Some(environment) = self.environment.take() else {
            return Err(PyValueError::new_err("the engine must be told of an environment first"));
        };
        let strategies = std::mem::take(&mut self.strategies);
        let (m, s) = (environment.motor_dim(), environment.effect_dim());
        let kept = keep_commands || strategies.needs_commands();
        let (motor_space, sensory_space) = (self.motor_space.clone(), self.sensory_space.clone());
        let history = History::new(motor_space, sensory_space, s, kept).map_err(value_error)?;
        let mut run =
            Exploration::new(environment, history, strategies, strategy).map_err(value_error)?;
        run.reserve(n).map_err(value_error)?;

        while run.len() < n {
            // Locked anew each time: what handles a signal may draw from the same generator.
            let mut stream = NumpyStream::lock(rng)?;
            let draws = stream.draws();
            py.detach(|| for_a_while(&mut run, n, draws)).map_err(value_error)?;
            drop(stream);
            py.check_signals()?;
            if let Some(between) = between {
                between.call0()?;
            }
        }

        let Log { commands, effects, paths, depth, diversities } =
            py.detach(|| run.into_log()).map_err(value_error)?;
        let rows = |numbers: Vec<f64>, width: usize| numbers.into_pyarray(py).reshape([n, width]);
        let beliefs = diversities.len() / n.max(1);
        Ok((
            if keep_commands { Some(rows(commands, m)?) } else { None },
            rows(effects, s)?,
            PyArray1::from_vec(py, paths).reshape([n, depth])?,
            if beliefs > 0 { Some(rows(diversities, beliefs)?) } else { None },
        ))
    }
}

impl PyEngine {
    /// Takes an environment, and returns the dimensions of its commands and effects.
    fn explore_it(&mut self, environment: impl Environment + 'static) -> (usize, usize) {
        let dims = (environment.motor_dim(), environment.effect_dim());
        self.environment = Some(Box::new(environment));
        dims
    }
}

/// Runs on towards `n` steps, for about [`AT_ONCE`].
fn for_a_while(run: &mut Exploration, n: usize, draws: &mut Draws) -> Result<(), Error> {
    let end = Instant::now() + AT_ONCE;
    while run.len() < n && Instant::now() < end {
        run.run(STEPS.min(n - run.len()), draws)?;
    }
    Ok(())
}
