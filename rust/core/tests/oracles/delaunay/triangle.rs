//! What the area needs to know of one triangle, from the differences of its corners: those of
//! near points are exact.

use spade::Point2;

/// A triangle, counter-clockwise.
pub struct Triangle {
    /// Twice the area.
    pub cross: f64,
    /// Each side's squared length, and a number with the sign of the opposite angle's cosine.
    pub sides: [(f64, f64); 3],
}

impl Triangle {
    #[inline]
    pub fn new(a: Point2<f64>, b: Point2<f64>, c: Point2<f64>) -> Self {
        let (ab, bc, ac) = (between(a, b), between(b, c), between(a, c));
        Self {
            cross: (ab[0] * ac[1] - ab[1] * ac[0]).max(0.0),
            sides: [
                (dot(ab, ab), dot(ac, bc)),
                (dot(bc, bc), dot(ab, ac)),
                (dot(ac, ac), -dot(ab, bc)),
            ],
        }
    }

    /// The square of the circumradius in radii.
    #[inline]
    pub fn squared_ratio(&self, radius_squared: f64) -> f64 {
        let [(ab, _), (bc, _), (ac, _)] = self.sides;
        ab * bc * ac / (4.0 * radius_squared * self.cross * self.cross)
    }

    #[inline]
    pub fn is_small(&self, radius_squared: f64) -> bool {
        self.squared_ratio(radius_squared) < 1.0 - 1e-9
    }
}

/// The strip beside an edge of this squared length, at most four squared radii.
#[inline]
pub fn strip(squared: f64, radius_squared: f64) -> f64 {
    let rho = 0.5 * squared.sqrt();
    let half_chord = (radius_squared - 0.25 * squared).max(0.0).sqrt();
    radius_squared * libm::atan2(rho, half_chord) + rho * half_chord
}

/// Whether `p` lies inside the circle through `a`, `b`, `c` or so close to it that rounding could
/// hide it (the first of Shewchuk's error bounds).
pub fn may_be_in_circle(a: Point2<f64>, b: Point2<f64>, c: Point2<f64>, p: Point2<f64>) -> bool {
    let (a, b, c) = (between(p, a), between(p, b), between(p, c));
    let cross = |a: [f64; 2], b: [f64; 2]| (a[0] * b[1], a[1] * b[0]);
    let (ab, bc, ca) = (cross(a, b), cross(b, c), cross(c, a));
    let lifts = [dot(a, a), dot(b, b), dot(c, c)];
    let crosses = [bc, ca, ab];
    let (mut sum, mut size) = (0.0, 0.0);
    for (lift, (plus, minus)) in lifts.into_iter().zip(crosses) {
        sum += lift * (plus - minus);
        size += lift * (plus.abs() + minus.abs());
    }
    sum >= -1.2e-15 * size
}

fn between(a: Point2<f64>, b: Point2<f64>) -> [f64; 2] {
    [b.x - a.x, b.y - a.y]
}

fn dot(a: [f64; 2], b: [f64; 2]) -> f64 {
    a[0] * b[0] + a[1] * b[1]
}
