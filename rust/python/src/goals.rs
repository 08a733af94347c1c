//! Bindings of the searches for goals.

use divbandit_core::goals::{self as searches, Untried};
use numpy::{PyArray1, PyArrayMethods};
use pyo3::exceptions::PyValueError;
use pyo3::prelude::*;

use crate::arrays::{count, number, read_only};
use crate::bounds::PyBounds;
use crate::errors::value_error;
use crate::kdtree::PyNearestNeighbors;
use crate::random::NumpyStream;

/// A goal farther than `tau` from every effect: the first of at most `tries`, or else the last.
///
/// Examples
/// --------
/// >>> import numpy as np
/// >>> from divbandit._core import Bounds, NearestNeighbors, uncovered_goal
/// >>> effects = NearestNeighbors(1)
/// >>> effects.add([0.6])
/// >>> uncovered_goal(Bounds([0], [1]), 0.1, 5, effects, np.random.default_rng(0))
/// array([0.26978671])
#[pyfunction]
pub(crate) fn uncovered_goal<'py>(
    goals: &Bound<'py, PyBounds>,
    tau: &Bound<'py, PyAny>,
    tries: &Bound<'py, PyAny>,
    effects: PyRef<'py, PyNearestNeighbors>,
    rng: &Bound<'py, PyAny>,
) -> PyResult<Bound<'py, PyArray1<f64>>> {
    let (tau, tries) = (number("tau", tau)?, count("tries", tries)?);
    let mut stream = NumpyStream::lock(rng)?;
    let goal = searches::uncovered(&goals.get().0, tau, tries, &effects.0, &mut stream)
        .map_err(value_error)?;
    read_only(rng.py(), &goal)
}

/// A goal that no effect covers, moved to between `tau` and `reach` times `tau` from the nearest.
///
/// Examples
/// --------
/// >>> import numpy as np
/// >>> from divbandit._core import Bounds, NearestNeighbors, frontier_goal
/// >>> effects = NearestNeighbors(1)
/// >>> effects.add([0.0])
/// >>> frontier_goal(Bounds([0], [1]), 0.1, 3.0, 5, effects, np.random.default_rng(0))
/// array([0.28255112])
#[pyfunction]
pub(crate) fn frontier_goal<'py>(
    goals: &Bound<'py, PyBounds>,
    tau: &Bound<'py, PyAny>,
    reach: &Bound<'py, PyAny>,
    tries: &Bound<'py, PyAny>,
    effects: PyRef<'py, PyNearestNeighbors>,
    rng: &Bound<'py, PyAny>,
) -> PyResult<Bound<'py, PyArray1<f64>>> {
    let (tau, reach, tries) =
        (number("tau", tau)?, number("reach", reach)?, count("tries", tries)?);
    let mut stream = NumpyStream::lock(rng)?;
    let goal = searches::frontier(&goals.get().0, tau, reach, tries, &effects.0, &mut stream)
        .map_err(value_error)?;
    read_only(rng.py(), &goal)
}

/// Of `candidates` goals the one whose nearest effect is farthest away.
///
/// Examples
/// --------
/// >>> import numpy as np
/// >>> from divbandit._core import Bounds, NearestNeighbors, novel_goal
/// >>> effects = NearestNeighbors(1)
/// >>> effects.add([0.6])
/// >>> novel_goal(Bounds([0], [1]), 3, effects, np.random.default_rng(0))
/// array([0.04097352])
#[pyfunction]
pub(crate) fn novel_goal<'py>(
    goals: &Bound<'py, PyBounds>,
    candidates: &Bound<'py, PyAny>,
    effects: PyRef<'py, PyNearestNeighbors>,
    rng: &Bound<'py, PyAny>,
) -> PyResult<Bound<'py, PyArray1<f64>>> {
    let candidates = count("candidates", candidates)?;
    let mut stream = NumpyStream::lock(rng)?;
    let goal = searches::novel(&goals.get().0, candidates, &effects.0, &mut stream)
        .map_err(value_error)?;
    read_only(rng.py(), &goal)
}

/// Of up to `candidates` goals that no effect covers the one whose nearest effect has the least of
/// `counts`, which is raised by 1.
///
/// Examples
/// --------
/// >>> import numpy as np
/// >>> from divbandit._core import Bounds, NearestNeighbors, untried_goal
/// >>> effects = NearestNeighbors(1)
/// >>> effects.extend([[0.0], [1.0]])
/// >>> counts, rng = np.array([1, 0], dtype=np.uint32), np.random.default_rng(0)
/// >>> untried_goal(Bounds([0], [1]), 0.1, 5, 20, 2.0, effects, counts, rng)
/// array([0.8])
/// >>> counts
/// array([1, 1], dtype=uint32)
#[pyfunction]
#[expect(clippy::too_many_arguments, reason = "options by keyword are Python's, not the kernel's")]
pub(crate) fn untried_goal<'py>(
    goals: &Bound<'py, PyBounds>,
    tau: &Bound<'py, PyAny>,
    candidates: &Bound<'py, PyAny>,
    tries: &Bound<'py, PyAny>,
    reach: &Bound<'py, PyAny>,
    effects: PyRef<'py, PyNearestNeighbors>,
    counts: &Bound<'py, PyArray1<u32>>,
    rng: &Bound<'py, PyAny>,
) -> PyResult<Bound<'py, PyArray1<f64>>> {
    let (tau, reach) = (number("tau", tau)?, number("reach", reach)?);
    let (candidates, tries) = (count("candidates", candidates)?, count("tries", tries)?);
    let search = Untried::new(tau, candidates, tries, reach).map_err(value_error)?;
    let mut counts = counts
        .try_readwrite()
        .map_err(|error| PyValueError::new_err(format!("counts cannot be written to: {error}")))?;
    let mut stream = NumpyStream::lock(rng)?;
    let goal = search
        .sample(&goals.get().0, &effects.0, counts.as_slice_mut()?, &mut stream)
        .map_err(value_error)?;
    read_only(rng.py(), &goal)
}
