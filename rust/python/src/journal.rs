//! Journal: what an explorer was asked and told, in order, so that it can be replayed.

use std::collections::BTreeMap;

use numpy::PyArray1;
use pyo3::exceptions::PyValueError;
use pyo3::prelude::*;
use pyo3::types::{PyString, PyTuple};

use crate::trial::PyTrial;

/// What can happen to an explorer; a number goes with each event.
const ASK: i64 = 0;
/// How many trials, each asked for and told before the next.
const RUN: i64 = 1;
/// The number of the trial.
const TELL: i64 = 2;
/// The number of the trial.
const FAIL: i64 = 3;
/// How many earlier evaluations were added.
const PAST: i64 = 4;

/// Added to an event: the strategy raised an exception (at the last of several trials); was
/// interrupted, by what is no exception of its own.
const RAISED: i64 = 8;
const INTERRUPTED: i64 = 16;
const SHIFT: u32 = 5;

/// Who failed: the number of the trial, its command, the reason, the path, and how many effects had
/// been observed by then.
type Failed = (usize, Py<PyAny>, Py<PyString>, Py<PyTuple>, usize);

/// All that happened to an explorer, in order: eight bytes an event.
///
/// Examples
/// --------
/// >>> import divbandit as db
/// >>> journal = db._core.Journal()
/// >>> for number in range(3):
/// ...     trial = db.Trial([0.5]).given_out([0.5], journal.asked)
/// ...     journal.give_out(trial)
/// ...     if number < 2:
/// ...         journal.told(trial)
/// >>> journal.asked, journal.open == [trial], journal.events(0).tolist()  # two, one
/// (3, True, [65, 0])
#[pyclass(module = "divbandit._core", name = "Journal")]
#[derive(Default)]
pub(crate) struct PyJournal {
    events: Vec<i64>,
    /// Events before this one have been read, and do not change any more.
    read: usize,
    asked: usize,
    /// The trials under way, by number.
    open: BTreeMap<usize, Py<PyTrial>>,
    failures: Vec<Failed>,
}

#[pymethods]
impl PyJournal {
    #[new]
    fn new() -> Self {
        Self::default()
    }

    /// How many trials were given out.
    #[getter]
    pub fn asked(&self) -> usize {
        self.asked
    }

    /// How many events there are.
    #[getter]
    fn size(&self) -> usize {
        self.events.len()
    }

    /// The trials under way, in the order in which they were given out.
    #[getter]
    fn open(&self, py: Python<'_>) -> Vec<Py<PyTrial>> {
        self.open.values().map(|trial| trial.clone_ref(py)).collect()
    }

    /// Return the events from the one at `first` on; those that were read do not change any more.
    fn events<'py>(&mut self, py: Python<'py>, first: usize) -> Bound<'py, PyArray1<i64>> {
        self.read = self.events.len();
        PyArray1::from_slice(py, self.events.get(first..).unwrap_or_default())
    }

    /// Return the failures from the one at `first` on: the number of the trial, its command, the
    /// reason, the path, and how many effects had been observed by then.
    fn failures(&self, py: Python<'_>, first: usize) -> Vec<Failed> {
        let copy = |(number, command, reason, path, place): &Failed| {
            (*number, command.clone_ref(py), reason.clone_ref(py), path.clone_ref(py), *place)
        };
        self.failures.iter().skip(first).map(copy).collect()
    }

    /// Raise an error unless a trial is under way.
    pub fn find(&self, trial: &Bound<'_, PyTrial>) -> PyResult<usize> {
        let number = trial.get().number();
        number.filter(|number| self.open.get(number).is_some_and(|open| open.is(trial))).ok_or_else(
            || {
                PyValueError::new_err(
                    "trial must be pending: asked for by this explorer, not told and not failed",
                )
            },
        )
    }

    /// Note that a trial is under way; its number must be `asked`.
    pub fn give_out(&mut self, trial: Py<PyTrial>) {
        self.open.insert(self.asked, trial);
        self.asked += 1;
        self.events.push(ASK);
    }

    /// Note that the effect of a trial was recorded.
    pub fn told(&mut self, trial: &Bound<'_, PyTrial>) -> PyResult<()> {
        let number = self.find(trial)?;
        self.open.remove(&number);
        // Where it was the last thing to be asked for, both are one event.
        if number + 1 == self.asked && self.unread() && self.events.last() == Some(&ASK) {
            self.events.pop();
            self.ran(1);
        } else {
            self.note(TELL, number);
        }
        Ok(())
    }

    /// Note that a trial has failed, and why; `place` effects had been observed by then.
    pub fn failed(
        &mut self,
        trial: &Bound<'_, PyTrial>,
        reason: Py<PyString>,
        place: usize,
    ) -> PyResult<()> {
        let number = self.find(trial)?;
        let (py, given) = (trial.py(), trial.get());
        let (command, path) = (given.command.clone_ref(py), given.path.clone_ref(py));
        self.failures.push((number, command, reason, path, place));
        self.open.remove(&number);
        self.note(FAIL, number);
        Ok(())
    }

    /// Note that earlier evaluations were added.
    fn added(&mut self, count: usize) {
        self.note(PAST, count);
    }

    /// Note that the strategy raised an exception, or was interrupted, instead of proposing.
    #[pyo3(signature = (interrupted=false))]
    pub fn refused(&mut self, interrupted: bool) {
        self.events.push(ASK);
        self.raised(interrupted);
    }

    /// Note that the strategy raised an exception, or was interrupted, when it learned of the
    /// newest event.
    #[pyo3(signature = (interrupted=false))]
    pub fn raised(&mut self, interrupted: bool) {
        if let Some(event) = self.events.last_mut() {
            *event |= if interrupted { INTERRUPTED } else { RAISED };
        }
    }
}

impl PyJournal {
    /// Notes that so many trials were asked for and told, one after the other, by the engine.
    pub fn made(&mut self, count: usize) {
        self.asked += count;
        self.ran(count);
    }

    fn ran(&mut self, count: usize) {
        if count == 0 {
            return;
        }
        if self.unread()
            && let Some(last) = self.events.last_mut()
            && *last & ((1 << SHIFT) - 1) == RUN
        {
            *last += (count as i64) << SHIFT;
            return;
        }
        self.note(RUN, count);
    }

    /// Whether the newest event can still change.
    fn unread(&self) -> bool {
        self.events.len() > self.read
    }

    fn note(&mut self, event: i64, number: usize) {
        self.events.push((number as i64) << SHIFT | event);
    }
}
