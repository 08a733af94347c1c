//! Chain: the links of an arm as they go along a straight line in joint space.
//!
//! On such a line each link's direction turns at a constant rate r_k, so that the far end of link i moves with
//! the velocity L sum r_k u'(phi_k) over k <= i, and its acceleration is never more than L sum r_k^2.

use parry2d_f64::math::Vector;
use parry2d_f64::shape::Segment;

use crate::instructions::Dispatch;
use crate::trig::sin_cos;

/// How many angles go through the sines at once.
const LANES: usize = 8;

/// Joints on their way; the base is joint 0, and the tip is counted as one.
#[derive(Debug, Clone)]
pub(crate) struct Chain {
    dispatch: Dispatch,
    from: Vec<f64>,
    to: Vec<f64>,
    /// How fast each link's direction turns, in radians a unit of the way.
    rates: Vec<f64>,
    /// What no joint's acceleration exceeds, in metres a unit of the way squared.
    accelerations: Vec<f64>,
    /// What no joint's speed exceeds, in metres a unit of the way.
    speeds: Vec<f64>,
    directions: Vec<[f64; LANES]>,
    points: Vec<Vector>,
    velocities: Vec<Vector>,
}

impl Chain {
    /// Of so many links, at least one, all at rest.
    pub fn new(joints: usize, dispatch: Dispatch) -> Self {
        Self {
            dispatch,
            from: vec![0.0; joints],
            to: vec![0.0; joints],
            rates: vec![0.0; joints],
            accelerations: vec![0.0; joints + 1],
            speeds: vec![0.0; joints + 1],
            directions: vec![[0.0; LANES]; joints.div_ceil(LANES)],
            points: vec![Vector::ZERO; joints + 1],
            velocities: vec![Vector::ZERO; joints + 1],
        }
    }

    /// Sets out from some angles to others, one a joint.
    pub fn begin(&mut self, from: &[f64], to: &[f64]) {
        self.from.copy_from_slice(from);
        self.to.copy_from_slice(to);
        let length = 1.0 / self.from.len() as f64;
        let (mut rate, mut squares, mut sum) = (0.0_f64, 0.0, 0.0);
        for (joint, (from, to)) in from.iter().zip(to).enumerate() {
            rate += to - from;
            squares += rate * rate;
            sum += rate.abs();
            self.rates[joint] = rate;
            self.accelerations[joint + 1] = squares * length;
            self.speeds[joint + 1] = sum * length;
        }
    }

    /// The number of links.
    pub fn links(&self) -> usize {
        self.from.len()
    }

    /// The angle of `joint` at this share of the way.
    #[inline(always)]
    fn angle(&self, joint: usize, share: f64) -> f64 {
        let (from, to) = (self.from[joint], self.to[joint]);
        if share < 1.0 { from + share * (to - from) } else { to }
    }

    /// All angles at this share of the way.
    pub fn angles(&self, share: f64, angles: &mut [f64]) {
        for (joint, angle) in angles.iter_mut().enumerate() {
            *angle = self.angle(joint, share);
        }
    }

    /// Lays the first `links` links as they are at this share of the way.
    ///
    /// A posture has the same bits as that of a free arm with these angles.
    pub fn place(&mut self, share: f64, links: usize) {
        self.dispatch.run(
            #[inline(always)]
            || self.place_each(share, links),
        );
    }

    #[inline(always)]
    fn place_each(&mut self, share: f64, links: usize) {
        let count = self.links() as f64;
        let mut total = 0.0;
        for joint in 0..links {
            total += self.angle(joint, share);
            self.directions[joint / LANES][joint % LANES] = total;
        }
        let (mut place, mut velocity) = (Vector::ZERO, Vector::ZERO);
        for (lanes, first) in self.directions.iter().zip((0..links).step_by(LANES)) {
            let (sines, cosines) = sin_cos(*lanes);
            for joint in first..links.min(first + LANES) {
                let (sine, cosine) = (sines[joint - first], cosines[joint - first]);
                let rate = self.rates[joint];
                place += Vector::new(cosine, sine);
                velocity += Vector::new(-rate * sine, rate * cosine);
                self.points[joint + 1] = place / count;
                self.velocities[joint + 1] = velocity / count;
            }
        }
    }

    /// Where a joint is.
    #[inline]
    pub fn point(&self, joint: usize) -> Vector {
        self.points[joint]
    }

    /// How a joint moves.
    #[inline]
    pub fn velocity(&self, joint: usize) -> Vector {
        self.velocities[joint]
    }

    /// What the acceleration of a joint, seen from the joint `since`, never exceeds.
    #[inline]
    pub fn acceleration(&self, since: usize, joint: usize) -> f64 {
        self.accelerations[joint] - self.accelerations[since]
    }

    /// What the speed of a joint, seen from the joint `since`, never exceeds.
    #[inline]
    pub fn speed(&self, since: usize, joint: usize) -> f64 {
        self.speeds[joint] - self.speeds[since]
    }

    /// How far from the joint `since` a joint can be.
    #[inline]
    pub fn length(&self, since: usize, joint: usize) -> f64 {
        (joint - since) as f64 / self.links() as f64
    }

    /// How fast a link's direction turns, in radians a unit of the way.
    #[inline]
    pub fn rate(&self, link: usize) -> f64 {
        self.rates[link]
    }

    /// The axis of a link.
    #[inline]
    pub fn link(&self, link: usize) -> Segment {
        Segment::new(self.points[link], self.points[link + 1])
    }
}
