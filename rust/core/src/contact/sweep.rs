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
use super::scene::{Piece, Scene};

/// The share of the way to which contact is found.
pub(crate) const PRECISION: f64 = 1e-9;

/// What a link that stops could still go, in metres: a fast one is told more precisely than that share.
const NEARNESS: f64 = 5e-7;

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
        // What limited one link is likely to limit its neighbours, and then little else is looked at: of 10
        // obstacles 52 looks a motion compared 538 pairs without it, of 1000 obstacles 25 looks 17,000.
        let mut likely = None;
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
            let (open, met) = self.open(chain, link, end - share, other, &mut likely);
            let is_near = || Moving::new(chain, link).reach(open) <= NEARNESS;
            if open <= PRECISION && met.is_some() && is_near() {
                return Stop { share, met };
            }
            safe[link] = share + open;
        }
    }

    /// For how long a link, placed with all before it, is safe, at most `longest`; and what ends that.
    ///
    /// `likely` is the piece that limited another, and becomes the one that limits this.
    fn open(
        &self,
        chain: &Chain,
        link: usize,
        longest: f64,
        other: Option<&Capsule>,
        likely: &mut Option<usize>,
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
                limit(moving.clear_of_link(earlier, 2.0 * self.radius), Met::Link(earlier));
            }
        }
        let mut shortest = longest;
        let first = *likely;
        let mut look = |index: usize, piece: &Piece| {
            let apart = self.radius + piece.capsule.radius;
            let time = moving.clear_of(&piece.capsule.segment, apart);
            if time < shortest {
                (shortest, *likely) = (time, Some(index));
            }
            limit(time, Met::Obstacle(piece.obstacle))
        };
        let within = match first {
            Some(index) => look(index, self.scene.piece(index)),
            None => moving.reach(longest) + self.radius + 2.0 * CONTACT,
        };
        self.scene.near(&moving.axis, within, look);
        (open, met)
    }
}

/// A link at some moment: where its ends are, how they move, and how much that can change.
struct Moving<'a> {
    chain: &'a Chain,
    link: usize,
    axis: Segment,
    /// What is farther than the link can get in a time does not matter: its speed now.
    speed: f64,
}

impl<'a> Moving<'a> {
    fn new(chain: &'a Chain, link: usize) -> Self {
        let squares = [link, link + 1].map(|joint| chain.velocity(joint).length_squared());
        let speed = squares[0].max(squares[1]).sqrt();
        Self { chain, link, axis: chain.link(link), speed }
    }

    /// No point of the link gets farther than this in that time.
    #[inline]
    fn reach(&self, time: f64) -> f64 {
        (self.speed + 0.5 * self.chain.acceleration(0, self.link + 1) * time) * time
    }

    /// For how long the link's axis stays `apart` from a segment.
    #[inline]
    fn clear_of(&self, segment: &Segment, apart: f64) -> f64 {
        let chain = self.chain;
        let found = closest(&self.axis, segment);
        let normal = found.normal;
        // The half plane that the segment keeps to, whatever rounding did to the normal.
        let side = normal.dot(segment.a).max(normal.dot(segment.b)) + apart + CONTACT;
        let open = |joint: usize, end: Vector| {
            let closing = -normal.dot(chain.velocity(joint));
            open_for(normal.dot(end) - side, closing, chain.acceleration(0, joint))
        };
        let time = open(self.link, self.axis.a).min(open(self.link + 1, self.axis.b));
        if found.end_of == 0 {
            return time;
        }
        // A corner at the link's side.
        let end = |at: Vector| Point {
            at,
            velocity: Vector::ZERO,
            farthest: at.length() + chain.length(0, self.link),
            fastest: chain.speed(0, self.link),
            acceleration: chain.acceleration(0, self.link),
        };
        time.max(Side::of(chain, self.link).clear_of([end(segment.a), end(segment.b)], apart))
    }

    /// For how long the link's axis stays `apart` from that of an earlier link of the chain.
    #[inline]
    fn clear_of_link(&self, earlier: usize, apart: f64) -> f64 {
        let chain = self.chain;
        let axis = chain.link(earlier);
        let found = closest(&self.axis, &axis);
        let normal = found.normal;
        let mut time = f64::INFINITY;
        for (joint, its_end) in [(earlier, axis.a), (earlier + 1, axis.b)] {
            let its_velocity = chain.velocity(joint);
            for (own, end) in [(self.link, self.axis.a), (self.link + 1, self.axis.b)] {
                let gap = normal.dot(end - its_end) - apart - CONTACT;
                let closing = normal.dot(its_velocity - chain.velocity(own));
                time = time.min(open_for(gap, closing, chain.acceleration(joint, own)));
            }
        }
        // One's end at the other's side.
        let (turning, other) =
            if found.end_of == 0 { (earlier, self.link) } else { (self.link, earlier) };
        let end = |joint: usize| {
            let (first, last) = (turning.min(joint), turning.max(joint));
            Point {
                at: chain.point(joint),
                velocity: chain.velocity(joint),
                farthest: chain.length(first, last),
                fastest: chain.speed(first, last),
                acceleration: chain.acceleration(first, last),
            }
        };
        time.max(Side::of(chain, turning).clear_of([end(other), end(other + 1)], apart))
    }
}

/// A point that a link's side must not reach, and what is known of it as seen from the link's near joint.
struct Point {
    at: Vector,
    velocity: Vector,
    /// It is never farther away,
    farthest: f64,
    /// never faster,
    fastest: f64,
    /// and its acceleration is never more.
    acceleration: f64,
}

/// The line through a link, which turns with it.
///
/// Where a corner or a disc is at a link's side, the side is what the link touches it with. A line that does not turn would
/// separate them only until the faster end of the link crosses it.
struct Side {
    joint: Vector,
    velocity: Vector,
    normal: Vector,
    /// How the normal changes.
    turning: Vector,
    rate: f64,
}

impl Side {
    #[inline]
    fn of(chain: &Chain, link: usize) -> Self {
        let axis = chain.link(link);
        let direction = (axis.b - axis.a) * chain.links() as f64;
        let rate = chain.rate(link);
        Self {
            joint: axis.a,
            velocity: chain.velocity(link),
            normal: Vector::new(-direction.y, direction.x),
            turning: direction * -rate,
            rate: rate.abs(),
        }
    }

    /// For how long two points, both on one side, stay `apart` from the line.
    #[inline]
    fn clear_of(&self, points: [Point; 2], apart: f64) -> f64 {
        let between = points[0].at - self.joint;
        let sign = if self.normal.dot(between) < 0.0 { -1.0 } else { 1.0 };
        let open = |point: &Point| {
            let away = point.at - self.joint;
            let gap = sign * self.normal.dot(away) - apart - CONTACT;
            let moved = self.normal.dot(point.velocity - self.velocity);
            let closing = -sign * (self.turning.dot(away) + moved);
            let (rate, farthest) = (self.rate, point.farthest);
            let curved = rate * (rate * farthest + 2.0 * point.fastest) + point.acceleration;
            open_for(gap, closing, curved)
        };
        open(&points[0]).min(open(&points[1]))
    }
}
