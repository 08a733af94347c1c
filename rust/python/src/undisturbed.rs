//! Ctrl-C, put off until a step is complete.

use std::sync::Mutex;
use std::sync::atomic::{AtomicBool, Ordering};
use std::thread::{ThreadId, current};
use std::time::{Duration, Instant};

use pyo3::exceptions::PyValueError;
use pyo3::prelude::*;
use pyo3::sync::PyOnceLock;
use pyo3::types::PyTuple;

/// The number of SIGINT, on every system.
const SIGINT: i32 = 2;

/// A second Ctrl-C is heard at once if it comes so much later.
const PATIENCE: Duration = Duration::from_secs(1);

/// A handler of Ctrl-C that does what the usual one does, but not in the middle of a step.
#[pyclass(frozen)]
struct Later {
    usual: Py<PyAny>,
    /// The thread that hears Ctrl-C: the main one.
    thread: ThreadId,
    in_step: AtomicBool,
    /// When Ctrl-C was first pressed in this step.
    pressed: Mutex<Option<Instant>>,
}

#[pymethods]
impl Later {
    fn __call__(&self, py: Python<'_>, number: i32, frame: Py<PyAny>) -> PyResult<()> {
        if self.in_step.load(Ordering::Relaxed)
            && let Ok(mut pressed) = self.pressed.lock()
            && pressed.get_or_insert_with(Instant::now).elapsed() < PATIENCE
        {
            return Ok(());
        }
        self.usual.call1(py, (number, frame)).map(|_| ())
    }
}

impl Later {
    /// Calls a function; a Ctrl-C that comes meanwhile is heard when it has ended.
    fn step<'py>(
        &self,
        function: &Bound<'py, PyAny>,
        args: &Bound<'py, PyTuple>,
    ) -> PyResult<Bound<'py, PyAny>> {
        if self.in_step.swap(true, Ordering::Relaxed) {
            return function.call1(args); // a step within a step
        }
        let result = function.call1(args);
        self.in_step.store(false, Ordering::Relaxed);
        let pressed = self.pressed.lock().is_ok_and(|mut pressed| pressed.take().is_some());
        if pressed {
            self.usual.call1(function.py(), (SIGINT, function.py().None()))?;
        }
        result
    }
}

/// Call a function with arguments; a Ctrl-C that comes meanwhile is heard when it has ended.
///
/// If it takes more than a second, another Ctrl-C is heard at once.
///
/// Examples
/// --------
/// >>> from divbandit._core import undisturbed
/// >>> undisturbed(max, 1, 2)
/// 2
#[pyfunction]
#[pyo3(signature = (function, *args))]
pub(crate) fn undisturbed<'py>(
    function: &Bound<'py, PyAny>,
    args: &Bound<'py, PyTuple>,
) -> PyResult<Bound<'py, PyAny>> {
    with_later(function.py(), |later| match later {
        Some(later) => later.step(function, args),
        None => function.call1(args),
    })
}

/// Call a function with arguments; calls of `undisturbed` in it take less time.
///
/// Examples
/// --------
/// >>> from divbandit._core import interruptible, undisturbed
/// >>> interruptible(undisturbed, max, 1, 2)
/// 2
#[pyfunction]
#[pyo3(signature = (function, *args))]
pub(crate) fn interruptible<'py>(
    function: &Bound<'py, PyAny>,
    args: &Bound<'py, PyTuple>,
) -> PyResult<Bound<'py, PyAny>> {
    with_later(function.py(), |_| function.call1(args))
}

/// Does something while Ctrl-C is handled by a [`Later`]; without one where this thread does not
/// hear it, or Python does not handle it.
fn with_later<'py, T>(
    py: Python<'py>,
    body: impl FnOnce(Option<&Later>) -> PyResult<T>,
) -> PyResult<T> {
    static GET: PyOnceLock<Py<PyAny>> = PyOnceLock::new();
    static SET: PyOnceLock<Py<PyAny>> = PyOnceLock::new();
    // Not while Python is shutting down.
    let (Ok(get), Ok(set)) =
        (GET.import(py, "_signal", "getsignal"), SET.import(py, "_signal", "signal"))
    else {
        return body(None);
    };
    let usual = get.call1((SIGINT,))?;
    if let Ok(later) = usual.cast::<Later>() {
        return body(Some(later.get()).filter(|later| later.thread == current().id()));
    }
    if !usual.is_callable() {
        return body(None);
    }
    let handler = Later {
        usual: usual.clone().unbind(),
        thread: current().id(),
        in_step: AtomicBool::new(false),
        pressed: Mutex::new(None),
    };
    let later = Bound::new(py, handler)?;
    match set.call1((SIGINT, &later)) {
        // Only the main thread hears Ctrl-C.
        Err(error) if error.is_instance_of::<PyValueError>(py) => return body(None),
        set => set?,
    };
    let result = body(Some(later.get()));
    if get.call1((SIGINT,))?.is(&later) {
        set.call1((SIGINT, &usual))?;
    }
    result
}
