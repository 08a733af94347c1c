//! Sines and cosines that have the same bits on every machine, several at a time.
//!
//! The platform's `sin` and `cos` differ between C libraries and between CPUs. Here every
//! step is an addition or a multiplication in a fixed order, and Rust never contracts two
//! of them into a fused one, so one result comes out whether the compiler uses one lane or
//! eight. The angle is brought into [-pi/4, pi/4] by subtracting a multiple of pi/2 held in
//! three parts (Cody and Waite), exact while the multiple stays below 2^20; there two
//! polynomials of the square, with errors below 2.4e-17 r^3 (sine) and 1.5e-18 r^4 (cosine),
//! finish the work.

use std::f64::consts::FRAC_2_PI;

/// The largest absolute angle, in radians, for which the results are accurate.
pub const MAX_ANGLE: f64 = 1e6;

/// Adding and subtracting it rounds to the nearest integer, left in the low bits of the sum.
const ROUNDER: f64 = 6_755_399_441_055_744.0; // 1.5 * 2^52

/// pi/2 in three parts; the first two have 33 bits, so that a multiple below 2^20 is exact.
const HALF_PI: [f64; 3] =
    [1.570_796_326_734_125_6, 6.077_100_506_303_966e-11, 2.022_266_248_795_950_6e-21];

/// sin(r) = r + r^3 (S0 + S1 r^2 + ...) on |r| <= pi/4.
const SINE: [f64; 6] = [
    -0.166_666_666_666_666_66,
    0.008_333_333_333_330_7,
    -0.000_198_412_698_363_873_45,
    2.755_731_591_191_116e-6,
    -2.505_109_250_706_138_5e-8,
    1.591_532_321_227_14e-10,
];

/// cos(r) = 1 - r^2 / 2 + r^4 (C0 + C1 r^2 + ...) on |r| <= pi/4.
const COSINE: [f64; 6] = [
    0.041_666_666_666_666_664,
    -0.001_388_888_888_888_724_1,
    2.480_158_729_853_345_6e-5,
    -2.755_731_715_246_704e-7,
    2.087_612_165_887_116e-9,
    -1.138_087_694_816_971_7e-11,
];

/// The sines and cosines of `angles`, each within one unit in the last place.
///
/// Written without branches so that the loop becomes vector code in whatever instruction
/// set the caller was compiled or dispatched for.
#[inline(always)]
#[must_use]
pub fn sin_cos<const LANES: usize>(angles: [f64; LANES]) -> ([f64; LANES], [f64; LANES]) {
    let mut sines = [0.0; LANES];
    let mut cosines = [0.0; LANES];
    for lane in 0..LANES {
        let angle = angles[lane];
        let rounded = angle * FRAC_2_PI + ROUNDER;
        let quarter_turns = rounded - ROUNDER;
        let r = ((angle - quarter_turns * HALF_PI[0]) - quarter_turns * HALF_PI[1])
            - quarter_turns * HALF_PI[2];

        let u = r * r;
        let sine = r + r * u * polynomial(u, &SINE);
        let half = 0.5 * u;
        let near_one = 1.0 - half;
        let cosine = near_one + (((1.0 - near_one) - half) + u * u * polynomial(u, &COSINE));

        // Odd quarter turns swap the two; the second bit turns the signs.
        let quadrant = rounded.to_bits();
        let swap = (quadrant & 1).wrapping_neg();
        let (s, c) = (sine.to_bits(), cosine.to_bits());
        let sine_sign = (quadrant & 2) << 62;
        let cosine_sign = (quadrant.wrapping_add(1) & 2) << 62;
        sines[lane] = f64::from_bits(((s & !swap) | (c & swap)) ^ sine_sign);
        cosines[lane] = f64::from_bits(((c & !swap) | (s & swap)) ^ cosine_sign);
    }
    (sines, cosines)
}

/// Horner's rule, lowest coefficient first.
#[inline(always)]
fn polynomial(u: f64, coefficients: &[f64; 6]) -> f64 {
    let [c0, c1, c2, c3, c4, c5] = *coefficients;
    c0 + u * (c1 + u * (c2 + u * (c3 + u * (c4 + u * c5))))
}

#[cfg(test)]
mod tests {
    use super::*;

    fn check(angle: f64) {
        let ([sine], [cosine]) = sin_cos([angle]);
        // The standard library is itself accurate to about one unit in the last place.
        assert!((sine - angle.sin()).abs() <= 2.3e-16, "sin({angle}) = {sine}");
        assert!((cosine - angle.cos()).abs() <= 2.3e-16, "cos({angle}) = {cosine}");
    }

    #[test]
    fn agrees_with_the_standard_library() {
        for i in -200_000..=200_000 {
            check(f64::from(i) * 1.7e-4);
            check(f64::from(i) * 4.999);
        }
    }

    #[test]
    fn agrees_at_and_beside_multiples_of_a_quarter_turn() {
        for i in -64..=64 {
            let angle = f64::from(i) * std::f64::consts::FRAC_PI_4;
            check(angle);
            check(angle.next_up());
            check(angle.next_down());
        }
    }

    #[test]
    fn is_the_same_in_any_lane() {
        let angles: [f64; 8] = std::array::from_fn(|i| i as f64 * 0.83 - 3.0);
        let (sines, cosines) = sin_cos(angles);
        for lane in 0..8 {
            let ([sine], [cosine]) = sin_cos([angles[lane]]);
            assert_eq!(sine.to_bits(), sines[lane].to_bits());
            assert_eq!(cosine.to_bits(), cosines[lane].to_bits());
        }
    }

    #[test]
    fn zero_is_exact() {
        let ([sine], [cosine]) = sin_cos([0.0]);
        assert_eq!((sine, cosine), (0.0, 1.0));
    }
}
