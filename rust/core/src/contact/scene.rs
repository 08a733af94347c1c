//! Scene: all obstacles as capsules, in a hierarchy of boxes that finds those near a link.

use parry2d_f64::bounding_volume::Aabb;
use parry2d_f64::math::Vector;
use parry2d_f64::partitioning::{Bvh, BvhBuildStrategy, BvhNode, TraversalAction};
use parry2d_f64::shape::{Capsule, Segment};

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
    /// Its shape.
    pub capsule: Capsule,
    /// The index of the obstacle that it belongs to.
    pub obstacle: usize,
}

impl Scene {
    /// Of these obstacles.
    pub fn new(obstacles: Vec<Obstacle>) -> Self {
        let pieces: Vec<Piece> = obstacles
            .iter()
            .enumerate()
            .flat_map(|(obstacle, its)| {
                its.pieces().into_iter().map(move |capsule| Piece { capsule, obstacle })
            })
            .collect();
        let boxes: Vec<Aabb> = pieces.iter().map(|piece| around(&piece.capsule)).collect();
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

    /// Visits the pieces whose boxes are nearer to the box around a segment than a distance that `visit`
    /// returns anew each time; it never grows.
    #[inline]
    pub fn near(
        &self,
        segment: &Segment,
        within: f64,
        mut visit: impl FnMut(usize, &Piece) -> f64,
    ) {
        let (low, high) = (segment.a.min(segment.b), segment.a.max(segment.b));
        let mut square = within * within;
        self.boxes.traverse(|node: &BvhNode| {
            let apart = (node.mins() - high).max(low - node.maxs()).max(Vector::ZERO);
            if apart.length_squared() > square {
                return TraversalAction::Prune;
            }
            if let Some(leaf) = node.leaf_data() {
                let within = visit(leaf as usize, &self.pieces[leaf as usize]);
                square = within * within;
            }
            TraversalAction::Continue
        });
    }

    /// The first obstacle that a capsule touches, or that surrounds it.
    pub fn touching(&self, axis: &Segment, radius: f64) -> Option<usize> {
        let touched = self.pieces.iter().filter(|piece| {
            let between = super::gap::closest(axis, &piece.capsule.segment).distance;
            between <= radius + piece.capsule.radius || touch(axis, &piece.capsule.segment)
        });
        let touched = touched.map(|piece| piece.obstacle).min();
        let surrounding = self.obstacles.iter().position(|obstacle| obstacle.surrounds(axis.a));
        [touched, surrounding].into_iter().flatten().min()
    }
}

/// The box around a capsule.
fn around(capsule: &Capsule) -> Aabb {
    let (a, b) = (capsule.segment.a, capsule.segment.b);
    let radius = Vector::splat(capsule.radius);
    Aabb::new(a.min(b) - radius, a.max(b) + radius)
}
