//! A sum and what its roundings lost: a vertex with a hundred triangles would cost 1e-13 without.

/// A sum and what its roundings lost (Knuth).
#[derive(Default)]
pub struct Total(f64, f64);

impl Total {
    pub fn add(&mut self, term: f64) {
        let sum = self.0 + term;
        let part = sum - self.0;
        self.1 += (self.0 - (sum - part)) + (term - part);
        self.0 = sum;
    }

    pub fn value(&self) -> f64 {
        self.0 + self.1
    }
}
