//! A convex polygon that half-planes cut, with vertices as precise as their distance from the
//! origin is small.
//!
//! Each side keeps its line. A new vertex is the crossing of two lines, not a point between
//! two old vertices: around the foot of a face between centres 1e-12 apart the picture is that
//! small, while the polygon began as large as the ball.

/// The half-plane of the points y with normal . y <= offset. The normal has any length: many
/// a side is cut off again, and only those that stay need a root.
#[derive(Debug, Clone, Copy)]
pub(crate) struct HalfPlane {
    pub normal: [f64; 2],
    pub offset: f64,
}

impl HalfPlane {
    /// How far along its edge, with the inside to the left, a point lies from the foot of
    /// the origin, in lengths of the normal.
    #[inline]
    pub fn along(&self, [x, y]: [f64; 2]) -> f64 {
        self.normal[0] * y - self.normal[1] * x
    }

    #[inline]
    fn is_outside(&self, [x, y]: [f64; 2]) -> bool {
        self.normal[0] * x + self.normal[1] * y > self.offset
    }
}

/// A vertex and the side that begins there, counter-clockwise.
#[derive(Debug, Clone, Copy)]
pub(crate) struct Corner {
    pub vertex: [f64; 2],
    pub side: HalfPlane,
    /// The foot of the origin on the side's line.
    foot: [f64; 2],
}

/// A convex polygon. Kept from face to face for its memory alone.
#[derive(Debug, Clone, Default)]
pub(crate) struct Polygon {
    corners: Vec<Corner>,
    spare: Vec<Corner>,
}

impl Polygon {
    /// Becomes the square whose inscribed circle has radius `r`.
    pub fn begin(&mut self, r: f64) {
        let corner = |vertex, normal: [f64; 2]| {
            let foot = normal.map(|n| r * n);
            Corner { vertex, side: HalfPlane { normal, offset: r }, foot }
        };
        self.corners.clear();
        self.corners.extend([
            corner([r, -r], [1.0, 0.0]),
            corner([r, r], [0.0, 1.0]),
            corner([-r, r], [-1.0, 0.0]),
            corner([-r, -r], [0.0, -1.0]),
        ]);
    }

    pub fn is_empty(&self) -> bool {
        self.corners.is_empty()
    }

    pub fn corners(&self) -> &[Corner] {
        &self.corners
    }

    /// The largest squared distance of a vertex.
    pub fn squared_radius(&self) -> f64 {
        self.corners.iter().fold(0.0, |largest: f64, corner| {
            let [x, y] = corner.vertex;
            largest.max(x * x + y * y)
        })
    }

    /// Cuts off what lies outside of `half_plane`; tells whether that was anything.
    #[inline]
    pub fn cut(&mut self, half_plane: HalfPlane) -> bool {
        if !self.corners.iter().any(|corner| half_plane.is_outside(corner.vertex)) {
            return false;
        }
        let Self { corners, spare } = self;
        spare.clear();
        let Some(&first) = corners.first() else { return false };
        let [nx, ny] = half_plane.normal;
        let scale = half_plane.offset / (nx * nx + ny * ny);
        let foot = [scale * nx, scale * ny];
        let mut here_outside = half_plane.is_outside(first.vertex);
        for (i, &corner) in corners.iter().enumerate() {
            let next = corners.get(i + 1).unwrap_or(&first).vertex;
            let next_outside = half_plane.is_outside(next);
            if !here_outside {
                spare.push(corner);
            }
            if here_outside != next_outside {
                let vertex = crossing(corner, next, half_plane);
                spare.push(if next_outside {
                    Corner { vertex, side: half_plane, foot }
                } else {
                    Corner { vertex, ..corner }
                });
            }
            here_outside = next_outside;
        }
        std::mem::swap(corners, spare);
        true
    }
}

/// Where the side from `corner` to `next` crosses the border of `half_plane`.
#[inline]
fn crossing(corner: Corner, next: [f64; 2], half_plane: HalfPlane) -> [f64; 2] {
    let ([ax, ay], [bx, by], [fx, fy]) = (corner.side.normal, half_plane.normal, corner.foot);
    let t = (half_plane.offset - (bx * fx + by * fy)) / (ax * by - ay * bx);
    let vertex = [fx - t * ay, fy + t * ax];
    // Of almost parallel lines the crossing is imprecise, but it lies on the side; and a step
    // along both lines hardly changes what they enclose. (Of parallel ones it is not a number.)
    // Where nothing but a sliver is left, its sides may run backwards.
    let [start, along, end] = [corner.vertex, vertex, next].map(|v| corner.side.along(v));
    let (low, high) = if start <= end { (corner.vertex, next) } else { (next, corner.vertex) };
    if along >= start.max(end) {
        high
    } else if along > start.min(end) {
        vertex
    } else {
        low
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn half_plane(nx: f64, ny: f64, offset: f64) -> HalfPlane {
        let length = nx.hypot(ny);
        HalfPlane { normal: [nx / length, ny / length], offset: offset / length }
    }

    fn area(polygon: &Polygon) -> f64 {
        let corners = polygon.corners();
        let next = |i: usize| corners[(i + 1) % corners.len()].vertex;
        let twice = |(i, c): (usize, &Corner)| c.vertex[0] * next(i)[1] - c.vertex[1] * next(i)[0];
        corners.iter().enumerate().map(twice).sum::<f64>() / 2.0
    }

    #[test]
    fn cuts_leave_what_geometry_says() {
        let mut polygon = Polygon::default();
        polygon.begin(1.0);
        assert_eq!(area(&polygon), 4.0);
        assert!(!polygon.cut(half_plane(1.0, 1.0, 2.0)));
        assert!(polygon.cut(half_plane(1.0, 1.0, 0.0)));
        assert!((area(&polygon) - 2.0).abs() < 1e-15);
        assert!(polygon.cut(half_plane(-1.0, 0.0, 0.5)));
        assert!((area(&polygon) - 1.125).abs() < 1e-15);
        assert!((polygon.squared_radius() - 2.0).abs() < 1e-15);
        assert!(polygon.cut(half_plane(0.0, 1.0, -3.0)));
        assert!(polygon.is_empty());
    }

    #[test]
    fn a_sliver_may_be_cut_again_and_again() {
        // Its two long sides are the same line, in either sense, more or less; so are the cuts.
        let mut stream = 1_u64;
        let mut polygon = Polygon::default();
        for _ in 0..2000 {
            polygon.begin(1.0);
            for _ in 0..12 {
                stream = stream.wrapping_mul(6_364_136_223_846_793_005).wrapping_add(1);
                let (angle, jitter) = ((stream >> 60) as f64, (stream >> 40 & 7) as f64 - 3.5);
                let sense = if stream >> 50 & 1 == 1 { 1.0 } else { -1.0 };
                let (nx, ny) = if angle < 10.0 { (0.6, 0.8) } else { (angle.cos(), angle.sin()) };
                // All go through (0.24, 0.32) or along a line through it.
                let offset = 0.24 * nx + 0.32 * ny + 1e-17 * jitter;
                polygon.cut(half_plane(sense * nx, sense * ny, sense * offset));
                let corners = polygon.corners();
                for (i, corner) in corners.iter().enumerate() {
                    let next = corners[(i + 1) % corners.len()].vertex;
                    for [x, y] in [corner.vertex, next] {
                        let HalfPlane { normal: [nx, ny], offset } = corner.side;
                        assert!((nx * x + ny * y - offset).abs() < 1e-14, "{polygon:?}");
                    }
                }
            }
        }
    }

    #[test]
    fn a_tiny_polygon_has_relative_precision() {
        let mut polygon = Polygon::default();
        polygon.begin(1.0);
        let (size, n) = (1e-12, 7);
        for i in 0..n {
            let angle = f64::from(i) * std::f64::consts::TAU / f64::from(n);
            polygon.cut(half_plane(angle.cos(), angle.sin(), size));
        }
        let expected = f64::from(n) * (std::f64::consts::PI / f64::from(n)).tan();
        assert!((area(&polygon) / (size * size) / expected - 1.0).abs() < 1e-14);
    }
}
