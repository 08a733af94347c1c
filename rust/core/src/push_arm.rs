//! Push arm: an arm among obstacles that pushes a ball; the effect is where the ball ends.
//!
//! The arm moves as it does without the ball. Where a link comes to the ball, the ball gives way: it goes where it is clear
//! of all links and obstacles by the least displacement, without friction and without inertia. Where there
//! is no such place it is pinned, and all stop.

use std::borrow::Borrow;

use parry2d_f64::bounding_volume::{Aabb, BoundingVolume};
use parry2d_f64::math::Vector;
use parry2d_f64::shape::{Capsule, Segment};

use crate::arm::PlanarArm;
use crate::contact::clear::{LEFT, Near, least_displacement};
use crate::contact::gap::{Axis, Gap};
use crate::contact::sweep::{Met, PRECISION, Sweep};
use crate::environment::Environment;
use crate::error::{Error, check_finite};
use crate::obstructed_arm::{ObstructedArm, Room};

/// How far a link goes between two looks at a ball that it pushes, in radii of the ball.
const STEP: f64 = 0.02;

/// How far a ball can get out of the way of one such step, in radii of the ball.
const AWAY: f64 = 0.25;

/// How often a displacement is found anew, as what is near is round.
const LOOKS: usize = 12;

/// A planar arm and a ball.
#[derive(Debug, Clone)]
pub struct PushArm {
    arm: ObstructedArm,
    ball: Vector,
    radius: f64,
}

impl PushArm {
    /// An arm with a ball of this center and radius in its way.
    ///
    /// # Errors
    /// If a number is not finite, `ball_radius` is not from 1e-3 to 1, or the ball touches the arm at rest or an
    /// obstacle.
    pub fn new(arm: ObstructedArm, ball: [f64; 2], ball_radius: f64) -> Result<Self, Error> {
        check_finite("ball", &ball, 2)?;
        if !(1e-3..=1.0).contains(&ball_radius) {
            return Err(Error::Number {
                name: "ball_radius",
                must_be: "from 0.001 to 1",
                got: ball_radius,
            });
        }
        let push = Self { arm, ball: Vector::from(ball), radius: ball_radius };
        let here = Axis::from(Segment::new(push.ball, push.ball));
        let refused = |got: String| {
            let must_be = "clear of the arm at rest and of all obstacles";
            Err(Error::Unfit { name: "ball".to_owned(), must_be, got })
        };
        if let Some(index) = push.arm.sweep().scene.touching(&here, ball_radius + LEFT) {
            return refused(format!("one in contact with obstacles[{index}]"));
        }
        let at_rest = Axis::from(Segment::new(Vector::ZERO, Vector::X));
        let gap = at_rest.offset(push.ball).length();
        if gap <= push.arm.sweep().radius + ball_radius + LEFT {
            return refused(format!("one at {ball:?} in contact with the arm"));
        }
        Ok(push)
    }

    /// The arm.
    #[must_use]
    pub fn arm(&self) -> &ObstructedArm {
        &self.arm
    }

    /// The arm itself, as it is without anything in its way.
    #[must_use]
    pub fn free(&self) -> &PlanarArm {
        self.arm.free()
    }

    /// Where the ball is at first.
    #[must_use]
    pub fn ball(&self) -> [f64; 2] {
        self.ball.into()
    }

    /// The arm, ready to push: many moves need no more memory than one.
    #[must_use]
    pub fn pushing(&self) -> Pushing<&Self> {
        Pushing::from(self)
    }
}

/// An arm that can push, borrowed or owned.
#[derive(Debug)]
pub struct Pushing<Arm> {
    arm: Arm,
    room: Room,
    ball: Vector,
    near: Vec<Near>,
}

impl<Arm: Borrow<PushArm>> From<Arm> for Pushing<Arm> {
    fn from(arm: Arm) -> Self {
        let (room, ball) = (Room::new(arm.borrow().free()), arm.borrow().ball);
        Self { arm, room, ball, near: Vec::new() }
    }
}

impl<Arm: Borrow<PushArm>> Pushing<Arm> {
    /// Where the ball is when the arm has gone from rest towards `command` as far as it can.
    ///
    /// ```
    /// use divbandit_core::{ObstructedArm, PlanarArm, PushArm};
    ///
    /// let arm = ObstructedArm::new(PlanarArm::new(1, 2.0).unwrap(), 0.1, vec![], false).unwrap();
    /// let push = PushArm::new(arm, [0.5, 0.5], 0.1).unwrap();
    /// assert_eq!(push.pushing().effect(&[0.5]).unwrap(), [0.5, 0.5]); // not as far as the ball
    /// let [x, y] = push.pushing().effect(&[1.57]).unwrap();
    /// assert!(x < -0.1 && y > 0.5); // to the left of the upright link
    /// ```
    ///
    /// # Errors
    /// If the command is none of the arm's.
    pub fn effect(&mut self, command: &[f64]) -> Result<[f64; 2], Error> {
        self.progress(command)?;
        Ok(self.ball.into())
    }

    /// The share of the way from rest to `command` that the arm can go; 1 if nothing stops it.
    ///
    /// # Errors
    /// If the command is none of the arm's.
    pub fn progress(&mut self, command: &[f64]) -> Result<f64, Error> {
        self.arm.borrow().arm.check(command)?;
        self.reset();
        Ok(self.go(command, &mut |_, _| ()))
    }

    /// The base, each joint's far end and the tip, where the arm has stopped.
    ///
    /// # Errors
    /// If the command is none of the arm's.
    pub fn posture(&mut self, command: &[f64]) -> Result<Vec<[f64; 2]>, Error> {
        self.progress(command)?;
        self.arm.borrow().free().posture(&self.room.angles)
    }

    /// How the ball moves on the way to `command`: the share of the way and the ball's place, whenever it was looked at.
    ///
    /// # Errors
    /// If the command is none of the arm's.
    pub fn path(&mut self, command: &[f64]) -> Result<Vec<[f64; 3]>, Error> {
        self.arm.borrow().arm.check(command)?;
        self.reset();
        let mut path = vec![[0.0, self.ball.x, self.ball.y]];
        let share = self.go(command, &mut |share, ball| path.push([share, ball.x, ball.y]));
        path.push([share, self.ball.x, self.ball.y]);
        Ok(path)
    }

    /// Where the ball is when the arm has followed a trajectory as far as it can.
    ///
    /// # Errors
    /// If there is no row, a row is cut short, an angle is beyond the limit, or the first row is not all 0.
    pub fn follow(&mut self, trajectory: &[f64]) -> Result<[f64; 2], Error> {
        self.arm.borrow().arm.check_trajectory(trajectory)?;
        self.reset();
        for to in trajectory.chunks(self.room.angles.len()).skip(1) {
            if self.go(to, &mut |_, _| ()) < 1.0 {
                break;
            }
        }
        Ok(self.ball.into())
    }

    /// Brings arm and ball to where they are at first.
    fn reset(&mut self) {
        self.room.angles.fill(0.0);
        self.ball = self.arm.borrow().ball;
    }

    /// Sets out from where the arm is towards other angles; returns the share of the way that it can go.
    fn go(&mut self, to: &[f64], look: &mut dyn FnMut(f64, Vector)) -> f64 {
        let Self { arm, room, ball, near } = self;
        let push: &PushArm = (*arm).borrow();
        room.chain.begin(&room.angles, to);
        let mut way = Way { sweep: push.arm.sweep(), room, ball, radius: push.radius, near };
        let share = way.go(look);
        room.chain.angles(share, &mut room.angles);
        share
    }
}

impl Environment for Pushing<PushArm> {
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

/// A straight line in joint space, with a ball that may be on it.
struct Way<'a> {
    sweep: &'a Sweep,
    room: &'a mut Room,
    ball: &'a mut Vector,
    radius: f64,
    near: &'a mut Vec<Near>,
}

impl Way<'_> {
    /// Goes as far as the arm can; tells `look` of the ball whenever it has moved.
    fn go(&mut self, look: &mut dyn FnMut(f64, Vector)) -> f64 {
        let stop = self.advance(0.0, 1.0, true);
        if stop.1 != Some(Met::Other) {
            return stop.0;
        }
        // How far the arm would get does not depend on the ball.
        let mut share = stop.0;
        let end = self.advance(share, 1.0, false).0;
        loop {
            look(share, *self.ball);
            let Some(next) = self.push(share, end) else { return share };
            share = next;
            if share >= end {
                return end;
            }
            if self.gap() > 10.0 * LEFT {
                share = self.advance(share, end, true).0;
                if share >= end {
                    return end;
                }
            }
        }
    }

    /// Goes on to `end` or the first contact, with the ball or without.
    fn advance(&mut self, start: f64, end: f64, with_ball: bool) -> (f64, Option<Met>) {
        let ball = Capsule::new(*self.ball, *self.ball, self.radius);
        let ball = with_ball.then_some(&ball);
        let stop = self.sweep.advance(&mut self.room.chain, start, end, ball, &mut self.room.safe);
        (stop.share, stop.met)
    }

    /// One step towards `end`, the ball being near; returns how far it came, None if the ball is pinned.
    fn push(&mut self, share: f64, end: f64) -> Option<f64> {
        let mut step = self.step(share).min(end - share);
        loop {
            let next = if share + step < end { share + step } else { end };
            self.room.chain.place(next);
            if let Some(ball) = self.cleared() {
                *self.ball = ball;
                return Some(next);
            }
            step *= 0.5;
            if step < PRECISION {
                return None;
            }
        }
    }

    /// How long a step may be: no link that is near the ball goes far, and none that is not gets there.
    fn step(&mut self, share: f64) -> f64 {
        let chain = &mut self.room.chain;
        chain.place(share);
        let mut step = f64::INFINITY;
        for link in 0..chain.links() {
            let gap =
                chain.axis(link).offset(*self.ball).length() - self.sweep.radius - self.radius;
            let square = |joint: usize| chain.joint(joint).velocity.length_squared();
            let speed = square(link).max(square(link + 1)).sqrt();
            let free = (gap - AWAY * self.radius).max(STEP * self.radius);
            let acceleration = chain.acceleration(0, link + 1);
            step = step.min(Gap { width: free, closing: speed, acceleration }.open_for());
        }
        step
    }

    /// The least gap between the ball and a link, all of which are placed.
    fn gap(&self) -> f64 {
        let chain = &self.room.chain;
        let distances = (0..chain.links()).map(|link| chain.axis(link).offset(*self.ball).length());
        distances.fold(f64::INFINITY, f64::min) - self.sweep.radius - self.radius
    }

    /// Where the ball is clear of the links, as they are placed, and of all obstacles; None if that is too far away.
    fn cleared(&mut self) -> Option<Vector> {
        let mut ball = *self.ball;
        for _ in 0..LOOKS {
            self.look_around(ball);
            if self.near.iter().all(|each| each.gap >= 0.5 * LEFT) {
                return Some(ball);
            }
            ball += least_displacement(self.near)?;
            let moved = (ball - *self.ball).length();
            if moved > AWAY * self.radius || moved.is_nan() {
                return None;
            }
        }
        None
    }

    /// Finds all that is near a ball at this place.
    fn look_around(&mut self, ball: Vector) {
        let (near, radius) = (&mut *self.near, self.radius);
        near.clear();
        let within = 2.0 * AWAY * radius;
        let mut add = |axis: &Axis, apart: f64| {
            let offset = axis.offset(ball);
            let distance = offset.length();
            if distance - apart <= within {
                near.push(Near { normal: offset / distance, gap: distance - apart });
            }
        };
        let chain = &self.room.chain;
        for link in 0..chain.links() {
            add(&chain.axis(link), self.sweep.radius + radius);
        }
        let here = Aabb::new(ball, ball).loosened(radius + within);
        self.sweep.scene.within(&here, |_, piece| add(&piece.axis, piece.radius + radius));
    }
}
