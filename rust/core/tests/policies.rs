//! Estimators and policies by numbers worked out on paper; `tests/bandits/` has more of them, and
//! holds all to their specifications in Python.

use divbandit_core::bandits::estimators::{Estimator, EstimatorKind};
use divbandit_core::bandits::policies::{Estimates, Policy, PolicyKind};
use divbandit_core::error::Error;

const LARGEST: f64 = 4.0;
/// Part 0 earned 1 and 3, part 1 earned 4 once, part 2 earned 0, 0 and 3.
const REWARDS: [(usize, f64); 6] = [(0, 1.0), (1, 4.0), (2, 0.0), (0, 3.0), (2, 0.0), (2, 3.0)];

fn told(kind: EstimatorKind) -> Box<dyn Estimator> {
    let mut estimator = kind.start(3, LARGEST).unwrap();
    for (part, reward) in REWARDS {
        estimator.add(part, reward);
    }
    estimator
}

fn begun(kind: PolicyKind) -> Box<dyn Policy> {
    kind.start(3, LARGEST).unwrap()
}

/// What a policy chooses after all rewards were told, given the draws; all of these are drawn.
fn chosen(policy: &mut dyn Policy, draws: &[f64]) -> (usize, Option<f64>) {
    let estimator = told(EstimatorKind::WholePast);
    let mut draws = draws.iter().copied();
    let choice = policy.choose(&Estimates::of(&*estimator), &mut || draws.next().unwrap());
    assert_eq!(draws.next(), None);
    (choice.part, choice.probability)
}

fn assert_chosen(kind: PolicyKind, draws: &[f64], part: usize, probability: f64) {
    let (found, its) = chosen(&mut *begun(kind), draws);
    assert_eq!(found, part, "{kind:?}");
    assert!((its.unwrap() - probability).abs() < 1e-14, "{kind:?}: {its:?}");
}

#[test]
fn estimators() {
    let kinds = [
        (EstimatorKind::WholePast, [2.0, 4.0, 1.0], [2.0, 1.0, 3.0]),
        (EstimatorKind::Window { size: 2, head_start: 1 }, [2.0, 4.0, 1.5], [2.0; 3]),
        (EstimatorKind::RecentWindow { size: 4 }, [3.0, 0.0, 1.0], [1.0, 0.0, 3.0]),
        (
            EstimatorKind::Discounted { gamma: 0.5, head_start: 0 },
            [25.0 / 9.0, 4.0, 3.0 / 1.625],
            [9.0 / 32.0, 1.0 / 16.0, 1.625],
        ),
    ];
    for (kind, means, counts) in kinds {
        let estimator = told(kind);
        for (got, expected) in estimator.means().iter().zip(means) {
            assert!((got - expected).abs() < 1e-14, "{kind:?}: {got} is not {expected}");
        }
        assert_eq!(estimator.counts(), counts, "{kind:?}");
        assert_eq!(estimator.largest(), LARGEST);
    }
}

#[test]
fn without_a_bound_the_largest_reward_is_the_largest_so_far() {
    let mut estimator = EstimatorKind::WholePast.start(2, 0.0).unwrap();
    assert_eq!(estimator.largest(), 0.0);
    for (reward, largest) in [(1.0, 1.0), (-7.0, 7.0), (2.0, 7.0)] {
        estimator.add(0, reward);
        assert_eq!(estimator.largest(), largest);
    }
}

#[test]
fn proportional() {
    // Means 2, 4, 1: sevenths.
    let kind = PolicyKind::Proportional { alpha: 0.3, power: 1.0 };
    assert_chosen(kind, &[0.3, 0.28], 0, 0.1 + 0.7 * 2.0 / 7.0);
    assert_chosen(kind, &[0.3, 0.29], 1, 0.1 + 0.7 * 4.0 / 7.0);
    assert_chosen(kind, &[0.29, 0.7], 2, 0.1 + 0.7 / 7.0);
    // Squares 4, 16, 1.
    let kind = PolicyKind::Proportional { alpha: 0.0, power: 2.0 };
    assert_chosen(kind, &[0.3, 0.2], 1, 16.0 / 21.0);
}

#[test]
fn epsilon_greedy() {
    let kind = PolicyKind::EpsilonGreedy { epsilon: 0.3 };
    assert_chosen(kind, &[0.3, 0.99], 1, 0.8);
    assert_chosen(kind, &[0.29, 0.99], 2, 0.1);
}

#[test]
fn softmax() {
    // Exponents 1, 2, 0.5.
    let total = 1.0_f64.exp() + 2.0_f64.exp() + 0.5_f64.exp();
    for (temperature, scaled) in [(0.5, true), (2.0, false)] {
        let kind = PolicyKind::Softmax { temperature, scaled };
        assert_chosen(kind, &[0.2], 0, 1.0_f64.exp() / total);
        assert_chosen(kind, &[0.99], 2, 0.5_f64.exp() / total);
    }
}

#[test]
fn thompson() {
    // 2 + 4 / sqrt(3) 1.96 = 6.53 is more than 4; so is 1 + 2 1.96 = 4.92; 1 + 2 1.476 is not.
    let mut policy = begun(PolicyKind::Thompson);
    assert_eq!(chosen(&mut *policy, &[0.975, 0.5, 0.5]), (0, None));
    assert_eq!(chosen(&mut *policy, &[0.5, 0.5, 0.975]), (2, None));
    assert_eq!(chosen(&mut *policy, &[0.5, 0.5, 0.93]), (1, None));
    assert_eq!(chosen(&mut *policy, &[0.5, 0.0, 0.0]), (0, None));
}

#[test]
fn exp3_and_exp3s() {
    // Reward 3 of 4, when chosen with probability 1/2: exp(0.6 1.5 / 3).
    let w = 0.3_f64.exp();
    let mut policy = begun(PolicyKind::Exp3 { gamma: 0.6 });
    policy.learn(1, 3.0, Some(0.5));
    let (part, probability) = chosen(&mut *policy, &[0.5]);
    assert_eq!(part, 1);
    assert!((probability.unwrap() - (0.4 * w / (2.0 + w) + 0.2)).abs() < 1e-15);
    // All three grow by e 0.1 / 3 of the sum 3.
    let mut policy = begun(PolicyKind::Exp3S { gamma: 0.6, alpha: 0.1 });
    policy.learn(1, 3.0, Some(0.5));
    let more = 0.1 * 1.0_f64.exp();
    let expected = 0.4 * (w + more) / (2.0 + w + 3.0 * more) + 0.2;
    assert!((chosen(&mut *policy, &[0.5]).1.unwrap() - expected).abs() < 1e-15);
}

#[test]
fn in_turn_and_at_random() {
    let mut policy = begun(PolicyKind::RoundRobin);
    let turns: Vec<_> = (0..4).map(|_| chosen(&mut *policy, &[]).0).collect();
    assert_eq!(turns, [0, 1, 2, 0]);
    assert_chosen(PolicyKind::Uniform, &[0.34], 1, 1.0 / 3.0);
}

#[test]
fn parameters_out_of_range_are_refused() {
    let estimators = [
        EstimatorKind::Window { size: 0, head_start: 0 },
        EstimatorKind::Window { size: 2, head_start: 3 },
        EstimatorKind::RecentWindow { size: 1_000_001 },
        EstimatorKind::Discounted { gamma: 0.0, head_start: 0 },
        EstimatorKind::Discounted { gamma: 0.5, head_start: 1_000_001 },
    ];
    for kind in estimators {
        assert!(kind.start(2, 1.0).is_err(), "{kind:?}");
    }
    let policies = [
        PolicyKind::Proportional { alpha: 1.1, power: 1.0 },
        PolicyKind::Proportional { alpha: 0.1, power: f64::NAN },
        PolicyKind::EpsilonGreedy { epsilon: -0.1 },
        PolicyKind::Softmax { temperature: 0.0, scaled: true },
        PolicyKind::Ucb { xi: -1.0 },
        PolicyKind::Exp3 { gamma: 0.0 },
        PolicyKind::Exp3S { gamma: 0.1, alpha: 1.1 },
    ];
    for kind in policies {
        assert!(kind.start(2, 1.0).is_err(), "{kind:?}");
    }
    for largest in [-1.0, f64::NAN, f64::INFINITY] {
        assert!(EstimatorKind::WholePast.start(2, largest).is_err());
        assert!(PolicyKind::Uniform.start(2, largest).is_err());
    }
    let none = Error::Count { name: "parts", must_be: "at least 1".to_owned(), got: 0 };
    assert_eq!(PolicyKind::RoundRobin.start(0, 1.0).unwrap_err(), none);
    assert_eq!(EstimatorKind::WholePast.start(0, 1.0).unwrap_err(), none);
}
