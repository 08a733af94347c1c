//! The truth lies within three stated standard errors in at least 98 of 100 cases.

use crate::oracles::Stream;
use crate::oracles::coplanar::free_share;
use divbandit_core::Coverage;
use divbandit_core::coverage::estimate::Estimate;

const CASES: u64 = 100;

/// The gain at the origin and its standard error, in units of a ball, after `centres` in units
/// of the radius.
fn estimated(centres: &[Vec<f64>], dim: usize, accuracy: f64, key: u64) -> (f64, f64) {
    let tau = 0.3;
    let mut estimate = Estimate::new(tau, dim, accuracy, key);
    for centre in centres {
        let effect: Vec<f64> = centre.iter().map(|x| x * tau).collect();
        estimate.insert(&effect);
    }
    let (estimated, ball) = (estimate.gain(&vec![0.0; dim]), estimate.ball());
    (estimated.gain / ball, estimated.standard_error / ball)
}

/// Points of the plane as points of `dim` dimensions.
fn lifted(centres: &[[f64; 2]], dim: usize) -> Vec<Vec<f64>> {
    let lift = |&[x, y]: &[f64; 2]| {
        let mut centre = vec![0.0; dim];
        (centre[0], centre[dim - 1]) = (x, y);
        centre
    };
    centres.iter().map(lift).collect()
}

/// `case` gives a truth, what it may be off, the estimate and its standard error.
fn honest(name: &str, case: impl Fn(u64, &mut Stream) -> (f64, f64, (f64, f64))) {
    let (mut beyond, mut sum, mut squares) = (0, 0.0, 0.0);
    for i in 0..CASES {
        let mut stream = Stream(i * 7919 + 17);
        let (truth, slack, (gain, error)) = case(i, &mut stream);
        let off = gain - truth;
        beyond += u64::from(off.abs() > 3.0 * error + slack);
        if error > slack {
            let z = off / error;
            sum += z / CASES as f64;
            squares += z * z / CASES as f64;
        }
    }
    println!("{name}: {beyond} of {CASES} beyond 3, mean {sum:.2}, rms {:.2}", squares.sqrt());

    assert!(50 * beyond <= CASES, "{name}: {beyond} of {CASES} beyond three standard errors");
}

fn coplanar_case(
    dim: usize,
    accuracy: f64,
    spread: f64,
    most: usize,
) -> impl Fn(u64, &mut Stream) -> (f64, f64, (f64, f64)) {
    move |key, stream| {
        let n = 2 + stream.below(most - 1);
        let centres: Vec<[f64; 2]> = (0..n)
            .map(|_| {
                let [x, y] = stream.normals();
                let (r, length) = (spread * stream.unit(), x.hypot(y));
                [r * x / length, r * y / length]
            })
            .collect();
        let estimated = estimated(&lifted(&centres, dim), dim, accuracy, key);
        (free_share(&centres, dim), 3e-5, estimated)
    }
}

fn balls_in_a_plane(dim: usize) {
    for accuracy in [5e-2, 1e-2, 1e-3] {
        for (spread, most) in [(2.0, 3), (1.0, 4), (2.0, 10), (1.6, 30)] {
            honest(
                &format!("{most} within {spread} in {dim} dimensions at {accuracy}"),
                coplanar_case(dim, accuracy, spread, most),
            );
        }
    }
}

#[test]
fn balls_in_a_plane_in_3_dimensions() {
    balls_in_a_plane(3);
}

#[test]
fn balls_in_a_plane_in_4_dimensions() {
    balls_in_a_plane(4);
}

#[test]
fn balls_in_a_plane_in_8_dimensions() {
    balls_in_a_plane(8);
}

#[test]
fn balls_in_a_plane_in_16_dimensions() {
    balls_in_a_plane(16);
}

#[test]
fn discs() {
    for accuracy in [5e-2, 1e-2, 1e-3] {
        honest(&format!("discs at {accuracy}"), |key, stream| {
            let n = 1 + stream.below(8);
            let mut coverage = Coverage::new(1.0, 2).unwrap();
            let centres: Vec<[f64; 2]> =
                (0..n).map(|_| [stream.between(-1.5, 1.5), stream.between(-1.5, 1.5)]).collect();
            for &centre in &centres {
                coverage.add(centre).unwrap();
            }
            let truth = coverage.gain([0.0; 2]).unwrap() / coverage.ball();
            (truth, 1e-12, estimated(&lifted(&centres, 2), 2, accuracy, key))
        });
    }
}
