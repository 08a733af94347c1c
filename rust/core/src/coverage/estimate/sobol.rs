//! Sobol's sequence: points that fill the unit cube more evenly than random ones.
//!
//! With the direction numbers of Joe and Kuo (SIAM Journal on Scientific Computing 30, 2008),
//! their table new-joe-kuo-6.21201, which SciPy's `scipy.stats.qmc.Sobol` uses too; the points
//! come in the Gray code's order (Antonov and Saleev, 1979), as there.

/// The most coordinates that a point can have.
pub(super) const DIMS: usize = 32;

/// Coordinates from the second on: the degree of a primitive polynomial modulo 2, its inner
/// coefficients as bits, and the first direction numbers.
#[rustfmt::skip]
const TABLE: [(u32, u32, &[u32]); DIMS - 1] = [
    (1, 0, &[1]),
    (2, 1, &[1, 3]),
    (3, 1, &[1, 3, 1]),
    (3, 2, &[1, 1, 1]),
    (4, 1, &[1, 1, 3, 3]),
    (4, 4, &[1, 3, 5, 13]),
    (5, 2, &[1, 1, 5, 5, 17]),
    (5, 4, &[1, 1, 5, 5, 5]),
    (5, 7, &[1, 1, 7, 11, 19]),
    (5, 11, &[1, 1, 5, 1, 1]),
    (5, 13, &[1, 1, 1, 3, 11]),
    (5, 14, &[1, 3, 5, 5, 31]),
    (6, 1, &[1, 3, 3, 9, 7, 49]),
    (6, 13, &[1, 1, 1, 15, 21, 21]),
    (6, 16, &[1, 3, 1, 13, 27, 49]),
    (6, 19, &[1, 1, 1, 15, 7, 5]),
    (6, 22, &[1, 3, 1, 15, 13, 25]),
    (6, 25, &[1, 1, 5, 5, 19, 61]),
    (7, 1, &[1, 3, 7, 11, 23, 15, 103]),
    (7, 4, &[1, 3, 7, 13, 13, 15, 69]),
    (7, 7, &[1, 1, 3, 13, 7, 35, 63]),
    (7, 8, &[1, 3, 5, 9, 1, 25, 53]),
    (7, 14, &[1, 3, 1, 13, 9, 35, 107]),
    (7, 19, &[1, 3, 1, 5, 27, 61, 31]),
    (7, 21, &[1, 1, 5, 11, 19, 41, 61]),
    (7, 28, &[1, 3, 5, 3, 3, 13, 69]),
    (7, 31, &[1, 1, 7, 13, 1, 19, 1]),
    (7, 32, &[1, 3, 7, 5, 13, 19, 59]),
    (7, 37, &[1, 1, 3, 9, 25, 29, 41]),
    (7, 41, &[1, 3, 5, 13, 23, 1, 55]),
    (7, 42, &[1, 3, 7, 3, 13, 59, 17]),
];

/// The sequence, and where it stands.
#[derive(Debug, Clone)]
pub(super) struct Sobol {
    /// The 32 directions of each coordinate.
    directions: Vec<[u32; 32]>,
    /// The next point, in units of 2^-32.
    point: Vec<u32>,
    index: u32,
}

impl Sobol {
    /// The sequence in `dim` dimensions, from its first point, the origin.
    pub fn new(dim: usize) -> Self {
        let directions = (0..dim.min(DIMS)).map(directions).collect();
        Self { directions, point: vec![0; dim], index: 0 }
    }

    /// Writes the next point, in units of 2^-32. After 2^32 points they come again.
    pub fn next_into(&mut self, point: &mut [u32]) {
        point.copy_from_slice(&self.point);
        self.index = self.index.wrapping_add(1);
        let bit = self.index.trailing_zeros().min(31) as usize;
        for (x, directions) in self.point.iter_mut().zip(&self.directions) {
            *x ^= directions[bit];
        }
    }
}

/// The directions of one coordinate: m_1 / 2, m_2 / 4, ..., in units of 2^-32.
fn directions(coordinate: usize) -> [u32; 32] {
    let mut v = std::array::from_fn(|k| 1 << (31 - k));
    if coordinate > 0 {
        let (degree, inner, first) = TABLE[coordinate - 1];
        let s = degree as usize;
        for k in 0..32 {
            if k < s {
                v[k] = first[k] << (31 - k);
                continue;
            }
            v[k] = v[k - s] ^ (v[k - s] >> s);
            for i in 1..s {
                if (inner >> (s - 1 - i)) & 1 == 1 {
                    v[k] ^= v[k - i];
                }
            }
        }
    }
    v
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Points of `scipy.stats.qmc.Sobol(32, scramble=False, bits=32)`, SciPy 1.17, some
    /// coordinates, and a sum over all coordinates of the first 4096.
    #[test]
    fn agrees_with_scipy() {
        let coordinates = [0, 1, 2, 7, 15, 30, 31];
        #[rustfmt::skip]
        let expected: [(usize, [u32; 7]); 5] = [
            (1, [2147483648; 7]),
            (3, [1073741824, 3221225472, 3221225472, 1073741824, 3221225472, 3221225472, 3221225472]),
            (100, [1778384896, 1107296256, 3321888768, 2046820352, 2113929216, 3053453312, 1778384896]),
            (1023, [4194304, 3233808384, 2629828608, 2654994432, 1992294400, 3988783104, 2638217216]),
            (4095, [1048576, 4042260480, 1435500544, 1678770176, 1789919232, 1552941056, 376438784]),
        ];
        let (mut sobol, mut point, mut sum) = (Sobol::new(32), [0; 32], 0_u64);
        for i in 0..4096 {
            sobol.next_into(&mut point);
            if let Some((_, values)) = expected.iter().find(|(index, _)| *index == i) {
                assert_eq!(coordinates.map(|c| point[c]), *values, "point {i}");
            }
            for x in point {
                sum = sum.wrapping_mul(6_364_136_223_846_793_005).wrapping_add(u64::from(x) + 1);
            }
        }
        assert_eq!(sum, 14_946_345_323_790_204_928);
    }

    /// Every coordinate of 2^k points falls once into each of 2^k equal parts.
    #[test]
    fn each_coordinate_is_stratified() {
        let (mut sobol, mut point) = (Sobol::new(DIMS), [0; DIMS]);
        let mut seen = vec![[false; 1024]; DIMS];
        for _ in 0..1024 {
            sobol.next_into(&mut point);
            for (seen, x) in seen.iter_mut().zip(point) {
                assert!(!std::mem::replace(&mut seen[(x >> 22) as usize], true));
            }
        }
    }
}
