//! The yardstick of `benches/engine.py`: a planar arm's forward kinematics as one would write
//! them first, one sample at a time, with the standard library's sine and cosine.

use numpy::{PyArray2, PyArrayMethods, PyReadonlyArray2, PyUntypedArrayMethods};
use pyo3::exceptions::PyValueError;
use pyo3::prelude::*;

/// The tip of an arm 1 m long that turns by `command`, in radians, at its joints.
fn tip(command: &[f64]) -> [f64; 2] {
    let (mut angle, mut x, mut y) = (0.0, 0.0, 0.0);
    for turn in command {
        angle += turn;
        let (sine, cosine) = f64::sin_cos(angle);
        x += cosine;
        y += sine;
    }
    [x / command.len() as f64, y / command.len() as f64]
}

/// The tips' positions, (n, joints) -> (n, 2), computed without holding the interpreter.
///
/// Parameters
/// ----------
/// commands : numpy.ndarray of float64, shape (n, joints), C-contiguous
///     Angles in radians, at least one a command.
///
/// Returns
/// -------
/// numpy.ndarray of float64, shape (n, 2)
///     In metres.
///
/// Raises
/// ------
/// TypeError, ValueError
///     If `commands` is no such array.
#[pyfunction]
fn effects<'py>(commands: PyReadonlyArray2<'py, f64>) -> PyResult<Bound<'py, PyArray2<f64>>> {
    let (py, n, joints) = (commands.py(), commands.shape()[0], commands.shape()[1]);
    if joints == 0 {
        return Err(PyValueError::new_err("commands must have at least one joint, got 0"));
    }
    if !commands.is_c_contiguous() {
        return Err(PyValueError::new_err("commands must be C-contiguous, got another order"));
    }
    let angles = commands.as_slice()?;
    let tips = PyArray2::zeros(py, [n, 2], false);
    let mut written = tips.try_readwrite()?;
    let slots = written.as_slice_mut()?;
    py.detach(|| {
        for (command, slot) in angles.chunks_exact(joints).zip(slots.chunks_exact_mut(2)) {
            slot.copy_from_slice(&tip(command));
        }
    });
    drop(written);
    Ok(tips)
}

/// One function, `effects`.
#[pymodule]
fn scalar_arm(module: &Bound<'_, PyModule>) -> PyResult<()> {
    module.add_function(wrap_pyfunction!(effects, module)?)
}
