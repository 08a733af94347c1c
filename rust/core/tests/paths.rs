//! The tree of paths equals a plain list of paths.

use crate::oracles::fixed;
use divbandit_core::paths::{Paths, ROOT};
use proptest::prelude::*;

proptest! {
    #![proptest_config(fixed(200))]

    #[test]
    fn a_path_is_the_same_branch_whenever_it_is_taken(
        all in prop::collection::vec(prop::collection::vec(0..4_u32, 0..6), 1..60),
    ) {
        let mut paths = Paths::default();
        let ends: Vec<u32> = all.iter().map(|path| paths.of(path)).collect();
        for (path, &end) in all.iter().zip(&ends) {
            for (other, &its) in all.iter().zip(&ends) {
                prop_assert_eq!(end == its, path == other);
            }
            // Once more, and index by index.
            prop_assert_eq!(paths.of(path), end);
            prop_assert_eq!(path.iter().fold(ROOT, |node, &index| paths.child(node, index)), end);
            prop_assert_eq!(paths.length(end), path.len());
            let mut row = [7; 8];
            paths.write(end, &mut row);
            let mut expected: Vec<i64> = path.iter().copied().map(i64::from).collect();
            expected.resize(8, -1);
            prop_assert_eq!(&row[..], expected);
        }
    }
}

#[test]
fn the_empty_path_is_the_root() {
    let mut paths = Paths::default();
    assert_eq!((paths.of(&[]), paths.length(ROOT)), (ROOT, 0));
    paths.write(ROOT, &mut []);
    // The largest index that there can be.
    let end = paths.of(&[u32::MAX]);
    let mut row = [0];
    paths.write(end, &mut row);
    assert_eq!(row, [i64::from(u32::MAX)]);
}
