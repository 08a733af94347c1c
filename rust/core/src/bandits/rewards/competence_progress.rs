//! CompetenceProgress: by how much the nearest effect to the goal has come nearer.

use super::{Reward, unseen};
use crate::error::Error;
use crate::history::History;
use crate::kdtree::NearestNeighbors;

/// The distance from the goal to the nearest effect known before, less that to the newest effect; 0
/// where this is negative, where the trial has no goal, and for the first effect of all (in the
/// spirit of Baranes and Oudeyer 2013, "Active Learning of Inverse Models with Intrinsically
/// Motivated Goal Exploration in Robots", Robotics and Autonomous Systems 61(1), 49-73).
#[derive(Debug)]
pub(super) struct CompetenceProgress {
    /// The effects before the newest.
    before: NearestNeighbors,
}

impl CompetenceProgress {
    pub fn new(dim: usize) -> Result<Self, Error> {
        Ok(Self { before: NearestNeighbors::new(dim)? })
    }
}

impl Reward for CompetenceProgress {
    fn newest(&mut self, history: &History, goal: Option<&[f64]>) -> Result<f64, Error> {
        let dim = self.before.dim();
        let mut between = unseen(history, self.before.len(), dim)?.chunks_exact(dim);
        let Some(newest) = between.next_back() else {
            return Err(Error::Empty { name: "history after the effects seen before" });
        };
        between.for_each(|effect| self.before.log(effect));
        let Some(goal) = goal.filter(|_| !self.before.is_empty()) else { return Ok(0.0) };
        self.before.file_all();
        let (_, index) = self.before.nearest(goal)?;
        let known = self.before.points();
        let progress = distance(goal, &known[index * dim..][..dim]) - distance(goal, newest);
        // The difference of two infinite distances is not a number: then it is 0.
        Ok(if progress > 0.0 { progress } else { 0.0 })
    }
}

/// The Euclidean distance, by plain operations in order; nothing overflows in between.
fn distance(one: &[f64], other: &[f64]) -> f64 {
    let pairs = || one.iter().zip(other).map(|(x, y)| (x - y).abs());
    let largest = pairs().fold(0.0, f64::max);
    if !(largest > 0.0 && largest.is_finite()) {
        return largest;
    }
    let mut total = 0.0;
    for difference in pairs() {
        let share = difference / largest;
        total += share * share;
    }
    largest * total.sqrt()
}

#[cfg(test)]
mod tests {
    use super::{CompetenceProgress, Reward, distance};
    use crate::bounds::Bounds;
    use crate::history::History;

    #[test]
    fn progress_is_towards_the_goal() {
        let unit = Bounds::new(vec![0.0], vec![1.0]).unwrap();
        let mut history = History::new(unit, None, true, 0).unwrap();
        let mut progress = CompetenceProgress::new(1).unwrap();
        let mut after = |effect: f64, goal: Option<&[f64]>| {
            history.record(&[0.5], &[effect], &[], &[]).unwrap();
            progress.newest(&history, goal).unwrap()
        };
        assert_eq!(after(0.0, Some(&[5.0])), 0.0); // the first
        assert_eq!(after(1.0, Some(&[5.0])), 1.0);
        assert_eq!(after(9.0, None), 0.0); // no goal
        assert_eq!(after(6.0, Some(&[5.0])), 3.0);
        assert_eq!(after(0.0, Some(&[5.0])), 0.0); // farther
    }

    #[test]
    fn distances_do_not_overflow() {
        let large = 2_f64.powi(1000);
        assert_eq!(distance(&[3.0 * large, 0.0], &[0.0, 4.0 * large]), 5.0 * large);
        assert_eq!(distance(&[0.0], &[0.0]), 0.0);
        assert_eq!(distance(&[1.7e308], &[-1.7e308]), f64::INFINITY);
    }
}
