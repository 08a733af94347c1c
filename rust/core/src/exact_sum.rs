//! A sum that is never rounded: numbers are added and taken away exactly, and rounded when read.

/// As a count of 2^-1074 the largest number has 2098 bits. 34 limbs of 64 leave 78 for carries and
/// the sign: enough for 2^76 numbers at a time.
const LIMBS: usize = 34;
const FRACTION_BITS: u32 = 52;
const FRACTION: u64 = (1 << FRACTION_BITS) - 1;

/// The exact sum of finite numbers, some of which may be taken away again.
///
/// It depends on nothing but the numbers in it, not on their order nor on what has been there.
/// All that f64 can hold are whole multiples of 2^-1074, so the sum is one integer, in two's
/// complement: adding a number adds its 53 bits at their place, and a carry seldom goes further.
///
/// ```
/// use divbandit_core::ExactSum;
///
/// let mut sum = ExactSum::default();
/// for number in [1e300, 0.1, 1e-300] {
///     sum.add(number);
/// }
/// sum.subtract(1e300);
/// assert_eq!(sum.value(), 0.1);
/// sum.subtract(0.1);
/// assert_eq!(sum.value(), 1e-300);
/// ```
#[derive(Debug, Clone)]
pub struct ExactSum {
    /// The lowest first; the unit of the lowest is 2^-1074.
    limbs: [u64; LIMBS],
    /// From here on up there is nothing but the sign, whatever has been added.
    end: usize,
}

impl Default for ExactSum {
    /// The sum of nothing.
    fn default() -> Self {
        Self { limbs: [0; LIMBS], end: 2 }
    }
}

impl ExactSum {
    /// Adds a finite number. What is not finite counts as 2^1024 or more, with its sign.
    #[inline]
    pub fn add(&mut self, number: f64) {
        let bits = number.to_bits();
        let exponent = (bits >> FRACTION_BITS) & 0x7FF;
        // Subnormal numbers have the lowest normal ones' place, but no leading one.
        let normal = u64::from(exponent != 0);
        let mantissa = (bits & FRACTION) | normal << FRACTION_BITS;
        let place = (exponent - normal) as usize;
        let (at, shifted) = (place / 64, u128::from(mantissa) << (place % 64));
        // The shifted mantissa ends 12 bits or more below the end of the second limb: as many
        // numbers as there may ever be do not carry out of the third.
        self.end = self.end.max(at + 3);
        let pair = pair(&self.limbs, at);
        let (sum, carry) = if number.is_sign_negative() {
            pair.overflowing_sub(shifted)
        } else {
            pair.overflowing_add(shifted)
        };
        self.limbs[at] = sum as u64;
        self.limbs[at + 1] = (sum >> 64) as u64;
        if carry {
            self.carry(at + 2, number.is_sign_negative());
        }
    }

    /// Takes away a number that was added.
    #[inline]
    pub fn subtract(&mut self, number: f64) {
        self.add(-number);
    }

    /// The f64 next to the sum, of two equally near ones that whose last bit is 0; infinite
    /// beyond the largest. An empty sum, or one in which all cancels, is 0.0.
    #[inline]
    #[must_use]
    pub fn value(&self) -> f64 {
        if self.limbs[LIMBS - 1] >> 63 == 0 {
            rounded(&self.limbs, self.end)
        } else {
            -rounded(&negated(self.limbs), self.end)
        }
    }

    /// Carries one into limb `at`, or borrows one from it.
    fn carry(&mut self, at: usize, borrow: bool) {
        for limb in &mut self.limbs[at..] {
            let (sum, further) =
                if borrow { limb.overflowing_sub(1) } else { limb.overflowing_add(1) };
            *limb = sum;
            if !further {
                break;
            }
        }
    }
}

/// Two limbs, the lower one at `at`.
#[inline]
fn pair(limbs: &[u64; LIMBS], at: usize) -> u128 {
    u128::from(limbs[at]) | u128::from(limbs[at + 1]) << 64
}

#[cold]
fn negated(mut limbs: [u64; LIMBS]) -> [u64; LIMBS] {
    let mut carry = true;
    for limb in &mut limbs {
        (*limb, carry) = (!*limb).overflowing_add(u64::from(carry));
    }
    limbs
}

/// A sum that is not negative, with no limb but 0 from `end` on.
#[inline]
fn rounded(limbs: &[u64; LIMBS], end: usize) -> f64 {
    let high = (1..end).rev().find(|&i| limbs[i] != 0).unwrap_or(1);
    let leading = pair(limbs, high - 1);
    if high == 1 && leading >> (FRACTION_BITS + 1) == 0 {
        // As a count of 2^-1074 such a number, normal or not, is its own representation.
        return f64::from_bits(leading as u64);
    }
    let zeros = leading.leading_zeros();
    let leading = leading << zeros;
    let mantissa = (leading >> 75) as u64;
    let (rest, half) = (leading << 53, 1 << 127);
    let up = rest > half
        || rest == half && (mantissa & 1 == 1 || limbs[..high - 1].iter().any(|&limb| limb != 0));
    // The mantissa's leading one counts as one more in the exponent, and a carry out of it, to
    // the next power of two, as yet one more.
    let exponent = 64 * (high as u64 - 1) + 127 - u64::from(zeros) - u64::from(FRACTION_BITS);
    let bits = (exponent << FRACTION_BITS) + mantissa + u64::from(up);
    f64::from_bits(bits.min(f64::INFINITY.to_bits()))
}
