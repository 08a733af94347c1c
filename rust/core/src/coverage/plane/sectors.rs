//! A first look at a disc, rough but never wrong to dismiss: can its exposed arcs meet another?
//!
//! The circle is cut into 32 sectors, and a word tells which of them a disc's exposed arcs touch.
//! A second word tells which of them a disc at some offset may reach, from a table. Where the
//! two have no sector in common, the arcs cannot matter - and at depth, where most neighbours
//! expose little and look elsewhere, that spares most of them a closer look.

use std::f64::consts::PI;
use std::sync::LazyLock;

use super::circle::{Direction, Span, floor};

/// Which sectors something touches: a bit each.
pub(crate) type Sectors = u32;

const SECTORS: f64 = 32.0;

/// The sectors that arcs touch.
pub(crate) fn of_arcs(arcs: &[Span]) -> Sectors {
    arcs.iter()
        .fold(0, |all, arc| all | between(arc.from * (SECTORS / 4.0), arc.to * (SECTORS / 4.0)))
}

/// The sectors from one place to another, in sectors, and a little more at both ends.
fn between(from: f64, to: f64) -> Sectors {
    let (low, high) = (floor(from - ROUNDING), floor(to + ROUNDING));
    if high - low >= 31 {
        return Sectors::MAX;
    }
    let run = (1_u32 << (high - low + 1)) - 1;
    run.rotate_left(low.rem_euclid(32) as u32)
}

/// What single precision may take, in sectors.
const ROUNDING: f64 = 1e-3;

/// Squares along the table's edge, for each radius and in all; the outermost hold nothing.
const FINE: f32 = 8.0;
const SIDE: usize = 34;

/// Which sectors of a disc the disc at an offset from it may reach.
#[derive(Debug, Clone, Copy)]
pub(crate) struct Reach(&'static [Sectors; SIDE * SIDE]);

impl Reach {
    pub fn new() -> Self {
        static TABLE: LazyLock<[Sectors; SIDE * SIDE]> = LazyLock::new(|| {
            std::array::from_fn(|index| reached_from((index % SIDE) as f64, (index / SIDE) as f64))
        });
        Self(&TABLE)
    }

    /// The sectors that a disc whose centre lies (`x`, `y`) radii away, both within 2.01, may reach.
    #[inline]
    pub fn from(self, x: f32, y: f32) -> Sectors {
        // Adding 2^23 leaves the whole part in the lowest bits, faster than a checked cast.
        let index = |x: f32| ((x * FINE + (0.5 * SIDE as f32 - 0.5)) + 8_388_608.0).to_bits() & 63;
        self.0.get(index(y) as usize * SIDE + index(x) as usize).copied().unwrap_or(Sectors::MAX)
    }
}

/// The sectors that may be reached from somewhere in a square of the table.
fn reached_from(column: f64, row: f64) -> Sectors {
    let middle = |index: f64| (index + 0.5 - 0.5 * SIDE as f64) / f64::from(FINE);
    let (x, y) = (middle(column), middle(row));
    let (distance, around) = (libm::hypot(x, y), 0.75 / f64::from(FINE));
    let nearest = distance - around;
    if nearest >= 2.0 {
        return 0;
    }
    if nearest <= 0.1 {
        return Sectors::MAX;
    }
    let angle = libm::atan2(y, x);
    let width = libm::acos(0.5 * nearest) + libm::asin(around / distance);
    if width >= PI - 0.1 {
        return Sectors::MAX;
    }
    let sector =
        |angle: f64| Direction::new(libm::cos(angle), libm::sin(angle)).turn * (SECTORS / 4.0);
    let (from, to) = (sector(angle - width), sector(angle + width));
    between(from, if to < from { to + SECTORS } else { to })
}

#[cfg(test)]
mod tests {
    use super::*;
    use std::f64::consts::TAU;

    /// Sectors that hold a point of the unit circle inside the disc at (x, y).
    fn touched(x: f64, y: f64) -> Sectors {
        (0..4096).fold(0, |all, i| {
            let angle = f64::from(i) * TAU / 4096.0;
            let (cosine, sine) = (angle.cos(), angle.sin());
            let inside = (cosine - x).powi(2) + (sine - y).powi(2) < 1.0;
            let sector = (Direction::new(cosine, sine).turn * 8.0) as u32 % 32;
            all | u32::from(inside) << sector
        })
    }

    #[test]
    fn no_sector_is_missed_and_few_are_superfluous() {
        let (mut told, mut all) = (0, 0);
        for i in 0..200 {
            for j in 0..200 {
                let (x, y) = (f64::from(i) * 0.0201 - 2.005, f64::from(j) * 0.0201 - 2.005);
                let (found, must) = (Reach::new().from(x as f32, y as f32), touched(x, y));
                assert_eq!(found & must, must, "{x} {y}");
                told += must.count_ones();
                all += found.count_ones();
            }
        }
        assert!(f64::from(all) < 1.4 * f64::from(told), "{all} for {told}");
    }

    #[test]
    fn arcs_touch_their_sectors() {
        assert_eq!(of_arcs(&[Span { from: 0.0, to: 4.0 }]), Sectors::MAX);
        assert_eq!(of_arcs(&[Span { from: 0.3, to: 0.4 }]), 0b1100);
        assert_eq!(
            of_arcs(&[Span { from: 0.05, to: 0.06 }, Span { from: 3.9, to: 3.95 }]),
            1 << 31 | 1
        );
        assert_eq!(of_arcs(&[Span { from: 0.0, to: 0.06 }]), 1 << 31 | 1);
        assert_eq!(of_arcs(&[]), 0);
    }
}
