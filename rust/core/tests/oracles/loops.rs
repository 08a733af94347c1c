//! What a boundary's loops must be, from their arcs alone; and how many there must be, from the
//! discs alone.

#![allow(dead_code, reason = "each test takes the part that it needs")]

use std::f64::consts::{PI, TAU};

use divbandit_core::Coverage;
use divbandit_core::coverage::BoundaryArc;

use crate::oracles::Stream;

/// One loop, looked at.
#[derive(Debug, Clone, Copy)]
pub struct Looked {
    /// The signed area, in squared radii: Green's theorem, arc by arc.
    pub area: f64,
    /// How far tangents turn on the way around, in radians: 2 pi counter-clockwise.
    pub turning: f64,
    /// The longest way from an arc's end to the next one's start, in radii.
    pub gap: f64,
}

pub fn look(arcs: &[BoundaryArc], tau: f64) -> Looked {
    let mut looked = Looked { area: 0.0, turning: 0.0, gap: 0.0 };
    for (index, arc) in arcs.iter().enumerate() {
        assert!((0.0..TAU).contains(&arc.from), "{arc:?}");
        assert!(arc.from < arc.to && arc.to <= arc.from + TAU, "{arc:?}");
        let (cx, cy) = ((arc.x - arcs[0].x) / tau, (arc.y - arcs[0].y) / tau);
        let ((y0, x0), (y1, x1)) = (arc.from.sin_cos(), arc.to.sin_cos());
        looked.area += 0.5 * (arc.to - arc.from + cx * (y1 - y0) - cy * (x1 - x0));
        looked.turning += arc.to - arc.from;
        if arcs.len() == 1 && arc.to - arc.from > TAU - 1e-15 {
            continue; // no corner
        }
        let next = arcs[(index + 1) % arcs.len()];
        let (y2, x2) = next.from.sin_cos();
        let (dx, dy) = ((next.x - arc.x) / tau + (x2 - x1), (next.y - arc.y) / tau + (y2 - y1));
        looked.gap = looked.gap.max(dx.hypot(dy));
        // Outside of discs corners are less than half a turn wide: the way turns to the right.
        let corner = (x1 * y2 - y1 * x2).atan2(x1 * x2 + y1 * y2);
        looked.turning += if corner > 1.0 { corner - TAU } else { corner };
    }
    looked
}

/// Checks every loop; how many are outer ones and how many holes, and the area inside them all.
pub fn counts(name: &str, loops: &[Vec<BoundaryArc>], tau: f64) -> (usize, usize, f64) {
    let (mut outers, mut holes, mut area) = (0, 0, 0.0);
    for arcs in loops {
        let looked = look(arcs, tau);
        assert!(looked.gap < 1e-9, "{name}: {looked:?}\n{arcs:?}");
        assert!((looked.turning.abs() - TAU).abs() < 1e-6, "{name}: {looked:?}\n{arcs:?}");
        if looked.turning > 0.0 {
            assert!(looked.area > PI - 1e-10, "{name}: {looked:?}\n{arcs:?}");
            outers += 1;
        } else {
            assert!(looked.area < 1e-14, "{name}: {looked:?}\n{arcs:?}");
            holes += 1;
        }
        area += looked.area;
    }
    (outers, holes, area)
}

/// How many parts the union has: discs that overlap are in one.
pub fn components(discs: &[[f64; 2]], overlap: impl Fn([f64; 2], [f64; 2]) -> bool) -> usize {
    let mut part: Vec<usize> = (0..discs.len()).collect();
    for i in 0..discs.len() {
        for j in 0..i {
            let (a, b) = (part[i], part[j]);
            if a != b && overlap(discs[i], discs[j]) {
                part.iter_mut().filter(|p| **p == a).for_each(|p| *p = b);
            }
        }
    }
    part.iter().enumerate().filter(|&(i, &p)| part[..i].iter().all(|&q| q != p)).count()
}

fn distance(a: [f64; 2], b: [f64; 2]) -> f64 {
    (a[0] - b[0]).hypot(a[1] - b[1])
}

pub fn overlap(a: [f64; 2], b: [f64; 2]) -> bool {
    distance(a, b) < 2.0
}

/// Whether three unit discs have a common point: whether the smallest ball around their centres
/// is smaller than one.
fn have_common(a: [f64; 2], b: [f64; 2], c: [f64; 2]) -> bool {
    let mut sides = [distance(a, b), distance(b, c), distance(c, a)];
    sides.sort_by(f64::total_cmp);
    let [p, q, r] = sides;
    if p * p + q * q <= r * r {
        return r < 2.0;
    }
    let cross = (b[0] - a[0]) * (c[1] - a[1]) - (b[1] - a[1]) * (c[0] - a[0]);
    p * q * r < 2.0 * cross.abs()
}

/// The Euler characteristic of a union of unit discs, parts less holes: the alternating sum over
/// all sets of discs that have a common point (the nerve theorem). In the plane a set has one if
/// every three of it have (Helly).
pub fn euler_characteristic(discs: &[[f64; 2]]) -> i64 {
    fn all(discs: &[[f64; 2]], chosen: &mut Vec<[f64; 2]>) -> i64 {
        let mut sum = 0;
        for (i, &disc) in discs.iter().enumerate() {
            let fits = chosen.iter().enumerate().all(|(j, &a)| {
                overlap(a, disc) && chosen[..j].iter().all(|&b| have_common(a, b, disc))
            });
            if fits {
                chosen.push(disc);
                sum += if chosen.len() % 2 == 1 { 1 } else { -1 };
                sum += all(&discs[i + 1..], chosen);
                chosen.pop();
            }
        }
        sum
    }
    all(discs, &mut Vec::new())
}

pub fn boundary(effects: &[[f64; 2]], tau: f64) -> (Coverage, Vec<Vec<BoundaryArc>>) {
    let mut coverage = Coverage::new(tau, 2).unwrap();
    coverage.extend(effects.as_flattened(), &mut vec![0.0; effects.len()]).unwrap();
    let loops = coverage.boundary().unwrap();
    (coverage, loops)
}

/// Checks loops and area; how many outer loops and holes there are.
pub fn check(name: &str, effects: &[[f64; 2]], tau: f64) -> (usize, usize) {
    let (coverage, loops) = boundary(effects, tau);
    let (outers, holes, area) = counts(name, &loops, tau);
    let error = (area - coverage.measure() / (tau * tau)).abs() / PI;
    assert!(error < 1e-10 * loops.len() as f64, "{name}: off by {error:e} discs\n{effects:?}");
    let key = |arc: &BoundaryArc| [arc.x, arc.y, arc.from];
    assert!(loops.iter().all(|arcs| arcs.iter().all(|arc| key(arc) >= key(&arcs[0]))), "{name}");
    assert!(loops.is_sorted_by_key(|arcs| key(&arcs[0])), "{name}");
    (outers, holes)
}

/// Checks a set in units of the radius: as it is and shuffled, for several radii.
pub fn check_orders(name: &str, set: &[[f64; 2]], expected: (usize, usize)) {
    let mut set = set.to_vec();
    for (tau, seed) in [(1.0, 1), (0.02, 2), (700.0, 3)] {
        let scaled: Vec<_> = set.iter().map(|c| c.map(|x| x * tau)).collect();
        assert_eq!(check(name, &scaled, tau), expected, "{name}, tau = {tau}");
        Stream(seed).shuffle(&mut set);
    }
}

/// `columns` x `rows` points, `step` apart, every second row shifted by `shift`.
pub fn lattice(columns: usize, rows: usize, step: [f64; 2], shift: f64) -> Vec<[f64; 2]> {
    let point = |i: usize| {
        let (column, row) = ((i % columns) as f64, (i / columns) as f64);
        [step[0] * column + shift * (row % 2.0), step[1] * row]
    };
    (0..columns * rows).map(point).collect()
}

pub fn ring(n: usize, radius: f64) -> Vec<[f64; 2]> {
    let at = |i: usize| i as f64 / n as f64 * TAU;
    (0..n).map(|i| [radius * at(i).cos(), radius * at(i).sin()]).collect()
}
