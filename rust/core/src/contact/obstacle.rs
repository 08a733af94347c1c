//! Obstacle: what a link cannot pass, given as the capsules that make its outline.

use parry2d_f64::math::Vector;
use parry2d_f64::query::PointQuery;
use parry2d_f64::shape::{Capsule, Segment};

use crate::error::{Error, check_each, check_finite, check_number};

/// The farthest a coordinate, and the largest a radius, may be: squares keep their digits, and no arm gets there.
const LARGEST: f64 = 1e6;

/// The longest outline: each edge is compared with all others once.
const MOST_POINTS: usize = 10_000;

/// A disc, a polygon or a wall.
///
/// ```
/// use divbandit_core::Obstacle;
///
/// assert!(Obstacle::disc([0.5, 0.5], 0.1).is_ok());
/// let bow_tie = [[0.0, 0.0], [1.0, 1.0], [1.0, 0.0], [0.0, 1.0]];
/// assert!(Obstacle::polygon(&bow_tie).is_err());
/// ```
#[derive(Debug, Clone)]
pub struct Obstacle {
    /// The capsules that nothing outside can pass without touching one of them.
    pub(crate) pieces: Vec<Capsule>,
    /// Whether they are the edges of a polygon.
    is_outline: bool,
}

impl Obstacle {
    /// A disc, in metres.
    ///
    /// # Errors
    /// If a number is not finite or beyond 1e6, or `radius` is not positive.
    pub fn disc(center: [f64; 2], radius: f64) -> Result<Self, Error> {
        let center = point("center", center)?;
        let is_right = radius > 0.0 && radius <= LARGEST;
        check_number("radius", radius, is_right, "positive and at most 1e6")?;
        Ok(Self::capsule(center, center, radius))
    }

    /// A rectangle along the axes, from its lower left to its upper right corner.
    ///
    /// # Errors
    /// If a number is not finite or beyond 1e6, or `low` is not below `high`.
    pub fn rectangle(low: [f64; 2], high: [f64; 2]) -> Result<Self, Error> {
        let (a, b) = (point("low", low)?, point("high", high)?);
        if let Some(axis) = (0..2).find(|&axis| low[axis] >= high[axis]) {
            let must_be = format!("greater than low[{axis}] = {:?}", low[axis]);
            let (at, got) = (format!("[{axis}]"), high[axis]);
            return Err(Error::Element { name: "high", at, must_be, got });
        }
        let corners = [a, Vector::new(b.x, a.y), b, Vector::new(a.x, b.y)];
        Ok(Self::outline(edges(&corners)))
    }

    /// A polygon, convex or not, by its corners in order.
    ///
    /// # Errors
    /// If there are not 3 to 10,000 corners, a number is not finite or beyond 1e6, or the outline touches itself.
    pub fn polygon(points: &[[f64; 2]]) -> Result<Self, Error> {
        if !(3..=MOST_POINTS).contains(&points.len()) {
            let must_be = format!("from 3 to {MOST_POINTS} corners");
            return Err(Error::Count { name: "points", must_be, got: points.len() });
        }
        check_places("points", points.as_flattened(), 2)?;
        let corners: Vec<Vector> = points.iter().copied().map(Vector::from).collect();
        let edges: Vec<Segment> = edges(&corners).collect();
        check_simple(&edges)?;
        Ok(Self::outline(edges))
    }

    /// A straight wall with rounded ends; without thickness it is a line.
    ///
    /// # Errors
    /// If a number is not finite or beyond 1e6, `thickness` is negative, or the ends are the same.
    pub fn wall(start: [f64; 2], end: [f64; 2], thickness: f64) -> Result<Self, Error> {
        let (a, b) = (point("start", start)?, point("end", end)?);
        let is_right = (0.0..=LARGEST).contains(&thickness);
        check_number("thickness", thickness, is_right, "from 0 to 1e6")?;
        if a == b {
            let (must_be, got) = ("another point than start", format!("{end:?} twice"));
            return Err(Error::Unfit { name: "end".to_owned(), must_be, got });
        }
        Ok(Self::capsule(a, b, 0.5 * thickness))
    }

    fn capsule(a: Vector, b: Vector, radius: f64) -> Self {
        Self { pieces: vec![Capsule::new(a, b, radius)], is_outline: false }
    }

    fn outline(edges: impl IntoIterator<Item = Segment>) -> Self {
        let pieces = edges.into_iter().map(|Segment { a, b }| Capsule::new(a, b, 0.0)).collect();
        Self { pieces, is_outline: true }
    }

    /// Whether a point that is on none of the pieces lies inside.
    pub(crate) fn surrounds(&self, point: Vector) -> bool {
        // A ray to the right crosses the outline an odd number of times.
        let crossed = self.pieces.iter().filter(|piece| {
            let (a, b) = (piece.segment.a - point, piece.segment.b - point);
            (a.y > 0.0) != (b.y > 0.0) && (a.perp_dot(b) > 0.0) == (b.y > a.y)
        });
        self.is_outline && crossed.count() % 2 == 1
    }
}

fn point(name: &'static str, at: [f64; 2]) -> Result<Vector, Error> {
    check_places(name, &at, 2)?;
    Ok(Vector::from(at))
}

/// Refuses coordinates, rows of length `row`, that are not finite or too large.
fn check_places(name: &'static str, numbers: &[f64], row: usize) -> Result<(), Error> {
    check_finite(name, numbers, row)?;
    check_each(name, numbers, row, "at most 1e6 from 0", |x| x.abs() <= LARGEST)
}

/// The outline's edges; the last leads back to the first corner.
fn edges(corners: &[Vector]) -> impl Iterator<Item = Segment> {
    let next = corners.iter().cycle().skip(1);
    corners.iter().zip(next).map(|(&a, &b)| Segment::new(a, b))
}

/// Refuses an outline that touches itself.
fn check_simple(edges: &[Segment]) -> Result<(), Error> {
    let refuse = |got| {
        let must_be = "corners of an outline that does not touch itself";
        Err(Error::Unfit { name: "points".to_owned(), must_be, got })
    };
    for (i, edge) in edges.iter().enumerate() {
        if edge.a == edge.b {
            return refuse(format!("corner {i} twice"));
        }
        let next = &edges[(i + 1) % edges.len()];
        let (along, onward) = (edge.b - edge.a, next.b - next.a);
        if along.perp_dot(onward) == 0.0 && along.dot(onward) < 0.0 {
            return refuse(format!("a spike at corner {}", (i + 1) % edges.len()));
        }
        // Neighbours share a corner; of the others, the first and the last are neighbours too.
        let others = i + 2..edges.len() - usize::from(i == 0);
        for j in others {
            if touch(edge, &edges[j]) {
                return refuse(format!("edges {i} and {j} in touch"));
            }
        }
    }
    Ok(())
}

/// Whether two segments have a point in common.
pub(crate) fn touch(one: &Segment, other: &Segment) -> bool {
    let apart = |line: &Segment, points: &Segment| {
        let along = line.b - line.a;
        along.perp_dot(points.a - line.a) * along.perp_dot(points.b - line.a) >= 0.0
    };
    let ends = |line: &Segment, points: &Segment| {
        [points.a, points.b].iter().any(|&end| line.project_local_point(end, true).point == end)
    };
    ends(one, other) || ends(other, one) || !(apart(one, other) || apart(other, one))
}
