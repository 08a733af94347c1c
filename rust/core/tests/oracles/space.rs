//! The volume of a union of balls, by slices: the integral of the area of a union of discs.
//!
//! Between heights where a ball begins or ends, two balls' circle has its lowest or highest
//! point, or three balls meet, the area is analytic, with square roots at most at the ends. A
//! cosine substitution takes these away; Gauss-Legendre panels are halved until nothing changes.

use std::f64::consts::{PI, TAU};

use super::Stream;

type Vector = [f64; 3];

fn dot(a: Vector, b: Vector) -> f64 {
    a[0] * b[0] + a[1] * b[1] + a[2] * b[2]
}

fn plus(a: Vector, factor: f64, b: Vector) -> Vector {
    [a[0] + factor * b[0], a[1] + factor * b[1], a[2] + factor * b[2]]
}

fn cross(a: Vector, b: Vector) -> Vector {
    [a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]]
}

/// `n` effects, most within `spread` radii of the origin: evenly or around three places; with
/// `lattice`, on multiples of half a radius, where many balls touch, coincide or meet.
pub fn scatter(n: usize, spread: f64, lattice: bool, tau: f64, seed: u64) -> Vec<Vector> {
    let mut stream = Stream(seed);
    let clustered = stream.below(2) == 1;
    let mut place = || [0; 3].map(|_| stream.between(-spread, spread));
    let places = [place(), place(), place()];
    let effect = |i: usize| {
        let place = if clustered {
            places[i % 3].map(|x| x + 0.03 * spread * stream.normals()[0])
        } else {
            [0; 3].map(|_| stream.between(-spread, spread))
        };
        place.map(|x| if lattice { (2.0 * x).round() / 2.0 * tau } else { x * tau })
    };
    (0..n).map(effect).collect()
}

/// The volume of the union of balls of radius `tau`, to some 1e-12 of a ball for each of them.
pub fn union_volume(effects: &[Vector], tau: f64) -> f64 {
    let mut balls: Vec<Vector> = effects.iter().map(|e| e.map(|x| x / tau)).collect();
    balls.sort_by(|a, b| a.partial_cmp(b).unwrap());
    balls.dedup();
    let mut cuts = cuts(&balls);
    cuts.sort_by(f64::total_cmp);
    let rule = gauss_legendre(12);
    let slab = |slab: &[f64]| {
        let (low, high) = (slab[0], slab[1]);
        if high - low < 1e-14 {
            return 0.0;
        }
        let near: Vec<Vector> =
            balls.iter().copied().filter(|b| b[2] - 1.0 < high && b[2] + 1.0 > low).collect();
        let integrand = |angle: f64| {
            let z = low + (high - low) * 0.5 * (1.0 - angle.cos());
            0.5 * (high - low) * angle.sin() * union_area(&near, z)
        };
        let whole = panel(&integrand, &rule, 0.0, PI);
        adaptive(&integrand, &rule, 0.0, PI, whole, 10)
    };
    cuts.windows(2).map(slab).sum::<f64>() * tau.powi(3)
}

/// Heights where the area of the slice is not analytic.
fn cuts(balls: &[Vector]) -> Vec<f64> {
    let mut points = Vec::new();
    for &a in balls {
        points.extend([plus(a, 1.0, [0.0, 0.0, 1.0]), plus(a, -1.0, [0.0, 0.0, 1.0])]);
    }
    let mut touching = Vec::new();
    for (i, &a) in balls.iter().enumerate() {
        for (j, &b) in balls[..i].iter().enumerate() {
            let difference = plus(b, -1.0, a);
            let squared = dot(difference, difference);
            if squared >= 4.0 {
                continue;
            }
            touching.push((i, j));
            let unit = difference.map(|x| x / squared.sqrt());
            let middle = plus(a, 0.5, difference);
            // The circle's steepest direction.
            let up = plus([0.0, 0.0, 1.0], -unit[2], unit);
            let length = dot(up, up).sqrt();
            let radius = (1.0 - squared / 4.0).sqrt();
            if length > 0.0 {
                let factor = radius / length;
                points.extend([plus(middle, factor, up), plus(middle, -factor, up)]);
            } else {
                // It lies level: any of its points will do. Four, lest one be buried.
                let [x, y, z] = middle;
                points.extend([[x + radius, y, z], [x - radius, y, z]]);
                points.extend([[x, y + radius, z], [x, y - radius, z]]);
            }
        }
    }
    for &(i, j) in &touching {
        for &(_, k) in touching.iter().filter(|&&(first, k)| first == i && k < j) {
            points.extend(meeting_points(balls[i], balls[j], balls[k]));
        }
    }
    // What lies inside a ball leaves no mark on the union.
    let buried = |p: &Vector| {
        balls.iter().any(|&b| {
            let away = plus(*p, -1.0, b);
            dot(away, away) < 1.0 - 1e-7
        })
    };
    points.iter().filter(|p| !buried(p)).map(|p| p[2]).collect()
}

/// The two points at distance 1 from all three.
fn meeting_points(a: Vector, b: Vector, c: Vector) -> Vec<Vector> {
    let (ab, ac) = (plus(b, -1.0, a), plus(c, -1.0, a));
    let normal = cross(ab, ac);
    let squared = dot(normal, normal);
    let towards = plus(cross(ac, normal).map(|x| -x * dot(ab, ab)), dot(ac, ac), cross(ab, normal));
    let offset = towards.map(|x| -x / (2.0 * squared));
    let height = 1.0 - dot(offset, offset);
    if squared == 0.0 || height.is_nan() || height < 0.0 {
        return Vec::new();
    }
    let centre = plus(a, 1.0, offset);
    let factor = (height / squared).sqrt();
    vec![plus(centre, factor, normal), plus(centre, -factor, normal)]
}

/// The area of the slice at height `z`: Green's theorem over the exposed arcs of its circles.
fn union_area(balls: &[Vector], z: f64) -> f64 {
    let discs: Vec<[f64; 3]> = balls
        .iter()
        .map(|b| [b[0], b[1], 1.0 - (z - b[2]) * (z - b[2])])
        .filter(|d| d[2] > 0.0)
        .map(|[x, y, rr]| [x, y, rr.sqrt()])
        .collect();
    let mut area = 0.0;
    let mut covered: Vec<(f64, f64)> = Vec::new();
    'discs: for (i, &[x, y, r]) in discs.iter().enumerate() {
        covered.clear();
        for (j, &[u, v, s]) in discs.iter().enumerate() {
            let (dx, dy) = (u - x, v - y);
            let d = dx.hypot(dy);
            if i == j || d >= r + s || d + s < r {
                continue;
            }
            if d + r < s || (d == 0.0 && r == s && j < i) {
                continue 'discs;
            }
            if d == 0.0 {
                continue;
            }
            let cosine = ((d * d + (r - s) * (r + s)) / (2.0 * d * r)).clamp(-1.0, 1.0);
            let (middle, half) = (dy.atan2(dx), cosine.acos());
            let from = (middle - half).rem_euclid(TAU);
            if from + 2.0 * half > TAU {
                covered.push((0.0, from + 2.0 * half - TAU));
            }
            covered.push((from, (from + 2.0 * half).min(TAU)));
        }
        covered.sort_by(|a, b| a.0.total_cmp(&b.0));
        covered.push((TAU, TAU));
        let mut reached = 0.0_f64;
        for &(from, to) in &covered {
            if from > reached {
                let (sine, cosine) = (from.sin() - reached.sin(), from.cos() - reached.cos());
                area += 0.5 * r * (r * (from - reached) + x * sine - y * cosine);
            }
            reached = reached.max(to);
        }
    }
    area
}

/// Nodes and weights on [-1, 1], by Newton's method on the Legendre polynomial.
fn gauss_legendre(n: usize) -> Vec<(f64, f64)> {
    let node = |i: usize| {
        let mut x = (PI * (i as f64 + 0.75) / (n as f64 + 0.5)).cos();
        let mut slope = 1.0;
        for _ in 0..20 {
            let (mut last, mut this) = (1.0, x);
            for k in 2..=n {
                let k = k as f64;
                (last, this) = (this, ((2.0 * k - 1.0) * x * this - (k - 1.0) * last) / k);
            }
            slope = n as f64 * (x * this - last) / (x * x - 1.0);
            x -= this / slope;
        }
        (x, 2.0 / ((1.0 - x * x) * slope * slope))
    };
    (0..n).map(node).collect()
}

fn panel(f: &impl Fn(f64) -> f64, rule: &[(f64, f64)], low: f64, high: f64) -> f64 {
    let (middle, half) = (0.5 * (low + high), 0.5 * (high - low));
    half * rule.iter().map(|&(x, weight)| weight * f(middle + half * x)).sum::<f64>()
}

fn adaptive(
    f: &impl Fn(f64) -> f64,
    rule: &[(f64, f64)],
    low: f64,
    high: f64,
    whole: f64,
    depth: u32,
) -> f64 {
    let middle = 0.5 * (low + high);
    let (left, right) = (panel(f, rule, low, middle), panel(f, rule, middle, high));
    // The halves are better than the whole by many digits.
    if (left + right - whole).abs() < 1e-10 || depth == 0 {
        return left + right;
    }
    adaptive(f, rule, low, middle, left, depth - 1)
        + adaptive(f, rule, middle, high, right, depth - 1)
}
