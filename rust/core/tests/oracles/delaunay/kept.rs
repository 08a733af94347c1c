//! What the triangulation keeps of triangles and edges.

use std::f64::consts::FRAC_PI_2;

use spade::handles::FixedDirectedEdgeHandle;
use spade::{DelaunayTriangulation, HintGenerator, Point2, Triangulation};

use super::triangle;

/// What is kept of a triangle. A flip leaves it where it is: after an insertion the triangles
/// around the new vertex still hold what those had that it replaced.
#[derive(Debug, Clone, Copy, Default)]
pub struct Share {
    pub share: f64,
    /// Whether the circumcircle is clearly smaller than the discs.
    pub small: bool,
}

/// What is kept of an edge.
#[derive(Debug, Clone, Copy)]
pub struct Side {
    /// NaN while nobody has asked.
    pub strip: f64,
    /// That for each side on which there is no triangle.
    pub outer: f64,
}

impl Default for Side {
    fn default() -> Self {
        Self { strip: f64::NAN, outer: 0.0 }
    }
}

pub type Delaunay<H> = DelaunayTriangulation<Point2<f64>, (), Side, Share, H>;

/// The strip of an edge, found once and kept; two quarters of a disc where discs do not overlap.
pub fn strip<H: HintGenerator<f64>>(
    delaunay: &mut Delaunay<H>,
    edge: FixedDirectedEdgeHandle,
    squared: f64,
    radius_squared: f64,
) -> f64 {
    if squared >= 4.0 * radius_squared {
        return FRAC_PI_2 * radius_squared; // most edges among sparse effects: no look at memory
    }
    let data = delaunay.undirected_edge_data_mut(edge.as_undirected());
    if data.strip.is_nan() {
        data.strip = triangle::strip(squared, radius_squared);
    }
    data.strip
}
