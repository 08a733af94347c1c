//! Which balls may touch a given one: a hash grid of cubes over the first three coordinates.
//!
//! Cubes are as wide as a ball, so that all centres closer than that lie in the 3 x 3 x 3 cubes around; further
//! coordinates would multiply the cubes to look into by three each. Each keeps its centres beside each other in memory.

use rustc_hash::FxHashMap;

/// Centres by cube.
#[derive(Debug, Clone)]
pub(super) struct Cubes {
    dim: usize,
    width: f64,
    cubes: FxHashMap<[i64; 3], Vec<f64>>,
}

impl Cubes {
    /// Without any centre yet, for balls of radius `tau` in `dim` dimensions.
    pub fn new(dim: usize, tau: f64) -> Self {
        Self { dim, width: 2.0 * tau, cubes: FxHashMap::default() }
    }

    /// How many centres there are.
    pub fn len(&self) -> usize {
        self.cubes.values().map(Vec::len).sum::<usize>() / self.dim
    }

    pub fn insert(&mut self, centre: &[f64]) {
        self.cubes.entry(self.key(centre)).or_default().extend_from_slice(centre);
    }

    /// The centres in the cubes around a point, coordinate by coordinate, cube by cube and in the order of insertion.
    pub fn around(&self, point: &[f64]) -> impl Iterator<Item = &[f64]> {
        let key = self.key(point);
        (0..3_i64.pow(self.dim.min(3) as u32)).filter_map(move |step| {
            let steps = match self.dim {
                1 => [step - 1, 0, 0],
                2 => [step / 3 - 1, step % 3 - 1, 0],
                _ => [step / 9 - 1, step / 3 % 3 - 1, step % 3 - 1],
            };
            // Beyond the outermost cubes there are none; to meet those twice would count twice.
            let [i, j, k] = std::array::from_fn(|axis| key[axis].checked_add(steps[axis]));
            self.cubes.get(&[i?, j?, k?]).map(Vec::as_slice)
        })
    }

    /// Far beyond the integers all coordinates share the outermost cubes, and with that
    /// nothing is missed: the cast saturates and stays monotone.
    fn key(&self, point: &[f64]) -> [i64; 3] {
        std::array::from_fn(|k| point.get(k).map_or(0, |x| (x / self.width).floor() as i64))
    }
}
