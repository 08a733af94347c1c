//! Binding of the sum that is never rounded.

use divbandit_core::bandits::ExactSum;
use pyo3::prelude::*;

/// The exact sum of finite numbers, some of which may be taken away again.
///
/// It depends on nothing but the numbers in it, and never drifts.
///
/// Examples
/// --------
/// >>> from divbandit._core import ExactSum
/// >>> total = ExactSum([1e300, 0.1])
/// >>> total.slide(2.0, 1e300)
/// >>> total.add(3.0)
/// >>> total.value()
/// 5.1
#[pyclass(module = "divbandit._core", name = "ExactSum")]
pub(crate) struct PyExactSum(ExactSum);

#[pymethods]
impl PyExactSum {
    #[new]
    fn new(numbers: Vec<f64>) -> Self {
        let mut sum = ExactSum::default();
        for number in numbers {
            sum.add(number);
        }
        Self(sum)
    }

    /// Add a number.
    fn add(&mut self, number: f64) {
        self.0.add(number);
    }

    /// Add a number, and take away one that was added.
    fn slide(&mut self, number: f64, old: f64) {
        self.0.subtract(old);
        self.0.add(number);
    }

    /// Take away a number that was added.
    fn subtract(&mut self, old: f64) {
        self.0.subtract(old);
    }

    /// Return the float next to the sum.
    fn value(&self) -> f64 {
        self.0.value()
    }
}
