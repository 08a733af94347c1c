//! The measure is the share of points that lie in a disc, as parry's balls see them.
//!
//! A square grid of cells covers the discs. A cell that lies wholly in a disc counts, one that
//! meets none does not; of the others, one random point each decides. The error is then a sum
//! of B independent numbers in [0, h^2], and stays below 4 h^2 sqrt(B) but with probability
//! 2 exp(-32) (Hoeffding). Seeds are fixed.

use crate::oracles::{Stream, scatter};
use divbandit_core::Coverage;
use parry2d_f64::math::{Pose, Vector};
use parry2d_f64::query::PointQuery;
use parry2d_f64::shape::Ball;

/// The area by cells, and the error that it stays below.
fn sampled(effects: &[[f64; 2]], tau: f64, cells: usize, stream: &mut Stream) -> (f64, f64) {
    let ball = Ball::new(tau);
    let poses: Vec<Pose> = effects.iter().map(|&[x, y]| Pose::translation(x, y)).collect();
    let depth = |point: Vector| {
        let distances = poses.iter().map(|pose| ball.distance_to_point(pose, point, false));
        distances.fold(f64::INFINITY, f64::min)
    };
    let most = effects.as_flattened().iter().fold(0.0, |most: f64, x| most.max(x.abs())) + tau;
    let h = 2.0 * most / cells as f64;
    let (mut inside, mut undecided) = (0_u32, 0_u32);
    for cell in 0..cells * cells {
        let corner = [(cell % cells) as f64, (cell / cells) as f64].map(|i| i * h - most);
        let away = depth(Vector::new(corner[0] + h / 2.0, corner[1] + h / 2.0));
        let within = if away.abs() > h * 0.7072 {
            away < 0.0
        } else {
            undecided += 1;
            let (x, y) = (corner[0] + h * stream.unit(), corner[1] + h * stream.unit());
            poses.iter().any(|pose| ball.contains_point(pose, Vector::new(x, y)))
        };
        inside += u32::from(within);
    }
    (f64::from(inside) * h * h, 4.0 * h * h * f64::from(undecided).sqrt())
}

#[test]
fn for_effects_dense_and_sparse() {
    let tau = 0.02;
    for (seed, (n, spread)) in
        [(1, 1.0), (5, 0.5), (40, 2.0), (40, 8.0), (200, 4.0)].into_iter().enumerate()
    {
        let seed = seed as u64;
        let effects = scatter(n, spread, seed % 2 == 1, tau, seed);
        let mut coverage = Coverage::new(tau, 2).unwrap();
        coverage.extend(effects.as_flattened(), &mut vec![0.0; n]).unwrap();
        let (expected, error) = sampled(&effects, tau, 800, &mut Stream(seed));
        let measure = coverage.measure();
        assert!((measure - expected).abs() < error, "{n}: {measure} {expected} +- {error}");
        assert!(error < 0.01 * measure, "{n}: +- {error} says too little");
    }
}
