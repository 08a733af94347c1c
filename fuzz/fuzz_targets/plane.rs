//! Growing unions of discs in the plane, from any bytes: do all laws hold?

#![no_main]

#[path = "../../rust/core/tests/laws/mod.rs"]
mod laws;
#[path = "../../rust/core/tests/oracles/mod.rs"]
mod oracles;

use libfuzzer_sys::fuzz_target;

fuzz_target!(|bytes: &[u8]| laws::plane::check_bytes(bytes));
