//! Binding of the planar arm's kinematics.

use divbandit_core::PlanarArm;
use numpy::IntoPyArray;
use pyo3::prelude::*;

use crate::arrays::{Any, Array2, Floats, count, number, rows, rows_of};
use crate::errors::Result;

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
    fn new(joints: &Any<'_>, limit: &Any<'_>) -> Result<Self> {
        Ok(Self(PlanarArm::new(count("joints", joints)?, number("limit", limit)?)?))
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
    fn effect<'py>(&self, command: &Any<'py>) -> Result<Any<'py>> {
        let (py, command) = (command.py(), Floats::either("command", command, self.0.joints())?);
        if !command.is_batch() {
            return Ok(self.0.effect(&command.copied()?)?.to_vec().into_pyarray(py).into_any());
        }
        // Not copied: if another thread writes to it meanwhile, the result is undefined numbers, as
        // in NumPy.
        let angles = command.slice()?;
        let mut effects = vec![0.0; angles.len() / self.0.joints() * 2];
        py.detach(|| self.0.effects(angles, &mut effects))?;
        Ok(rows(py, effects, 2)?.into_any())
    }

    /// The positions of the base, of each joint's far end and, last, of the tip.
    fn posture<'py>(&self, command: &Any<'py>) -> Result<Array2<'py>> {
        let angles = Floats::point("command", command, Some(self.0.joints()))?.copied()?;
        Ok(rows_of(command.py(), self.0.posture(&angles)?)?)
    }
}
