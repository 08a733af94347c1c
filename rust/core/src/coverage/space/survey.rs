//! The volume that a new ball adds, from the faces between centres.
//!
//! Each point of a union belongs to its nearest centre. The new centre p takes from that the
//! cell V of points nearest to p, whose part in p's ball is new or was in cells of others. With
//! cells split into cones from their centres, the difference between before and after is
//!
//! ```text
//! gain = (4 pi - 2 sum of share(p, k) + 2 sum of share(k, l within V)) / 3
//! ```
//!
//! over the faces (p, k) of the new cell, and over those parts of the old faces (k, l) that now
//! lie nearer to p. Seen from k, whatever of k's cell p takes lies behind the face (p, k): only
//! bounding neighbours, those with such a face, lose anything, so the old faces and what cuts
//! them are found among these.
//!
//! In units of the radius and relative to p: the result does not depend on where the balls lie.

use std::f64::consts::PI;

use super::super::cubes::Cubes;
use super::cover::is_covered;
use super::face::Face;
use super::neighbours::{Neighbour, Neighbours, TOUCHING};
use super::vector::{Vector, dot, minus};

/// The volume of a ball of radius 1.
pub(crate) const BALL: f64 = 4.0 * PI / 3.0;

/// A gain below this part of a ball is rounding noise, counted as none: a million of them
/// should not add up. What was measured of noise is some 1e-15.
const NOISE: f64 = 1e-13;

/// Nearer than the root of this, a ball adds to its neighbour alone less than `NOISE`.
const SAME: f64 = 1e-26;

/// With more neighbours than this, a few of them are tried first: they prove most balls redundant.
const CROWD: usize = 32;

/// A face seen under a smaller solid angle is none but for rounding.
const NO_FACE: f64 = 1e-16;

/// Finds gains. Kept between calls for its memory alone.
#[derive(Debug, Clone, Default)]
pub(crate) struct Survey {
    neighbours: Neighbours,
    /// Some of them, from all directions.
    few: Neighbours,
    cell: Cell,
}

/// The new centre's cell.
#[derive(Debug, Clone, Default)]
struct Cell {
    /// Those neighbours with which the new cell has a face, nearest first.
    bounding: Vec<Neighbour>,
    face: Face,
}

impl Survey {
    /// The volume that a ball of radius `tau` around `effect` adds to those around `centres`, in units
    /// of tau^3: 0, or more than noise.
    pub fn gain(&mut self, effect: Vector, tau: f64, centres: &Cubes) -> f64 {
        self.neighbours.find(centres, tau, effect);
        // What a few cover, all do.
        if self.neighbours.len() > CROWD {
            self.few.choose(&self.neighbours);
            if self.cell.new_faces(&mut self.few).is_none() {
                return 0.0;
            }
        }
        let Some(new_faces) = self.cell.new_faces(&mut self.neighbours) else { return 0.0 };
        let gain = (4.0 * PI - 2.0 * new_faces + 2.0 * self.cell.old_faces()) / 3.0;
        if gain < NOISE * BALL { 0.0 } else { gain.min(BALL) }
    }
}

impl Cell {
    /// The shares of the new cell's faces; None if the ball is redundant for certain.
    fn new_faces(&mut self, neighbours: &mut Neighbours) -> Option<f64> {
        self.bounding.clear();
        let (mut shares, mut free, mut index) = (0.0, 4.0 * PI, 0);
        while let Some(k) = neighbours.nearest(index) {
            index += 1;
            if k.squared < SAME {
                return None;
            }
            if !self.cut_new_face(k, neighbours, index) {
                continue;
            }
            let amount = self.face.amount();
            if amount.solid_angle < NO_FACE {
                continue;
            }
            self.bounding.push(k);
            shares += amount.share;
            // When only noise is left free of covered cones, so is the gain.
            if is_covered(&self.face, k, &self.bounding[..self.bounding.len() - 1]) {
                free -= amount.solid_angle;
                if free < NOISE * 4.0 * PI {
                    return None;
                }
            }
        }
        Some(shares)
    }

    /// Cuts the face between p and k, where `after` is the rank of the neighbour after k;
    /// tells whether anything is left of it.
    ///
    /// Of those nearer than k only bounding ones matter.
    #[inline]
    fn cut_new_face(
        &mut self,
        k: Neighbour,
        neighbours: &mut Neighbours,
        mut after: usize,
    ) -> bool {
        let Self { bounding, face } = self;
        face.begin([0.0; 3], k.at);
        let farther = std::iter::from_fn(|| {
            after += 1;
            neighbours.nearest(after - 1)
        });
        face.keep_away_from_all(bounding.iter().copied().chain(farther))
    }

    /// The shares of the old faces, as far as they lie in the new cell.
    fn old_faces(&mut self) -> f64 {
        let mut shares = 0.0;
        for i in 0..self.bounding.len() {
            for j in i + 1..self.bounding.len() {
                if self.cut_old_face(i, j) {
                    shares += self.face.amount().share;
                }
            }
        }
        shares
    }

    /// Cuts the old face between two bounding neighbours; tells whether anything is left of it.
    #[inline]
    fn cut_old_face(&mut self, i: usize, j: usize) -> bool {
        let Self { bounding, face } = self;
        let (k, l) = (bounding[i], bounding[j]);
        let difference = minus(l.at, k.at);
        let squared = dot(difference, difference);
        // What lies in the new cell is nearer to p than 1: so must be the face's plane.
        let twice_away = l.squared - k.squared;
        if squared >= TOUCHING || twice_away * twice_away >= 4.0 * squared {
            return false;
        }
        face.begin(k.at, l.at);
        if !face.keep_near_to([0.0; 3]) {
            return false;
        }
        // Here, too, those farther are no nearer, as what is left is nearer to p than to k and l.
        let others = bounding.iter().enumerate().filter(|&(index, _)| index != i && index != j);
        face.keep_away_from_all(others.map(|(_, &other)| other))
    }
}
