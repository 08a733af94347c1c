//! Binding of the history: the log of an exploration, shared by the loop in Python and the engine.

use divbandit_core::History;
use divbandit_core::error::check_finite;
use divbandit_core::history::Log;
use numpy::{IntoPyArray, PyArray1, PyArray2, PyArrayMethods};
use pyo3::exceptions::{PyTypeError, PyValueError};
use pyo3::intern;
use pyo3::prelude::*;
use pyo3::types::PyTuple;

use crate::arrays::{Floats, read_only_rows};
use crate::bounds::PyBounds;
use crate::errors::value_error;
use crate::kdtree::found;

/// Rows of numbers, and of indices.
type Rows<'py, T> = Bound<'py, PyArray2<T>>;

/// Commands and effects.
type Points<'py> = (Rows<'py, f64>, Rows<'py, f64>);

/// Commands (if kept), effects, paths and, of a bandit, estimates: an array each.
type Arrays<'py> = (Option<Rows<'py, f64>>, Rows<'py, f64>, Rows<'py, i64>, Option<Rows<'py, f64>>);

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
    ) -> PyResult<Self> {
        let (m, s) = (&motor_space.get().0, sensory_space.map(|space| space.get().0.clone()));
        History::new(m.clone(), s, true, 0).map(Self).map_err(value_error)
    }

    /// Decide, while nothing has been tried, whether commands are kept or forgotten as soon as they
    /// are recorded, and how many estimates are logged with each step.
    fn begin(&mut self, keeps_commands: bool, width: usize) -> PyResult<()> {
        self.0.begin(keeps_commands, width).map_err(value_error)
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
        command: &Bound<'_, PyAny>,
        effect: &Bound<'_, PyAny>,
        path: Vec<u32>,
        estimates: Option<Vec<f64>>,
    ) -> PyResult<()> {
        let command = Floats::point("command", command, Some(self.0.motor_space().dim()))?;
        let effect = Floats::point("effect", effect, self.0.effect_dim())?;
        let estimates = estimates.unwrap_or_default();
        self.0.record(command.slice()?, effect.slice()?, &path, &estimates).map_err(value_error)
    }

    /// Check evaluations made elsewhere: both arrays, and the dimension of the effects.
    fn checked<'py>(
        &self,
        commands: &Bound<'py, PyAny>,
        effects: &Bound<'py, PyAny>,
    ) -> PyResult<(Points<'py>, Option<usize>)> {
        let (py, m) = (commands.py(), self.0.motor_space().dim());
        let commands = Floats::points("commands", commands, m)?.copied()?;
        let (effects, s) = Floats::any_points("effects", effects, self.0.effect_dim())?;
        for (row, command) in commands.chunks_exact(m).enumerate() {
            self.0.motor_space().check("command", command).map_err(|error| {
                PyValueError::new_err(format!("row {row} of commands: {error}"))
            })?;
        }
        check_finite("effects", &effects, s).map_err(value_error)?;
        let n = commands.len() / m;
        if effects.len() != n * s {
            let got = effects.len() / s.max(1);
            return Err(PyValueError::new_err(format!(
                "effects must be as many as the commands, {n}, got {got}"
            )));
        }
        let both = (read_only_rows(py, commands, m)?, read_only_rows(py, effects, s)?);
        Ok((both, (n > 0).then_some(s)))
    }

    /// Record evaluations that were checked: all, or none.
    fn extend(&mut self, points: Points<'_>) -> PyResult<()> {
        let (commands, effects) = (points.0.try_readonly(), points.1.try_readonly());
        let used = |error| PyValueError::new_err(format!("an array is in use elsewhere: {error}"));
        let (commands, effects) = (commands.map_err(used)?, effects.map_err(used)?);
        let (m, s) = (self.0.motor_space().dim(), effects.dims()[1].max(1));
        let rows = commands.as_slice()?.chunks_exact(m).zip(effects.as_slice()?.chunks_exact(s));
        self.0.reserve(rows.len()).map_err(value_error)?;
        for (command, effect) in rows {
            self.0.record(command, effect, &[], &[]).map_err(value_error)?;
        }
        Ok(())
    }

    /// The effects nearest to a goal: as `NearestNeighbors.nearest` finds them.
    fn nearest<'py>(
        &mut self,
        py: Python<'py>,
        goal: &Bound<'py, PyAny>,
        k: &Bound<'py, PyAny>,
    ) -> PyResult<Bound<'py, PyAny>> {
        let observed = self.0.observed().map_err(value_error)?;
        found(py, observed.effects, "goal", goal, Some(k))
    }

    /// The commands from a row on, copied.
    fn commands_from<'py>(&self, py: Python<'py>, first: usize) -> PyResult<Rows<'py, f64>> {
        rows(py, self.0.commands(), self.0.motor_space().dim(), first)
    }

    /// The effects from a row on, copied.
    fn effects_from<'py>(&self, py: Python<'py>, first: usize) -> PyResult<Rows<'py, f64>> {
        rows(py, self.0.effects(), self.0.effect_dim().unwrap_or(0), first)
    }

    /// The paths from a row on.
    fn paths_from<'py>(&self, py: Python<'py>, first: usize) -> PyResult<Vec<Bound<'py, PyTuple>>> {
        let (paths, ends) = self.0.paths();
        let mut row = Vec::new();
        let ends = ends.get(first..).unwrap_or_default();
        ends.iter()
            .map(|&end| {
                row.resize(paths.length(end), 0);
                paths.write(end, &mut row);
                PyTuple::new(py, &row)
            })
            .collect()
    }

    /// Copies of all that was logged: commands, effects, paths, estimates.
    fn arrays<'py>(&self, py: Python<'py>, keep_commands: bool) -> PyResult<Arrays<'py>> {
        // Attached to Python all the while: an exploration in another thread may want to write.
        let log = self.0.clone().into_log().map_err(value_error)?;
        self.as_arrays(py, log, self.0.effect_dim(), keep_commands)
    }

    /// All that was logged, without copies: the log is empty then.
    fn take<'py>(&mut self, py: Python<'py>, keep_commands: bool) -> PyResult<Arrays<'py>> {
        let (space, goals) = (self.0.motor_space().clone(), self.0.sensory_space().cloned());
        let width = self.0.estimates().1;
        let empty =
            History::new(space, goals, self.0.keeps_commands(), width).map_err(value_error)?;
        let dim = self.0.effect_dim();
        let log = std::mem::replace(&mut self.0, empty).into_log().map_err(value_error)?;
        self.as_arrays(py, log, dim, keep_commands)
    }

    fn __len__(&self) -> usize {
        self.0.len()
    }
}

impl PyHistory {
    /// A log of effects of this dimension as arrays; its other widths are those of this history.
    fn as_arrays<'py>(
        &self,
        py: Python<'py>,
        log: Log,
        effect_dim: Option<usize>,
        keep_commands: bool,
    ) -> PyResult<Arrays<'py>> {
        let (n, m, width) = (log.len, self.0.motor_space().dim(), self.0.estimates().1);
        let s = effect_dim.unwrap_or(0);
        let array = |numbers: Vec<f64>, width: usize| numbers.into_pyarray(py).reshape([n, width]);
        Ok((
            if keep_commands { Some(array(log.commands, m)?) } else { None },
            array(log.effects, s)?,
            PyArray1::from_vec(py, log.paths).reshape([n, log.depth])?,
            if width > 0 { Some(array(log.estimates, width)?) } else { None },
        ))
    }
}

/// The log of a history, which is one itself or has it as `_log`.
pub(crate) fn log_of<'py>(history: &Bound<'py, PyAny>) -> PyResult<PyRefMut<'py, PyHistory>> {
    if let Ok(log) = history.cast::<PyHistory>() {
        return Ok(log.try_borrow_mut()?);
    }
    let refused = || {
        let got = history.get_type().name().map_or_else(|_| "an object".into(), |n| n.to_string());
        PyTypeError::new_err(format!("history must be a History, got {got}"))
    };
    let log = history.getattr(intern!(history.py(), "_log")).map_err(|_| refused())?;
    Ok(log.cast::<PyHistory>().map_err(|_| refused())?.try_borrow_mut()?)
}

/// Rows of `width` numbers from row `first` on, copied.
fn rows<'py>(
    py: Python<'py>,
    numbers: &[f64],
    width: usize,
    first: usize,
) -> PyResult<Rows<'py, f64>> {
    let rest = numbers.get(first.saturating_mul(width)..).unwrap_or_default();
    PyArray1::from_slice(py, rest).reshape([rest.len().checked_div(width).unwrap_or(0), width])
}
