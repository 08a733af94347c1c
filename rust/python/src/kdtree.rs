//! Binding of the k-d tree.

use divbandit_core::NearestNeighbors;
use numpy::IntoPyArray;
use pyo3::IntoPyObjectExt;
use pyo3::prelude::*;

use crate::arrays::{Any, Floats, count};
use crate::errors::Result;

/// Points in R^dim, searched exactly for the nearest: a k-d tree that grows.
///
/// Points can be added at any time. Duplicates, sorted, collinear and clustered points are
/// no slower than others. Among points at the same (computed) distance the earliest is nearest;
/// distances are computed by their squares, and so up to 1e154 and down to 1e-154.
///
/// Parameters
/// ----------
/// dim : int
///     Dimension of the points, at least 1.
///
/// Raises
/// ------
/// TypeError, ValueError
///     If `dim` is not a whole number, or less than 1.
///
/// Examples
/// --------
/// >>> import divbandit as db
/// >>> tree = db.NearestNeighbors(2)
/// >>> tree.extend([[0, 0], [1, 0], [1, 1]])
/// >>> tree.nearest([1, 0.75])
/// (0.25, 2)
/// >>> len(tree)
/// 3
#[pyclass(module = "divbandit", name = "NearestNeighbors")]
#[derive(Clone)]
pub(crate) struct PyNearestNeighbors(pub NearestNeighbors);

#[pymethods]
impl PyNearestNeighbors {
    #[new]
    fn new(dim: &Any<'_>) -> Result<Self> {
        Ok(Self(NearestNeighbors::new(count("dim", dim)?)?))
    }

    /// Dimension of the points.
    #[getter]
    fn dim(&self) -> usize {
        self.0.dim()
    }

    /// Add a point; its index is the number of points before it.
    ///
    /// Parameters
    /// ----------
    /// point : array_like, shape (dim,)
    ///
    /// Raises
    /// ------
    /// TypeError, ValueError
    ///     If it is not a finite point of this dimension; nothing is added then.
    ///
    /// Examples
    /// --------
    /// >>> import divbandit as db
    /// >>> tree = db.NearestNeighbors(1)
    /// >>> tree.add([0.5])
    /// >>> tree.nearest([0.25])
    /// (0.25, 0)
    fn add(&mut self, point: &Any<'_>) -> Result<()> {
        let point = Floats::point("point", point, Some(self.0.dim()))?;
        Ok(self.0.add(&point.copied()?)?)
    }

    /// Add points in order; none of them if one cannot be added.
    ///
    /// Parameters
    /// ----------
    /// points : array_like, shape (n, dim)
    ///
    /// Raises
    /// ------
    /// TypeError, ValueError
    ///     If one is not a finite point of this dimension; nothing is added then.
    ///
    /// Examples
    /// --------
    /// >>> import divbandit as db
    /// >>> tree = db.NearestNeighbors(3)
    /// >>> tree.extend([[0, 0, 0], [0, 0, 1]])
    /// >>> len(tree)
    /// 2
    fn extend(&mut self, py: Python<'_>, points: &Any<'_>) -> Result<()> {
        let points = Floats::points("points", points, self.0.dim())?.copied()?;
        Ok(py.detach(|| self.0.extend(&points))?)
    }

    /// The nearest points to `query`.
    ///
    /// Parameters
    /// ----------
    /// query : array_like, shape (dim,)
    /// k : int
    ///     How many points to find.
    ///
    /// Returns
    /// -------
    /// distance, index : float, int
    ///     If `k` is 1: the nearest point's Euclidean distance and index.
    /// distances, indices : arrays of shape (k,)
    ///     If `k` is more: nearest first and, at the same distance, earliest first.
    ///
    /// Raises
    /// ------
    /// TypeError, ValueError
    ///     If `query` is not a finite point of this dimension, there are no points, or `k` is not
    ///     from 1 to their number.
    ///
    /// Examples
    /// --------
    /// >>> import divbandit as db
    /// >>> tree = db.NearestNeighbors(1)
    /// >>> tree.extend([[0], [3], [4]])
    /// >>> tree.nearest([1], k=2)
    /// (array([1., 2.]), array([0, 1]))
    #[pyo3(signature = (query, *, k=None), text_signature = "($self, query, *, k=1)")]
    fn nearest<'py>(&self, query: &Any<'py>, k: Option<&Any<'py>>) -> Result<Any<'py>> {
        found(&self.0, "query", query, k)
    }

    fn __len__(&self) -> usize {
        self.0.len()
    }

    fn __copy__(&self) -> Self {
        self.clone()
    }

    fn __deepcopy__(&self, _memo: &Any<'_>) -> Self {
        self.clone()
    }

    fn __repr__(&self) -> String {
        format!("<NearestNeighbors of {} points in R^{}>", self.0.len(), self.0.dim())
    }
}

/// The points of a tree nearest to what an error calls `name`: one, or `k` as arrays.
pub(crate) fn found<'py>(
    tree: &NearestNeighbors,
    name: &str,
    query: &Any<'py>,
    k: Option<&Any<'py>>,
) -> Result<Any<'py>> {
    let (py, point) = (query.py(), Floats::finite_point(name, query, Some(tree.dim()))?);
    let k = k.map_or(Ok(1), |k| count("k", k))?;
    if k == 1 {
        return Ok(tree.nearest(&point)?.into_bound_py_any(py)?);
    }
    let found =
        tree.nearest_k(&point, k)?.into_iter().map(|(distance, index)| (distance, index as i64));
    let (distances, indices): (Vec<f64>, Vec<i64>) = found.unzip();
    Ok((distances.into_pyarray(py), indices.into_pyarray(py)).into_bound_py_any(py)?)
}
