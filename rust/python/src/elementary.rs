//! Binding of the elementary functions, for what decides trajectories in Python.

use divbandit_core::elementary;
use pyo3::exceptions::PyValueError;
use pyo3::prelude::*;

/// Passes on what is a number, or says which argument led to none.
fn finite(value: f64, name: &str, must_be: &str, got: f64) -> PyResult<f64> {
    if value.is_finite() {
        return Ok(value);
    }
    Err(PyValueError::new_err(format!("{name} must be {must_be}, got {got:?}")))
}

/// e to the power of x, with the same bits on every platform.
///
/// Raises
/// ------
/// ValueError
///     If x is not finite, or so large that no number can hold the result.
///
/// Examples
/// --------
/// >>> from divbandit._core import exp
/// >>> exp(0.0), exp(-1000.0)
/// (1.0, 0.0)
#[pyfunction]
pub(crate) fn exp(x: f64) -> PyResult<f64> {
    let value = if x.is_finite() { elementary::exp(x) } else { f64::NAN };
    finite(value, "x", "a finite number of at most 709.78", x)
}

/// The natural logarithm of x, with the same bits on every platform.
///
/// Raises
/// ------
/// ValueError
///     If x is not finite and positive.
///
/// Examples
/// --------
/// >>> from divbandit._core import log
/// >>> log(1.0), round(log(10.0), 6)
/// (0.0, 2.302585)
#[pyfunction]
pub(crate) fn log(x: f64) -> PyResult<f64> {
    finite(elementary::log(x), "x", "finite and positive", x)
}

/// base to the power of exponent, with the same bits on every platform.
///
/// Raises
/// ------
/// ValueError
///     If the result is not a finite number.
///
/// Examples
/// --------
/// >>> from divbandit._core import power
/// >>> power(9.0, 0.5), power(0.0, 2.0)
/// (3.0, 0.0)
#[pyfunction]
pub(crate) fn power(base: f64, exponent: f64) -> PyResult<f64> {
    let value = elementary::power(base, exponent);
    finite(value, "base", &format!("such that its power {exponent:?} is a finite number"), base)
}

/// The number below which a standard normal number lies with probability p.
///
/// The same bits on every platform; right to about 1e-15, and to 1e-8 within 1e-11 of 0 or 1.
///
/// Raises
/// ------
/// ValueError
///     If p is not in (0, 1).
///
/// Examples
/// --------
/// >>> from divbandit._core import normal_quantile
/// >>> normal_quantile(0.5), round(normal_quantile(0.975), 6)
/// (0.0, 1.959964)
#[pyfunction]
pub(crate) fn normal_quantile(p: f64) -> PyResult<f64> {
    let value = if 0.0 < p && p < 1.0 { elementary::normal_quantile(p) } else { f64::NAN };
    finite(value, "p", "in (0, 1)", p)
}
