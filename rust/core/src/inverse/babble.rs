//! Random goal babbling, many trials at once: goals and their commands, drawn in turn.

use super::Observed;
use crate::bounds::{Bounds, UniformStream, check_share};
use crate::error::{Error, check_length, reserve};

/// `n` goals uniform in a box, and for each the command that [`inverse`](super::inverse()) makes of
/// it: both row by row.
///
/// The draws are those of as many goals and commands, one after the other.
///
/// # Errors
/// If nothing was observed yet, `d` is not in [0, 1], the sizes do not fit, or there is no memory
/// for so many; `stream` is then untouched.
pub fn babble(
    n: usize,
    goals: &Bounds,
    d: f64,
    observed: &Observed<'_>,
    stream: &mut (impl UniformStream + ?Sized),
) -> Result<(Vec<f64>, Vec<f64>), Error> {
    let (s, motor_space) = (observed.effects.dim(), observed.motor_space);
    let m = motor_space.dim();
    check_length("goals", goals.low(), s)?;
    check_share("d", d)?;
    check_length("commands", observed.commands, observed.effects.len() * m)?;
    if observed.effects.is_empty() {
        return Err(Error::Empty { name: "the set of effects" });
    }
    let (mut drawn, mut commands) = (Vec::new(), Vec::new());
    reserve(&mut drawn, n, s)?;
    reserve(&mut commands, n, m)?;
    drawn.resize(n * s, 0.0);
    commands.resize(n * m, 0.0);
    for (goal, command) in drawn.chunks_exact_mut(s).zip(commands.chunks_exact_mut(m)) {
        goals.sample_into(goal, stream);
        let (_, index) = observed.effects.nearest(goal)?;
        motor_space.perturb_into(command, observed.command(index), d, stream);
    }
    Ok((drawn, commands))
}
