//! Instructions: the hottest loops are compiled for several widths of vectors, and one is chosen
//! when the program runs.
//!
//! A kernel takes the widest that the CPU has. As Rust never fuses multiplications and additions,
//! and no loop adds in another order when it gets wider, the choice changes the speed alone. Tests
//! take each in turn and compare.

/// Vector instructions that a loop is compiled for.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
#[non_exhaustive]
pub enum Instructions {
    /// What every CPU of the target has: SSE2 on x86-64.
    Baseline,
    /// AVX2 with what CPUs that have it have as well (x86-64-v3): four numbers at once.
    Avx2,
    /// AVX-512 likewise (x86-64-v4): eight numbers at once.
    Avx512,
}

impl Instructions {
    /// All of them, the narrowest first.
    pub const ALL: [Self; 3] = [Self::Baseline, Self::Avx2, Self::Avx512];
}

/// Runs loops with the instructions that were chosen once.
#[derive(Debug, Clone, Copy)]
pub(crate) struct Dispatch(pulp::Arch);

impl Dispatch {
    /// With the widest instructions that this CPU has.
    pub fn widest() -> Self {
        Self(pulp::Arch::new())
    }

    /// With these; None where this CPU does not have them.
    pub fn to(instructions: Instructions) -> Option<Self> {
        match instructions {
            Instructions::Baseline => Some(Self(pulp::Arch::Scalar)),
            #[cfg(any(target_arch = "x86", target_arch = "x86_64"))]
            Instructions::Avx2 => pulp::x86::V3::try_new().map(|v3| Self(pulp::Arch::V3(v3))),
            #[cfg(any(target_arch = "x86", target_arch = "x86_64"))]
            Instructions::Avx512 => pulp::x86::V4::try_new().map(|v4| Self(pulp::Arch::V4(v4))),
            #[cfg(not(any(target_arch = "x86", target_arch = "x86_64")))]
            Instructions::Avx2 | Instructions::Avx512 => None,
        }
    }

    /// Runs `work`, and all that is inlined into it, with these instructions.
    ///
    /// The closure itself must be `#[inline(always)]`: left to choose, the compiler may not inline
    /// it, and then there is one version of it, for the baseline.
    #[inline(always)]
    pub fn run<R>(self, work: impl FnOnce() -> R) -> R {
        self.0.dispatch(work)
    }
}

impl PartialEq for Dispatch {
    fn eq(&self, _: &Self) -> bool {
        true // the instructions change the speed, never the result
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn each_name_stands_for_its_instructions() {
        let found = Instructions::ALL.map(|name| {
            Dispatch::to(name).map(|Dispatch(arch)| format!("{arch:?}").replace(['(', ')'], " "))
        });
        let begins = |i: usize, with: &str| found[i].as_ref().is_none_or(|s| s.starts_with(with));
        assert!(found[0].is_some());
        assert!(begins(0, "Scalar") && begins(1, "V3 ") && begins(2, "V4 "), "{found:?}");
    }

    /// Wherever any but the baseline can be had, the widest is not the baseline.
    #[test]
    fn the_widest_is_the_last_that_can_be_had() {
        let last = Instructions::ALL.into_iter().filter_map(Dispatch::to).next_back();
        let last = last.map(|Dispatch(arch)| std::mem::discriminant(&arch));
        let Dispatch(widest) = Dispatch::widest();
        if cfg!(any(target_arch = "x86", target_arch = "x86_64")) {
            assert_eq!(last, Some(std::mem::discriminant(&widest)));
        }
    }
}
