//! Trial: a motor command that a strategy proposes, and why.

use pyo3::prelude::*;
use pyo3::types::{PyDict, PyTuple, PyType};

use crate::arrays::{Any, Array1};

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
#[pyclass(module = "divbandit", name = "Trial", frozen, subclass, get_all)]
pub(crate) struct PyTrial {
    pub command: Py<PyAny>,
    goal: Option<Py<PyAny>>,
    pub path: Py<PyTuple>,
    probability: Option<f64>,
    inner: Option<Py<PyTrial>>,
    number: Option<usize>,
}

impl PyTrial {
    /// How many trials its explorer gave out before.
    pub fn number(&self) -> Option<usize> {
        self.number
    }

    /// A trial that the engine gives out.
    pub fn numbered(
        command: Array1<'_>,
        goal: Option<Array1<'_>>,
        path: Bound<'_, PyTuple>,
        probability: Option<f64>,
        number: usize,
    ) -> Self {
        let (command, goal) =
            (command.into_any().unbind(), goal.map(|goal| goal.into_any().unbind()));
        Self { command, goal, path: path.unbind(), probability, inner: None, number: Some(number) }
    }

    /// The same trial as another object.
    fn copied(&self, py: Python<'_>) -> Self {
        Self {
            command: self.command.clone_ref(py),
            goal: self.goal.as_ref().map(|goal| goal.clone_ref(py)),
            path: self.path.clone_ref(py),
            probability: self.probability,
            inner: self.inner.as_ref().map(|inner| inner.clone_ref(py)),
            number: self.number,
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
    fn of<'py>(class: &Bound<'py, PyType>, proposal: Any<'py>) -> PyResult<Bound<'py, PyTrial>> {
        let new = |proposal: Any<'py>| Self::new(class.py(), proposal.unbind(), None);
        proposal.cast_into().or_else(|other| Bound::new(class.py(), new(other.into_inner())))
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
        let outer = PyTuple::new(py, [index])?.into_sequence();
        let path = outer.concat(this.path.bind(py).as_sequence())?.to_tuple()?.unbind();
        let inner = Some(slf.clone().unbind());
        Ok(Self { path, probability, inner, number: None, ..this.copied(py) })
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
        let inner = Some(slf.clone().unbind());
        Self { command, inner, number: Some(number), ..slf.get().copied(slf.py()) }
    }

    fn __reduce__<'py>(slf: &Bound<'py, Self>) -> PyResult<Bound<'py, PyTuple>> {
        let Self { command, goal, path, probability, inner, number } = slf.get();
        let state = (command, goal, path, probability, inner, number);
        let again = slf.get_type().getattr("_again")?;
        (again, state, slf.getattr("__dict__").ok()).into_pyobject(slf.py())
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
    ) -> PyResult<Any<'py>> {
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
        let goal = self.goal.as_ref().map(|goal| goal.bind(py).repr()).transpose()?;
        let goal = goal.map_or(String::new(), |goal| format!(", goal={goal}"));
        Ok(format!("Trial({}{goal}, path={})", self.command.bind(py).repr()?, self.path))
    }
}
