//! The inverse of the normal distribution function.
//!
//! Wichura's algorithm AS 241 (Applied Statistics 37, 1988), routine PPND16: ratios of two
//! polynomials of degree seven, with a relative error of about 1e-16. Its third range, for
//! tails below 1e-11, is left out: the smallest argument that draws lead to is 5e-17, where the
//! second is still good to 1e-8, and all that one makes of so rare a number is a direction or a
//! choice.

/// For |p - 1/2| <= 0.425, in 0.425^2 - (p - 1/2)^2.
const CENTRE: ([f64; 8], [f64; 8]) = (
    [
        3.387_132_872_796_366_5,
        1.331_416_678_917_843_8e2,
        1.971_590_950_306_551_3e3,
        1.373_169_376_550_946e4,
        4.592_195_393_154_987e4,
        6.726_577_092_700_87e4,
        3.343_057_558_358_813e4,
        2.509_080_928_730_122_7e3,
    ],
    [
        1.0,
        4.231_333_070_160_091e1,
        6.871_870_074_920_579e2,
        5.394_196_021_424_751e3,
        2.121_379_430_158_659_7e4,
        3.930_789_580_009_271e4,
        2.872_908_573_572_194_3e4,
        5.226_495_278_852_854e3,
    ],
);

/// Beyond that, in sqrt(-log(tail)) - 1.6.
const TAIL: ([f64; 8], [f64; 8]) = (
    [
        1.423_437_110_749_683_5,
        4.630_337_846_156_546,
        5.769_497_221_460_691,
        3.647_848_324_763_204_5,
        1.270_458_252_452_368_4,
        2.417_807_251_774_506e-1,
        2.272_384_498_926_918_4e-2,
        7.745_450_142_783_414e-4,
    ],
    [
        1.0,
        2.053_191_626_637_759,
        1.676_384_830_183_803_8,
        6.897_673_349_851e-1,
        1.481_039_764_274_800_8e-1,
        1.519_866_656_361_645_7e-2,
        5.475_938_084_995_345e-4,
        1.050_750_071_644_416_9e-9,
    ],
);

/// The number below which a standard normal number lies with probability `p` in (0, 1).
///
/// Right to about 1e-15, and to 1e-8 where `p` is below 1e-11 or above 1 - 1e-11.
#[must_use]
pub fn quantile(p: f64) -> f64 {
    let away = p - 0.5;
    if away.abs() <= 0.425 {
        return away * ratio(&CENTRE, 0.425 * 0.425 - away * away);
    }
    let tail = if away < 0.0 { p } else { 1.0 - p };
    let found = ratio(&TAIL, (-libm::log(tail)).sqrt() - 1.6);
    if away < 0.0 { -found } else { found }
}

fn ratio((above, below): &([f64; 8], [f64; 8]), x: f64) -> f64 {
    let horner = |terms: &[f64; 8]| terms.iter().rev().fold(0.0, |sum, term| sum * x + term);
    horner(above) / horner(below)
}

#[cfg(test)]
mod tests {
    use super::*;

    /// The error in x of x = quantile(p), by one step of Newton's method from erfc.
    fn error(p: f64) -> f64 {
        let x = quantile(p);
        let density = (-0.5 * x * x).exp() / std::f64::consts::TAU.sqrt();
        let tail = 0.5 * libm::erfc(x.abs() / std::f64::consts::SQRT_2);
        (tail - p.min(1.0 - p)) / density
    }

    #[test]
    fn inverts_the_distribution_function() {
        for i in 1..20_000 {
            let p = f64::from(i) / 20_000.0;
            assert!(error(p).abs() < 2e-15, "{p}: off by {}", error(p));
        }
        for i in 0..100 {
            let p = 1e-11 + f64::from(i) * 1e-7;
            assert!(error(p).abs() < 2e-14, "{p}: off by {}", error(p));
        }
        for p in [5.5e-17, 1.1e-16, 1e-14, 1e-12] {
            assert!(error(p).abs() < 1e-8, "{p}: off by {}", error(p));
        }
    }

    #[test]
    fn is_odd() {
        assert_eq!(quantile(0.5), 0.0);
        for i in 1..1024 {
            let p = f64::from(i) / 1024.0;
            assert_eq!(quantile(p), -quantile(1.0 - p));
        }
    }
}
