//! The kernels of divbandit, without Python and without unsafe code.
//!
//! They follow the way data flows through an exploration (Benureau and Oudeyer,
//! ICDL-EpiRob 2015):
//!
//! 1. [`PlanarArm`], an [`Environment`], turns a motor command into an effect; so does an [`ObstructedArm`]
//!    among obstacles, which may push a ball, and a [`Maze`];
//! 2. [`NearestNeighbors`] finds the observed effect nearest to a goal;
//! 3. [`goals`] draw the goal by what is known, and [`inverse`] models turn it into the next motor
//!    command, inside its [`Bounds`];
//! 4. [`strategies`] propose commands in this and other ways, seeing the [`History`] of all that
//!    was observed;
//! 5. [`Coverage`] says how much an effect has newly covered: its gain; [`measures`] are this and
//!    other ways to say how diverse effects are;
//! 6. [`bandits`] let one of several strategies propose, by the rewards that each has earned;
//! 7. [`exploration`] is the loop of all these, run by an [`Exploration`].
//!
//! Everything that decides a trajectory is made of additions, multiplications,
//! divisions and square roots in a fixed order, so that a seed gives the same bits
//! on any machine: no fused multiply-adds, no platform sines.
//!
//! ```
//! use divbandit_core::{Coverage, PlanarArm};
//!
//! let arm = PlanarArm::new(20, 2.6).unwrap();
//! let mut coverage = Coverage::new(0.02, 2).unwrap();
//! let effect = arm.effect(&[0.1; 20]).unwrap();
//! assert!(coverage.add(effect).unwrap() > 0.0);
//! assert_eq!(coverage.add(effect).unwrap(), 0.0);
//! ```

#![forbid(unsafe_code)]
#![deny(missing_docs)]

pub mod arm;
pub mod bandits;
pub mod bounds;
pub mod contact;
pub mod coverage;
pub mod elementary;
pub mod environment;
pub mod error;
pub mod exact_sum;
pub mod exploration;
pub mod goals;
pub mod history;
pub mod instructions;
pub mod inverse;
pub mod kdtree;
pub mod linear_projection;
pub mod maze;
pub mod measures;
pub mod obstructed_arm;
pub mod paths;
mod push_arm;
pub mod shape;
pub mod strategies;
pub mod trig;

pub use arm::PlanarArm;
pub use bounds::{Bounds, UniformStream};
pub use contact::Obstacle;
pub use coverage::Coverage;
pub use environment::Environment;
pub use error::Error;
pub use exact_sum::ExactSum;
pub use exploration::{Composition, Exploration, Proposal};
pub use history::History;
pub use instructions::Instructions;
pub use kdtree::NearestNeighbors;
pub use linear_projection::LinearProjection;
pub use maze::Maze;
pub use obstructed_arm::ObstructedArm;
pub use shape::Shape;
