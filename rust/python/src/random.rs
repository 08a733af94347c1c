//! Drawing from the caller's `numpy.random.Generator`, through its bit generator's C interface.
//!
//! A bit generator offers a capsule with a `bitgen_t`: its state and the functions that advance
//! it. `next_double` is what `Generator.random()` calls, so a draw here and a draw there advance
//! one and the same stream. This is the only file of the project with unsafe code; each use says
//! why it is sound.

#![allow(unsafe_code)]

use std::ptr::NonNull;

use divbandit_core::UniformStream;
use numpy::npyffi::random::bitgen_t;
use pyo3::intern;
use pyo3::prelude::*;
use pyo3::sync::PyOnceLock;
use pyo3::types::{PyCapsule, PyType};

use crate::arrays::wrong_type;

/// The caller's stream of uniform numbers, locked for as long as this lives.
pub(crate) struct NumpyStream<'py> {
    draws: Draws,
    lock: Bound<'py, PyAny>,
    /// Owns the memory behind the draws' `bitgen_t`.
    _capsule: Bound<'py, PyCapsule>,
    /// Owns the state that the `bitgen_t` points to.
    _bit_generator: Bound<'py, PyAny>,
}

/// The numbers themselves, which can be drawn while the thread is detached from Python.
///
/// There is one in each [`NumpyStream`], which lends it out but never gives it away.
pub(crate) struct Draws(NonNull<bitgen_t>);

// SAFETY: NumPy's bit generators may be used from any thread without Python's global lock by who
// holds the bit generator's own lock, and that is held for as long as the `NumpyStream` lives
// that lends this.
unsafe impl Send for Draws {}

impl<'py> NumpyStream<'py> {
    /// Locks the stream of `rng`, a `numpy.random.Generator`.
    pub fn lock(rng: &Bound<'py, PyAny>) -> PyResult<Self> {
        static GENERATOR: PyOnceLock<Py<PyType>> = PyOnceLock::new();
        let py = rng.py();
        if !rng.is_instance(GENERATOR.import(py, "numpy.random", "Generator")?)? {
            return Err(wrong_type("rng", "a numpy.random.Generator", rng));
        }
        let bit_generator = rng.getattr(intern!(py, "bit_generator"))?;
        let capsule = bit_generator.getattr(intern!(py, "capsule"))?.cast_into::<PyCapsule>()?;
        let bitgen = capsule.pointer_checked(Some(c"BitGenerator"))?.cast::<bitgen_t>();
        let lock = bit_generator.getattr(intern!(py, "lock"))?;
        lock.call_method0(intern!(py, "acquire"))?;
        Ok(Self { draws: Draws(bitgen), lock, _capsule: capsule, _bit_generator: bit_generator })
    }

    /// The numbers, lent to a computation, which may detach from Python.
    pub fn draws(&mut self) -> &mut Draws {
        &mut self.draws
    }
}

impl UniformStream for Draws {
    #[inline]
    fn next(&mut self) -> f64 {
        let mut number = [0.0];
        self.fill(&mut number);
        number[0]
    }

    #[inline]
    fn fill(&mut self, numbers: &mut [f64]) {
        // SAFETY: NumPy names a capsule "BitGenerator" only if it holds a `bitgen_t`, whose layout
        // is part of its C interface. The capsule and the bit generator are kept alive by the
        // `NumpyStream` that owns or lends `self`, so the pointer and the state behind it are
        // valid; the bit generator's lock is held, so nothing else advances the state meanwhile.
        unsafe {
            let &bitgen_t { next_double, state, .. } = self.0.as_ref();
            for number in numbers {
                *number = next_double(state);
            }
        }
    }
}

impl Drop for NumpyStream<'_> {
    fn drop(&mut self) {
        if let Err(error) = self.lock.call_method0(intern!(self.lock.py(), "release")) {
            error.write_unraisable(self.lock.py(), Some(&self.lock));
        }
    }
}
