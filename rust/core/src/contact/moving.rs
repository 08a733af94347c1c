//! Moving: a link at some moment, and for how long it is clear of something for sure.
//!
//! Where two capsules are apart, the line between their closest points is normal to a line that separates them.
//! From how fast the link's ends approach along it, and from what their accelerations cannot exceed, follows for
//! how long both stay on their sides.

use parry2d_f64::bounding_volume::Aabb;
use parry2d_f64::math::Vector;

use super::chain::{Chain, Joint};
use super::gap::{Axis, CONTACT, Gap, closest};

/// A link at some moment: where its ends are, how they move, and how much that can change.
pub(crate) struct Moving<'a> {
    chain: &'a Chain,
    /// Which link.
    pub link: usize,
    axis: Axis,
    ends: [&'a Joint; 2],
}

impl<'a> Moving<'a> {
    #[inline(always)]
    pub fn new(chain: &'a Chain, link: usize) -> Self {
        let ends = [link, link + 1].map(|joint| &chain.joints[joint]);
        Self { chain, link, axis: chain.axis(link), ends }
    }

    /// No point of the link gets farther than this in that time.
    #[inline(always)]
    pub fn reach(&self, time: f64) -> f64 {
        let squares = self.ends.map(|end| end.velocity.length_squared());
        squares[0].max(squares[1]).sqrt() * time + self.bend(time)
    }

    /// No point of the link gets farther than this from where it would be at its velocity now.
    #[inline(always)]
    fn bend(&self, time: f64) -> f64 {
        0.5 * self.chain.acceleration(0, self.link + 1) * time * time
    }

    /// A box that the link's axis does not leave in that time, and so much more around it.
    #[inline(always)]
    pub fn swept(&self, time: f64, around: f64) -> Aabb {
        let [one, other] = self.ends;
        let (a, b) = (one.at + one.velocity * time, other.at + other.velocity * time);
        let margin = Vector::splat(self.bend(time) + around);
        Aabb::new(
            one.at.min(other.at).min(a.min(b)) - margin,
            one.at.max(other.at).max(a.max(b)) + margin,
        )
    }

    /// For how long the link's axis stays `apart` from a segment; None if that is as long as `open`.
    #[inline(always)]
    pub fn clear_of(&self, segment: &Axis, apart: f64, open: f64) -> Option<f64> {
        let chain = self.chain;
        let found = closest(&self.axis, segment);
        let normal = found.normal;
        // The half plane that the segment keeps to, whatever rounding did to the normal.
        let side = normal.dot(segment.a).max(normal.dot(segment.b)) + apart + CONTACT;
        let gap = |joint: usize, end: &Joint| Gap {
            width: normal.dot(end.at) - side,
            closing: -normal.dot(end.velocity),
            acceleration: chain.acceleration(0, joint),
        };
        let gaps = [gap(self.link, self.ends[0]), gap(self.link + 1, self.ends[1])];
        if gaps.iter().all(|gap| gap.is_open_for(open)) {
            return None;
        }
        let time = gaps[0].open_for().min(gaps[1].open_for());
        if found.end_of == 0 {
            return (time < open).then_some(time);
        }
        // A corner at the link's side.
        let end = |at: Vector| Point {
            at,
            velocity: Vector::ZERO,
            farthest: at.length() + chain.length(0, self.link),
            since: 0,
            until: self.link,
        };
        let ends = [end(segment.a), end(segment.b)];
        let time = time.max(clear_of_side(chain, self.link, ends, apart));
        (time < open).then_some(time)
    }

    /// For how long the link's axis stays `apart` from that of an earlier link of the chain; None if that is as
    /// long as `open`.
    #[inline(always)]
    pub fn clear_of_link(&self, earlier: usize, apart: f64, open: f64) -> Option<f64> {
        let chain = self.chain;
        let axis = chain.axis(earlier);
        let between = self.axis.a + self.axis.b - axis.a - axis.b;
        let reach =
            chain.speed(earlier, self.link + 1) * open + self.axis.length + apart + 2.0 * CONTACT;
        if between.length_squared() > 4.0 * reach * reach {
            return None;
        }
        let found = closest(&self.axis, &axis);
        let normal = found.normal;
        let mut time = f64::INFINITY;
        for joint in [earlier, earlier + 1] {
            let its = &chain.joints[joint];
            for (own, end) in [(self.link, self.ends[0]), (self.link + 1, self.ends[1])] {
                let gap = Gap {
                    width: normal.dot(end.at - its.at) - apart - CONTACT,
                    closing: normal.dot(its.velocity - end.velocity),
                    acceleration: chain.acceleration(joint, own),
                };
                if !gap.is_open_for(open) {
                    time = time.min(gap.open_for());
                }
            }
        }
        if time >= open {
            return None;
        }
        // One's end at the other's side.
        let (turning, other) =
            if found.end_of == 0 { (earlier, self.link) } else { (self.link, earlier) };
        let end = |joint: usize| {
            let (since, until) = (turning.min(joint), turning.max(joint));
            let Joint { at, velocity, .. } = chain.joints[joint];
            Point { at, velocity, farthest: chain.length(since, until), since, until }
        };
        let time = time.max(clear_of_side(chain, turning, [end(other), end(other + 1)], apart));
        (time < open).then_some(time)
    }
}

/// A point that a link's side must not reach, and what is known of it as seen from the link's near joint.
struct Point {
    at: Vector,
    velocity: Vector,
    /// It is never farther away,
    farthest: f64,
    /// and its speed and acceleration are never more than those of the joint `until`, seen from `since`.
    since: usize,
    until: usize,
}

/// For how long two points, both on one side of a link, stay `apart` from the line through it, which turns with it.
///
/// Where a corner or a disc is at a link's side, the side is what the link touches it with. A line that does not turn would
/// separate them only until the faster end of the link crosses it.
#[inline(always)]
fn clear_of_side(chain: &Chain, link: usize, points: [Point; 2], apart: f64) -> f64 {
    let Joint { at, velocity, direction } = chain.joints[link];
    let rate = chain.rate(link);
    // The line's normal, and how that changes.
    let (normal, turning) = (direction.perp(), direction * -rate);
    let sign = if normal.dot(points[0].at - at) < 0.0 { -1.0 } else { 1.0 };
    let open_for = |point: Point| {
        let away = point.at - at;
        let moved = normal.dot(point.velocity - velocity);
        let fastest = chain.speed(point.since, point.until);
        let gap = Gap {
            width: sign * normal.dot(away) - apart - CONTACT,
            closing: -sign * (turning.dot(away) + moved),
            acceleration: rate.abs() * (rate.abs() * point.farthest + 2.0 * fastest)
                + chain.acceleration(point.since, point.until),
        };
        gap.open_for()
    };
    let [one, other] = points.map(open_for);
    one.min(other)
}
