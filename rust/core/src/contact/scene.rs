//! Scene: all obstacles as capsules, in a hierarchy of boxes that finds those near a link.

use std::cmp::Ordering;

use parry2d_f64::bounding_volume::Aabb;
use parry2d_f64::math::Vector;
use parry2d_f64::partitioning::{Bvh, BvhBuildStrategy, BvhNode, TraversalAction};
use parry2d_f64::shape::{Capsule, Segment};

use super::gap::{Axis, closest};
use super::obstacle::{Obstacle, touch};

/// So many boxes are looked through one by one: 20 take 4.6 us a motion and in a hierarchy 5.6, 60 take 3.9 and 4.2,
/// from 80 on the hierarchy is faster.
const FEW: usize = 64;

/// The obstacles around an arm.
#[derive(Debug, Clone)]
pub(crate) struct Scene {
    obstacles: Vec<Obstacle>,
    pub pieces: Vec<Piece>,
    /// The sides of the boxes around the pieces.
    boxes: Vec<[f64; 4]>,
    /// The same boxes in a hierarchy, for many.
    tree: Bvh,
}

/// A capsule of an obstacle.
#[derive(Debug, Clone)]
pub(crate) struct Piece {
    /// Its axis.
    pub axis: Axis,
    /// Half of how thick it is.
    pub radius: f64,
    /// The index of the obstacle that it belongs to.
    pub obstacle: usize,
}

impl Scene {
    /// Of these obstacles.
    pub fn new(obstacles: Vec<Obstacle>) -> Self {
        let pieces_of = |(obstacle, its): (usize, &Obstacle)| {
            let piece = move |&Capsule { segment, radius }: &Capsule| Piece {
                axis: segment.into(),
                radius,
                obstacle,
            };
            its.pieces.iter().map(piece).collect::<Vec<_>>()
        };
        let mut pieces: Vec<Piece> = obstacles.iter().enumerate().flat_map(pieces_of).collect();
        // By their places, so that the order of the obstacles changes no bit.
        let place =
            |Piece { axis: Axis { a, b, .. }, radius, .. }: &Piece| [a.x, a.y, b.x, b.y, *radius];
        pieces.sort_by(|one, other| {
            let each = place(one).into_iter().zip(place(other));
            each.fold(Ordering::Equal, |order, (a, b)| order.then(a.total_cmp(&b)))
        });
        let boxes: Vec<Aabb> = pieces.iter().map(around).collect();
        let tree = Bvh::from_leaves(BvhBuildStrategy::Binned, &boxes);
        let boxes = boxes.iter().map(sides).collect();
        Self { obstacles, pieces, boxes, tree }
    }

    /// Visits the pieces whose boxes meet a box.
    #[inline(always)]
    pub fn within(&self, bounds: &Aabb, mut visit: impl FnMut(usize, &Piece)) {
        if self.boxes.len() <= FEW {
            let [low, bottom, high, top] = sides(bounds).map(|side| -side);
            for (index, each) in self.boxes.iter().enumerate() {
                // Without a branch for each side, as none can be foretold: 5.3 us a motion where four of them take 6.1.
                let is_apart =
                    (each[0] > high) | (each[1] > top) | (each[2] > low) | (each[3] > bottom);
                if !is_apart {
                    visit(index, &self.pieces[index]);
                }
            }
            return;
        }
        self.tree.traverse(|node: &BvhNode| {
            let apart = (node.mins() - bounds.maxs).max(bounds.mins - node.maxs());
            if apart.x > 0.0 || apart.y > 0.0 {
                return TraversalAction::Prune;
            }
            if let Some(leaf) = node.leaf_data() {
                visit(leaf as usize, &self.pieces[leaf as usize]);
            }
            TraversalAction::Continue
        });
    }

    /// The first obstacle that a capsule touches, or that surrounds it.
    pub fn touching(&self, axis: &Axis, radius: f64) -> Option<usize> {
        let segment = |axis: &Axis| Segment::new(axis.a, axis.b);
        let touched = self.pieces.iter().filter(|piece| {
            let between = closest(axis, &piece.axis).distance;
            between <= radius + piece.radius || touch(&segment(axis), &segment(&piece.axis))
        });
        let touched = touched.map(|piece| piece.obstacle).min();
        let surrounding = self.obstacles.iter().position(|obstacle| obstacle.surrounds(axis.a));
        [touched, surrounding].into_iter().flatten().min()
    }
}

/// The box around a piece.
fn around(Piece { axis, radius, .. }: &Piece) -> Aabb {
    let radius = Vector::splat(*radius);
    Aabb::new(axis.a.min(axis.b) - radius, axis.a.max(axis.b) + radius)
}

/// Left, lower, right and upper side of a box, the last two with the other sign.
#[inline(always)]
fn sides(Aabb { mins, maxs }: &Aabb) -> [f64; 4] {
    [mins.x, mins.y, -maxs.x, -maxs.y]
}
