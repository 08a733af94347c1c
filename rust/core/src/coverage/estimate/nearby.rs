//! The stored balls that overlap a new one: their centres as seen from the new centre, in
//! units of the radius, nearest first.

use super::lens::{apart, lens};
use super::rotation::Rotation;

/// Balls that overlap the unit ball at the origin.
#[derive(Debug, Clone)]
pub(super) struct Nearby {
    dim: usize,
    /// Row after row, as found.
    found: Vec<f64>,
    /// Squared distance of each, and its row in `found`; sorted by distance.
    order: Vec<(f64, usize)>,
    /// Row after row, nearest first.
    centres: Vec<f64>,
    squares: Vec<f64>,
}

impl Nearby {
    pub fn new(dim: usize) -> Self {
        Self { dim, found: vec![], order: vec![], centres: vec![], squares: vec![] }
    }

    pub fn dim(&self) -> usize {
        self.dim
    }

    pub fn len(&self) -> usize {
        self.squares.len()
    }

    pub fn clear(&mut self) {
        self.found.clear();
        self.order.clear();
        self.centres.clear();
        self.squares.clear();
    }

    /// Notes a centre if its ball overlaps; coordinates may be infinite.
    #[inline]
    pub fn consider(&mut self, from: &[f64], centre: &[f64], tau: f64) {
        let mut square = 0.0;
        for (c, x) in centre.chunks(4).zip(from.chunks(4)) {
            for (c, x) in c.iter().zip(x) {
                let away = (c - x) / tau;
                square += away * away;
            }
            if square >= 4.0 {
                return;
            }
        }
        self.order.push((square, self.order.len()));
        self.found.extend(centre.iter().zip(from).map(|(c, x)| (c - x) / tau));
    }

    /// Sorts what was found. Balls whose part of the unit ball no other ball meets are taken
    /// out: returns the share that they cover together. In high dimensions that is most.
    pub fn settle(&mut self) -> f64 {
        // Found in a fixed order, so that ties are in a fixed order too.
        self.order.sort_by(|a, b| a.0.total_cmp(&b.0));
        let row = |i: usize| &self.found[i * self.dim..(i + 1) * self.dim];
        let mut alone = 0.0;
        for (rank, &(square, i)) in self.order.iter().enumerate() {
            let mut others = self.order.iter().enumerate().filter(|(other, _)| *other != rank);
            // In a crowd the nearest balls meet everything: `all` ends at once.
            if others.all(|(_, &(other, j))| apart(row(i), row(j), square, other)) {
                alone += lens(square, self.dim);
            } else {
                self.centres.extend_from_slice(row(i));
                self.squares.push(square);
            }
        }
        alone
    }

    /// Turns the space around the origin.
    pub fn turn(&mut self, rotation: &Rotation) {
        self.centres.chunks_exact_mut(self.dim).for_each(|centre| rotation.turn(centre));
    }

    /// Centres and their squared distances, nearest first.
    #[inline(always)]
    pub fn iter(&self) -> impl Iterator<Item = (&[f64], f64)> {
        self.centres.chunks_exact(self.dim).zip(self.squares.iter().copied())
    }

    /// What the balls cover of the unit ball: all added up, and the nearest alone.
    pub fn lenses(&self) -> (f64, f64) {
        let all = self.squares.iter().fold(0.0, |sum, &square| sum + lens(square, self.dim));
        (all, self.squares.first().map_or(0.0, |&square| lens(square, self.dim)))
    }
}
