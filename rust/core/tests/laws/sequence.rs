//! Any bytes as a sequence of effects, most of them hostile: lattices, duplicates and near ones,
//! discs that touch, circles through common points, clusters, long runs, places far away.
//!
//! The first three bytes choose tau, a home and a key; then each byte chooses what comes next and
//! takes its parameters from those behind it. Bytes that are not there count as 0.

use std::f64::consts::TAU;

use divbandit_core::trig::sin_cos;

/// Effects to be added, points to be asked about in between, and their radius.
#[derive(Debug, Clone)]
pub struct Sequence<const D: usize> {
    pub tau: f64,
    /// Decides all else that is chosen: orders, probes.
    pub key: u64,
    pub steps: Vec<Step<D>>,
}

#[derive(Debug, Clone, Copy)]
pub enum Step<const D: usize> {
    Add([f64; D]),
    Peek([f64; D]),
}

/// What a byte may ask for. `Of` is an earlier effect, counted from the latest, or home.
#[derive(Debug, Clone, Copy, PartialEq)]
#[repr(u8)]
pub enum Op {
    /// Place on a lattice around home: the spacing, then a signed byte for each coordinate.
    Lattice,
    /// Place anywhere within 4 radii of home: two bytes for each coordinate.
    Anywhere,
    /// Of: the same again.
    Again,
    /// Of, exponent, signs: moved by 2^-1 to 2^-60 radii along some of the axes.
    Jitter,
    /// Of, radius, jitter, direction: at a distance such as 1 (so that the circle passes through
    /// the other centre) or 2 (so that both touch), exactly or nearly.
    Polar,
    /// Of, exponent, number, seed: a cluster 1 to 1e-16 radii wide.
    Cluster,
    /// Of, direction, exponent, number: a row with a step of 1 to 2^-31 radii.
    Line,
    /// Of, radius, exponent, number, direction: centres on part of a circle.
    Circle,
    /// As `Polar`, but only asked about.
    Peek,
    /// One byte for each coordinate: 0, tiny, huge.
    Extreme,
    /// Home moves far away, or back.
    Home,
}

const OPS: [Op; 11] = [
    Op::Lattice,
    Op::Anywhere,
    Op::Again,
    Op::Jitter,
    Op::Polar,
    Op::Cluster,
    Op::Line,
    Op::Circle,
    Op::Peek,
    Op::Extreme,
    Op::Home,
];

pub const TAUS: [f64; 10] =
    [1.0, 0.02, 0.1, 3.7, 1.0 / 1024.0, 1e-9, 1e9, 1e-100, 1e100, 0.300_000_000_000_000_04];
/// In radii.
pub const HOMES: [f64; 10] =
    [0.0, 0.5, -7.3, 8.0, 1e3, -123_456.789, 1e9, -1e12, 8_796_093_022_208.0, 1e15];
pub const SPACINGS: [f64; 8] =
    [1.0, 0.5, 0.25, 0.125, 0.0625, 1.0 / 3.0, 0.1, 0.707_106_781_186_547_5];
pub const RADII: [f64; 8] =
    [2.0, 1.0, 0.5, 0.01, std::f64::consts::SQRT_2, 1.732_050_807_568_877_2, 1.999, 1e-8];
pub const JITTERS: [f64; 9] = [0.0, 1e-16, -2e-16, 1e-14, -1e-12, 1e-10, -1e-8, 1e-6, -1e-4];
const EXTREMES: [f64; 8] = [0.0, 1e-300, -1e-30, 1.0, 1e15, -1e16, 1e150, -1e300];

/// The most effects that bytes are worth: more would make a run too slow to have many.
pub const MOST: [usize; 4] = [0, 0, 400, 80];

struct Reader<'a, const D: usize> {
    bytes: std::slice::Iter<'a, u8>,
    tau: f64,
    home: [f64; D],
    effects: Vec<[f64; D]>,
    steps: Vec<Step<D>>,
}

/// The sequence that bytes stand for.
pub fn decode<const D: usize>(bytes: &[u8]) -> Sequence<D> {
    let mut reader = Reader {
        bytes: bytes.iter(),
        tau: 1.0,
        home: [0.0; D],
        effects: Vec::new(),
        steps: Vec::new(),
    };
    reader.tau = reader.one_of(&TAUS);
    reader.go_home();
    let key = u64::from(reader.byte());
    while let Some(&op) = reader.bytes.next() {
        if reader.effects.len() >= MOST[D] || reader.steps.len() >= 2 * MOST[D] {
            break;
        }
        reader.step(OPS[usize::from(op) % OPS.len()]);
    }
    Sequence { tau: reader.tau, key, steps: reader.steps }
}

impl<const D: usize> Reader<'_, D> {
    fn byte(&mut self) -> u8 {
        self.bytes.next().copied().unwrap_or(0)
    }

    fn one_of(&mut self, values: &[f64]) -> f64 {
        values[usize::from(self.byte()) % values.len()]
    }

    /// A whole number from 0 to `most`.
    fn count(&mut self, most: u8) -> usize {
        usize::from(self.byte()) % (usize::from(most) + 1)
    }

    /// Home lies on the diagonal, but for a little.
    fn go_home(&mut self) {
        let away = self.one_of(&HOMES) * self.tau;
        self.home = std::array::from_fn(|i| if i == 1 { -0.75 * away } else { away });
    }

    fn base(&mut self) -> [f64; D] {
        let back = usize::from(self.byte());
        match self.effects.len() {
            0 => self.home,
            n => self.effects[n - 1 - back % n],
        }
    }

    /// A unit vector: a byte for the angle, and in space another one for the height.
    fn direction(&mut self) -> [f64; D] {
        let angle = f64::from(self.byte()) * (TAU / 240.0);
        let tilt = if D > 2 { f64::from(self.byte()) * (TAU / 240.0) } else { 0.0 };
        unit(angle, tilt)
    }

    /// `offset` radii from `base`.
    fn place(&self, base: [f64; D], offset: [f64; D]) -> [f64; D] {
        std::array::from_fn(|i| base[i] + self.tau * offset[i])
    }

    fn add(&mut self, effect: [f64; D]) {
        if self.effects.len() < MOST[D] {
            self.effects.push(effect);
            self.steps.push(Step::Add(effect));
        }
    }

    fn polar(&mut self) -> [f64; D] {
        let base = self.base();
        let distance = self.one_of(&RADII) + self.one_of(&JITTERS);
        let direction = self.direction();
        self.place(base, direction.map(|x| distance * x))
    }

    fn step(&mut self, op: Op) {
        match op {
            Op::Lattice => {
                let spacing = self.one_of(&SPACINGS);
                let offset = [0.0; D].map(|_| spacing * f64::from(self.byte().cast_signed()));
                self.add(self.place(self.home, offset));
            }
            Op::Anywhere => {
                let offset = [0.0; D].map(|_| {
                    let pair = [self.byte(), self.byte()];
                    f64::from(i16::from_be_bytes(pair)) / 8192.0
                });
                self.add(self.place(self.home, offset));
            }
            Op::Again => {
                let base = self.base();
                self.add(base);
            }
            Op::Jitter => {
                let base = self.base();
                let size = power_of_two(1 + self.count(59));
                let mut signs = self.byte();
                let offset = [0.0; D].map(|_| {
                    let sign = f64::from(signs % 3) - 1.0;
                    signs /= 3;
                    size * sign
                });
                self.add(self.place(base, offset));
            }
            Op::Polar => {
                let effect = self.polar();
                self.add(effect);
            }
            Op::Cluster => {
                let base = self.base();
                let width = (0..self.count(16)).fold(1.0, |width, _| width / 10.0);
                let number = 1 + self.count(59);
                let mut state = u64::from(self.byte()) + 1;
                for _ in 0..number {
                    let offset = [0.0; D].map(|_| width * noise(&mut state));
                    self.add(self.place(base, offset));
                }
            }
            Op::Line => {
                let (base, along) = (self.base(), self.direction());
                let step = power_of_two(self.count(31));
                for i in 0..=self.count(159) {
                    self.add(self.place(base, along.map(|x| step * i as f64 * x)));
                }
            }
            Op::Circle => {
                let (base, radius) = (self.base(), self.one_of(&RADII));
                let angle = power_of_two(self.count(15)) * TAU;
                let number = 1 + self.count(199);
                let middle: [f64; D] = unit(f64::from(self.byte()) * (TAU / 240.0), 0.0);
                for i in 0..number {
                    let ([sine], [cosine]) = sin_cos([angle * i as f64 / number as f64]);
                    let offset = std::array::from_fn(|axis| match axis {
                        0 => radius * (cosine * middle[0] - sine * middle[1]),
                        1 => radius * (cosine * middle[1] + sine * middle[0]),
                        // In space a curve that leaves the plane.
                        _ => radius * 0.5 * sine,
                    });
                    self.add(self.place(base, offset));
                }
            }
            Op::Peek => {
                let point = self.polar();
                self.steps.push(Step::Peek(point));
            }
            Op::Extreme => {
                let effect = [0.0; D].map(|_| self.one_of(&EXTREMES));
                self.add(effect);
            }
            Op::Home => self.go_home(),
        }
    }
}

fn unit<const D: usize>(angle: f64, tilt: f64) -> [f64; D] {
    let ([sine, rise], [cosine, run]) = sin_cos([angle, tilt]);
    std::array::from_fn(|axis| [run * cosine, run * sine, rise][axis])
}

fn power_of_two(down: usize) -> f64 {
    0.5_f64.powi(down as i32)
}

/// Even in [-1, 1].
fn noise(state: &mut u64) -> f64 {
    *state = state.wrapping_mul(6_364_136_223_846_793_005).wrapping_add(1_442_695_040_888_963_407);
    (*state >> 11) as f64 / (1_u64 << 52) as f64 - 1.0
}
