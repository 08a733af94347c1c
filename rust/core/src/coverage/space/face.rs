//! The face between two centres: the part of the plane half-way that lies in both their balls
//! and no nearer to any other centre.
//!
//! In the plane, seen from the point o half-way between the centres, the two balls are one disc
//! around o, and each other centre leaves a half-plane. What the face contributes to a volume
//! is three times that of the cone from either centre over it, up to the sphere, less what lies
//! in front of it: *solid angle - height * area*, its `share`. It is a sum over the polygon's
//! sides, of triangles where a side runs inside the disc and sectors where it runs outside;
//! contributions of degenerate faces are as small as the faces, so that no case is special.

use super::neighbours::Neighbour;
use super::polygon::{HalfPlane, Polygon};
use super::turn::Turn;
use super::vector::{Vector, across, dot, minus};

/// What a face amounts to.
#[derive(Debug, Clone, Copy)]
pub(crate) struct Amount {
    /// The solid angle under which either centre sees it.
    pub solid_angle: f64,
    /// Three times the volume behind it, in the ball's sector over it.
    pub share: f64,
}

/// The face between two centres less than 2 apart. Kept between calls for its memory alone.
#[derive(Debug, Clone, Default)]
pub(crate) struct Face {
    centres: [Vector; 2],
    /// Directions of the plane.
    frame: (Vector, Vector),
    /// Half the centres' distance, and that squared.
    height: f64,
    squared_height: f64,
    /// The squared radius of the disc in which both balls cut the plane.
    squared_disc: f64,
    polygon: Polygon,
    /// The face lies within the root of this from o.
    squared_radius: f64,
}

impl Face {
    /// Begins with the whole disc between `a` and `b`.
    #[inline]
    pub fn begin(&mut self, a: Vector, b: Vector) {
        let difference = minus(b, a);
        let squared = dot(difference, difference);
        let distance = squared.sqrt();
        self.centres = [a, b];
        self.frame = across(difference, distance);
        self.height = 0.5 * distance;
        self.squared_height = 0.25 * squared;
        self.squared_disc = (1.0 - self.height) * (1.0 + self.height);
        self.squared_radius = self.squared_disc;
        self.polygon.begin(self.squared_disc.sqrt());
    }

    /// The squared distance from its centres to the farthest point, or more than that.
    #[inline]
    fn squared_reach(&self) -> f64 {
        self.squared_height + self.squared_radius
    }

    /// Leaves what is no nearer to any of `others`, which come nearest to the origin first; tells whether anything is.
    ///
    /// Those farther than twice the face's reach are no nearer to any point of it than its centres are.
    #[inline]
    pub fn keep_away_from_all(&mut self, others: impl Iterator<Item = Neighbour>) -> bool {
        for other in others {
            if other.squared >= 4.0 * self.squared_reach() {
                return true;
            }
            let (normal, offset) = self.line(other.at);
            if !self.cut(normal, offset) {
                return false;
            }
        }
        true
    }

    /// Leaves what is nearer to `other`; tells whether anything is.
    #[inline]
    pub fn keep_near_to(&mut self, other: Vector) -> bool {
        let (normal, offset) = self.line(other);
        self.cut([-normal[0], -normal[1]], -offset)
    }

    /// Where the face's plane is as near to `other`: the y with normal . y = offset.
    ///
    /// The planes half-way between `other` and either centre cut ours in the same line. Of the
    /// two the one with the nearer centre crosses at the larger angle; with the other one, three
    /// centres in a row would give a line with an error as large as the face. The centres'
    /// differences are exact where it matters, between close ones.
    #[inline]
    fn line(&self, other: Vector) -> ([f64; 2], f64) {
        let [from_a, from_b] = self.centres.map(|centre| minus(other, centre));
        let shorter = if dot(from_a, from_a) <= dot(from_b, from_b) { from_a } else { from_b };
        ([dot(shorter, self.frame.0), dot(shorter, self.frame.1)], 0.5 * dot(from_a, from_b))
    }

    #[inline]
    fn cut(&mut self, normal: [f64; 2], offset: f64) -> bool {
        let squared_length = normal[0] * normal[0] + normal[1] * normal[1];
        // The line misses all that is left.
        if offset * offset >= squared_length * self.squared_radius {
            return offset >= 0.0;
        }
        if self.polygon.cut(HalfPlane { normal, offset }) {
            self.squared_radius = self.polygon.squared_radius().min(self.squared_disc);
        }
        !self.polygon.is_empty()
    }

    /// The vertices of what is left, in space and in order, if it lies in both balls.
    #[inline]
    pub fn vertices(&self) -> Option<impl Iterator<Item = Vector>> {
        let ([a, b], (e, f)) = (self.centres, self.frame);
        let place = move |[x, y]: [f64; 2]| {
            std::array::from_fn(|i| 0.5 * (a[i] + b[i]) + (x * e[i] + y * f[i]))
        };
        let inside = self.squared_radius < self.squared_disc;
        inside.then(|| self.polygon.corners().iter().map(move |corner| place(corner.vertex)))
    }

    /// What is left amounts to this.
    pub fn amount(&self) -> Amount {
        let (mut triangles, mut sectors) = (Turn::ZERO, Turn::ZERO);
        let mut twice_area = 0.0;
        let corners = self.polygon.corners();
        for (i, corner) in corners.iter().enumerate() {
            let next = corners.get(i + 1).unwrap_or(&corners[0]);
            let side = corner.side;
            let length = (side.normal[0] * side.normal[0] + side.normal[1] * side.normal[1]).sqrt();
            let q = side.offset / length;
            let (start, end) =
                (side.along(corner.vertex) / length, side.along(next.vertex) / length);
            let half_chord = (self.squared_disc - q * q).max(0.0).sqrt();
            let into_disc = start.max(-half_chord).min(half_chord);
            let out_of_disc = end.max(-half_chord).min(half_chord);
            if half_chord == 0.0 {
                sectors.add(q * q + start * end, q * (end - start));
                continue;
            }
            if into_disc != start {
                sectors.add(q * q + start * into_disc, q * (into_disc - start));
            }
            if out_of_disc != end {
                sectors.add(q * q + out_of_disc * end, q * (end - out_of_disc));
            }
            if into_disc != out_of_disc {
                twice_area += q * (out_of_disc - into_disc);
                let (a, b) = self.triangle(q, into_disc);
                let (c, d) = self.triangle(q, out_of_disc);
                triangles.add(a * c + b * d, a * d - b * c);
            }
        }
        let (h, triangles, sectors) = (self.height, triangles.total(), sectors.total());
        let cap = 1.0 - h; // the solid angle of a sector of 1 rad
        Amount {
            solid_angle: triangles + sectors * cap,
            share: (triangles - 0.5 * h * twice_area) + 0.5 * sectors * cap * cap * (2.0 + h),
        }
    }

    /// The solid angle of the triangle between o, the foot of o on a line at distance `q`, and
    /// the point at `t` from there: as the argument of a complex number.
    ///
    /// It is atan(t / q) - atan(h t / (q s)), with s the point's distance from the centre; the
    /// two are put together so that nothing cancels where the triangle is small.
    #[inline]
    fn triangle(&self, q: f64, t: f64) -> (f64, f64) {
        let (qq, tt, h) = (q * q, t * t, self.height);
        let plane = qq + tt;
        if plane == 0.0 {
            return (1.0, 0.0);
        }
        let s = (self.squared_height + plane).sqrt();
        ((qq * s + h * tt) * (s + h), q * t * plane)
    }
}
