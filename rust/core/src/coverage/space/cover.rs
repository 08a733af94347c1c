//! Whether old balls cover for certain the cone between a new centre p and a face of its cell.
//!
//! Most effects of a long exploration fall into the union. Then the new cell lies in the new
//! ball, and usually a look at each cone proves that old balls cover it: the old faces, more
//! than half of the work, need not be found.

use super::face::Face;
use super::neighbours::Neighbour;
use super::vector::dot;

/// Whether `others`, neighbours of p nearer than k, and k's ball cover the cone between p, the
/// origin, and its `face` with k. Only true is certain.
///
/// A ball around k that reaches p covers all, as both are convex. Otherwise k's ball begins some
/// way up the cone. Split into triangular ones, by a fan of the face: what k's ball leaves of
/// one lies within p and the places where it begins on the three edges, and if one other ball
/// reaches all four, it covers that.
pub(crate) fn is_covered(face: &Face, k: Neighbour, others: &[Neighbour]) -> bool {
    if k.squared <= 1.0 {
        return true;
    }
    let Some(mut vertices) = face.vertices() else { return false };
    // The others that reach p and the beginning on this edge, a bit for each.
    let reaching = |vertex: [f64; 3]| {
        let (square, half) = (dot(vertex, vertex), dot(vertex, k.at));
        let root = (half * half - square * (k.squared - 1.0)).max(0.0).sqrt();
        let scale = (half - root) / square;
        let place = vertex.map(|x| scale * x);
        let squared = dot(place, place);
        let reaches =
            |j: &Neighbour| j.squared <= 1.0 && squared - 2.0 * dot(place, j.at) + j.squared <= 1.0;
        let bits = others.iter().take(64).enumerate();
        bits.fold(0_u64, |found, (bit, j)| found | u64::from(reaches(j)) << bit)
    };
    let Some(first) = vertices.next().map(reaching) else { return false };
    let mut last = first;
    vertices.map(reaching).all(|next| first & std::mem::replace(&mut last, next) & next != 0)
}
