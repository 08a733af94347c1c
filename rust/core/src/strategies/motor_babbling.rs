//! MotorBabbling: motor commands at random.

use super::Strategy;
use crate::bounds::UniformStream;
use crate::error::Error;
use crate::history::History;

/// Commands uniform in M: one draw a coordinate.
#[derive(Debug, Clone, Copy, Default)]
pub struct MotorBabbling;

impl Strategy for MotorBabbling {
    fn propose(
        &mut self,
        history: &mut History,
        draws: &mut dyn UniformStream,
        command: &mut [f64],
    ) -> Result<(), Error> {
        history.motor_space().sample_into(command, draws);
        Ok(())
    }

    fn needs_commands(&self) -> bool {
        false
    }
}
