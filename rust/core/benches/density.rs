//! What an insertion costs where effects are even and where they pile up, beside the other
//! family: Voronoi cells on an incremental Delaunay triangulation (spade's).
//!
//! After criterion's groups a table of processor time, the best of three whole runs each, and
//! what that is of the even case's. `cargo bench --bench density -- table` prints it alone.

use std::f64::consts::TAU;
use std::hint::black_box;

use cpu_time::ProcessTime;
use criterion::{BenchmarkId, Criterion, Throughput};
use divbandit_core::Coverage;

#[path = "../tests/oracles/delaunay/mod.rs"]
mod delaunay;
#[path = "../tests/oracles/mod.rs"]
mod oracles;
mod settings;

use delaunay::Cells;
use oracles::Stream;

const N: usize = 100_000;

/// Effects and the radius of their discs.
struct Case {
    name: &'static str,
    n: usize,
    tau: f64,
    effects: fn(&mut Stream, usize, f64) -> Vec<[f64; 2]>,
}

const CASES: [Case; 8] = [
    Case { name: "a: even, tau 0.002", n: N, tau: 0.002, effects: even },
    Case { name: "a: a million", n: 10 * N, tau: 0.002, effects: even },
    Case { name: "b: even, tau 0.2", n: N, tau: 0.2, effects: even },
    Case { name: "c: cluster, sigma tau/10", n: N, tau: 0.02, effects: cluster },
    Case { name: "d: ten, sigma 1e-6 tau", n: N, tau: 0.02, effects: ten_clusters },
    Case { name: "e: circle, any order", n: N, tau: 0.02, effects: circle },
    Case { name: "e': circle, in order", n: N, tau: 0.02, effects: circle_in_order },
    Case { name: "f: figure 2, jittered", n: N, tau: 0.02, effects: archived },
];

impl Case {
    fn effects(&self) -> Vec<[f64; 2]> {
        (self.effects)(&mut Stream(1), self.n, self.tau)
    }
}

fn in_disc(stream: &mut Stream) -> [f64; 2] {
    let (radius, (sine, cosine)) = (stream.unit().sqrt(), stream.between(0.0, TAU).sin_cos());
    [radius * cosine, radius * sine]
}

fn near([x, y]: [f64; 2], sigma: f64, stream: &mut Stream) -> [f64; 2] {
    let [dx, dy] = stream.normals();
    [x + sigma * dx, y + sigma * dy]
}

/// Uniform in the unit disc.
fn even(stream: &mut Stream, n: usize, _: f64) -> Vec<[f64; 2]> {
    (0..n).map(|_| in_disc(stream)).collect()
}

/// Normal around one place.
fn cluster(stream: &mut Stream, n: usize, tau: f64) -> Vec<[f64; 2]> {
    (0..n).map(|_| near([0.3, 0.4], 0.1 * tau, stream)).collect()
}

/// Normal around ten places in turn.
fn ten_clusters(stream: &mut Stream, n: usize, tau: f64) -> Vec<[f64; 2]> {
    let places = [(); 10].map(|()| in_disc(stream));
    (0..n).map(|i| near(places[i % 10], 1e-6 * tau, stream)).collect()
}

/// Evenly on a circle whose radius is a thousandth of tau: each widens the hull of all.
fn circle_in_order(_: &mut Stream, n: usize, tau: f64) -> Vec<[f64; 2]> {
    let at = |i: usize| {
        let (sine, cosine) = (i as f64 / n as f64 * TAU).sin_cos();
        [0.3 + 1e-3 * tau * cosine, 0.4 + 1e-3 * tau * sine]
    };
    (0..n).map(at).collect()
}

fn circle(stream: &mut Stream, n: usize, tau: f64) -> Vec<[f64; 2]> {
    let mut effects = circle_in_order(stream, n, tau);
    stream.shuffle(&mut effects);
    effects
}

/// The 5000 effects of figure 2 for d = 0.001, again and again: the numbers of `figure2_d0.001`
/// in tests/reference/figures_1_2_effects.npz, little-endian, x and y in turn.
fn archived(stream: &mut Stream, n: usize, _: f64) -> Vec<[f64; 2]> {
    let numbers = include_bytes!("figure2_d0.001.bin").as_chunks::<8>().0;
    let numbers: Vec<f64> = numbers.iter().map(|&bytes| f64::from_le_bytes(bytes)).collect();
    let effects = numbers.as_chunks::<2>().0;
    effects.iter().cycle().take(n).map(|&effect| near(effect, 1e-9, stream)).collect()
}

/// Both families: the total, so that their results can be compared.
type Family = fn(&[[f64; 2]], f64) -> f64;

const FAMILIES: [(&str, Family); 2] = [("ours", ours), ("Delaunay", delaunay)];

fn ours(effects: &[[f64; 2]], tau: f64) -> f64 {
    let mut coverage = Coverage::new(tau, 2).unwrap();
    for &effect in effects {
        black_box(coverage.add(effect).unwrap());
    }
    coverage.measure()
}

fn delaunay(effects: &[[f64; 2]], tau: f64) -> f64 {
    let mut cells: Cells = Cells::new(tau);
    for &effect in effects {
        black_box(cells.add(effect));
    }
    cells.measure()
}

/// The least processor time of `times` runs, in ns an insertion.
fn least(family: Family, effects: &[[f64; 2]], tau: f64, times: usize) -> f64 {
    let time = |_| {
        let start = ProcessTime::now();
        black_box(family(black_box(effects), tau));
        start.elapsed().as_nanos() as f64 / effects.len() as f64
    };
    (0..times).map(time).fold(f64::INFINITY, f64::min)
}

/// Criterion takes eleven runs at least: what costs more than this, in ns an insertion, is left to
/// the table, and so is the million.
const DEAR: f64 = 60_000.0;

fn groups(criterion: &mut Criterion) {
    for case in CASES.iter().filter(|case| case.n == N) {
        let mut group = criterion.benchmark_group(format!("density/{}", case.name));
        group.throughput(Throughput::Elements(case.n as u64));
        let effects = case.effects();
        for (name, family) in FAMILIES {
            let few = &effects[..case.n / 20];
            if least(family, few, case.tau, 1) > DEAR {
                println!("{}: {name} takes more than {DEAR} ns an insertion, skipped", case.name);
                continue;
            }
            group.bench_function(BenchmarkId::from_parameter(name), |bencher| {
                bencher.iter(|| family(black_box(&effects), case.tau));
            });
        }
    }
}

fn table() {
    println!(
        "\n{:25} {:>11} {:>8} {:>11} {:>8}",
        "ns an insertion", "ours", "of a's", "Delaunay", "of a's"
    );
    let mut even = [f64::NAN; FAMILIES.len()];
    for (i, case) in CASES.iter().enumerate() {
        let effects = case.effects();
        print!("{:25}", case.name);
        let mut totals = [0.0; FAMILIES.len()];
        for (j, (_, family)) in FAMILIES.iter().enumerate() {
            let time = least(*family, &effects, case.tau, 3);
            if i == 0 {
                even[j] = time;
            }
            totals[j] = family(&effects, case.tau);
            print!(" {time:11.0} {:8.2}", time / even[j]);
        }
        println!("  totals differ by {:.1e}", (totals[1] / totals[0] - 1.0).abs());
    }
}

fn main() {
    if !std::env::args().any(|argument| argument == "table") {
        let mut criterion = settings::quick().configure_from_args();
        groups(&mut criterion);
        criterion.final_summary();
    }
    table();
}
