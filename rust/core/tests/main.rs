//! All tests of the kernels from outside, in one program: it is compiled and linked once.

mod arm;
mod arm_errors;
mod ask_and_tell;
mod contact;
mod coverage;
mod coverage_area;
mod coverage_boundary;
mod coverage_boundary_laws;
mod coverage_delaunay;
mod coverage_found;
mod coverage_motions;
mod coverage_near_touching;
mod coverage_points;
mod coverage_two_discs;
#[path = "oracles/delaunay/mod.rs"]
mod delaunay; // apart from the other oracles: the fuzzers do without spade
mod dispatch;
mod estimate;
mod estimate_honesty;
mod exact_sum;
mod exploration;
mod exploration_errors;
mod fuzz_seeds;
mod goals;
mod inverse;
mod inverse_models;
mod inverse_uniform;
mod kdtree;
mod kdtree_depth;
mod kdtree_errors;
mod laws;
mod measures;
mod oracles;
mod paths;
mod policies;
mod runs;
mod space;
mod space_volume;
mod towards;
mod window;
