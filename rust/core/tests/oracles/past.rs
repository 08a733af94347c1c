//! Histories in which something was observed.

use divbandit_core::{Bounds, History};

/// A history of these commands and effects, row by row.
pub fn past(
    motor_space: &Bounds,
    sensory_space: Option<&Bounds>,
    effect_dim: usize,
    commands: &[f64],
    effects: &[f64],
) -> History {
    let (motor_space, sensory_space) = (motor_space.clone(), sensory_space.cloned());
    let m = motor_space.dim();
    let mut history = History::new(motor_space, sensory_space, true, 0).unwrap();
    for (command, effect) in commands.chunks_exact(m).zip(effects.chunks_exact(effect_dim)) {
        history.record(command, effect, &[], &[]).unwrap();
    }
    history
}
