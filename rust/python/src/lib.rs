//! Python bindings of the divbandit kernels: the compiled module `divbandit._core`.
//!
//! One file beside each kernel; `arrays` holds every check of what comes in as an array or a
//! number, `errors` the way from a kernel's error to a Python exception, and `random` the one
//! use of unsafe code, drawing from NumPy's generators.

#![deny(unsafe_code)]

mod arm;
mod arrays;
mod bounds;
mod composition;
mod coverage;
mod elementary;
mod engine;
mod environments;
mod errors;
mod estimators;
mod goals;
mod history;
mod inverse;
mod journal;
mod kdtree;
mod linear_projection;
mod maze;
mod measures;
mod obstructed_arm;
mod parts;
mod policies;
mod random;
mod rewards;
mod trial;
mod undisturbed;

use pyo3::prelude::*;

/// The compiled kernels of divbandit; `import divbandit` brings all that is public.
///
/// Nothing in it relies on Python's global lock: what can change is borrowed by one call at a time,
/// and a generator's own lock is held while it is drawn from.
#[pymodule(gil_used = false)]
fn _core(module: &Bound<'_, PyModule>) -> PyResult<()> {
    arrays::prepare(module.py())?;
    module.add_class::<arm::PyPlanarArm>()?;
    module.add_class::<bounds::PyBounds>()?;
    module.add_class::<coverage::PyCoverage>()?;
    module.add_class::<engine::PyEngine>()?;
    module.add_class::<estimators::PyEstimator>()?;
    module.add_class::<goals::PyGoalSampler>()?;
    module.add_class::<history::PyHistory>()?;
    module.add_class::<inverse::PyInverseModel>()?;
    module.add_class::<journal::PyJournal>()?;
    module.add_class::<kdtree::PyNearestNeighbors>()?;
    module.add_class::<linear_projection::PyLinearProjection>()?;
    module.add_class::<maze::PyMaze>()?;
    module.add_class::<measures::PyMeasure>()?;
    module.add_class::<obstructed_arm::PyObstacle>()?;
    module.add_class::<obstructed_arm::PyObstructedArm>()?;
    module.add_class::<policies::PyPolicy>()?;
    module.add_class::<rewards::PyReward>()?;
    module.add_class::<trial::PyTrial>()?;
    module.add("NotBuiltInError", module.py().get_type::<composition::NotBuiltInError>())?;
    module.add_function(wrap_pyfunction!(arrays::as_point, module)?)?;
    module.add_function(wrap_pyfunction!(elementary::exp, module)?)?;
    module.add_function(wrap_pyfunction!(elementary::log, module)?)?;
    module.add_function(wrap_pyfunction!(elementary::normal_quantile, module)?)?;
    module.add_function(wrap_pyfunction!(elementary::power, module)?)?;
    module.add_function(wrap_pyfunction!(policies::powers, module)?)?;
    module.add_function(wrap_pyfunction!(policies::proportionally, module)?)?;
    module.add_function(wrap_pyfunction!(undisturbed::undisturbed, module)?)?;
    module.add_function(wrap_pyfunction!(undisturbed::interruptible, module)?)?;
    Ok(())
}
