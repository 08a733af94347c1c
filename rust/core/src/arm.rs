//! Forward kinematics of a planar arm: the paper's environment.
//!
//! The arm has equal segments of total length 1 and its base at the origin. A command holds
//! one angle a joint, in radians, each relative to the segment before; with all of them 0
//! the arm lies along +x. The effect is the tip's position.

use crate::environment::Environment;
use crate::error::{Error, check_each, check_finite, check_length, check_number, check_rows};
use crate::instructions::{Dispatch, Instructions};
use crate::trig::{MAX_ANGLE, sin_cos};

/// How many angles go through the sines at once: one 512-bit or two 256-bit registers.
const LANES: usize = 8;

/// How many segments of one arm are laid at once. A vector cannot be loaded before the numbers in it
/// have left for the cache: 20 joints take 102 ns with 8, 77 with 16, 54 with 24 and 57 with 32 at once.
const SEGMENTS: usize = 24;

/// The longest chain: bent by pi at every joint it stays within the accurate sines.
const MAX_JOINTS: usize = 100_000;

/// A planar arm of total length 1.
#[derive(Debug, Clone, PartialEq)]
pub struct PlanarArm {
    joints: usize,
    limit: f64,
    dispatch: Dispatch,
}

impl PlanarArm {
    /// An arm of `joints` joints, each limited to [-`limit`, `limit`] radians.
    ///
    /// # Errors
    /// If `joints` is not from 1 to 100,000, `limit` is not positive and finite, or a fully bent arm would turn
    /// by more than 1e6 radians.
    pub fn new(joints: usize, limit: f64) -> Result<Self, Error> {
        if !(1..=MAX_JOINTS).contains(&joints) {
            let must_be = format!("from 1 to {MAX_JOINTS}");
            return Err(Error::Count { name: "joints", must_be, got: joints });
        }
        let is_right = limit > 0.0 && limit.is_finite();
        check_number("limit", limit, is_right, "positive and finite (radians)")?;
        let must_be = "at most 1e6 radians over all joints together";
        check_number("limit", limit, joints as f64 * limit <= MAX_ANGLE, must_be)?;
        Ok(Self { joints, limit, dispatch: Dispatch::widest() })
    }

    /// The same arm, reckoned with these vector instructions in place of the widest that the CPU
    /// has; None where it does not have them. Effects have the same bits with all of them.
    ///
    /// ```
    /// use divbandit_core::{Instructions, PlanarArm};
    ///
    /// let arm = PlanarArm::new(3, 1.0).unwrap();
    /// let plain = arm.clone().using(Instructions::Baseline).unwrap();
    /// assert_eq!(plain.effect(&[0.1, 0.2, 0.3]), arm.effect(&[0.1, 0.2, 0.3]));
    /// ```
    #[must_use]
    pub fn using(self, instructions: Instructions) -> Option<Self> {
        Dispatch::to(instructions).map(|dispatch| Self { dispatch, ..self })
    }

    /// The number of joints, which is the dimension of the motor space.
    #[must_use]
    pub fn joints(&self) -> usize {
        self.joints
    }

    /// Every joint's limit, in radians.
    #[must_use]
    pub fn limit(&self) -> f64 {
        self.limit
    }

    /// The tip's position for one command.
    ///
    /// # Errors
    /// If the command has not one angle a joint, or one of them is not finite or beyond the
    /// limit.
    pub fn effect(&self, command: &[f64]) -> Result<[f64; 2], Error> {
        check_length("command", command, self.joints)?;
        self.check("command", command)?;
        Ok(self.dispatch.run(
            #[inline(always)]
            || {
                let mut tip = Tip::default();
                for angles in command.chunks(SEGMENTS) {
                    tip.extend(angles);
                }
                tip.over(self.joints)
            },
        ))
    }

    /// The tips' positions for many commands, row by row: `effects` gets x and y of each.
    ///
    /// Works on eight samples side by side; a sample's additions keep the order they have
    /// in [`effect`](Self::effect), so both give the same bits.
    ///
    /// # Errors
    /// As [`effect`](Self::effect), or if `effects` has not two numbers for each command.
    pub fn effects(&self, commands: &[f64], effects: &mut [f64]) -> Result<(), Error> {
        check_rows("commands", commands, self.joints)?;
        check_length("effects", effects, commands.len() / self.joints * 2)?;
        self.check("commands", commands)?;
        let joints = self.joints;
        self.dispatch.run(
            #[inline(always)]
            || {
                for (rows, tips) in
                    commands.chunks(LANES * joints).zip(effects.chunks_mut(LANES * 2))
                {
                    let samples = tips.len() / 2;
                    let (mut angle, mut x, mut y) = ([0.0; LANES], [0.0; LANES], [0.0; LANES]);
                    for joint in 0..joints {
                        for sample in 0..samples {
                            angle[sample] += rows[sample * joints + joint];
                        }
                        let (sines, cosines) = sin_cos(angle);
                        for lane in 0..LANES {
                            x[lane] += cosines[lane];
                            y[lane] += sines[lane];
                        }
                    }
                    for sample in 0..samples {
                        tips[2 * sample] = x[sample] / joints as f64;
                        tips[2 * sample + 1] = y[sample] / joints as f64;
                    }
                }
            },
        );
        Ok(())
    }

    /// The positions of the base, of each joint's far end and, last, of the tip.
    ///
    /// # Errors
    /// As [`effect`](Self::effect).
    pub fn posture(&self, command: &[f64]) -> Result<Vec<[f64; 2]>, Error> {
        check_length("command", command, self.joints)?;
        self.check("command", command)?;
        let mut tip = Tip::default();
        let mut points = vec![[0.0, 0.0]];
        for angle in command {
            tip.extend(std::slice::from_ref(angle));
            points.push(tip.over(self.joints));
        }
        Ok(points)
    }

    /// Which instructions it takes.
    pub(crate) fn dispatch(&self) -> Dispatch {
        self.dispatch
    }

    /// Checks every angle against the limit; a NaN fails it as well.
    ///
    /// # Errors
    /// Naming the first that is not finite or beyond the limit.
    pub fn check(&self, name: &'static str, angles: &[f64]) -> Result<(), Error> {
        // One pass without an early exit is vector code; the exact culprit is looked for
        // only when there is one.
        let within = angles.iter().fold(true, |all, angle| all & (angle.abs() <= self.limit));
        if within {
            return Ok(());
        }
        check_finite(name, angles, self.joints)?;
        let must_be = format_args!("within the joint's limit of +-{:?} radians", self.limit);
        check_each(name, angles, self.joints, must_be, |angle| angle.abs() <= self.limit)
    }
}

impl Environment for PlanarArm {
    fn motor_dim(&self) -> usize {
        self.joints
    }

    fn effect_dim(&self) -> usize {
        2
    }

    fn effect_into(&mut self, command: &[f64], effect: &mut [f64]) -> Result<(), Error> {
        effect.copy_from_slice(&self.effect(command)?);
        Ok(())
    }
}

/// The tip of the segments laid so far, in units of a segment.
#[derive(Default)]
struct Tip {
    angle: f64,
    x: f64,
    y: f64,
}

impl Tip {
    /// Lays up to `SEGMENTS` further segments.
    #[inline(always)]
    fn extend(&mut self, angles: &[f64]) {
        let mut totals = [[0.0; LANES]; SEGMENTS / LANES];
        let (mut sines, mut cosines) = (totals, totals);
        for (total, angle) in totals.as_flattened_mut().iter_mut().zip(angles) {
            self.angle += angle;
            *total = self.angle;
        }
        let used = angles.len().div_ceil(LANES);
        for ((&total, sines), cosines) in totals[..used].iter().zip(&mut sines).zip(&mut cosines) {
            (*sines, *cosines) = sin_cos(total);
        }
        for ((&sine, &cosine), _) in
            sines.as_flattened().iter().zip(cosines.as_flattened()).zip(angles)
        {
            self.x += cosine;
            self.y += sine;
        }
    }

    /// The position for segments of length 1 / `joints`.
    #[inline(always)]
    fn over(&self, joints: usize) -> [f64; 2] {
        [self.x / joints as f64, self.y / joints as f64]
    }
}
