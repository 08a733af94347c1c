//! How much of each ray from a ball's centre the balls around it leave uncovered.
//!
//! A ball of radius 1 around c meets the ray along a direction w in [p - s, p + s] with
//! p = c . w and s^2 = p^2 + 1 - |c|^2. What is left of [0, 1] weighs d t^(d-1) dt: differences
//! of t^d. Each product p serves two rays, along w and -w.
//!
//! Balls come nearest first. One that holds the centre covers a ray from 0 on, so the covered
//! front rises; one that is sqrt(2) or more away covers to the end if at all; only one between
//! can cover an inner piece, which is kept in a list unless it touches the front. Where front
//! and back meet on all rays of a block, farther balls need not be looked at.

use super::directions::LANES;
use super::nearby::Nearby;

type Lanes = [f64; LANES];

/// What a block of rays says, summed over them.
#[derive(Debug, Clone, Copy, Default)]
pub(super) struct Shares {
    /// What no ball covers.
    pub free: f64,
    /// What each ball covers, added up: its mean is known.
    pub covered: f64,
}

/// An inner piece of a ray: of which (along w 0 to LANES, along -w from LANES on), and where.
type Piece = (usize, f64, f64);

/// The sum over the blocks' rays of both shares; without `control` of the first alone, which
/// allows to leave covered rays early.
#[inline(always)]
pub(super) fn shares(
    near: &Nearby,
    blocks: &[f64],
    control: bool,
    pieces: &mut Vec<Piece>,
) -> Shares {
    let mut sum = Shares::default();
    for block in blocks.chunks_exact(near.dim() * LANES) {
        let shares = of_block(near, block, control, pieces);
        sum.free += shares.free;
        sum.covered += shares.covered;
    }
    sum
}

#[inline(always)]
fn of_block(near: &Nearby, block: &[f64], control: bool, pieces: &mut Vec<Piece>) -> Shares {
    let dim = near.dim();
    // The front up to which and the back from which each ray is covered, along w and -w.
    let (mut front, mut back): ([Lanes; 2], [Lanes; 2]) = ([[0.0; LANES]; 2], [[1.0; LANES]; 2]);
    let mut covered: Lanes = [0.0; LANES];
    pieces.clear();
    for (j, (centre, square)) in near.iter().enumerate() {
        let product = dot(centre, block);
        let (mut low, mut high): (Lanes, Lanes) = ([0.0; LANES], [0.0; LANES]);
        if square < 1.0 {
            for l in 0..LANES {
                let half = (product[l] * product[l] + (1.0 - square)).sqrt();
                (high[l], low[l]) = ((half + product[l]).min(1.0), (half - product[l]).min(1.0));
                front[0][l] = front[0][l].max(high[l]);
                front[1][l] = front[1][l].max(low[l]);
            }
        } else {
            // Where the ball is missed, low is 1. Only one of w and -w can meet it.
            for l in 0..LANES {
                let under = product[l] * product[l] + (1.0 - square);
                let (far, half) = (product[l].abs(), under.max(0.0).sqrt());
                low[l] = if under > 0.0 { (far - half).clamp(0.0, 1.0) } else { 1.0 };
                high[l] = if under > 0.0 { (far + half).min(1.0) } else { 1.0 };
                let inner = high[l] < 1.0;
                let (plus, minus) = (product[l] > 0.0 && !inner, product[l] <= 0.0 && !inner);
                back[0][l] = back[0][l].min(if plus { low[l] } else { 1.0 });
                back[1][l] = back[1][l].min(if minus { low[l] } else { 1.0 });
            }
            if square < 2.0 {
                for l in 0..LANES {
                    if high[l] < 1.0 {
                        let side = usize::from(product[l] <= 0.0);
                        if low[l] <= front[side][l] {
                            front[side][l] = front[side][l].max(high[l]);
                        } else {
                            pieces.push((side * LANES + l, low[l], high[l]));
                        }
                    }
                }
            }
        }
        if control {
            let (high, low) = (power(high, dim), power(low, dim));
            let sign = if square < 1.0 { 1.0 } else { -1.0 };
            for l in 0..LANES {
                covered[l] += high[l] + sign * low[l];
            }
        }
        // Looking costs about half a product: every fourth ball.
        if !control && j % 4 == 3 && (0..2).all(|side| met(&front[side], &back[side])) {
            return Shares::default();
        }
    }
    let mut free = 0.0;
    for side in 0..2 {
        let (from, to) = (power(front[side], dim), power(back[side], dim));
        for l in 0..LANES {
            free += (to[l] - from[l]).max(0.0);
        }
    }
    if !pieces.is_empty() {
        free -= inner(&front, &back, pieces, dim);
    }
    Shares { free, covered: covered.iter().sum() }
}

#[inline(always)]
fn dot(centre: &[f64], block: &[f64]) -> Lanes {
    let mut product = [0.0; LANES];
    for (c, row) in centre.iter().zip(block.chunks_exact(LANES)) {
        for l in 0..LANES {
            product[l] += c * row[l];
        }
    }
    product
}

/// x^n by squaring.
#[inline(always)]
fn power(mut x: Lanes, mut n: usize) -> Lanes {
    let mut result = [1.0; LANES];
    loop {
        if n & 1 == 1 {
            for l in 0..LANES {
                result[l] *= x[l];
            }
        }
        n >>= 1;
        if n == 0 {
            return result;
        }
        for x in &mut x {
            *x *= *x;
        }
    }
}

#[inline(always)]
fn met(front: &Lanes, back: &Lanes) -> bool {
    let mut all = true;
    for l in 0..LANES {
        all &= front[l] >= back[l];
    }
    all
}

/// What inner pieces cover between front and back, all rays together.
#[inline(never)]
fn inner(front: &[Lanes; 2], back: &[Lanes; 2], pieces: &mut [Piece], dim: usize) -> f64 {
    pieces
        .sort_unstable_by(|a, b| a.0.cmp(&b.0).then(a.1.total_cmp(&b.1)).then(a.2.total_cmp(&b.2)));
    let mut covered = 0.0;
    let (mut ray, mut reached) = (usize::MAX, 0.0);
    for &(which, low, high) in &*pieces {
        let (side, lane) = (which / LANES, which % LANES);
        if which != ray {
            (ray, reached) = (which, front[side][lane]);
        }
        let (from, to) = (low.max(reached), high.min(back[side][lane]));
        if from < to {
            covered += power([to; LANES], dim)[0] - power([from; LANES], dim)[0];
            reached = to;
        }
    }
    covered
}
