//! Scene: all obstacles as capsules, in a hierarchy of boxes that finds those near a link.

use std::cmp::Ordering;

use parry2d_f64::bounding_volume::Aabb;
use parry2d_f64::math::Vector;
use parry2d_f64::partitioning::{Bvh, BvhBuildStrategy, BvhNode, TraversalAction};
use parry2d_f64::shape::{Capsule, Segment};

use super::gap::{Axis, closest};
use super::obstacle::{Obstacle, touch};

/// The obstacles around an arm.
#[derive(Debug, Clone)]
pub(crate) struct Scene {
    obstacles: Vec<Obstacle>,
    pieces: Vec<Piece>,
    boxes: Bvh,
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
        let mut pieces: Vec<Piece> = obstacles
            .iter()
            .enumerate()
            .flat_map(|(obstacle, its)| {
                let piece = move |shape: Capsule| Piece {
                    axis: shape.segment.into(),
                    radius: shape.radius,
                    obstacle,
                };
                its.pieces().into_iter().map(piece)
            })
            .collect();
        // By their places, so that the order of the obstacles changes no bit.
        let place =
            |Piece { axis: Axis { a, b, .. }, radius, .. }: &Piece| [a.x, a.y, b.x, b.y, *radius];
        pieces.sort_by(|one, other| {
            let each = place(one).into_iter().zip(place(other));
            each.fold(Ordering::Equal, |order, (a, b)| order.then(a.total_cmp(&b)))
        });
        let boxes: Vec<Aabb> = pieces.iter().map(|piece| around(piece)).collect();
        let boxes = Bvh::from_leaves(BvhBuildStrategy::Binned, &boxes);
        Self { obstacles, pieces, boxes }
    }

    /// All obstacles.
    pub fn obstacles(&self) -> &[Obstacle] {
        &self.obstacles
    }

    /// The piece of this index.
    #[inline]
    pub fn piece(&self, index: usize) -> &Piece {
        &self.pieces[index]
    }

    /// Visits the pieces whose boxes meet a box.
    #[inline(always)]
    pub fn within(&self, bounds: &Aabb, mut visit: impl FnMut(usize, &Piece)) {
        self.boxes.traverse(|node: &BvhNode| {
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
    pub fn touching(&self, axis: &Segment, radius: f64) -> Option<usize> {
        let touched = self.pieces.iter().filter(|piece| {
            let between = closest(&Axis::from(*axis), &piece.axis).distance;
            let its_axis = Segment::new(piece.axis.a, piece.axis.b);
            between <= radius + piece.radius || touch(axis, &its_axis)
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
