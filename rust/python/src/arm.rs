//! Binding of the planar arm's kinematics.

use divbandit_core::PlanarArm;
use numpy::{IntoPyArray, PyArray2, PyArrayMethods};
use pyo3::prelude::*;

use crate::arrays::{Floats, count, number};
use crate::errors::value_error;

/// Forward kinematics of a planar arm of total length 1.
///
/// Parameters
/// ----------
/// joints : int
///     Number of joints, at least 1.
/// limit : float
///     Every joint's limit in radians: angles lie in [-limit, limit].
#[pyclass(module = "divbandit._core", name = "PlanarArm", frozen)]
pub(crate) struct PyPlanarArm(pub PlanarArm);

#[pymethods]
impl PyPlanarArm {
    #[new]
    fn new(joints: &Bound<'_, PyAny>, limit: &Bound<'_, PyAny>) -> PyResult<Self> {
        let (joints, limit) = (count("joints", joints)?, number("limit", limit)?);
        PlanarArm::new(joints, limit).map(Self).map_err(value_error)
    }

    /// The number of joints.
    #[getter]
    fn joints(&self) -> usize {
        self.0.joints()
    }

    /// Every joint's limit, in radians.
    #[getter]
    fn limit(&self) -> f64 {
        self.0.limit()
    }

    /// The tip's position: (joints,) -> (2,), or (n, joints) -> (n, 2).
    fn effect<'py>(
        &self,
        py: Python<'py>,
        command: &Bound<'py, PyAny>,
    ) -> PyResult<Bound<'py, PyAny>> {
        let command = Floats::either("command", command, self.0.joints())?;
        if !command.is_batch() {
            let effect = self.0.effect(&command.copied()?).map_err(value_error)?;
            return Ok(effect.to_vec().into_pyarray(py).into_any());
        }
        // Not copied: if another thread writes to it meanwhile, the result is undefined numbers, as
        // in NumPy.
        let angles = command.slice()?;
        let mut effects = vec![0.0; angles.len() / self.0.joints() * 2];
        py.detach(|| self.0.effects(angles, &mut effects)).map_err(value_error)?;
        Ok(effects.into_pyarray(py).reshape([angles.len() / self.0.joints(), 2])?.into_any())
    }

    /// The positions of the base, of each joint's far end and, last, of the tip.
    fn posture<'py>(
        &self,
        py: Python<'py>,
        command: &Bound<'py, PyAny>,
    ) -> PyResult<Bound<'py, PyArray2<f64>>> {
        let command = Floats::point("command", command, Some(self.0.joints()))?;
        let points = self.0.posture(&command.copied()?).map_err(value_error)?;
        points.concat().into_pyarray(py).reshape([points.len(), 2])
    }
}
