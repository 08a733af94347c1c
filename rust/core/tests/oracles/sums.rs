//! Exact sums in two ways that share nothing: on paper in decimals, and in floating point.

/// The sum, rounded once: written out in decimals, which end after 1074 digits, added column by
/// column as at school, and read again by the standard library.
pub fn on_paper(numbers: &[f64]) -> f64 {
    let column = |negative: bool| -> Vec<u64> {
        let mut digits = vec![0; 1074 + 309 + 20];
        for number in numbers.iter().filter(|number| number.is_sign_negative() == negative) {
            let written = format!("{:.1074}", number.abs());
            let written = written.bytes().rev().filter(u8::is_ascii_digit);
            digits.iter_mut().zip(written).for_each(|(sum, digit)| *sum += u64::from(digit - b'0'));
        }
        carried(digits)
    };
    let (above, below) = (column(false), column(true));
    let negative = above.iter().rev().lt(below.iter().rev());
    let (more, less) = if negative { (below, above) } else { (above, below) };
    // Less is taken away by adding its nines' complement, and one; the last carry is dropped.
    let mut digits: Vec<u64> = more.iter().zip(less).map(|(more, less)| more + 9 - less).collect();
    digits[0] += 1;
    let mut written: String =
        carried(digits).iter().rev().map(|digit| char::from(b'0' + *digit as u8)).collect();
    written.insert(written.len() - 1074, '.');
    let sum: f64 = written.parse().unwrap();
    if negative { -sum } else { sum }
}

/// Columns carried into each other, the lowest first; what leaves the highest is dropped.
fn carried(mut columns: Vec<u64>) -> Vec<u64> {
    let mut carry = 0;
    for column in &mut columns {
        let sum = *column + carry;
        (*column, carry) = (sum % 10, sum / 10);
    }
    columns
}

/// The sum, rounded once, from numbers that do not overlap (Shewchuk, 1997), as Python's `fsum`
/// does it; right as long as no sum on the way is infinite.
pub fn in_parts(numbers: &[f64]) -> f64 {
    let mut parts: Vec<f64> = Vec::new();
    for &number in numbers {
        let mut carried = number;
        let mut next = Vec::new();
        for part in parts {
            let (sum, error) = two_sum(carried, part);
            if error != 0.0 {
                next.push(error);
            }
            carried = sum;
        }
        next.push(carried);
        parts = next;
    }
    let mut rest = parts.into_iter().rev();
    let mut total = 0.0;
    while let Some(part) = rest.next() {
        let (sum, error) = two_sum(total, part);
        total = sum;
        if error != 0.0 {
            // Half-way between two numbers the next part decides, which is less than the error.
            let beyond = rest.next().unwrap_or(0.0);
            let (other, more) = two_sum(total, 2.0 * error);
            let same_side = error < 0.0 && beyond < 0.0 || error > 0.0 && beyond > 0.0;
            if more == 0.0 && same_side {
                total = other;
            }
            break;
        }
    }
    total
}

/// The rounded sum of two numbers and its error (Knuth).
fn two_sum(a: f64, b: f64) -> (f64, f64) {
    let sum = a + b;
    let b_rounded = sum - a;
    (sum, (a - (sum - b_rounded)) + (b - b_rounded))
}
