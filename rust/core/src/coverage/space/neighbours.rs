//! The stored balls that overlap a new one, nearest first.

use std::cmp::Ordering;

use super::super::cubes::Cubes;
use super::vector::{Vector, dot};

/// Two unit balls whose centres are further apart than the root of this only touch: each loses
/// to the other a cap smaller than 3e-18.
pub(crate) const TOUCHING: f64 = 4.0 - 4e-9;

/// A stored centre seen from a new one, in units of the radius.
#[derive(Debug, Clone, Copy, Default)]
pub(crate) struct Neighbour {
    pub at: Vector,
    /// Its squared distance.
    pub squared: f64,
}

/// Neighbours, sorted by distance only as far as somebody asks: a ball deep inside a crowd
/// is known to be redundant after the nearest few.
#[derive(Debug, Clone, Default)]
pub(crate) struct Neighbours {
    found: Vec<Neighbour>,
    /// So many of them are the nearest, in order.
    sorted: usize,
}

impl Neighbours {
    /// Collects the centres that are near enough to `effect`, with `tau` the balls' radius.
    pub fn find(&mut self, cubes: &Cubes, tau: f64, effect: Vector) {
        self.found.clear();
        self.sorted = 0;
        for centres in cubes.around(&effect) {
            let centres = centres.as_chunks::<3>().0;
            // Five in six are too far, in no predictable order: each is written, and the
            // place kept only if it is near.
            let start = self.found.len();
            self.found.resize(start + centres.len(), Neighbour::default());
            let mut end = start;
            for centre in centres {
                let at: Vector = std::array::from_fn(|i| (centre[i] - effect[i]) / tau);
                let squared = dot(at, at);
                self.found[end] = Neighbour { at, squared };
                end += usize::from(squared < TOUCHING);
            }
            self.found.truncate(end);
        }
    }

    /// How many there are.
    pub fn len(&self) -> usize {
        self.found.len()
    }

    /// Becomes a few of `all`: the nearest in each of 24 directions, as an axis and signs.
    pub fn choose(&mut self, all: &Self) {
        let none = Neighbour { squared: f64::INFINITY, ..Neighbour::default() };
        let mut nearest = [none; 24];
        for neighbour in &all.found {
            let [x, y, z] = neighbour.at;
            let (ax, ay, az) = (x.abs(), y.abs(), z.abs());
            let signs =
                usize::from(x < 0.0) | usize::from(y < 0.0) << 1 | usize::from(z < 0.0) << 2;
            let along_z = az > ax && az > ay;
            let axis = if along_z { 2 } else { usize::from(ay > ax) };
            let best = &mut nearest[axis << 3 | signs];
            if neighbour.squared < best.squared {
                *best = *neighbour;
            }
        }
        self.found.clear();
        self.found.extend(nearest.iter().filter(|neighbour| neighbour.squared < TOUCHING));
        self.sorted = 0;
    }

    /// The `index`-th nearest.
    #[inline]
    pub fn nearest(&mut self, index: usize) -> Option<Neighbour> {
        while self.sorted <= index {
            if self.sorted == self.found.len() {
                return None;
            }
            self.sort_more();
        }
        Some(self.found[index])
    }

    /// Doubles the sorted part.
    fn sort_more(&mut self) {
        let rest = &mut self.found[self.sorted..];
        let more = self.sorted.max(24).min(rest.len());
        if more < rest.len() {
            rest.select_nth_unstable_by(more, Neighbour::order);
        }
        rest[..more].sort_unstable_by(Neighbour::order);
        self.sorted += more;
    }
}

impl Neighbour {
    /// By distance, then by place: no two are equal, so the order does not depend on how it
    /// was sorted, nor on who was stored first.
    fn order(&self, other: &Self) -> Ordering {
        let order = self.squared.total_cmp(&other.squared);
        let places = || self.at.iter().zip(&other.at);
        order.then_with(|| {
            places().fold(Ordering::Equal, |order, (a, b)| order.then(a.total_cmp(b)))
        })
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn nearest_first_and_none_beyond_two_radii() {
        let mut cubes = Cubes::new(3, 1.0);
        for i in 0..400_i32 {
            // Spread over [-3, 3] in an order without order.
            let x = f64::from(i * 37 % 401) * 6.0 / 401.0 - 3.0;
            cubes.insert(&[x, 0.3, -0.1]);
        }
        let mut neighbours = Neighbours::default();
        neighbours.find(&cubes, 1.0, [0.1, 0.3, -0.1]);
        let mut distances = Vec::new();
        while let Some(neighbour) = neighbours.nearest(distances.len()) {
            distances.push(neighbour.squared);
        }
        assert!(distances.is_sorted());
        let near = |i: &i32| ((f64::from(i * 37 % 401) * 6.0 / 401.0 - 3.1).abs()) < 2.0;
        assert_eq!(distances.len(), (0..400_i32).filter(near).count());
    }
}
