//! A k-d tree that grows point by point and always answers exactly.
//!
//! Goal babbling with a small d piles effects up in clusters many orders of magnitude
//! smaller than the space, and duplicates, sorted and collinear points are everyday input.
//! Three choices make all of these ordinary:
//!
//! - A leaf splits at its *median* by (coordinate, index), never at a midpoint: the halves
//!   are equal whatever the coordinates are, also when all are the same.
//! - A subtree whose sides have grown too unequal is built anew (a scapegoat tree), so the
//!   depth stays near log(n) / log(10/7) at most for any order of arrival; insertion costs
//!   amortised O(log^2 n).
//! - Every node knows the tight bounding box of its points and the earliest of them. The
//!   pair (squared distance to the box, earliest index) bounds the same pair of every point
//!   inside from below - in floating point too, since rounding is monotone - and the search
//!   minimises that pair. Ties therefore go to the earliest point, and of a million
//!   duplicates all but one branch is pruned.

mod grow;
mod search;

use grow::Rows;
pub(crate) use search::nearer;

use smallvec::SmallVec;

use crate::error::{Error, check_finite, check_length, check_rows, reserve};

/// Points a leaf holds before it splits. With 16, 32, 48 and 64, inserting one of the 10,000
/// effects of ADAPT with d = 0.05 took 185, 112, 90 and 78 ns, its searches 174, 178, 173 and 180
/// ns a step; with a million 427, 326, 256 and 246, and 343, 370, 351 and 301 (bench `exploration`).
const LEAF: usize = 48;

/// Points in R^dim, to be searched for the nearest.
#[derive(Debug, Clone)]
pub struct NearestNeighbors {
    dim: usize,
    points: Vec<f64>,
    /// How many of them are in the tree: all, but while a log waits for the next search.
    filed: u32,
    root: Option<Node>,
}

/// A part of space with at least one point in it.
#[derive(Debug, Clone)]
struct Node {
    /// How many points it holds.
    size: u32,
    /// The earliest of them.
    earliest: u32,
    /// Their lowest, then highest, coordinates: `2 * dim` numbers, up to three dimensions in place.
    bounds: SmallVec<[f64; 6]>,
    kind: Kind,
}

#[derive(Debug, Clone)]
enum Kind {
    /// The points are copied here so that a leaf is read in one go.
    Leaf { points: Vec<f64>, indices: Vec<u32> },
    /// A new point goes to the first half if its coordinate is below `at`, else to the second.
    Split { axis: usize, at: f64, halves: Box<[Node; 2]> },
}

impl NearestNeighbors {
    /// An empty set of points in R^`dim`.
    ///
    /// # Errors
    /// If `dim` is 0.
    pub fn new(dim: usize) -> Result<Self, Error> {
        if dim == 0 {
            return Err(Error::Count { name: "dim", must_be: "at least 1".into(), got: dim });
        }
        Ok(Self { dim, points: Vec::new(), filed: 0, root: None })
    }

    /// The dimension of the points.
    #[must_use]
    pub fn dim(&self) -> usize {
        self.dim
    }

    /// How many points there are.
    #[must_use]
    pub fn len(&self) -> usize {
        self.points.len() / self.dim
    }

    /// Whether there are none.
    #[must_use]
    pub fn is_empty(&self) -> bool {
        self.points.is_empty()
    }

    /// All points in order of arrival, row by row.
    #[must_use]
    pub fn points(&self) -> &[f64] {
        &self.points
    }

    /// How many levels the tree has.
    #[must_use]
    pub fn depth(&self) -> usize {
        fn levels(node: &Node) -> usize {
            match &node.kind {
                Kind::Leaf { .. } => 1,
                Kind::Split { halves, .. } => 1 + levels(&halves[0]).max(levels(&halves[1])),
            }
        }
        self.root.as_ref().map_or(0, levels)
    }

    /// Adds a point; its index is the number of points before it.
    ///
    /// # Errors
    /// If it is not `dim` finite numbers, or there are 2^32 - 1 points already.
    pub fn add(&mut self, point: &[f64]) -> Result<(), Error> {
        check_length("point", point, self.dim)?;
        check_finite("point", point, self.dim)?;
        self.check_room(1)?;
        self.log(point);
        self.file_all();
        Ok(())
    }

    /// Adds points row by row; adds none if one of them cannot be added.
    ///
    /// # Errors
    /// If they are not whole rows of `dim` finite numbers, or would be more than 2^32 - 1.
    pub fn extend(&mut self, points: &[f64]) -> Result<(), Error> {
        check_rows("points", points, self.dim)?;
        check_finite("points", points, self.dim)?;
        self.check_room(points.len() / self.dim)?;
        self.points.extend_from_slice(points);
        self.file_all();
        Ok(())
    }

    /// Makes room for so many more points.
    ///
    /// # Errors
    /// If there is no memory for them.
    pub(crate) fn reserve(&mut self, n: usize) -> Result<(), Error> {
        reserve(&mut self.points, n, self.dim)
    }

    /// All points in order of arrival.
    pub(crate) fn into_points(self) -> Vec<f64> {
        self.points
    }

    /// Adds a finite point that nobody searches for yet: only [`file_all`](Self::file_all) lets
    /// it be found.
    pub(crate) fn log(&mut self, point: &[f64]) {
        self.points.extend_from_slice(point);
    }

    /// Brings the tree up to date with all that was logged.
    pub(crate) fn file_all(&mut self) {
        while (self.filed as usize) < self.len() {
            let points = Rows { numbers: &self.points, dim: self.dim };
            match &mut self.root {
                Some(root) => root.insert(self.filed, points),
                None => self.root = Some(Node::build(&mut [self.filed], points)),
            }
            self.filed += 1;
        }
    }

    /// Refuses so many more points where they would be too many.
    ///
    /// # Errors
    /// If they would be more than 2^32 - 1.
    pub(crate) fn check_room(&self, more: usize) -> Result<(), Error> {
        let total = self.len().saturating_add(more);
        if total < u32::MAX as usize {
            Ok(())
        } else {
            Err(Error::Count { name: "points", must_be: "fewer than 2^32".into(), got: total })
        }
    }
}
