//! Inverse_d, the paper's inverse model: the command of the observed effect
//! nearest to the goal, perturbed.

use crate::bounds::{Bounds, UniformStream};
use crate::error::{Error, check_finite, check_length};
use crate::kdtree::NearestNeighbors;

/// A command likely to bring about an effect near `goal`.
///
/// `effects` holds the observed effects, `commands` the motor commands that produced them,
/// row by row in the same order.
///
/// # Errors
/// If nothing was observed yet, `goal` is not a finite point of the effects' dimension,
/// `d` is not in [0, 1], or the sizes do not fit; `stream` is then untouched.
pub fn inverse(
    goal: &[f64],
    d: f64,
    effects: &NearestNeighbors,
    commands: &[f64],
    motor_space: &Bounds,
    stream: &mut (impl UniformStream + ?Sized),
) -> Result<Vec<f64>, Error> {
    check_length("goal", goal, effects.dim())?;
    check_finite("goal", goal, goal.len())?;
    let m = motor_space.dim();
    check_length("commands", commands, effects.len() * m)?;
    let (_, index) = effects.nearest(goal)?;
    let parent = commands.get(index * m..(index + 1) * m).unwrap_or_default();
    motor_space.perturb(parent, d, stream)
}
