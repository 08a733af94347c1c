//! Obstructed arm: a planar arm with thick links that stops where it touches something.
//!
//! It sets out from rest, all angles 0, along a straight line in joint space, or follows a trajectory of
//! such lines. At the first contact of a link with an obstacle, or with another link, it stops: the effect is where the tip
//! is then.

use std::borrow::Cow;

use parry2d_f64::math::Vector;

use crate::arm::PlanarArm;
use crate::contact::Obstacle;
use crate::contact::chain::Chain;
use crate::contact::clear::Near;
use crate::contact::scene::Scene;
use crate::contact::sweep::Sweep;
use crate::environment::Environment;
use crate::error::{Error, check_length, check_number, check_rows};
use crate::push_arm::{Ball, Pushing};

/// The thinnest arm, in metres: the directions of shorter gaps would be noise.
const THINNEST: f64 = 1e-6;

/// A planar arm of total length 1 among obstacles.
#[derive(Debug, Clone)]
pub struct ObstructedArm {
    arm: PlanarArm,
    pub(crate) sweep: Sweep,
    /// What it pushes, if anything.
    pub(crate) ball: Option<Ball>,
}

impl ObstructedArm {
    /// An arm whose links are as thick as `thickness`, with rounded ends, among `obstacles`.
    ///
    /// # Errors
    /// If `thickness` is not at least 1e-6 and less than a link is long, or the arm at rest touches an
    /// obstacle.
    pub fn new(
        arm: PlanarArm,
        thickness: f64,
        obstacles: Vec<Obstacle>,
        self_contact: bool,
    ) -> Result<Self, Error> {
        let length = 1.0 / arm.joints() as f64;
        let must_be = "at least 1e-6 and less than a link is long, 1 / joints";
        let is_right = (THINNEST..length).contains(&thickness);
        check_number("thickness", thickness, is_right, must_be)?;
        let radius = 0.5 * thickness;
        let scene = Scene::new(obstacles);
        let mut chain = Chain::new(arm.joints(), arm.dispatch());
        chain.place(0.0);
        let touching = |link: usize| Some((link, scene.touching(&chain.axis(link), radius)?));
        if let Some((link, index)) = (0..arm.joints()).find_map(touching) {
            return Err(Error::Unfit {
                name: format!("obstacles[{index}]"),
                must_be: "clear of the arm at rest",
                got: format!("one in contact with link {link}"),
            });
        }
        Ok(Self { arm, sweep: Sweep { scene, radius, self_contact }, ball: None })
    }

    /// The arm itself, as it is without anything in its way.
    #[must_use]
    pub fn free(&self) -> &PlanarArm {
        &self.arm
    }

    /// The arm, ready to move: many moves need no more memory than one.
    #[must_use]
    pub fn moving(&self) -> Moving<'_> {
        Moving::of(Cow::Borrowed(self))
    }
}

/// An obstructed arm that can move, borrowed or owned. Its effect is where the ball ends, if there is one; else the tip.
#[derive(Debug)]
pub struct Moving<'a> {
    arm: Cow<'a, ObstructedArm>,
    room: Room,
}

/// The memory that a move needs.
#[derive(Debug)]
pub(crate) struct Room {
    pub chain: Chain,
    /// Where the arm is.
    angles: Vec<f64>,
    pub safe: Vec<f64>,
    /// Where the ball is,
    pub ball: Vector,
    /// and what is near it.
    pub near: Vec<Near>,
}

impl From<ObstructedArm> for Moving<'_> {
    fn from(arm: ObstructedArm) -> Self {
        Self::of(Cow::Owned(arm))
    }
}

impl<'a> Moving<'a> {
    fn of(arm: Cow<'a, ObstructedArm>) -> Self {
        let joints = arm.arm.joints();
        let room = Room {
            chain: Chain::new(joints, arm.arm.dispatch()),
            angles: vec![0.0; joints],
            safe: vec![0.0; joints],
            ball: Vector::ZERO,
            near: Vec::new(),
        };
        Self { arm, room }
    }

    /// What is where it ends when the arm has gone from rest towards `command` as far as it can: the tip, or the ball.
    ///
    /// ```
    /// use divbandit_core::{Obstacle, ObstructedArm, PlanarArm};
    ///
    /// let post = Obstacle::disc([0.0, 0.5], 0.1).unwrap();
    /// let arm = ObstructedArm::new(PlanarArm::new(1, 2.0).unwrap(), 0.1, vec![post], false).unwrap();
    /// // The link would point up and is stopped where its side touches the disc.
    /// let angle = (std::f64::consts::FRAC_PI_2 - (0.15_f64 / 0.5).asin());
    /// let tip = arm.moving().effect(&[1.6]).unwrap();
    /// assert!((tip[0] - angle.cos()).abs() < 1e-9 && (tip[1] - angle.sin()).abs() < 1e-9);
    /// ```
    ///
    /// # Errors
    /// If the command is none of the arm's.
    pub fn effect(&mut self, command: &[f64]) -> Result<[f64; 2], Error> {
        self.progress(command)?;
        self.outcome()
    }

    /// The share of the way from rest to `command` that the arm can go; 1 if nothing stops it.
    ///
    /// # Errors
    /// If the command is none of the arm's.
    pub fn progress(&mut self, command: &[f64]) -> Result<f64, Error> {
        self.check(command)?;
        self.rest();
        Ok(self.go(command, &mut |_, _| ()))
    }

    /// The base, each joint's far end and the tip, where the arm has stopped.
    ///
    /// # Errors
    /// If the command is none of the arm's.
    pub fn posture(&mut self, command: &[f64]) -> Result<Vec<[f64; 2]>, Error> {
        self.progress(command)?;
        self.arm.arm.posture(&self.room.angles)
    }

    /// How the ball moves on the way to `command`: the share of the way and the ball's place, whenever it was looked at.
    ///
    /// # Errors
    /// If the command is none of the arm's.
    pub fn path(&mut self, command: &[f64]) -> Result<Vec<[f64; 3]>, Error> {
        self.check(command)?;
        self.rest();
        let at = |share, ball: Vector| [share, ball.x, ball.y];
        let mut path = vec![at(0.0, self.room.ball)];
        let share = self.go(command, &mut |share, ball| path.push(at(share, ball)));
        path.push(at(share, self.room.ball));
        Ok(path)
    }

    /// What is where it ends when the arm has followed a trajectory as far as it can: the tip, or the ball.
    ///
    /// `trajectory` holds postures, rows of one angle a joint, the first of them rest; the arm goes along straight
    /// lines between them.
    ///
    /// # Errors
    /// If there is no row, a row is cut short, an angle is beyond the limit, or the first row is not all 0.
    pub fn follow(&mut self, trajectory: &[f64]) -> Result<[f64; 2], Error> {
        let (arm, joints) = (&self.arm.arm, self.arm.arm.joints());
        if trajectory.is_empty() {
            return Err(Error::Empty { name: "trajectory" });
        }
        check_rows("trajectory", trajectory, joints)?;
        arm.check("trajectory", trajectory)?;
        let start = &trajectory[..joints];
        if let Some(index) = start.iter().position(|&angle| angle != 0.0) {
            let (at, must_be) =
                (format!("[0, {index}]"), "0, as the arm begins at rest".to_owned());
            return Err(Error::Element { name: "trajectory", at, must_be, got: start[index] });
        }
        self.rest();
        for to in trajectory.chunks(joints).skip(1) {
            if self.go(to, &mut |_, _| ()) < 1.0 {
                break;
            }
        }
        self.outcome()
    }

    fn check(&self, command: &[f64]) -> Result<(), Error> {
        check_length("command", command, self.arm.arm.joints())?;
        self.arm.arm.check("command", command)
    }

    /// Brings arm and ball to where they are at first.
    fn rest(&mut self) {
        self.room.angles.fill(0.0);
        self.room.ball = self.arm.ball.map_or(Vector::ZERO, |ball| ball.center);
    }

    /// Sets out from where the arm is towards other angles; returns the share of the way that it can go.
    fn go(&mut self, to: &[f64], look: &mut dyn FnMut(f64, Vector)) -> f64 {
        let (sweep, room) = (&self.arm.sweep, &mut self.room);
        room.chain.begin(&room.angles, to);
        let share = match self.arm.ball {
            None => sweep.advance(&mut room.chain, 0.0, 1.0, None, &mut room.safe).share,
            Some(Ball { radius, .. }) => Pushing { sweep, room, radius }.go(look),
        };
        room.chain.angles(share, &mut room.angles);
        share
    }

    fn outcome(&self) -> Result<[f64; 2], Error> {
        match self.arm.ball {
            None => self.arm.arm.effect(&self.room.angles),
            Some(_) => Ok(self.room.ball.into()),
        }
    }
}

impl Environment for Moving<'_> {
    fn motor_dim(&self) -> usize {
        self.room.angles.len()
    }

    fn effect_dim(&self) -> usize {
        2
    }

    fn effect_into(&mut self, command: &[f64], effect: &mut [f64]) -> Result<(), Error> {
        effect.copy_from_slice(&self.effect(command)?);
        Ok(())
    }
}
