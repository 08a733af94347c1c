//! Push arm: an arm among obstacles that pushes a ball; the effect is where the ball ends.
//!
//! The arm moves as it does without the ball. Where a link comes to the ball, the ball gives way: it goes where it is clear
//! of all links and obstacles by the least displacement, without friction and without inertia. Where there
//! is no such place it is pinned, and all stop.

use parry2d_f64::bounding_volume::{Aabb, BoundingVolume};
use parry2d_f64::math::Vector;
use parry2d_f64::shape::{Capsule, Segment};

use crate::contact::clear::{LEFT, Near, least_displacement};
use crate::contact::gap::{Axis, Gap};
use crate::contact::sweep::{Met, PRECISION, Stop, Sweep};
use crate::error::{Error, check_finite, check_number};
use crate::obstructed_arm::{ObstructedArm, Room};

/// How far a link goes between two looks at a ball that it pushes, in radii of the ball.
const STEP: f64 = 0.02;

/// How far a ball can get out of the way of one such step, in radii of the ball.
const AWAY: f64 = 0.25;

/// How often a displacement is found anew, as what is near is round.
const LOOKS: usize = 12;

/// What is pushed.
#[derive(Debug, Clone, Copy)]
pub(crate) struct Ball {
    /// Where it is at first.
    pub center: Vector,
    pub radius: f64,
}

impl ObstructedArm {
    /// The same arm with a ball of this center and radius in its way.
    ///
    /// ```
    /// use divbandit_core::{ObstructedArm, PlanarArm};
    ///
    /// let arm = ObstructedArm::new(PlanarArm::new(1, 2.0).unwrap(), 0.1, vec![], false).unwrap();
    /// let push = arm.pushing([0.5, 0.5], 0.1).unwrap();
    /// assert_eq!(push.moving().effect(&[0.5]).unwrap(), [0.5, 0.5]); // not as far as the ball
    /// let [x, y] = push.moving().effect(&[1.57]).unwrap();
    /// assert!(x < -0.1 && y > 0.5); // to the left of the upright link
    /// ```
    ///
    /// # Errors
    /// If a number is not finite, `ball_radius` is not from 1e-3 to 1, or the ball touches the arm at rest or an
    /// obstacle.
    pub fn pushing(mut self, ball: [f64; 2], ball_radius: f64) -> Result<Self, Error> {
        check_finite("ball", &ball, 2)?;
        let is_right = (1e-3..=1.0).contains(&ball_radius);
        check_number("ball_radius", ball_radius, is_right, "from 0.001 to 1")?;
        let center = Vector::from(ball);
        let here = Axis::from(Segment::new(center, center));
        let refused = |got: String| {
            let must_be = "clear of the arm at rest and of all obstacles";
            Err(Error::Unfit { name: "ball".to_owned(), must_be, got })
        };
        if let Some(index) = self.sweep.scene.touching(&here, ball_radius + LEFT) {
            return refused(format!("one in contact with obstacles[{index}]"));
        }
        let at_rest = Axis::from(Segment::new(Vector::ZERO, Vector::X));
        if at_rest.offset(center).length() <= self.sweep.radius + ball_radius + LEFT {
            return refused(format!("one at {ball:?} in contact with the arm"));
        }
        self.ball = Some(Ball { center, radius: ball_radius });
        Ok(self)
    }
}

/// A move along a straight line in joint space, with a ball that may be on it.
pub(crate) struct Pushing<'a> {
    pub sweep: &'a Sweep,
    pub room: &'a mut Room,
    /// The ball's.
    pub radius: f64,
}

impl Pushing<'_> {
    /// Goes as far as the arm can; tells `look` of the ball whenever it has moved.
    pub fn go(&mut self, look: &mut dyn FnMut(f64, Vector)) -> f64 {
        let Stop { mut share, met } = self.advance(0.0, 1.0, true);
        if met != Some(Met::Other) {
            return share;
        }
        // How far the arm would get does not depend on the ball.
        let end = self.advance(share, 1.0, false).share;
        loop {
            look(share, self.room.ball);
            let Some(next) = self.push(share, end) else { return share };
            share = next;
            if share < end && (0..self.room.chain.links()).all(|link| self.gap(link) > 10.0 * LEFT)
            {
                share = self.advance(share, end, true).share;
            }
            if share >= end {
                return end;
            }
        }
    }

    /// Goes on to `end` or the first contact, with the ball or without.
    fn advance(&mut self, start: f64, end: f64, with_ball: bool) -> Stop {
        let ball = Capsule::new(self.room.ball, self.room.ball, self.radius);
        let ball = with_ball.then_some(&ball);
        self.sweep.advance(&mut self.room.chain, start, end, ball, &mut self.room.safe)
    }

    /// One step towards `end`, the ball being near; returns how far it came, None if the ball is pinned.
    fn push(&mut self, share: f64, end: f64) -> Option<f64> {
        let mut step = self.step(share).min(end - share);
        loop {
            let next = if share + step < end { share + step } else { end };
            self.room.chain.place(next);
            if let Some(ball) = self.cleared() {
                self.room.ball = ball;
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
        self.room.chain.place(share);
        let chain = &self.room.chain;
        let longest = |link: usize| {
            let [one, other] =
                [link, link + 1].map(|joint| chain.joints[joint].velocity.length_squared());
            let width = (self.gap(link) - AWAY * self.radius).max(STEP * self.radius);
            let (closing, acceleration) = (one.max(other).sqrt(), chain.acceleration(0, link + 1));
            Gap { width, closing, acceleration }.open_for()
        };
        (0..chain.links()).map(longest).fold(f64::INFINITY, f64::min)
    }

    /// The gap between the ball and a link, which is placed.
    fn gap(&self, link: usize) -> f64 {
        let distance = self.room.chain.axis(link).offset(self.room.ball).length();
        distance - self.sweep.radius - self.radius
    }

    /// Where the ball is clear of the links, as they are placed, and of all obstacles; None if that is too far away.
    fn cleared(&mut self) -> Option<Vector> {
        let mut ball = self.room.ball;
        for _ in 0..LOOKS {
            self.look_around(ball);
            if self.room.near.iter().all(|each| each.gap >= 0.5 * LEFT) {
                return Some(ball);
            }
            ball += least_displacement(&self.room.near)?;
            let moved = (ball - self.room.ball).length();
            if moved > AWAY * self.radius || moved.is_nan() {
                return None;
            }
        }
        None
    }

    /// Finds all that is near a ball at this place.
    fn look_around(&mut self, ball: Vector) {
        let (Room { chain, near, .. }, radius) = (&mut *self.room, self.radius);
        near.clear();
        let within = 2.0 * AWAY * radius;
        let mut add = |axis: &Axis, apart: f64| {
            let offset = axis.offset(ball);
            let distance = offset.length();
            if distance - apart <= within {
                near.push(Near { normal: offset / distance, gap: distance - apart });
            }
        };
        for link in 0..chain.links() {
            add(&chain.axis(link), self.sweep.radius + radius);
        }
        let here = Aabb::new(ball, ball).loosened(radius + within);
        self.sweep.scene.within(&here, |_, piece| add(&piece.axis, piece.radius + radius));
    }
}
