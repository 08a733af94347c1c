//! Sweep: the first contact of a chain on its way, by conservative advancement.
//!
//! Where two capsules are apart, the line between their closest points is normal to a line that separates them.
//! From how fast the link's ends approach along it, and from what their accelerations cannot exceed, follows for
//! how long both stay on their sides. Each link is given the shortest of these times, and the link whose time runs out
//! first is looked at again, until the time that it is given is as short as contact is to be found. As the
//! approach is known to first order, a time is wrong by its square: six or so looks lead from afar to contact.

use parry2d_f64::math::Vector;
use parry2d_f64::shape::{Capsule, Segment};

use super::chain::Chain;
use super::gap::{CONTACT, closest, open_for};
use super::scene::Scene;

/// The share of the way to which contact is found.
pub(crate) const PRECISION: f64 = 1e-9;

/// Where a chain had to stop, and why.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(crate) struct Stop {
    /// The share of the way, up to which nothing touched.
    pub share: f64,
    /// What is touched there; nothing at the end of the way.
    pub met: Option<Met>,
}

/// What a link touches.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(crate) enum Met {
    /// The obstacle of this index.
    Obstacle(usize),
    /// The link of this index.
    Link(usize),
    /// What was given beside the scene.
    Other,
}

/// What links are, and what they can touch.
#[derive(Debug, Clone)]
pub(crate) struct Sweep {
    /// The obstacles.
    pub scene: Scene,
    /// Half of the links' thickness.
    pub radius: f64,
    /// Whether links that are no neighbours can touch each other.
    pub self_contact: bool,
}

impl Sweep {
    /// Goes on from `start`, where nothing touches, to `end` or the first contact, with an `other` capsule in the way.
    ///
    /// `safe` holds a number a link; what it held does not matter.
    pub fn advance(
        &self,
        chain: &mut Chain,
        start: f64,
        end: f64,
        other: Option<&Capsule>,
        safe: &mut [f64],
    ) -> Stop {
        safe.fill(start);
        loop {
            let (mut link, mut share) = (0, safe[0]);
            for (index, &until) in safe.iter().enumerate().skip(1) {
                if until < share {
                    (link, share) = (index, until);
                }
            }
            if share >= end {
                return Stop { share: end, met: None };
            }
            chain.place(share, link + 1);
            let (open, met) = self.open(chain, link, end - share, other);
            if open <= PRECISION && met.is_some() {
                return Stop { share, met };
            }
            safe[link] = share + open;
        }
    }

    /// For how long a link, placed with all before it, is safe, at most `longest`; and what ends that.
    fn open(
        &self,
        chain: &Chain,
        link: usize,
        longest: f64,
        other: Option<&Capsule>,
    ) -> (f64, Option<Met>) {
        let moving = Moving::new(chain, link);
        let (mut open, mut met) = (longest, None);
        let mut limit = |time: f64, by: Met| {
            if time < open {
                (open, met) = (time, Some(by));
            }
            // How near something must be to matter now.
            moving.reach(open) + self.radius + 2.0 * CONTACT
        };
        if let Some(capsule) = other {
            limit(moving.clear_of(&capsule.segment, self.radius + capsule.radius), Met::Other);
        }
        if self.self_contact {
            for earlier in 0..link.saturating_sub(1) {
                limit(moving.clear_of_link(chain, earlier, 2.0 * self.radius), Met::Link(earlier));
            }
        }
        let within = limit(f64::INFINITY, Met::Other);
        self.scene.near(&moving.axis, within, |piece| {
            let apart = self.radius + piece.capsule.radius;
            let time = moving.clear_of(&piece.capsule.segment, apart);
            limit(time, Met::Obstacle(piece.obstacle))
        });
        (open, met)
    }
}

/// A link at some moment: where its ends are, how they move, and how much that can change.
struct Moving {
    link: usize,
    axis: Segment,
    velocities: [Vector; 2],
    accelerations: [f64; 2],
    speed: f64,
}

impl Moving {
    fn new(chain: &Chain, link: usize) -> Self {
        let velocities = [chain.velocity(link), chain.velocity(link + 1)];
        let squares = velocities.map(Vector::length_squared);
        Self {
            link,
            axis: chain.link(link),
            velocities,
            accelerations: [chain.acceleration(0, link), chain.acceleration(0, link + 1)],
            speed: squares[0].max(squares[1]).sqrt(),
        }
    }

    /// No point of the link gets farther than this in that time.
    #[inline]
    fn reach(&self, time: f64) -> f64 {
        (self.speed + 0.5 * self.accelerations[1] * time) * time
    }

    /// For how long the link's axis stays `apart` from a segment.
    #[inline]
    fn clear_of(&self, segment: &Segment, apart: f64) -> f64 {
        let (_, normal) = closest(&self.axis, segment);
        // The half plane that the segment keeps to, whatever rounding did to the normal.
        let side = normal.dot(segment.a).max(normal.dot(segment.b)) + apart + CONTACT;
        let open = |end: Vector, i: usize| {
            let closing = -normal.dot(self.velocities[i]);
            open_for(normal.dot(end) - side, closing, self.accelerations[i])
        };
        open(self.axis.a, 0).min(open(self.axis.b, 1))
    }

    /// For how long the link's axis stays `apart` from that of an earlier link of the chain.
    #[inline]
    fn clear_of_link(&self, chain: &Chain, earlier: usize, apart: f64) -> f64 {
        let axis = chain.link(earlier);
        let (_, normal) = closest(&self.axis, &axis);
        let mut shortest = f64::INFINITY;
        for (joint, its_end) in [(earlier, axis.a), (earlier + 1, axis.b)] {
            let its_velocity = chain.velocity(joint);
            for (i, end) in [self.axis.a, self.axis.b].into_iter().enumerate() {
                let gap = normal.dot(end - its_end) - apart - CONTACT;
                let closing = normal.dot(its_velocity - self.velocities[i]);
                let acceleration = chain.acceleration(joint, self.link + i);
                shortest = shortest.min(open_for(gap, closing, acceleration));
            }
        }
        shortest
    }
}
