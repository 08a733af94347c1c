//! The gain of a ball among balls whose centres lie in one plane with its own, by quadrature.

/// The share of the unit ball in `dim` >= 3 dimensions that unit balls around centres in a
/// plane through its own centre leave free, within about 1e-5.
///
/// Above a point x of the plane, a ball around c is a ball of dim - 2 dimensions of squared
/// radius 1 - |x - c|^2, and all are concentric: the largest of the others covers. What is
/// left is integrated over the disc on a polar grid of midpoints.
pub fn free_share(centres: &[[f64; 2]], dim: usize) -> f64 {
    let (radii, turns) = (600, 600);
    let height = |square: f64| {
        let power = (dim as i32 - 2).cast_unsigned();
        let side = (1.0 - square).max(0.0).sqrt();
        (0..power).fold(1.0, |product, _| product * side)
    };
    let (mut free, mut all) = (0.0, 0.0);
    for j in 0..turns {
        let (sine, cosine) =
            ((f64::from(j) + 0.5) * std::f64::consts::TAU / f64::from(turns)).sin_cos();
        for i in 0..radii {
            let r = (f64::from(i) + 0.5) / f64::from(radii);
            let own = height(r * r);
            let square = |[x, y]: &[f64; 2]| {
                let (x, y) = (r * cosine - x, r * sine - y);
                x * x + y * y
            };
            let nearest = centres.iter().map(square).fold(f64::INFINITY, f64::min);
            free += r * (own - height(nearest)).max(0.0);
            all += r * own;
        }
    }
    free / all
}
