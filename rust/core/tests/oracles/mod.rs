//! Slow and plain ways to the kernels' results, each simple enough to check by eye, and the
//! fixed seeds of the tests.

#![allow(dead_code, reason = "each test takes the part that it needs")]

pub mod adapt;
pub mod coplanar;
pub mod loops;
pub mod past;
pub mod space;
pub mod sums;

use proptest::test_runner::{Config, RngSeed};

/// A property test of `cases` cases that are the same in every run.
pub fn fixed(cases: u32) -> Config {
    Config {
        cases,
        rng_seed: RngSeed::Fixed(20150813),
        failure_persistence: None,
        ..Config::default()
    }
}

/// Numbers uniform in [0, 1) from a seed: SplitMix64.
pub struct Stream(pub u64);

impl Stream {
    pub fn unit(&mut self) -> f64 {
        self.0 = self.0.wrapping_add(0x9E37_79B9_7F4A_7C15);
        let mut z = self.0;
        z = (z ^ (z >> 30)).wrapping_mul(0xBF58_476D_1CE4_E5B9);
        z = (z ^ (z >> 27)).wrapping_mul(0x94D0_49BB_1331_11EB);
        ((z ^ (z >> 31)) >> 11) as f64 / (1_u64 << 53) as f64
    }

    pub fn between(&mut self, low: f64, high: f64) -> f64 {
        low + (high - low) * self.unit()
    }

    pub fn below(&mut self, n: usize) -> usize {
        (self.unit() * n as f64) as usize
    }

    /// Two independent standard normal numbers (Box and Muller).
    pub fn normals(&mut self) -> [f64; 2] {
        let radius = (-2.0 * (1.0 - self.unit()).ln()).sqrt();
        let (sine, cosine) = self.between(0.0, std::f64::consts::TAU).sin_cos();
        [radius * cosine, radius * sine]
    }

    pub fn shuffle<T>(&mut self, items: &mut [T]) {
        for i in (1..items.len()).rev() {
            items.swap(i, self.below(i + 1));
        }
    }
}

/// `n` effects, most within `spread` radii of the origin: evenly or around three places; with
/// `lattice`, on multiples of a quarter radius, where many circles touch, coincide or meet.
pub fn scatter(n: usize, spread: f64, lattice: bool, tau: f64, seed: u64) -> Vec<[f64; 2]> {
    let mut stream = Stream(seed);
    let clustered = stream.below(2) == 1;
    let mut place = || [stream.between(-spread, spread), stream.between(-spread, spread)];
    let places = [place(), place(), place()];
    let effect = |i: usize| {
        let [x, y] = if clustered {
            let ([x, y], [dx, dy]) = (places[i % 3], stream.normals());
            [x + 0.03 * spread * dx, y + 0.03 * spread * dy]
        } else {
            [stream.between(-spread, spread), stream.between(-spread, spread)]
        };
        [x, y].map(|x| if lattice { (4.0 * x).round() / 4.0 * tau } else { x * tau })
    };
    (0..n).map(effect).collect()
}

/// Every point's distance and index, nearest first, at the same distance earliest first.
pub fn by_distance(points: &[Vec<f64>], query: &[f64]) -> Vec<(f64, usize)> {
    let squared = |point: &Vec<f64>| -> f64 {
        point.iter().zip(query).fold(0.0, |sum, (p, q)| sum + (q - p) * (q - p))
    };
    let mut found: Vec<_> = points.iter().map(squared).zip(0..).collect();
    found.sort_by(|a, b| a.0.total_cmp(&b.0).then(a.1.cmp(&b.1)));
    found.iter().map(|&(squared, index)| (squared.sqrt(), index)).collect()
}

/// The area of the union of discs of radius `tau`, by vertical slabs.
///
/// The plane is cut at every disc's left and right end and wherever two circles cross. In the
/// middle of a slab the discs are intervals; where a run of overlapping ones has its lowest and
/// its highest end, the same two circles bound it in the whole slab, and the area below a
/// circle has a closed form. A cut misplaced by e costs an area of the order of e^2 only.
pub fn union_area(centres: &[[f64; 2]], tau: f64) -> f64 {
    let discs: Vec<[f64; 2]> = centres.iter().map(|[x, y]| [x / tau, y / tau]).collect();
    let mut cuts: Vec<f64> = discs.iter().flat_map(|[x, _]| [x - 1.0, x + 1.0]).collect();
    for (i, a) in discs.iter().enumerate() {
        for b in &discs[..i] {
            let (dx, dy) = (b[0] - a[0], b[1] - a[1]);
            let distance = dx.hypot(dy);
            // A cut too many does no harm: where circles touch there is one in any case.
            if 0.0 < distance && distance < 2.1 {
                let half_chord = ((2.0 - distance) * (2.0 + distance)).max(0.0).sqrt() / 2.0;
                let (middle, aside) = (a[0] + dx / 2.0, dy / distance * half_chord);
                cuts.extend([middle - aside, middle + aside]);
            }
        }
    }
    cuts.sort_by(f64::total_cmp);
    let area: f64 = cuts.windows(2).map(|slab| slab_area(&discs, slab[0], slab[1])).sum();
    area * tau * tau
}

fn slab_area(discs: &[[f64; 2]], left: f64, right: f64) -> f64 {
    let middle = left + (right - left) / 2.0;
    // Lowest and highest end of each disc there, and the disc.
    let mut intervals: Vec<(f64, f64, [f64; 2])> = Vec::new();
    for &[x, y] in discs {
        let away = middle - x;
        if away.abs() < 1.0 {
            let half = ((1.0 - away) * (1.0 + away)).sqrt();
            intervals.push((y - half, y + half, [x, y]));
        }
    }
    intervals.sort_by(|a, b| a.0.total_cmp(&b.0));
    let half_disc = |[x, _]: [f64; 2]| below_circle(right - x) - below_circle(left - x);
    let mut area = 0.0;
    let mut rest = &intervals[..];
    while let Some(&(_, mut high, bottom)) = rest.first() {
        let (mut top, mut run) = (bottom, 1);
        while run < rest.len() && rest[run].0 <= high {
            if rest[run].1 > high {
                (high, top) = (rest[run].1, rest[run].2);
            }
            run += 1;
        }
        area += (top[1] - bottom[1]) * (right - left) + half_disc(top) + half_disc(bottom);
        rest = &rest[run..];
    }
    area
}

/// The area between the upper half of the unit circle and its diameter, from 0 to `x`.
fn below_circle(x: f64) -> f64 {
    let x = x.clamp(-1.0, 1.0);
    0.5 * (x * ((1.0 - x) * (1.0 + x)).sqrt() + x.asin())
}
