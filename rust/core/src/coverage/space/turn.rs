//! A sum of angles that costs one arc tangent.
//!
//! Angles are the arguments of complex numbers, so their sum is that of a product; how often
//! the product has gone round is counted at the negative real axis. A face has some five sides,
//! each with an angle or two.

use std::f64::consts::TAU;

/// A sum of signed angles, each in (-pi, pi).
#[derive(Debug, Clone, Copy)]
pub(crate) struct Turn {
    re: f64,
    im: f64,
    rounds: f64,
}

impl Turn {
    pub const ZERO: Self = Self { re: 1.0, im: 0.0, rounds: 0.0 };

    /// Adds the argument of re + i im; nothing for 0.
    #[inline]
    pub fn add(&mut self, re: f64, im: f64) {
        let product = (self.re * re - self.im * im, self.re * im + self.im * re);
        let size = product.0.abs() + product.1.abs();
        if size < f64::MIN_POSITIVE {
            return;
        }
        // Where rounding makes the product cross the axis too early or too late, the arc
        // tangent's jump from pi to -pi makes up for it.
        if im >= 0.0 {
            self.rounds += f64::from(u8::from(self.im >= 0.0 && product.1 < 0.0));
        } else {
            self.rounds -= f64::from(u8::from(self.im < 0.0 && product.1 >= 0.0));
        }
        // A shorter product would some time underflow.
        (self.re, self.im) = (product.0 / size, product.1 / size);
    }

    /// The sum, in radians.
    #[inline]
    pub fn total(&self) -> f64 {
        // Above the axis counts as on it: -0 must become 0, not -pi.
        libm::atan2(self.im + 0.0, self.re) + TAU * self.rounds
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use std::f64::consts::PI;

    #[test]
    fn sums_of_angles_go_round_and_back() {
        for steps in [1, 2, 3, 5, 8, 40] {
            for total in [0.0, 0.1, 1.0, PI - 1e-15, PI, PI + 1e-15, 4.0, TAU - 1e-9, TAU, 3.0 * PI]
            {
                let step: f64 = total / f64::from(steps);
                if step >= PI {
                    continue;
                }
                let (mut there, mut back) = (Turn::ZERO, Turn::ZERO);
                for _ in 0..steps {
                    there.add(1e-40 * step.cos(), 1e-40 * step.sin());
                    back.add(3.0 * step.cos(), -3.0 * step.sin());
                }
                assert!((there.total() - total).abs() <= 3e-15, "{steps} {total}");
                assert!((back.total() + total).abs() <= 3e-15, "{steps} {total}");
                for _ in 0..steps {
                    there.add(step.cos(), -step.sin());
                }
                assert!(there.total().abs() <= 3e-15, "{steps} {total}");
            }
        }
    }

    #[test]
    fn half_a_turn_is_no_matter_of_signed_zeros() {
        for zero in [0.0, -0.0] {
            let mut turn = Turn::ZERO;
            turn.add(0.0, 1.0);
            turn.add(zero, 1.0);
            turn.add(1.0, zero);
            turn.add(1.0, zero);
            assert_eq!(turn.total(), PI);
            turn.add(zero, 1.0);
            turn.add(zero, 1.0);
            turn.add(1.0, zero);
            assert_eq!(turn.total(), TAU);
            let mut turn = Turn::ZERO;
            turn.add(-1.0, zero);
            assert_eq!(turn.total(), PI);
        }
    }

    #[test]
    fn nothing_adds_nothing() {
        let mut turn = Turn::ZERO;
        turn.add(0.0, 0.0);
        assert_eq!(turn.total(), 0.0);
    }
}
