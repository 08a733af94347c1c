//! The boundary's loops where they are known beforehand: how many there are, of which arcs.

use std::f64::consts::TAU;

use crate::oracles::Stream;
use crate::oracles::loops::{boundary, check, check_orders, components, lattice, ring};
use divbandit_core::Coverage;
use divbandit_core::coverage::BoundaryArc;

#[test]
fn of_nothing_is_nothing() {
    assert_eq!(Coverage::new(1.0, 2).unwrap().boundary().unwrap(), [[]; 0]);
}

#[test]
fn of_one_disc_is_its_circle() {
    let (_, loops) = boundary(&[[0.3, -0.7]; 3], 0.02);
    assert_eq!(loops, [[BoundaryArc { x: 0.3, y: -0.7, from: 0.0, to: TAU }]]);
}

#[test]
fn of_two_discs() {
    // They cross at 60 degrees above and below the first one's centre.
    let (_, loops) = boundary(&[[0.0, 0.0], [1.0, 0.0]], 1.0);
    let [arcs] = &loops[..] else { panic!("{loops:?}") };
    let expected = [(0.0, TAU / 6.0, TAU * 5.0 / 6.0), (1.0, TAU * 4.0 / 6.0, TAU * 8.0 / 6.0)];
    assert_eq!(arcs.len(), 2);
    for (arc, (x, from, to)) in arcs.iter().zip(expected) {
        assert_eq!((arc.x, arc.y), (x, 0.0));
        assert!((arc.from - from).abs() < 1e-15 && (arc.to - to).abs() < 2e-15, "{arc:?}");
    }
    check_orders("overlap", &[[0.0, 0.0], [1.0, 0.5]], (1, 0));
    check_orders("touch", &[[0.0, 0.0], [0.0, 2.0]], (2, 0));
    check_orders("touch aslant", &[[0.0, 0.0], [1.2, 1.6], [-1.2, -1.6]], (3, 0));
    check_orders("apart", &[[0.0, 0.0], [3.0, 1.0]], (2, 0));
    check_orders("all but touch", &[[0.0, 0.0], [2.0 - 1e-13, 0.0]], (1, 0));
    check_orders("all but coincide", &[[0.0, 0.0], [1e-15, 0.0]], (1, 0));
}

#[test]
fn of_rings() {
    let outer = ring(12, 3.0);
    check_orders("ring", &outer, (1, 1));
    let (_, loops) = boundary(&outer, 1.0);
    assert!(loops.iter().all(|arcs| arcs.len() == 12), "{loops:?}");
    check_orders("and a disc inside", &[&outer[..], &[[0.1, -0.2]]].concat(), (2, 1));
    check_orders(
        "and a ring inside",
        &[ring(24, 6.0), ring(36, 9.0), outer.clone()].concat(),
        (3, 3),
    );
    check_orders("filled", &[outer, ring(12, 1.5), vec![[0.0, 0.0]]].concat(), (1, 0));
    check_orders("through one point", &ring(60, 1.0), (1, 0));
    check_orders("all but through one point", &ring(60, 1.0 + 1e-6), (1, 1));
    check_orders("tiny", &ring(60, 1e-9), (1, 0));
}

#[test]
fn of_square_lattices() {
    // A radius that leaves out 1/2 or less leaves them apart, one from the root of 1/2 on covers all.
    let covering = 0.5_f64.sqrt();
    for (radius, expected) in [
        (0.4, (16, 0)),
        (0.5, (16, 0)),
        (0.5 + 1e-9, (1, 9)),
        (0.6, (1, 9)),
        (covering - 1e-8, (1, 9)),
        (covering, (1, 0)),
        (covering + 1e-8, (1, 0)),
        (1.0, (1, 0)),
        (1.5, (1, 0)),
    ] {
        let set = lattice(4, 4, [1.0 / radius; 2], 0.0);
        assert_eq!(check("square", &lattice(4, 4, [1.0; 2], 0.0), radius), expected, "{radius}");
        if radius != 0.5 && radius != covering {
            check_orders("square", &set, expected);
        }
    }
}

#[test]
fn of_hexagonal_lattices() {
    let third = 3.0_f64.sqrt();
    for step in [third - 1e-7, third, 1.0, 0.5] {
        let set = lattice(7, 6, [step, step * third / 2.0], step / 2.0);
        check_orders(&format!("step {step}"), &set, (1, 0));
    }
    // Six rows of seven: 2 x 6 x 5 triangles.
    for step in [third + 1e-7, 1.9, 2.0 - 1e-9] {
        let set = lattice(7, 6, [step, step * third / 2.0], step / 2.0);
        check_orders(&format!("step {step}"), &set, (1, 60));
    }
}

/// Discs that touch but for the rounding of their centres: exact whole numbers tell who overlaps.
#[test]
fn of_a_hexagonal_lattice_of_touching_discs() {
    let whole = |x: f64| (x * 2.0_f64.powi(51)) as i128;
    let squared = |a: [f64; 2], b: [f64; 2]| {
        let [dx, dy] = [whole(a[0]) - whole(b[0]), whole(a[1]) - whole(b[1])];
        dx * dx + dy * dy
    };
    let overlap = |a: [f64; 2], b: [f64; 2]| squared(a, b) < 1 << 104;
    let mut overlaps = 0;
    for rows in 2..12 {
        let set = lattice(7, rows, [2.0, 3.0_f64.sqrt()], 1.0);
        assert!(set.iter().flatten().all(|&x| whole(x) as f64 == x * 2.0_f64.powi(51)));
        // No three have a common point: the union is like the graph of overlaps.
        let edges: usize = set
            .iter()
            .enumerate()
            .map(|(i, &a)| set[..i].iter().filter(|&&b| overlap(a, b)).count())
            .sum();
        let parts = components(&set, overlap);
        assert_eq!(check("touching", &set, 1.0), (parts, parts + edges - set.len()));
        overlaps += edges;
    }
    assert!(overlaps > 100, "{overlaps}");
}

#[test]
fn of_clusters() {
    let mut stream = Stream(6);
    for width in [1.0, 1e-3, 1e-6, 1e-9, 1e-12, 1e-15] {
        let place = |i: usize| {
            let [x, y] = stream.normals();
            [(i % 3) as f64 * 2.5 + width * x.clamp(-0.2, 0.2), width * y.clamp(-2.0, 2.0)]
        };
        let set: Vec<_> = (0..300).map(place).collect();
        if width < 0.1 {
            check_orders(&format!("width {width:e}"), &set, (3, 0));
        } else {
            check("wide", &set, 1.0);
        }
    }
}
