//! Covered: whether any effect is within tau of a point, mostly without a search.
//!
//! Late in an exploration most points drawn are covered. So the box is cut into cells, a fraction
//! of tau wide, and those that lie wholly within tau of a single effect are marked, effect by
//! effect: a point in one of them is covered. Only the others are searched for.
//!
//! The answer is exactly that of the search. Rounding is monotone: if the computed distance from an
//! effect to the farthest corner of a cell is at most tau, so is that to any point in it. Cells are
//! enlarged a little, for the rounding of their borders.

use crate::bounds::Bounds;
use crate::error::{Error, check_positive};
use crate::kdtree::NearestNeighbors;

/// Upper limit on the number of cells, a bit each.
const MOST_CELLS: usize = 1 << 22;

/// How many cells to a tau: the first of these of which there are not too many.
const FINENESS: [f64; 2] = [4.0, 2.0];

/// Below, squares lose digits.
const LEAST_TAU: f64 = 1e-140;

/// The points of a box that are within tau of an effect.
#[derive(Debug, Clone)]
pub(super) struct Covered {
    tau: f64,
    /// The largest square of which the root is at most tau.
    squared: f64,
    /// The box that is cut into cells.
    frame: Option<Bounds>,
    raster: Option<Raster>,
    /// How many effects are marked in the raster.
    marked: usize,
}

impl Covered {
    /// Within `tau`, which must be positive and finite.
    pub fn new(tau: f64) -> Result<Self, Error> {
        check_positive("tau", tau)?;
        let mut squared = (tau * tau).min(f64::MAX);
        while squared.sqrt() > tau {
            squared = squared.next_down();
        }
        while squared.next_up().sqrt() <= tau {
            squared = squared.next_up();
        }
        Ok(Self { tau, squared, frame: None, raster: None, marked: 0 })
    }

    /// Marks what effects newly cover of a box, which may grow.
    pub fn update(&mut self, goals: &Bounds, effects: &NearestNeighbors) {
        let holds = |frame: &Bounds| frame.holds(goals.low()) && frame.holds(goals.high());
        if !self.frame.as_ref().is_some_and(holds) {
            // One that has grown will grow further: with room for that, it is seldom cut again.
            let frame = if self.frame.is_none() { goals.clone() } else { doubled(goals) };
            self.raster = Raster::new(&frame, self.tau);
            self.frame = Some(frame);
            self.marked = 0;
        }
        if let Some(raster) = &mut self.raster {
            let dim = effects.dim();
            for effect in effects.points()[self.marked * dim..].chunks_exact(dim) {
                raster.mark(effect, self.tau, self.squared);
            }
            self.marked = effects.len();
        }
    }

    /// Whether a point of the box is within tau of an effect.
    pub fn covers(&self, goal: &[f64], effects: &NearestNeighbors) -> Result<bool, Error> {
        Ok(self.is_marked(goal) || effects.nearest_or_within(goal, self.squared)?.0 <= self.squared)
    }

    /// The squared distance and the index of the effect nearest to a point of the box; or, where
    /// the point is covered, perhaps of another that covers it, or None.
    pub fn nearest_unless_covered(
        &self,
        goal: &[f64],
        effects: &NearestNeighbors,
    ) -> Result<Option<(f64, usize)>, Error> {
        if self.is_marked(goal) {
            return Ok(None);
        }
        let found = effects.nearest_or_within(goal, self.squared)?;
        Ok((found.0 > self.squared).then_some(found))
    }

    #[inline]
    fn is_marked(&self, goal: &[f64]) -> bool {
        self.raster.as_ref().is_some_and(|raster| raster.is_marked(goal))
    }
}

/// A box twice as wide around the same centre; the same box where that is too wide for a number.
fn doubled(goals: &Bounds) -> Bounds {
    let pairs = goals.low().iter().zip(goals.high());
    let halves = pairs.map(|(low, high)| (low, high, 0.5 * (high - low)));
    let (low, high) = halves.map(|(low, high, half)| (low - half, high + half)).unzip();
    Bounds::new(low, high).unwrap_or_else(|_| goals.clone())
}

/// A box of up to three dimensions cut into cells, each marked or not.
///
/// A box of fewer is a single cell thick along the others, which come first.
#[derive(Debug, Clone)]
struct Raster {
    axes: [Axis; 3],
    dim: usize,
    marks: Vec<u64>,
}

/// One dimension of a raster.
#[derive(Debug, Clone, Copy)]
struct Axis {
    low: f64,
    width: f64,
    cells: usize,
    /// Cells a unit of length; 0 if there is only one.
    density: f64,
    /// By how much the cells are enlarged.
    margin: f64,
}

impl Axis {
    /// A dimension that the box does not have.
    const NONE: Self = Self { low: 0.0, width: 0.0, cells: 1, density: 0.0, margin: 0.0 };

    /// From `low` to `high`, in cells no wider than `side`; None if they are too many.
    fn new(low: f64, high: f64, side: f64) -> Option<Self> {
        let width = high - low;
        let cells = (width / side).ceil().max(1.0);
        if cells > MOST_CELLS as f64 {
            return None;
        }
        let density = if cells > 1.0 { cells / width } else { 0.0 };
        // Borders are right to a few units in the last place, which is 2.2e-16.
        let margin = 1e-14 * (low.abs() + high.abs() + width);
        Some(Self { low, width, cells: cells as usize, density, margin })
    }

    /// The cell that holds `x`, or the one nearest to it.
    #[inline(always)]
    fn place(&self, x: f64) -> usize {
        (((x - self.low) * self.density) as usize).min(self.cells - 1)
    }

    /// The square of the distance from `x` to the farther end of a cell.
    fn farthest(&self, cell: usize, x: f64) -> f64 {
        let border = |cell: usize| self.low + self.width * (cell as f64 / self.cells as f64);
        let (below, above) = (border(cell) - self.margin, border(cell + 1) + self.margin);
        let along = (below - x).abs().max((above - x).abs());
        along * along
    }
}

impl Raster {
    /// Nothing marked; None if there would be too many cells or dimensions.
    fn new(goals: &Bounds, tau: f64) -> Option<Self> {
        if goals.dim() > 3 || tau < LEAST_TAU {
            return None;
        }
        FINENESS.iter().find_map(|fineness| {
            let mut axes = [Axis::NONE; 3];
            let corners = goals.low().iter().zip(goals.high());
            for (axis, (&low, &high)) in axes[3 - goals.dim()..].iter_mut().zip(corners) {
                *axis = Axis::new(low, high, tau / fineness)?;
            }
            let cells = axes.iter().map(|axis| axis.cells).fold(1, usize::saturating_mul);
            (cells <= MOST_CELLS).then(|| {
                let marks = vec![0; cells.div_ceil(64)];
                Self { axes, dim: goals.dim(), marks }
            })
        })
    }

    /// Marks the cells that are wholly within the ball around an effect.
    fn mark(&mut self, effect: &[f64], tau: f64, squared: f64) {
        let [a, b, c] = self.axes;
        let mut at = [0.0; 3];
        at[3 - self.dim..].copy_from_slice(effect);
        let reach = |axis: &Axis, x: f64| axis.place(x - tau)..=axis.place(x + tau);
        for i in reach(&a, at[0]) {
            let plane = a.farthest(i, at[0]);
            for j in reach(&b, at[1]) {
                // The order of the sum is that of the search.
                let line = plane + b.farthest(j, at[1]);
                if line > squared {
                    continue;
                }
                for k in reach(&c, at[2]) {
                    if line + c.farthest(k, at[2]) <= squared {
                        let cell = (i * b.cells + j) * c.cells + k;
                        self.marks[cell / 64] |= 1 << (cell % 64);
                    }
                }
            }
        }
    }

    /// Whether the cell that holds a point of the box is marked.
    #[inline]
    fn is_marked(&self, goal: &[f64]) -> bool {
        let cell = self.axes[3 - self.dim..]
            .iter()
            .zip(goal)
            .fold(0, |cell, (axis, &x)| cell * axis.cells + axis.place(x));
        self.marks[cell / 64] >> (cell % 64) & 1 == 1
    }
}
