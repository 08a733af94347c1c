//! The few operations on vectors of space that the volume needs.

/// A point or a difference of points, in units of the radius unless said otherwise.
pub(crate) type Vector = [f64; 3];

#[inline]
pub(crate) fn dot(a: Vector, b: Vector) -> f64 {
    a[0] * b[0] + a[1] * b[1] + a[2] * b[2]
}

#[inline]
pub(crate) fn minus(a: Vector, b: Vector) -> Vector {
    [a[0] - b[0], a[1] - b[1], a[2] - b[2]]
}

#[inline]
pub(crate) fn over(a: Vector, divisor: f64) -> Vector {
    [a[0] / divisor, a[1] / divisor, a[2] / divisor]
}

/// Two unit vectors at right angles to each other and to `v`, which has this `length`.
#[inline]
pub(crate) fn across(v: Vector, length: f64) -> (Vector, Vector) {
    // Of the two choices the one that is not short beside v.
    let first = if v[0].abs() > v[2].abs() { [-v[1], v[0], 0.0] } else { [0.0, -v[2], v[1]] };
    let first = over(first, dot(first, first).sqrt());
    let second = [
        v[1] * first[2] - v[2] * first[1],
        v[2] * first[0] - v[0] * first[2],
        v[0] * first[1] - v[1] * first[0],
    ];
    (first, over(second, length))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn across_gives_an_orthonormal_frame() {
        for x in -4..=4 {
            for y in -4..=4 {
                for z in -4..=4 {
                    let v = [f64::from(x), f64::from(y), 1e-3 * f64::from(z * z * z)];
                    if v == [0.0; 3] {
                        continue;
                    }
                    let length = dot(v, v).sqrt();
                    let (u, (e, f)) = (over(v, length), across(v, length));
                    for (a, b, expected) in
                        [(e, e, 1.0), (f, f, 1.0), (e, f, 0.0), (e, u, 0.0), (f, u, 0.0)]
                    {
                        assert!((dot(a, b) - expected).abs() <= 4.0 * f64::EPSILON, "{u:?}");
                    }
                }
            }
        }
    }
}
