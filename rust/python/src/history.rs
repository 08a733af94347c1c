//! Binding of the history: the log of an exploration, shared by the loop in Python and the engine.

use divbandit_core::History;
use divbandit_core::error::check_finite;
use divbandit_core::history::Log;
use numpy::{PyArray1, PyArray2, PyArrayMethods};
use pyo3::exceptions::PyValueError;
use pyo3::intern;
use pyo3::prelude::*;
use pyo3::types::PyTuple;

use crate::arrays::{Any, Array2, Floats, locked, rows, wrong_type};
use crate::bounds::PyBounds;
use crate::errors::Result;
use crate::kdtree::found;

/// Commands and effects.
type Points<'py> = (Array2<'py>, Array2<'py>);

/// Commands (if kept), effects, paths and, of a bandit, estimates: an array each.
type Arrays<'py> =
    (Option<Array2<'py>>, Array2<'py>, Bound<'py, PyArray2<i64>>, Option<Array2<'py>>);

/// The log of an exploration, and the k-d tree of its effects.
///
/// Parameters
/// ----------
/// motor_space : Bounds
/// sensory_space : Bounds, optional
///
/// Examples
/// --------
/// >>> from divbandit._core import Bounds, History
/// >>> history = History(Bounds([-1], [1]), None)
/// >>> history.record([0.5], [1.0, 2.0], (0, 1), None)
/// >>> history.effect_dim, len(history), history.paths_from(0)
/// (2, 1, [(0, 1)])
#[pyclass(module = "divbandit._core", name = "History")]
pub(crate) struct PyHistory(pub History);

#[pymethods]
impl PyHistory {
    #[new]
    #[pyo3(signature = (motor_space, sensory_space))]
    fn new(
        motor_space: &Bound<'_, PyBounds>,
        sensory_space: Option<&Bound<'_, PyBounds>>,
    ) -> Result<Self> {
        let (m, s) = (&motor_space.get().0, sensory_space.map(|space| space.get().0.clone()));
        Ok(Self(History::new(m.clone(), s, true, 0)?))
    }

    /// Decide, while nothing has been tried, whether commands are kept or forgotten as soon as they
    /// are recorded, and how many estimates are logged with each step.
    fn begin(&mut self, keeps_commands: bool, width: usize) -> Result<()> {
        Ok(self.0.begin(keeps_commands, width)?)
    }

    /// Whether commands are kept, and not forgotten as soon as they are recorded.
    #[getter]
    fn keeps_commands(&self) -> bool {
        self.0.keeps_commands()
    }

    /// The dimension of the effects; None until there is one.
    #[getter]
    fn effect_dim(&self) -> Option<usize> {
        self.0.effect_dim()
    }

    /// Record one evaluation, who proposed it, and the bandit's estimates.
    fn record(
        &mut self,
        command: &Any<'_>,
        effect: &Any<'_>,
        path: Vec<u32>,
        estimates: Option<Vec<f64>>,
    ) -> Result<()> {
        let command = Floats::point("command", command, Some(self.0.motor_space().dim()))?;
        let effect = Floats::point("effect", effect, self.0.effect_dim())?;
        let estimates = estimates.unwrap_or_default();
        Ok(self.0.record(command.slice()?, effect.slice()?, &path, &estimates)?)
    }

    /// Check evaluations made elsewhere: both arrays, and the dimension of the effects.
    fn checked<'py>(
        &self,
        commands: &Any<'py>,
        effects: &Any<'py>,
    ) -> Result<(Points<'py>, Option<usize>)> {
        let (py, m) = (commands.py(), self.0.motor_space().dim());
        let commands = Floats::points("commands", commands, m)?.copied()?;
        let (effects, s) = Floats::any_points("effects", effects, self.0.effect_dim())?;
        for (row, command) in commands.chunks_exact(m).enumerate() {
            self.0.motor_space().check("command", command).map_err(|error| {
                PyValueError::new_err(format!("row {row} of commands: {error}"))
            })?;
        }
        check_finite("effects", &effects, s)?;
        let (n, got) = (commands.len() / m, effects.len() / s);
        if got != n {
            let must_be = format!("effects must be as many as the commands, {n}");
            return Err(PyValueError::new_err(format!("{must_be}, got {got}")).into());
        }
        let both = (locked(rows(py, commands, m)?)?, locked(rows(py, effects, s)?)?);
        Ok((both, (n > 0).then_some(s)))
    }

    /// Record evaluations that were checked: all, or none.
    fn extend(&mut self, points: (Any<'_>, Any<'_>)) -> Result<()> {
        let m = self.0.motor_space().dim();
        let commands = Floats::points("commands", &points.0, m)?;
        let (effects, s) = Floats::any_points("effects", &points.1, self.0.effect_dim())?;
        let pairs = commands.slice()?.chunks_exact(m).zip(effects.chunks_exact(s));
        self.0.reserve(pairs.len())?;
        for (command, effect) in pairs {
            self.0.record(command, effect, &[], &[])?;
        }
        Ok(())
    }

    /// The effects nearest to a goal: as `NearestNeighbors.nearest` finds them.
    fn nearest<'py>(&mut self, goal: &Any<'py>, k: &Any<'py>) -> Result<Any<'py>> {
        found(self.0.observed()?.effects, "goal", goal, Some(k))
    }

    /// The commands from a row on, copied.
    fn commands_from<'py>(&self, py: Python<'py>, first: usize) -> PyResult<Array2<'py>> {
        rows_from(py, self.0.commands(), self.0.motor_space().dim(), first)
    }

    /// The effects from a row on, copied.
    fn effects_from<'py>(&self, py: Python<'py>, first: usize) -> PyResult<Array2<'py>> {
        rows_from(py, self.0.effects(), self.0.effect_dim().unwrap_or(0), first)
    }

    /// The paths from a row on.
    fn paths_from<'py>(&self, py: Python<'py>, first: usize) -> PyResult<Vec<Bound<'py, PyTuple>>> {
        let (paths, ends) = self.0.paths();
        let mut row = Vec::new();
        let path = |&end: &u32| {
            row.resize(paths.length(end), 0);
            paths.write(end, &mut row);
            PyTuple::new(py, &row)
        };
        ends.get(first..).unwrap_or_default().iter().map(path).collect()
    }

    /// Copies of all that was logged: commands, effects, paths, estimates.
    fn arrays<'py>(&self, py: Python<'py>, keep_commands: bool) -> Result<Arrays<'py>> {
        // Attached to Python all the while: an exploration in another thread may want to write.
        arrays_of(py, self.0.clone(), keep_commands)
    }

    /// All that was logged, without copies: the log is empty then.
    fn take<'py>(&mut self, py: Python<'py>, keep_commands: bool) -> Result<Arrays<'py>> {
        let (space, goals) = (self.0.motor_space().clone(), self.0.sensory_space().cloned());
        let width = self.0.estimates().1;
        let empty = History::new(space, goals, self.0.keeps_commands(), width)?;
        let history = std::mem::replace(&mut self.0, empty);
        arrays_of(py, history, keep_commands)
    }

    fn __len__(&self) -> usize {
        self.0.len()
    }
}

/// The log of a history as arrays.
fn arrays_of(py: Python<'_>, history: History, keep_commands: bool) -> Result<Arrays<'_>> {
    let (m, width) = (history.motor_space().dim(), history.estimates().1);
    let s = history.effect_dim().unwrap_or(0);
    let Log { len, commands, effects, paths, depth, estimates } = history.into_log()?;
    Ok((
        keep_commands.then(|| rows(py, commands, m)).transpose()?,
        rows(py, effects, s)?,
        PyArray1::from_vec(py, paths).reshape([len, depth])?,
        (width > 0).then(|| rows(py, estimates, width)).transpose()?,
    ))
}

/// The log of a history, which is one itself or has it as `_log`.
pub(crate) fn log_of<'py>(history: &Any<'py>) -> PyResult<PyRefMut<'py, PyHistory>> {
    if let Ok(log) = history.cast::<PyHistory>() {
        return Ok(log.try_borrow_mut()?);
    }
    let refused = || wrong_type("history", "a History", history);
    let log = history.getattr(intern!(history.py(), "_log")).map_err(|_| refused())?;
    Ok(log.cast::<PyHistory>().map_err(|_| refused())?.try_borrow_mut()?)
}

/// Rows of `width` numbers from row `first` on, copied.
fn rows_from<'py>(
    py: Python<'py>,
    numbers: &[f64],
    width: usize,
    first: usize,
) -> PyResult<Array2<'py>> {
    rows(py, numbers.get(first.saturating_mul(width)..).unwrap_or_default().to_vec(), width)
}
