//! Chain: the links of an arm as they go along a straight line in joint space.
//!
//! On such a line each link's direction turns at a constant rate r_k, so that the far end of link i moves with
//! the velocity L sum r_k u'(phi_k) over k <= i, and its acceleration is never more than L sum r_k^2.

use parry2d_f64::math::Vector;

use super::gap::Axis;
use crate::instructions::Dispatch;
use crate::trig::sin_cos;

/// How many angles go through the sines at once.
const LANES: usize = 8;

/// A joint at some moment.
#[derive(Debug, Clone, Copy, Default)]
pub(crate) struct Joint {
    /// Where it is, in metres,
    pub at: Vector,
    /// and how that changes.
    pub velocity: Vector,
    /// The direction of the link that begins there.
    pub direction: Vector,
}

/// How a joint and its link turn on the way.
#[derive(Debug, Clone, Copy, Default)]
struct Turn {
    /// The joint's angle at first, in radians,
    from: f64,
    /// and at last.
    to: f64,
    /// How fast the link's direction turns, in radians a unit of the way.
    rate: f64,
}

/// What a joint never exceeds on the way.
#[derive(Debug, Clone, Copy, Default)]
struct Bounds {
    /// In metres a unit of the way.
    speed: f64,
    /// In metres a unit of the way squared.
    acceleration: f64,
}

/// Joints on their way; the base is joint 0, and the tip is counted as one.
#[derive(Debug, Clone)]
pub(crate) struct Chain {
    /// The instructions that it is laid with.
    pub dispatch: Dispatch,
    turns: Vec<Turn>,
    bounds: Vec<Bounds>,
    /// How long a link is.
    length: f64,
    /// The angles of the links' directions.
    totals: Vec<[f64; LANES]>,
    /// The joints, where they were placed last.
    pub joints: Vec<Joint>,
}

impl Chain {
    /// Of so many links, at least one, all at rest.
    pub fn new(joints: usize, dispatch: Dispatch) -> Self {
        Self {
            dispatch,
            turns: vec![Turn::default(); joints],
            bounds: vec![Bounds::default(); joints + 1],
            length: 1.0 / joints as f64,
            totals: vec![[0.0; LANES]; joints.div_ceil(LANES)],
            joints: vec![Joint::default(); joints + 1],
        }
    }

    /// Sets out from some angles to others, one a joint.
    pub fn begin(&mut self, from: &[f64], to: &[f64]) {
        let mut rate = 0.0;
        let mut bounds = Bounds::default();
        for (joint, (&from, &to)) in from.iter().zip(to).enumerate() {
            rate += to - from;
            self.turns[joint] = Turn { from, to, rate };
            bounds.speed += self.length * rate.abs();
            bounds.acceleration += self.length * (rate * rate);
            self.bounds[joint + 1] = bounds;
        }
    }

    /// The number of links.
    pub fn links(&self) -> usize {
        self.turns.len()
    }

    /// The angle of `joint` at this share of the way.
    #[inline(always)]
    fn angle(&self, joint: usize, share: f64) -> f64 {
        let Turn { from, to, .. } = self.turns[joint];
        if share < 1.0 { from + share * (to - from) } else { to }
    }

    /// All angles at this share of the way.
    pub fn angles(&self, share: f64, angles: &mut [f64]) {
        for (joint, angle) in angles.iter_mut().enumerate() {
            *angle = self.angle(joint, share);
        }
    }

    /// Lays the links as they are at this share of the way.
    pub fn place(&mut self, share: f64) {
        self.dispatch.run(
            #[inline(always)]
            || {
                let links = self.links();
                let mut total = 0.0;
                for joint in 0..links {
                    total += self.angle(joint, share);
                    self.totals[joint / LANES][joint % LANES] = total;
                }
                let mut here = Joint::default();
                for (lanes, first) in self.totals.iter().zip((0..links).step_by(LANES)) {
                    let (sines, cosines) = sin_cos(*lanes);
                    let last = links.min(first + LANES);
                    let joints = self.joints[first..=last].iter_mut().zip(&self.turns[first..last]);
                    for ((joint, &Turn { rate, .. }), (&x, &y)) in
                        joints.zip(cosines.iter().zip(&sines))
                    {
                        here.direction = Vector::new(x, y);
                        *joint = here;
                        let step = here.direction * self.length;
                        here.at += step;
                        here.velocity += Vector::new(-rate * step.y, rate * step.x);
                    }
                }
                self.joints[links] = here;
            },
        );
    }

    /// What the acceleration of a joint, seen from the joint `since`, never exceeds.
    #[inline]
    pub fn acceleration(&self, since: usize, joint: usize) -> f64 {
        self.bounds[joint].acceleration - self.bounds[since].acceleration
    }

    /// What the speed of a joint, seen from the joint `since`, never exceeds.
    #[inline]
    pub fn speed(&self, since: usize, joint: usize) -> f64 {
        self.bounds[joint].speed - self.bounds[since].speed
    }

    /// How far from the joint `since` a joint can be.
    #[inline]
    pub fn length(&self, since: usize, joint: usize) -> f64 {
        (joint - since) as f64 * self.length
    }

    /// How fast a link's direction turns, in radians a unit of the way.
    #[inline]
    pub fn rate(&self, link: usize) -> f64 {
        self.turns[link].rate
    }

    /// A link's axis and its direction.
    #[inline]
    pub fn axis(&self, link: usize) -> Axis {
        let [here, next] = [&self.joints[link], &self.joints[link + 1]];
        Axis { a: here.at, b: next.at, direction: here.direction, length: self.length }
    }
}
