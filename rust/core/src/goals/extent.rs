//! Extent: a box that holds all effects observed so far, and a little more.

use crate::bounds::Bounds;
use crate::error::Error;
use crate::kdtree::NearestNeighbors;

/// By which share of its width the box of the effects is widened, on either side.
const MARGIN: f64 = 0.05;

/// The box, as of the last update.
#[derive(Debug, Clone, Default)]
pub(super) struct Extent {
    low: Vec<f64>,
    high: Vec<f64>,
    /// How many effects are in it.
    seen: usize,
    widened: Option<Bounds>,
}

impl Extent {
    /// The box of all effects, of which there is at least one, widened by a share of its own width
    /// and by `more`.
    pub fn update(&mut self, effects: &NearestNeighbors, more: f64) -> Result<&Bounds, Error> {
        let dim = effects.dim();
        self.low.resize(dim, f64::INFINITY);
        self.high.resize(dim, f64::NEG_INFINITY);
        let mut grows = false;
        for effect in effects.points()[self.seen * dim..].chunks_exact(dim) {
            for ((y, low), high) in effect.iter().zip(&mut self.low).zip(&mut self.high) {
                grows |= *y < *low || *y > *high;
                (*low, *high) = (low.min(*y), high.max(*y));
            }
        }
        self.seen = effects.len();
        if grows || self.widened.is_none() {
            let pairs = self.low.iter().zip(&self.high);
            let (low, high) = pairs.map(|(&low, &high)| wider(low, high, more)).unzip();
            self.widened = Some(Bounds::new(low, high)?);
        }
        self.widened.as_ref().ok_or(Error::Empty { name: "history" })
    }
}

/// A wider interval; the same where its ends would be too far apart for a number.
fn wider(low: f64, high: f64, more: f64) -> (f64, f64) {
    let margin = MARGIN * (high - low) + more;
    let (below, above) = (low - margin, high + margin);
    if (above - below).is_finite() { (below, above) } else { (low, high) }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn it_holds_all_effects_and_a_little_more() {
        let mut effects = NearestNeighbors::new(2).unwrap();
        effects.add(&[1.0, 2.0]).unwrap();
        let mut extent = Extent::default();
        let at_first = Bounds::new(vec![0.5, 1.5], vec![1.5, 2.5]).unwrap();
        assert_eq!(extent.update(&effects, 0.5), Ok(&at_first));
        assert_eq!(extent.update(&effects, 0.5), Ok(&at_first));
        effects.add(&[-1.0, 2.0]).unwrap();
        let wider = Bounds::new(vec![-1.6, 1.5], vec![1.6, 2.5]).unwrap();
        assert_eq!(extent.update(&effects, 0.5), Ok(&wider));
        effects.add(&[f64::MAX, 2.0]).unwrap();
        let largest = Bounds::new(vec![-1.0, 1.5], vec![f64::MAX, 2.5]).unwrap();
        assert_eq!(extent.update(&effects, 0.5), Ok(&largest));
    }

    #[test]
    fn effects_too_far_apart_are_refused() {
        let mut effects = NearestNeighbors::new(1).unwrap();
        effects.extend(&[-f64::MAX, f64::MAX]).unwrap();
        assert!(Extent::default().update(&effects, 1.0).is_err());
    }
}
