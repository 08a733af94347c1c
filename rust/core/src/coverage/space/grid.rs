//! Which balls may touch a given one: a hash grid of cubes.
//!
//! Cubes are as wide as a ball, so that all centres closer than that lie in the 3 x 3 x 3
//! cubes around. Each keeps its centres beside each other in memory.

use rustc_hash::FxHashMap;

use super::vector::Vector;

/// Centres by cube.
#[derive(Debug, Clone)]
pub(crate) struct Grid {
    width: f64,
    cubes: FxHashMap<[i64; 3], Vec<Vector>>,
    len: usize,
}

impl Grid {
    pub fn new(width: f64) -> Self {
        Self { width, cubes: FxHashMap::default(), len: 0 }
    }

    /// How many centres there are.
    pub fn len(&self) -> usize {
        self.len
    }

    pub fn insert(&mut self, centre: Vector) {
        self.cubes.entry(self.key(centre)).or_default().push(centre);
        self.len += 1;
    }

    /// The centres in the 3 x 3 x 3 cubes around a point, cube by cube.
    pub fn around(&self, point: Vector) -> impl Iterator<Item = &[Vector]> {
        let [i, j, k] = self.key(point);
        (0..27).filter_map(move |step: i64| {
            // Beyond the outermost cubes there are none; to meet those twice would count twice.
            let key = [
                i.checked_add(step / 9 - 1)?,
                j.checked_add(step / 3 % 3 - 1)?,
                k.checked_add(step % 3 - 1)?,
            ];
            self.cubes.get(&key).map(Vec::as_slice)
        })
    }

    /// Far beyond the integers all coordinates share the outermost cubes, and with that
    /// nothing is missed: the cast saturates and stays monotone.
    fn key(&self, point: Vector) -> [i64; 3] {
        point.map(|x| (x / self.width).floor() as i64)
    }
}
