//! Uniformly random rotations (and mirrorings): Haar measure on the orthogonal group.
//!
//! Stewart's way (SIAM Journal on Numerical Analysis 17, 1980): the first axis goes to a
//! uniform direction by a reflection, the rest of the axes go to the rest of the space by a
//! uniform orthogonal map of one dimension less, and so on down. Reflections stay orthogonal
//! to rounding, whatever the vector that they were made from, and turning a vector costs
//! d^2 operations, as a matrix would; the Gram-Schmidt process costs 2 d^3 before the first.

use super::stream::Stream;

/// A product of reflections, of the space without its first 0, 1, 2, ... axes.
#[derive(Debug, Clone, Default)]
pub(super) struct Rotation {
    dim: usize,
    /// The mirrors' normals one after another, of length dim, dim - 1, ..., 1, scaled so that
    /// x - n (n . x) is the reflection.
    normals: Vec<f64>,
}

impl Rotation {
    /// Draws another rotation of `dim`-dimensional space.
    pub fn draw(&mut self, dim: usize, stream: &mut Stream) {
        self.dim = dim;
        self.normals.clear();
        for axes in (1..=dim).rev() {
            let start = self.normals.len();
            self.normals.extend((0..axes).map(|_| stream.normal()));
            let normal = &mut self.normals[start..];
            // The mirror between the first axis, lengthened to the drawn vector's length, and
            // that vector. Both have the same length, so it swaps them.
            normal[0] -= square(normal).sqrt();
            let length = square(normal);
            if length > 0.0 {
                let scale = (2.0 / length).sqrt();
                normal.iter_mut().for_each(|x| *x *= scale);
            }
        }
    }

    /// Turns a vector.
    pub fn turn(&self, x: &mut [f64]) {
        let mut end = self.normals.len();
        for axes in 1..=self.dim {
            let normal = &self.normals[end - axes..end];
            let part = &mut x[self.dim - axes..];
            let along = normal.iter().zip(&*part).fold(0.0, |sum, (n, x)| sum + n * x);
            part.iter_mut().zip(normal).for_each(|(x, n)| *x -= along * n);
            end -= axes;
        }
    }
}

/// The squared length of a vector.
pub(super) fn square(x: &[f64]) -> f64 {
    x.iter().fold(0.0, |sum, x| sum + x * x)
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::coverage::estimate::stream::Purpose;

    /// The rotation's matrix, column by column.
    fn columns(dim: usize, counter: u64) -> Vec<Vec<f64>> {
        let mut rotation = Rotation::default();
        rotation.draw(dim, &mut Stream::new(1, Purpose::Effect, counter));
        let axis = |i| (0..dim).map(|j| f64::from(u8::from(i == j))).collect::<Vec<_>>();
        (0..dim).map(axis).map(|mut x| (rotation.turn(&mut x), x).1).collect()
    }

    #[test]
    fn keeps_lengths_and_angles() {
        for dim in 1..=32 {
            for counter in 0..20 {
                let q = columns(dim, counter);
                for (i, a) in q.iter().enumerate() {
                    for (j, b) in q.iter().enumerate() {
                        let dot: f64 = a.iter().zip(b).map(|(a, b)| a * b).sum();
                        let expected = f64::from(u8::from(i == j));
                        assert!((dot - expected).abs() < 1e-14, "{dim}: {i}, {j}: {dot}");
                    }
                }
            }
        }
    }

    /// Moments of a uniform orthogonal matrix: entries have mean 0, mean square 1 / d and mean
    /// fourth power 3 / (d (d + 2)); the trace has mean 0 and mean square 1; so do traces of
    /// squares around 1 and (for d >= 2) entries of different rows and columns do not correlate.
    #[test]
    fn is_uniform() {
        let n = 40_000;
        for dim in [1, 2, 3, 5, 8] {
            let d = dim as f64;
            let mut means = vec![0.0; 3 * dim * dim + 3];
            for counter in 0..n {
                let q = columns(dim, counter);
                let entry = |i: usize| q[i / dim][i % dim];
                let trace: f64 = (0..dim).map(|i| q[i][i]).sum();
                for i in 0..dim * dim {
                    let x = entry(i);
                    means[3 * i] += x;
                    means[3 * i + 1] += x * x - 1.0 / d;
                    means[3 * i + 2] += x * x * x * x - 3.0 / (d * (d + 2.0));
                }
                let squares: f64 =
                    (0..dim * dim).map(|i| q[i / dim][i % dim] * q[i % dim][i / dim]).sum();
                means[3 * dim * dim] += trace;
                means[3 * dim * dim + 1] += trace * trace - 1.0;
                means[3 * dim * dim + 2] += squares - 1.0;
            }
            for (i, mean) in means.iter().enumerate() {
                // Five standard errors: no quantity here has a variance above 2.
                let mean = mean / n as f64;
                assert!(mean.abs() < 5.0 * (2.0 / n as f64).sqrt(), "{dim}: moment {i}: {mean}");
            }
        }
    }
}
