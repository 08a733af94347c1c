//! The other family: the area of a growing union of discs on an incremental Delaunay
//! triangulation (spade's).
//!
//! The union is cut into its centres' Voronoi cells, each within its disc, and a disc loses to
//! each side of its cell what lies beyond the bisector: a side from a to b, the chord that the
//! bisector - not a circumcentre - clips, takes half of angle - a x b, from each of two discs.
//! Split at its foot, a side belongs half to each of the two triangles at its edge. Summed by
//! triangles, in squared radii and with Euler's formula for the number of these,
//!
//!   area = pi + the shares of all triangles + the strips beside the edges of the convex hull.
//!
//! A strip, asin rho + rho sqrt(1 - rho^2) with rho half the edge, is what two discs cover on one
//! side of it, but for two quarters. A triangle whose circumcircle is smaller than the discs is
//! covered and its share simply its area. In a larger one nothing but the discs ends the chords:
//! its share are its sides' strips less pi, or with an obtuse angle, the two short sides' less the
//! long one's. Both agree to first order where they meet: a rounded circumradius does no harm.
//! That the constants cancel on paper matters: in clusters shares are 1e-16 and less.

#![allow(dead_code, reason = "the bench takes less of it than the tests")]

mod kept;
mod quadtree;
mod total;
mod triangle;

use std::f64::consts::PI;

use spade::handles::{FixedDirectedEdgeHandle, FixedFaceHandle, FixedVertexHandle, InnerTag};
use spade::{HintGenerator, Point2, PositionInTriangulation, Triangulation};

use kept::{Delaunay, Share, Side, strip};
pub use quadtree::QuadtreeHint;
use total::Total;
use triangle::{Triangle, may_be_in_circle};

/// So many triangles are looked at to tell that a disc adds nothing; that it then does is rare.
const MANY: usize = 64;

/// The union of the discs of radius tau around the effects added so far.
pub struct Cells<H: HintGenerator<f64> = QuadtreeHint> {
    delaunay: Delaunay<H>,
    /// A power of two near 1 / tau: coordinates are scaled without rounding, and the radius is
    /// then in [1, 2). spade refuses what is below 2^-142 or above 2^201: the former counts as
    /// zero here, the latter panics.
    scale: f64,
    radius_squared: f64,
    measure: Total,
    spokes: Vec<FixedDirectedEdgeHandle>,
    stack: Vec<FixedDirectedEdgeHandle>,
}

impl<H: HintGenerator<f64>> Cells<H> {
    pub fn new(tau: f64) -> Self {
        let (_, exponent) = libm::frexp(tau);
        let scale = libm::ldexp(1.0, 1 - exponent);
        Self {
            delaunay: Delaunay::new(),
            scale,
            radius_squared: (tau * scale) * (tau * scale),
            measure: Total::default(),
            spokes: Vec::new(),
            stack: Vec::new(),
        }
    }

    /// The sum of all gains.
    pub fn measure(&self) -> f64 {
        self.measure.value()
    }

    /// How many centres had to be inserted.
    pub fn stored(&self) -> usize {
        self.delaunay.num_vertices()
    }

    /// Adds an effect and returns its gain.
    pub fn add(&mut self, effect: [f64; 2]) -> f64 {
        let [x, y] = effect.map(|x| x * self.scale).map(|x| {
            assert!(x.abs() <= spade::MAX_ALLOWED_VALUE, "spade takes no coordinate above 2^201");
            if x.abs() < spade::MIN_ALLOWED_VALUE { 0.0 } else { x }
        });
        let gain = self.insert(Point2::new(x, y)) / (self.scale * self.scale);
        self.measure.add(gain);
        gain
    }

    /// The area of the union from all triangles anew.
    pub fn area(&self) -> f64 {
        let mut area = Total::default();
        if self.delaunay.num_vertices() > 0 {
            area.add(PI * self.radius_squared);
        }
        self.delaunay.inner_faces().for_each(|face| area.add(face.data().share));
        self.delaunay.undirected_edges().for_each(|edge| area.add(edge.data().outer));
        area.value() / (self.scale * self.scale)
    }

    fn insert(&mut self, p: Point2<f64>) -> f64 {
        let before = self.delaunay.num_vertices();
        let new = if before < 3 || self.delaunay.all_vertices_on_line() {
            self.delaunay.insert(p)
        } else {
            let face = match self.delaunay.locate(p) {
                PositionInTriangulation::OnVertex(_) => return 0.0,
                PositionInTriangulation::OnFace(face) => Some(face),
                PositionInTriangulation::OnEdge(edge) => {
                    self.delaunay.directed_edge(edge).face().as_inner().map(|face| face.fix())
                }
                _ => None,
            };
            match face {
                Some(face) if self.is_covered(p, face) => return 0.0,
                Some(face) => {
                    let corner = self.delaunay.face(face).vertices()[0].fix();
                    self.delaunay.insert_with_hint(p, corner)
                }
                None => self.delaunay.insert(p),
            }
        };
        let new = new.expect("coordinates were checked");
        if self.delaunay.num_vertices() == before { 0.0 } else { self.gain(p, new) }
    }

    /// Whether a disc surely lies in the union. A point in `p`'s cell is farthest from the other
    /// centres at one of the triangles that `p` destroys, or where its own new triangles' circles
    /// have their centres; if all of these are smaller than the discs, nothing is left uncovered.
    /// Such a disc need not be inserted: the union stays the same set.
    fn is_covered(&mut self, p: Point2<f64>, face: FixedFaceHandle<InnerTag>) -> bool {
        let face = self.delaunay.face(face);
        if !face.data().small {
            return false;
        }
        self.stack.clear();
        self.stack.extend(face.adjacent_edges().map(|edge| edge.rev().fix()));
        let mut looks = 0;
        while let Some(edge) = self.stack.pop() {
            looks += 1;
            let edge = self.delaunay.directed_edge(edge);
            let [a, b] = edge.positions();
            let beyond = edge.face().as_inner();
            let is_small = beyond.is_some_and(|face| face.data().small);
            let destroyed =
                beyond.is_some() && may_be_in_circle(a, b, edge.next().to().position(), p);
            // Beyond a triangle that stays, only the corner between it and `p` counts, and it
            // lies between the centres of a destroyed triangle and of that one.
            let fine =
                is_small || !destroyed && Triangle::new(p, b, a).is_small(self.radius_squared);
            if !fine || looks > MANY {
                return false;
            }
            if destroyed {
                self.stack.extend([edge.next().rev().fix(), edge.prev().rev().fix()]);
            }
        }
        true
    }

    /// What the vertex `new` at `p` adds, once it is there.
    fn gain(&mut self, p: Point2<f64>, new: FixedVertexHandle) -> f64 {
        let Self { delaunay, spokes, radius_squared, .. } = self;
        let radius_squared = *radius_squared;
        spokes.clear();
        spokes.extend(delaunay.vertex(new).out_edges().map(|edge| edge.fix()));
        let (mut gain, mut on_hull) = (Total::default(), false);
        if delaunay.num_vertices() == 1 {
            return PI * radius_squared;
        }
        for &spoke in &*spokes {
            let edge = delaunay.undirected_edge_data_mut(spoke.as_undirected());
            gain.add(-edge.outer);
            *edge = Side::default();
        }
        for &spoke in &*spokes {
            let edge = delaunay.directed_edge(spoke);
            let Some(face) = edge.face().as_inner() else {
                on_hull = true;
                continue;
            };
            gain.add(-face.data().share);
            let (rim, back, face) = (edge.next(), edge.prev().fix(), face.fix());
            let triangle = Triangle::new(p, edge.to().position(), rim.to().position());
            let rim = rim.fix();
            let small = triangle.is_small(radius_squared);
            let share = if triangle.squared_ratio(radius_squared) < 1.0 {
                0.5 * triangle.cross
            } else {
                let sides = [spoke, rim, back].into_iter().zip(triangle.sides);
                let acute = triangle.sides.iter().all(|side| side.1.is_sign_positive());
                let less = if acute { -PI * radius_squared } else { 0.0 };
                sides.fold(less, |sum, (edge, (squared, opposite))| {
                    sum + strip(delaunay, edge, squared, radius_squared).copysign(opposite)
                })
            };
            *delaunay.face_data_mut(face) = Share { share, small };
            gain.add(share);
        }
        if on_hull {
            for &spoke in &*spokes {
                let edge = delaunay.directed_edge(spoke);
                let rim = edge.face().as_inner().map(|_| edge.next().fix());
                for edge in [Some(spoke), rim].into_iter().flatten() {
                    let handle = delaunay.directed_edge(edge);
                    let sides = [handle, handle.rev()].map(|side| f64::from(side.is_outer_edge()));
                    let (sides, squared) = (sides[0] + sides[1], handle.length_2());
                    let outer = if sides > 0.0 {
                        sides * strip(delaunay, edge, squared, radius_squared)
                    } else {
                        0.0
                    };
                    gain.add(outer);
                    let data = delaunay.undirected_edge_data_mut(edge.as_undirected());
                    gain.add(-std::mem::replace(&mut data.outer, outer));
                }
            }
        }
        gain.value().clamp(0.0, PI * radius_squared)
    }
}

/// The area of the union of discs of radius `tau`, from all triangles at once.
pub fn union_area(centres: &[[f64; 2]], tau: f64) -> f64 {
    let mut cells: Cells = Cells::new(tau);
    centres.iter().for_each(|&centre| {
        cells.add(centre);
    });
    cells.area()
}
