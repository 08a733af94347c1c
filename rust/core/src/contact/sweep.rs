//! Sweep: the first contact of a chain on its way, by conservative advancement.
//!
//! Each link is given a time for which it is safe for sure (see `moving`). When the first runs out that link is
//! looked at again, until the time that it is given is as short as contact is to be found. As the approach is
//! known to first order, a time is wrong by its square: six or so looks lead from afar to contact.

use parry2d_f64::shape::Capsule;

use super::chain::Chain;
use super::gap::{Axis, CONTACT};
use super::moving::Moving;
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
        let dispatch = chain.dispatch;
        let other =
            other.map(|capsule| (Axis::from(capsule.segment), self.radius + capsule.radius));
        safe.fill(start);
        // What limited one link is likely to limit its neighbours, and then little else is compared with them.
        let mut likely = None;
        dispatch.run(
            #[inline(always)]
            || loop {
                // The link that is safe for the shortest, and until when.
                let all = safe.iter().copied().enumerate();
                let first = all.min_by(|one, other| one.1.total_cmp(&other.1));
                let (first, share) = first.unwrap_or((0, end));
                if share >= end {
                    return Stop { share: end, met: None };
                }
                chain.place(share);
                let moving = Moving::new(chain, first);
                let Limit { time, met } =
                    self.limit(&moving, end - share, other.as_ref(), &mut likely);
                if time <= PRECISION && met.is_some() && moving.reach(time) <= NEARNESS {
                    return Stop { share, met };
                }
                safe[first] = share + time;
                // As the chain is laid, all links are looked at that would be before this one is again. Among 10
                // obstacles that is 57 looks in 7 rounds; one link each time took 52 looks, and a laying for each.
                for (link, safe) in safe.iter_mut().enumerate() {
                    if *safe < share + time && link != first {
                        let moving = Moving::new(chain, link);
                        let limit = self.limit(&moving, end - share, other.as_ref(), &mut likely);
                        *safe = share + limit.time;
                    }
                }
            },
        )
    }

    /// For how long a link is safe, at most `longest`; and what ends that.
    ///
    /// `likely` is the piece that limited another, and becomes the one that limits this.
    #[inline(always)]
    fn limit(
        &self,
        moving: &Moving,
        longest: f64,
        other: Option<&(Axis, f64)>,
        likely: &mut Option<usize>,
    ) -> Limit {
        let mut limit = Limit { time: longest, met: None };
        let first = *likely;
        if let Some(index) = first {
            limit.look(moving, &self.scene.pieces[index], self.radius);
        }
        // What is out of reach until then is not looked at. Nor is it later: which pieces are compared must not depend
        // on the order in which they are found.
        let bounds = moving.swept(limit.time, self.radius + 2.0 * CONTACT);
        self.scene.within(
            &bounds,
            #[inline(always)]
            |index, piece| {
                if Some(index) != first && limit.look(moving, piece, self.radius) {
                    *likely = Some(index);
                }
            },
        );
        if let Some((axis, apart)) = other {
            limit.by(moving.clear_of(axis, *apart, limit.time), Met::Other);
        }
        if self.self_contact {
            for earlier in 0..moving.link.saturating_sub(1) {
                let time = moving.clear_of_link(earlier, 2.0 * self.radius, limit.time);
                limit.by(time, Met::Link(earlier));
            }
        }
        limit
    }
}

/// For how long a link is safe, and what ends that.
struct Limit {
    time: f64,
    met: Option<Met>,
}

impl Limit {
    /// Takes the shorter time of something else, if it is; returns whether it is.
    #[inline(always)]
    fn by(&mut self, shorter: Option<f64>, met: Met) -> bool {
        if let Some(time) = shorter {
            *self = Self { time, met: Some(met) };
        }
        shorter.is_some()
    }

    /// Looks at a piece; returns whether it limits the link more than what was looked at before.
    #[inline(always)]
    fn look(&mut self, moving: &Moving, piece: &Piece, radius: f64) -> bool {
        let time = moving.clear_of(&piece.axis, radius + piece.radius, self.time);
        self.by(time, Met::Obstacle(piece.obstacle))
    }
}
