//! Trial: a motor command that a strategy proposes, and why.

use numpy::PyArray1;
use pyo3::prelude::*;
use pyo3::types::{PyDict, PyTuple, PyType};

/// A motor command that a strategy proposes, and why; it cannot be changed.
///
/// Parameters
/// ----------
/// command : array_like, shape (m,)
///     The motor command.
/// goal : array_like, shape (s,), optional
///     The effect that it is meant to bring about.
///
/// Attributes
/// ----------
/// command, goal
///     As given.
/// path : tuple of int
///     Who proposed it: indices of strategies, outermost first. Empty where one strategy explores
///     alone.
/// probability : float or None
///     The probability of the outermost strategy's choice; None if it is not known.
/// inner : Trial or None
///     For a trial of a composite strategy: the one that its part proposed.
/// number : int or None
///     For a trial of an Explorer: how many it gave out before.
///
/// Examples
/// --------
/// >>> import divbandit as db
/// >>> trial = db.Trial([0.5, 0.5], goal=[1.0])
/// >>> trial.goal, trial.path
/// ([1.0], ())
#[pyclass(module = "divbandit", name = "Trial", frozen, subclass)]
pub(crate) struct PyTrial {
    #[pyo3(get)]
    pub command: Py<PyAny>,
    #[pyo3(get)]
    goal: Option<Py<PyAny>>,
    #[pyo3(get)]
    pub path: Py<PyTuple>,
    #[pyo3(get)]
    probability: Option<f64>,
    #[pyo3(get)]
    inner: Option<Py<PyTrial>>,
    #[pyo3(get)]
    number: Option<usize>,
}

impl PyTrial {
    /// How many trials its explorer gave out before.
    pub fn number(&self) -> Option<usize> {
        self.number
    }

    /// A trial that the engine gives out.
    pub fn numbered(
        command: Bound<'_, PyArray1<f64>>,
        goal: Option<Bound<'_, PyArray1<f64>>>,
        path: Bound<'_, PyTuple>,
        probability: Option<f64>,
        number: usize,
    ) -> Self {
        Self {
            command: command.into_any().unbind(),
            goal: goal.map(|goal| goal.into_any().unbind()),
            path: path.unbind(),
            probability,
            inner: None,
            number: Some(number),
        }
    }
}

#[pymethods]
impl PyTrial {
    #[new]
    #[pyo3(signature = (command, *, goal=None))]
    fn new(py: Python<'_>, command: Py<PyAny>, goal: Option<Py<PyAny>>) -> Self {
        let path = PyTuple::empty(py).unbind();
        Self { command, goal, path, probability: None, inner: None, number: None }
    }

    /// Return what a strategy proposed as a Trial if it is not one already.
    ///
    /// Examples
    /// --------
    /// >>> import divbandit as db
    /// >>> db.Trial.of([0.5]).command
    /// [0.5]
    #[classmethod]
    fn of<'py>(
        _class: &Bound<'py, PyType>,
        proposal: Bound<'py, PyAny>,
    ) -> PyResult<Bound<'py, PyTrial>> {
        if let Ok(trial) = proposal.cast::<PyTrial>() {
            return Ok(trial.clone());
        }
        let py = proposal.py();
        Bound::new(py, Self::new(py, proposal.unbind(), None))
    }

    /// Return this trial as one of a composite strategy, whose part `index` proposed it.
    ///
    /// Parameters
    /// ----------
    /// index : int
    /// probability : float, optional
    ///     With which probability that part was chosen.
    ///
    /// Examples
    /// --------
    /// >>> import divbandit as db
    /// >>> db.Trial([0.5]).proposed_by(1).proposed_by(0).path
    /// (0, 1)
    #[pyo3(signature = (index, probability=None))]
    fn proposed_by(
        slf: &Bound<'_, Self>,
        index: usize,
        probability: Option<f64>,
    ) -> PyResult<Self> {
        let (py, this) = (slf.py(), slf.get());
        let inner = this.path.bind(py);
        let path = if inner.is_empty() {
            PyTuple::new(py, [index])?
        } else {
            let mut path = vec![index.into_pyobject(py)?.into_any()];
            path.extend(inner.iter());
            PyTuple::new(py, path)?
        };
        Ok(Self {
            command: this.command.clone_ref(py),
            goal: this.goal.as_ref().map(|goal| goal.clone_ref(py)),
            path: path.unbind(),
            probability,
            inner: Some(slf.clone().unbind()),
            number: None,
        })
    }

    /// Return what an Explorer gives out of this proposal: a command that was checked, numbered.
    ///
    /// Examples
    /// --------
    /// >>> import divbandit as db
    /// >>> proposed = db.Trial([0.5])
    /// >>> given = proposed.given_out([0.5], 3)
    /// >>> given.number, given.inner is proposed
    /// (3, True)
    fn given_out(slf: &Bound<'_, Self>, command: Py<PyAny>, number: usize) -> Self {
        let (py, this) = (slf.py(), slf.get());
        Self {
            command,
            goal: this.goal.as_ref().map(|goal| goal.clone_ref(py)),
            path: this.path.clone_ref(py),
            probability: this.probability,
            inner: Some(slf.clone().unbind()),
            number: Some(number),
        }
    }

    fn __reduce__<'py>(slf: &Bound<'py, Self>) -> PyResult<Bound<'py, PyTuple>> {
        let (py, this) = (slf.py(), slf.get());
        let state = (
            this.command.clone_ref(py),
            this.goal.as_ref().map(|goal| goal.clone_ref(py)),
            this.path.clone_ref(py),
            this.probability,
            this.inner.as_ref().map(|inner| inner.clone_ref(py)),
            this.number,
        );
        let again = slf.get_type().getattr("_again")?;
        let attributes = slf.getattr("__dict__").ok();
        (again, state, attributes).into_pyobject(py)
    }

    /// Return a trial with these fields, as a copy or a pickle has them.
    #[classmethod]
    fn _again<'py>(
        class: &Bound<'py, PyType>,
        command: Py<PyAny>,
        goal: Option<Py<PyAny>>,
        path: Py<PyTuple>,
        probability: Option<f64>,
        inner: Option<Py<PyTrial>>,
        number: Option<usize>,
    ) -> PyResult<Bound<'py, PyAny>> {
        let py = class.py();
        if class.is(py.get_type::<PyTrial>()) {
            let trial = Self { command, goal, path, probability, inner, number };
            return Ok(Bound::new(py, trial)?.into_any());
        }
        // A subclass keeps what it adds in its attributes, which are set afterwards.
        let options = PyDict::new(py);
        options.set_item("goal", goal)?;
        py.get_type::<PyTrial>().call_method("__new__", (class, command), Some(&options))
    }

    fn __repr__(&self, py: Python<'_>) -> PyResult<String> {
        let command = self.command.bind(py).repr()?;
        let mut text = format!("Trial({command}");
        if let Some(goal) = &self.goal {
            text += &format!(", goal={}", goal.bind(py).repr()?);
        }
        Ok(format!("{text}, path={})", self.path.bind(py).repr()?))
    }
}
