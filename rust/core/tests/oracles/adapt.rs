//! ADAPT over motor and goal babbling, written down as in the paper, with plain lists.

use divbandit_core::Coverage;

use super::sums::in_parts;
use super::{Stream, by_distance};

/// What ADAPT is made of; M is [-`limit`, `limit`] in each of `m` coordinates, goals lie in
/// [-1, 1] x [-1, 1].
pub struct Adapt {
    pub m: usize,
    pub limit: f64,
    pub d: f64,
    pub tau: f64,
    pub window: usize,
    pub alpha: f64,
    pub head_start: usize,
}

/// One step: who chose, what it believed, the command and its effect.
pub struct Step {
    pub choice: usize,
    pub estimates: [f64; 2],
    pub command: Vec<f64>,
    pub effect: Vec<f64>,
}

impl Adapt {
    /// The first `n` steps, with effects f(command).
    pub fn explore(
        &self,
        n: usize,
        stream: &mut Stream,
        f: impl Fn(&[f64]) -> Vec<f64>,
    ) -> Vec<Step> {
        let mut coverage = Coverage::new(self.tau, 2).unwrap();
        let disc = std::f64::consts::PI * self.tau * self.tau;
        let mut gains = [vec![disc; self.head_start], vec![disc; self.head_start]];
        let mut steps: Vec<Step> = Vec::new();
        for _ in 0..n {
            let estimates = [0, 1].map(|part| {
                let all: &Vec<f64> = &gains[part];
                let last = &all[all.len().saturating_sub(self.window)..];
                if last.is_empty() { 0.0 } else { in_parts(last) / last.len() as f64 }
            });
            let (exploring, u) = (stream.unit() < self.alpha, stream.unit());
            let total = estimates[0] + estimates[1];
            let choice = if exploring || total == 0.0 {
                usize::from(u >= 0.5)
            } else {
                usize::from(u * total >= estimates[0])
            };
            let command = if choice == 0 || steps.is_empty() {
                (0..self.m).map(|_| stream.between(-self.limit, self.limit)).collect()
            } else {
                self.inverse(&steps, stream)
            };
            let effect = f(&command);
            gains[choice].push(coverage.add(&effect).unwrap());
            steps.push(Step { choice, estimates, command, effect });
        }
        steps
    }

    /// The command of the effect nearest to a goal at random, perturbed.
    fn inverse(&self, steps: &[Step], stream: &mut Stream) -> Vec<f64> {
        let goal = [stream.between(-1.0, 1.0), stream.between(-1.0, 1.0)];
        let effects: Vec<Vec<f64>> = steps.iter().map(|step| step.effect.clone()).collect();
        let nearest = &steps[by_distance(&effects, &goal)[0].1];
        let reach = self.d * 2.0 * self.limit;
        let near =
            |&x: &f64| stream.between((x - reach).max(-self.limit), (x + reach).min(self.limit));
        nearest.command.iter().map(near).collect()
    }
}
