//! Writes the seeds: short sequences, one for each family of hostile effects.
//!
//! `cargo run --manifest-path fuzz/Cargo.toml --example seeds`, from the checkout's root.

#[path = "../../rust/core/tests/laws/sequence.rs"]
#[allow(dead_code, reason = "it decodes, too")]
mod sequence;

use std::path::Path;
use std::{fs, io};

use sequence::{HOMES, JITTERS, Op, RADII, SPACINGS, TAUS};

/// Bytes under way, for `dim` dimensions.
struct Seed {
    dim: usize,
    bytes: Vec<u8>,
}

impl Seed {
    fn new(dim: usize, tau: f64, home: f64, key: u8) -> Self {
        Self { dim, bytes: vec![index(&TAUS, tau), index(&HOMES, home), key] }
    }

    fn op(mut self, op: Op, parameters: &[u8]) -> Self {
        self.bytes.push(op as u8);
        self.bytes.extend(parameters);
        self
    }

    fn lattice(self, spacing: f64, place: [i8; 3]) -> Self {
        let place = place.map(i8::cast_unsigned);
        let parameters = [&[index(&SPACINGS, spacing)], &place[..self.dim]].concat();
        self.op(Op::Lattice, &parameters)
    }

    /// In multiples of 1.5 degrees.
    fn direction(&self, angle: u8) -> Vec<u8> {
        if self.dim > 2 { vec![angle, angle / 3] } else { vec![angle] }
    }

    fn polar(self, op: Op, of: u8, radius: f64, jitter: f64, angle: u8) -> Self {
        let head = [of, index(&RADII, radius), index(&JITTERS, jitter)];
        let parameters = [&head[..], &self.direction(angle)].concat();
        self.op(op, &parameters)
    }

    fn line(self, of: u8, angle: u8, halvings: u8, more: u8) -> Self {
        let parameters = [&[of], &self.direction(angle)[..], &[halvings, more]].concat();
        self.op(Op::Line, &parameters)
    }

    fn circle(self, of: u8, radius: f64, halvings: u8, number: u8, angle: u8) -> Self {
        self.op(Op::Circle, &[of, index(&RADII, radius), halvings, number - 1, angle])
    }
}

fn index(values: &[f64], value: f64) -> u8 {
    values.iter().position(|&known| known == value).map_or(0, |index| index as u8)
}

/// Names and bytes for so many dimensions.
fn seeds(dim: usize) -> Vec<(String, Vec<u8>)> {
    let mut seeds: Vec<(String, Seed)> = Vec::new();
    let mut keep = |name: &str, seed: Seed| seeds.push((name.to_owned(), seed));
    let begin = |tau, home, key| Seed::new(dim, tau, home, key);
    let square = |mut seed: Seed, spacing: f64, side: i8| {
        for i in 0..side * side {
            let (column, row) = (i % side, i / side);
            seed = seed.lattice(spacing, [column, row, (column + row) % 3]);
        }
        seed
    };

    for (name, spacing) in
        [("whole", 1.0), ("halves", 0.5), ("eighths", 0.125), ("thirds", 1.0 / 3.0)]
    {
        keep(&format!("lattice-{name}"), square(begin(1.0, 0.0, 1), spacing, 6));
    }
    keep("lattice-tenths-odd-radius", square(begin(0.1, 0.5, 2), 0.1, 7));
    keep("lattice-diagonal", square(begin(0.02, -7.3, 3), SPACINGS[7], 6));

    for (name, tau, home) in [
        ("near", 1.0, 1e3),
        ("billion", 0.02, 1e9),
        ("trillion", 3.7, -1e12),
        ("far", 0.1, 1e15),
        ("tiny-radius", 1e-100, 0.5),
        ("huge-radius", 1e100, 0.5),
    ] {
        let seed = square(begin(tau, home, 4), 0.5, 4).op(Op::Cluster, &[3, 2, 20, 9]);
        keep(&format!("away-{name}"), seed.polar(Op::Peek, 5, 1.0, 0.0, 17));
    }

    keep("duplicates", {
        let seed = square(begin(1.0, 0.0, 5), 0.5, 3);
        (0..9)
            .fold(seed, |seed, of| seed.op(Op::Again, &[2 * of]).polar(Op::Peek, of, 0.5, 0.0, of))
    });
    keep("near-duplicates", {
        let seed = begin(1.0, 0.5, 6).lattice(1.0, [0, 0, 0]).lattice(1.0, [2, 0, 0]);
        (0..24).fold(seed, |seed, i| seed.op(Op::Jitter, &[i % 5, (5 * i + 1) % 60, 7 * i]))
    });
    for (name, radius) in [("touching", 2.0), ("common-point", 1.0), ("nearly-touching", 1.999)] {
        let seed = begin(1.0, 0.5, 7).lattice(1.0, [0, 0, 0]);
        let seed = (0..24).fold(seed, |seed, i| seed.polar(Op::Polar, i, radius, 0.0, 10 * i));
        keep(name, seed.polar(Op::Peek, 3, 1.0, 0.0, 5));
    }
    keep("jittered-touching", {
        let seed = begin(0.02, 0.5, 8).lattice(1.0, [0, 0, 0]);
        (0..27_u8).fold(seed, |seed, i| {
            seed.polar(Op::Polar, i % 3, 2.0, JITTERS[usize::from(i) % 9], 40 * (i % 6))
        })
    });
    keep("jittered-common-point", {
        let seed = begin(0.1, 0.0, 9).lattice(1.0, [0, 0, 0]);
        (0..27_u8).fold(seed, |seed, i| {
            seed.polar(Op::Polar, i, 1.0, JITTERS[usize::from(i) % 9], 20 * (i % 12))
        })
    });

    for exponent in [1, 4, 8, 12, 15] {
        let seed = begin(1.0, 0.0, exponent).op(Op::Cluster, &[0, exponent, 49, 1]);
        let seed = seed.polar(Op::Polar, 0, 2.0, 0.0, 40).op(Op::Cluster, &[0, exponent, 29, 2]);
        keep(&format!("clusters-{exponent}"), seed.polar(Op::Peek, 0, 1.0, 0.0, 50));
    }
    for (name, halvings) in [("coarse", 1), ("fine", 7), ("finest", 20)] {
        let seed = begin(1.0, 8.0, 10).line(0, 0, halvings, 120).line(60, 37, halvings, 150);
        keep(&format!("lines-{name}"), seed.op(Op::Cluster, &[40, 1, 40, 3]));
    }
    for (name, radius) in [("half", 0.5), ("one", 1.0), ("small", 0.01), ("smallest", 1e-8)] {
        let seed = begin(1.0, 0.0, 11).lattice(1.0, [0, 0, 0]).circle(0, radius, 0, 180, 0);
        let seed = seed.circle(180, radius, 5, 120, 33).op(Op::Cluster, &[90, 2, 50, 4]);
        keep(&format!("circles-{name}"), seed.line(3, 60, 5, 100).polar(Op::Peek, 0, 1.0, 0.0, 3));
    }
    keep("crowd-scatters", {
        let seed = begin(1.0, 0.5, 12).circle(0, 0.01, 0, 120, 0).circle(0, 0.5, 0, 120, 7);
        let seed = (0..12).fold(seed, |seed, i| seed.polar(Op::Polar, i, 0.5, 0.0, 20 * i));
        seed.circle(0, 1.0, 0, 100, 0)
    });
    keep("extremes", {
        let seed = begin(1.0, 0.0, 13);
        (0..27_u8).fold(seed, |seed, i| {
            seed.op(Op::Extreme, &[i % 8, i / 3 % 8, i / 5 % 8][..dim]).op(Op::Jitter, &[0, 3, i])
        })
    });
    keep("anywhere", {
        let seed = begin(TAUS[9], 0.0, 14);
        (0..30_u8).fold(seed, |seed, i| {
            let place = [53, 101, 197, 89, 31, 211].map(|factor: u8| i.wrapping_mul(factor));
            seed.op(Op::Anywhere, &place[..2 * dim])
        })
    });
    keep("homes", {
        let seed = square(begin(1.0, 0.0, 15), 0.5, 3);
        (0..10).fold(seed, |seed, home| {
            seed.op(Op::Home, &[home]).lattice(0.25, [1, 2, 3]).op(Op::Cluster, &[0, 3, 9, home])
        })
    });
    keep("nothing", begin(1.0, 0.0, 0));
    seeds.into_iter().map(|(name, seed)| (name, seed.bytes)).collect()
}

fn main() -> io::Result<()> {
    for (folder, dim) in [("plane", 2), ("space", 3)] {
        let folder = Path::new(env!("CARGO_MANIFEST_DIR")).join("seeds").join(folder);
        fs::create_dir_all(&folder)?;
        for (name, bytes) in seeds(dim) {
            fs::write(folder.join(name), bytes)?;
        }
    }
    Ok(())
}
