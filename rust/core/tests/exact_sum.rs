//! An exact sum has the bits of a sum on paper, whatever is in it and whatever has been.

use crate::oracles::sums::{in_parts, on_paper};
use crate::oracles::{Stream, fixed};
use divbandit_core::ExactSum;
use proptest::prelude::*;
use proptest::sample::select;

const LEAST: f64 = f64::from_bits(1);

fn sum_of(numbers: &[f64]) -> ExactSum {
    let mut sum = ExactSum::default();
    numbers.iter().for_each(|&number| sum.add(number));
    sum
}

/// Any finite number, each exponent as likely as the others.
fn wild() -> impl Strategy<Value = f64> {
    any::<u64>().prop_map(f64::from_bits).prop_filter("finite", |x| x.is_finite())
}

/// Few bits, at places where sums of them meet, carry, lie half-way or leave the range.
fn sparse() -> impl Strategy<Value = f64> {
    let odd = prop_oneof![-4_i32..=4, select(vec![(1 << 26) - 1, 1 << 26, -(1 << 26)])];
    let places = vec![-1074, -1073, -1023, -1022, -1021, -970, -64, -1, 0, 1, 26, 52, 53, 54, 63];
    let power = |place: i32| 2_f64.powi(place / 2) * 2_f64.powi(place - place / 2);
    (odd, select(places)).prop_map(move |(odd, place)| f64::from(odd) * power(place))
}

fn numbers() -> impl Strategy<Value = Vec<f64>> {
    let number = prop_oneof![wild(), sparse(), 1e-19..1.3e-3, -1.0..1.0];
    let mixed = prop::collection::vec(number, 0..24);
    let alike = prop::collection::vec(sparse(), 0..24);
    let tiny = prop::collection::vec((0..1_u64 << 54).prop_map(f64::from_bits), 0..24);
    prop_oneof![mixed, alike, tiny]
}

proptest! {
    #![proptest_config(fixed(1500))]

    #[test]
    fn equals_a_sum_on_paper(numbers in numbers()) {
        prop_assert_eq!(sum_of(&numbers).value().to_bits(), on_paper(&numbers).to_bits());
    }

    /// Both oracles and the sum agree, where the second can.
    #[test]
    fn equals_a_sum_in_parts(numbers in numbers()) {
        let expected = in_parts(&numbers);
        prop_assume!(expected.is_finite());
        // Parts know a negative zero.
        prop_assert_eq!(sum_of(&numbers).value().to_bits(), (expected + 0.0).to_bits());
    }

    /// What has left no longer counts, whether it came early or late, was large or small.
    #[test]
    fn forgets_what_was_taken_away(kept in numbers(), others in numbers(), seed: u64) {
        let mut all: Vec<_> = kept.iter().map(|&x| (x, true)).collect();
        all.extend(others.iter().map(|&x| (x, false)));
        Stream(seed).shuffle(&mut all);
        let mut sum = ExactSum::default();
        all.iter().for_each(|&(x, _)| sum.add(x));
        Stream(seed ^ 1).shuffle(&mut all);
        all.iter().filter(|(_, kept)| !kept).for_each(|&(x, _)| sum.subtract(x));
        prop_assert_eq!(sum.value().to_bits(), sum_of(&kept).value().to_bits());
        kept.iter().for_each(|&x| sum.subtract(x));
        prop_assert_eq!(sum.value().to_bits(), 0);
    }

    #[test]
    fn is_odd(numbers in numbers()) {
        let opposite: Vec<f64> = numbers.iter().map(|x| -x).collect();
        let (sum, other) = (sum_of(&numbers).value(), sum_of(&opposite).value());
        prop_assert_eq!(sum, -other);
        prop_assert!(sum != 0.0 || (sum.to_bits() == 0 && other.to_bits() == 0));
    }

    /// One number alone, and thrice with one of them taken away as its opposite.
    #[test]
    fn holds_every_number(number in wild()) {
        prop_assert_eq!(sum_of(&[number]).value(), number);
        prop_assert_eq!(sum_of(&[number, number, -number]).value(), number);
    }
}

#[test]
fn ties_go_to_the_even_number_unless_anything_lies_beyond() {
    let big = 2_f64.powi(53);
    for (numbers, expected) in [
        (vec![big, 1.0], big),
        (vec![big, 1.0, LEAST], big + 2.0),
        (vec![big, 1.0, -LEAST], big),
        (vec![big, 3.0], big + 4.0),
        (vec![big, 3.0, -LEAST], big + 2.0),
        (vec![-big, -1.0], -big),
        (vec![-big, -1.0, -LEAST], -big - 2.0),
        (vec![-big, -3.0, LEAST], -big - 2.0),
        // Below a power of two numbers lie twice as dense.
        (vec![big, -0.5], big),
        (vec![big, -0.5, -LEAST], big - 1.0),
        // A carry through all bits to the next power of two.
        (vec![big - 1.0, 0.5], big),
    ] {
        assert_eq!(sum_of(&numbers).value(), expected, "{numbers:?}");
        assert_eq!(on_paper(&numbers), expected, "{numbers:?} on paper");
        assert_eq!(in_parts(&numbers), expected, "{numbers:?} in parts");
    }
}

#[test]
fn subnormal_sums_are_exact() {
    let normal = f64::MIN_POSITIVE;
    assert_eq!(sum_of(&[LEAST; 3]).value(), 3.0 * LEAST);
    assert_eq!(sum_of(&[normal, -LEAST]).value(), normal - LEAST);
    assert_eq!(sum_of(&[normal - LEAST, LEAST]).value(), normal);
    assert_eq!(sum_of(&[-normal, normal / 2.0]).value(), -normal / 2.0);
}

#[test]
fn sums_beyond_the_largest_number_are_infinite_until_they_return() {
    let half_unit = 2_f64.powi(969);
    assert_eq!(sum_of(&[f64::MAX, half_unit]).value(), f64::MAX);
    assert_eq!(sum_of(&[f64::MAX, half_unit, half_unit]).value(), f64::INFINITY);
    assert_eq!(sum_of(&[f64::MAX, 2.0 * half_unit, -LEAST]).value(), f64::MAX);
    let mut sum = sum_of(&[f64::MAX; 5000]);
    assert_eq!(sum.value(), f64::INFINITY);
    (0..9999).for_each(|_| sum.subtract(f64::MAX));
    assert_eq!(sum.value(), f64::NEG_INFINITY);
    (0..5000).for_each(|_| sum.add(f64::MAX));
    assert_eq!(sum.value(), f64::MAX);
}

#[test]
fn many_equal_numbers_carry_into_the_next_limbs() {
    for number in [1.0 - f64::EPSILON, -f64::MIN_POSITIVE, 1e300, 0.1, LEAST] {
        let mut sum = ExactSum::default();
        (0..1 << 20).for_each(|_| sum.add(number));
        assert_eq!(sum.value(), number * 1_048_576.0);
    }
}
