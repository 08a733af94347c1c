//! Obstructed arm: a planar arm with thick links that stops where it touches something.
//!
//! It sets out from rest, all angles 0, along a straight line in joint space, or follows a trajectory of
//! such lines. At the first contact of a link with an obstacle, or with another link, it stops: the effect is where the tip
//! is then.

use std::borrow::Borrow;

use crate::arm::PlanarArm;
use crate::contact::Obstacle;
use crate::contact::chain::Chain;
use crate::contact::scene::Scene;
use crate::contact::sweep::Sweep;
use crate::environment::Environment;
use crate::error::{Error, check_length, check_rows};

/// The thinnest arm, in metres: the directions of shorter gaps would be noise.
const THINNEST: f64 = 1e-6;

/// A planar arm of total length 1 among obstacles.
#[derive(Debug, Clone)]
pub struct ObstructedArm {
    arm: PlanarArm,
    thickness: f64,
    sweep: Sweep,
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
        if !(THINNEST..length).contains(&thickness) {
            return Err(Error::Number {
                name: "thickness",
                must_be: "at least 1e-6 and less than a link is long, 1 / joints",
                got: thickness,
            });
        }
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
        Ok(Self { arm, thickness, sweep: Sweep { scene, radius, self_contact } })
    }

    /// The arm itself, as it is without obstacles.
    #[must_use]
    pub fn free(&self) -> &PlanarArm {
        &self.arm
    }

    /// How thick the links are.
    #[must_use]
    pub fn thickness(&self) -> f64 {
        self.thickness
    }

    /// What is in its way.
    #[must_use]
    pub fn obstacles(&self) -> &[Obstacle] {
        self.sweep.scene.obstacles()
    }

    /// Whether links that are no neighbours stop each other.
    #[must_use]
    pub fn self_contact(&self) -> bool {
        self.sweep.self_contact
    }

    /// The arm, ready to move: many moves need no more memory than one.
    #[must_use]
    pub fn moving(&self) -> Moving<&Self> {
        Moving::from(self)
    }
}

/// An obstructed arm that can move, borrowed or owned.
#[derive(Debug)]
pub struct Moving<Arm> {
    arm: Arm,
    room: Room,
}

impl<Arm: Borrow<ObstructedArm>> From<Arm> for Moving<Arm> {
    fn from(arm: Arm) -> Self {
        Self { room: Room::new(&arm.borrow().arm), arm }
    }
}

impl<Arm: Borrow<ObstructedArm>> Moving<Arm> {
    /// Where the tip is when the arm has gone from rest towards `command` as far as it can.
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
        let share = self.progress(command)?;
        self.room.chain.angles(share, &mut self.room.angles);
        self.arm.borrow().arm.effect(&self.room.angles)
    }

    /// The share of the way from rest to `command` that the arm can go; 1 if nothing stops it.
    ///
    /// # Errors
    /// If the command is none of the arm's.
    pub fn progress(&mut self, command: &[f64]) -> Result<f64, Error> {
        let arm = self.arm.borrow();
        arm.check(command)?;
        self.room.angles.fill(0.0);
        Ok(self.room.advance(&arm.sweep, command))
    }

    /// The base, each joint's far end and the tip, where the arm has stopped.
    ///
    /// # Errors
    /// If the command is none of the arm's.
    pub fn posture(&mut self, command: &[f64]) -> Result<Vec<[f64; 2]>, Error> {
        let share = self.progress(command)?;
        self.room.chain.angles(share, &mut self.room.angles);
        self.arm.borrow().arm.posture(&self.room.angles)
    }

    /// Where the tip is when the arm has followed a trajectory as far as it can.
    ///
    /// `trajectory` holds postures, rows of one angle a joint, the first of them rest; the arm goes along straight
    /// lines between them.
    ///
    /// # Errors
    /// If there is no row, a row is cut short, an angle is beyond the limit, or the first row is not all 0.
    pub fn follow(&mut self, trajectory: &[f64]) -> Result<[f64; 2], Error> {
        let arm = self.arm.borrow();
        arm.check_trajectory(trajectory)?;
        self.room.angles.fill(0.0);
        for to in trajectory.chunks(arm.arm.joints()).skip(1) {
            let share = self.room.advance(&arm.sweep, to);
            self.room.chain.angles(share, &mut self.room.angles);
            if share < 1.0 {
                break;
            }
        }
        arm.arm.effect(&self.room.angles)
    }
}

impl ObstructedArm {
    pub(crate) fn sweep(&self) -> &Sweep {
        &self.sweep
    }

    pub(crate) fn check(&self, command: &[f64]) -> Result<(), Error> {
        check_length("command", command, self.arm.joints())?;
        self.arm.check("command", command)
    }

    pub(crate) fn check_trajectory(&self, trajectory: &[f64]) -> Result<(), Error> {
        let joints = self.arm.joints();
        if trajectory.is_empty() {
            return Err(Error::Empty { name: "trajectory" });
        }
        check_rows("trajectory", trajectory, joints)?;
        self.arm.check("trajectory", trajectory)?;
        match trajectory[..joints].iter().position(|&angle| angle != 0.0) {
            None => Ok(()),
            Some(index) => Err(Error::Element {
                name: "trajectory",
                at: format!("[0, {index}]"),
                must_be: "0, as the arm begins at rest".to_owned(),
                got: trajectory[index],
            }),
        }
    }
}

impl Environment for Moving<ObstructedArm> {
    fn motor_dim(&self) -> usize {
        self.arm.arm.joints()
    }

    fn effect_dim(&self) -> usize {
        2
    }

    fn effect_into(&mut self, command: &[f64], effect: &mut [f64]) -> Result<(), Error> {
        effect.copy_from_slice(&self.effect(command)?);
        Ok(())
    }
}

/// The memory that a move needs.
#[derive(Debug)]
pub(crate) struct Room {
    pub chain: Chain,
    /// Where the arm is.
    pub angles: Vec<f64>,
    pub safe: Vec<f64>,
}

impl Room {
    pub fn new(arm: &PlanarArm) -> Self {
        let none = vec![0.0; arm.joints()];
        let chain = Chain::new(arm.joints(), arm.dispatch());
        Self { chain, angles: none.clone(), safe: none }
    }

    /// Sets out from where the arm is towards other angles; returns the share of the way that it can go.
    fn advance(&mut self, sweep: &Sweep, to: &[f64]) -> f64 {
        self.chain.begin(&self.angles, to);
        sweep.advance(&mut self.chain, 0.0, 1.0, None, &mut self.safe).share
    }
}
