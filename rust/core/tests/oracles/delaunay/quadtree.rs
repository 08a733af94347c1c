//! Where to begin the walk to a new vertex: at the one filed in the smallest known square around it.
//!
//! Each vertex is filed once, in the largest square of a quadtree that holds none yet, so that
//! squares are as fine as the vertices are dense, in clusters of any width. A search begins at
//! the level where the last one ended. (spade's last used vertex walks through root n triangles
//! among even effects; its hierarchy of triangulations keeps to log n, but dearer ones.)

use std::cell::Cell;

use rustc_hash::FxHashMap;
use spade::handles::FixedVertexHandle;
use spade::{HasPosition, HintGenerator, Point2, Triangulation};

/// Squares of a quadtree with a vertex each.
#[derive(Default)]
pub struct QuadtreeHint {
    squares: FxHashMap<(i32, i64, i64), FixedVertexHandle>,
    first: Option<FixedVertexHandle>,
    level: Cell<i32>,
}

/// The finest and coarsest squares are 2^-60 and 2^60 wide.
const LEVELS: i32 = 60;

impl QuadtreeHint {
    fn at(&self, level: i32, position: Point2<f64>) -> Option<FixedVertexHandle> {
        self.squares.get(&square(level, position)).copied()
    }

    /// The finest level whose square around a position is known, and its vertex.
    fn finest(&self, position: Point2<f64>) -> Option<(i32, FixedVertexHandle)> {
        let mut level = self.level.get();
        let mut found = self.at(level, position);
        if found.is_none() {
            while found.is_none() && level > -LEVELS {
                level -= 1;
                found = self.at(level, position);
            }
        } else {
            while level < LEVELS
                && let finer @ Some(_) = self.at(level + 1, position)
            {
                (level, found) = (level + 1, finer);
            }
        }
        self.level.set(level);
        found.map(|vertex| (level, vertex))
    }
}

fn square(level: i32, position: Point2<f64>) -> (i32, i64, i64) {
    let scale = f64::from_bits(((1023 + i64::from(level)) as u64) << 52);
    (level, (position.x * scale).floor() as i64, (position.y * scale).floor() as i64)
}

impl HintGenerator<f64> for QuadtreeHint {
    fn get_hint(&self, position: Point2<f64>) -> FixedVertexHandle {
        let near = self.finest(position).map(|(_, vertex)| vertex);
        near.or(self.first).expect("asked for once there is a vertex")
    }

    fn notify_vertex_lookup(&self, _: FixedVertexHandle) {}

    fn notify_vertex_inserted(&mut self, vertex: FixedVertexHandle, position: Point2<f64>) {
        self.first.get_or_insert(vertex);
        let level = self.finest(position).map_or(-LEVELS, |(level, _)| level + 1);
        self.squares.insert(square(level, position), vertex);
    }

    fn notify_vertex_removed(
        &mut self,
        _: Option<Point2<f64>>,
        _: FixedVertexHandle,
        _: Point2<f64>,
    ) {
        unreachable!("no vertex is ever removed");
    }

    fn initialize_from_triangulation<TR, V>(triangulation: &TR) -> Self
    where
        TR: Triangulation<Vertex = V>,
        V: HasPosition<Scalar = f64>,
    {
        let mut hint = Self::default();
        for vertex in triangulation.vertices() {
            hint.notify_vertex_inserted(vertex.fix(), vertex.position());
        }
        hint
    }
}
