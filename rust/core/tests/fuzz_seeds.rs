//! The laws that the fuzzers check hold for their seeds, in every run of the tests.

use std::fs;
use std::path::Path;

/// What `check` makes of every seed in a folder; those that are broken are named.
fn replay(folder: &str, check: fn(&[u8])) {
    let folder = Path::new(env!("CARGO_MANIFEST_DIR")).join("../../fuzz/seeds").join(folder);
    let mut seeds: Vec<_> =
        fs::read_dir(&folder).unwrap().map(|seed| seed.unwrap().path()).collect();
    seeds.sort();
    assert!(seeds.len() >= 30, "{} seeds in {folder:?}", seeds.len());
    let broken = |seed: &&std::path::PathBuf| {
        let bytes = fs::read(seed).unwrap();
        std::panic::catch_unwind(|| check(&bytes)).is_err()
    };
    let broken: Vec<_> = seeds.iter().filter(broken).collect();
    assert!(broken.is_empty(), "{broken:?}");
}

#[test]
fn in_the_plane() {
    replay("plane", crate::laws::plane::check_bytes);
}

#[test]
fn in_space() {
    replay("space", crate::laws::space::check_bytes);
}
