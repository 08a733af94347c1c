//! Binding of the policies: which strategy a bandit chooses.

use divbandit_core::Error;
use divbandit_core::bandits::policies::{self, Choice, Estimates, Policy, PolicyKind};
use divbandit_core::error::{check_finite, check_length};
use divbandit_core::strategies;
use pyo3::intern;
use pyo3::prelude::*;

use crate::arrays::{Any, Floats, count, number};
use crate::errors::Result;
use crate::estimators::{PyEstimator, finite, part_of};
use crate::parts::{class_of, made_of, ours};
use crate::random::NumpyStream;

/// Which policy a value of the library is; None for a user's.
pub(crate) fn policy_of(part: &Any<'_>) -> Result<Option<PolicyKind>> {
    Ok(Some(match class_of(part)?.as_deref() {
        Some("Proportional") => made_of!(part, PolicyKind::Proportional { alpha, power }),
        Some("EpsilonGreedy") => made_of!(part, PolicyKind::EpsilonGreedy { epsilon }),
        Some("Softmax") => made_of!(part, PolicyKind::Softmax { temperature, scaled }),
        Some("UCB") => made_of!(part, PolicyKind::Ucb { xi }),
        Some("Thompson") => PolicyKind::Thompson,
        Some("Exp3") => made_of!(part, PolicyKind::Exp3 { gamma }),
        Some("Exp3S") => made_of!(part, PolicyKind::Exp3S { gamma, alpha }),
        Some("RoundRobin") => PolicyKind::RoundRobin,
        Some("Uniform") => PolicyKind::Uniform,
        _ => return Ok(None),
    }))
}

/// A running policy of the library: it chooses, and learns.
///
/// Parameters
/// ----------
/// value : policy of the library
///     For instance ``db.bandits.Proportional(0.1)``.
/// parts : int
///     How many strategies there are.
/// largest : float
///     Upper bound of the rewards; 0.0 if there is none.
///
/// Raises
/// ------
/// TypeError, ValueError
///     If `value` is not a policy of the library, there are no parts, or `largest` is negative or
///     not finite.
///
/// Examples
/// --------
/// >>> import numpy as np
/// >>> from divbandit.bandits import Proportional, WholePast
/// >>> estimates, policy = WholePast().start(2, 6.0), Proportional(0.5).start(2, 6.0)
/// >>> estimates.add(1, 3.0)
/// >>> policy.choose(estimates, np.random.default_rng(0))
/// (1, 0.75)
#[pyclass(module = "divbandit._core", name = "Policy")]
pub(crate) struct PyPolicy {
    policy: Box<dyn Policy>,
    parts: usize,
}

#[pymethods]
impl PyPolicy {
    #[new]
    fn new(value: &Any<'_>, parts: &Any<'_>, largest: &Any<'_>) -> Result<Self> {
        let kind = ours(policy_of(value)?, "a policy", value)?;
        let parts = count("parts", parts)?;
        Ok(Self { policy: kind.start(parts, number("largest", largest)?)?, parts })
    }

    /// Choose the strategy that proposes next.
    ///
    /// Parameters
    /// ----------
    /// estimates : object with means, counts and largest
    ///     A running estimator; one mean and one count for each strategy.
    /// rng : numpy.random.Generator
    ///     The only source of randomness, by ``rng.random()``.
    ///
    /// Returns
    /// -------
    /// index : int
    /// probability : float or None
    ///     Of this choice, if the policy knows it.
    ///
    /// Raises
    /// ------
    /// TypeError, ValueError
    ///     If the estimates are not finite numbers, or of another number of strategies, or `rng` is
    ///     not a generator.
    ///
    /// Examples
    /// --------
    /// >>> import numpy as np
    /// >>> from divbandit.bandits import RoundRobin, WholePast
    /// >>> estimates, policy = WholePast().start(2, 6.0), RoundRobin().start(2, 6.0)
    /// >>> rng = np.random.default_rng(0)
    /// >>> [policy.choose(estimates, rng)[0] for _ in range(3)]
    /// [0, 1, 0]
    fn choose(&mut self, estimates: &Any<'_>, rng: &Any<'_>) -> Result<(usize, Option<f64>)> {
        let Choice { part, probability } = match estimates.cast_exact::<PyEstimator>() {
            Ok(estimator) => {
                let estimator = estimator.try_borrow()?;
                let estimates = Estimates::of(&*estimator.0);
                check_length("estimates.means", estimates.means, self.parts)?;
                self.policy.choose(&estimates, NumpyStream::lock(rng)?.draws())
            }
            Err(_) => {
                let means = self.read("estimates.means", &estimates.getattr("means")?)?;
                let counts = self.read("estimates.counts", &estimates.getattr("counts")?)?;
                let largest = estimates.getattr(intern!(rng.py(), "largest"))?;
                let largest = finite("estimates.largest", &largest)?;
                let estimates = Estimates { means: &means, counts: &counts, largest };
                self.policy.choose(&estimates, NumpyStream::lock(rng)?.draws())
            }
        };
        Ok((part, probability))
    }

    /// Learn what a strategy has earned.
    ///
    /// Parameters
    /// ----------
    /// part : int
    ///     Its index.
    /// reward : float
    /// probability : float or None
    ///     Of that choice, if it is known.
    ///
    /// Raises
    /// ------
    /// TypeError, ValueError
    ///     If there is no such strategy, `reward` is not a finite number, or `probability` not in
    ///     (0, 1].
    ///
    /// Examples
    /// --------
    /// >>> import numpy as np
    /// >>> from divbandit.bandits import Exp3, WholePast
    /// >>> estimates, policy = WholePast().start(2, 6.0), Exp3(0.5).start(2, 6.0)
    /// >>> policy.learn(1, 3.0, 0.5)  # exp(0.5 (0.5 / 0.5) / 2) = 1.284
    /// >>> index, probability = policy.choose(estimates, np.random.default_rng(0))
    /// >>> index, round(probability, 6)
    /// (1, 0.531088)
    fn learn(
        &mut self,
        part: &Any<'_>,
        reward: &Any<'_>,
        probability: Option<&Any<'_>>,
    ) -> Result<()> {
        let (part, reward) = (part_of(part, self.parts)?, finite("reward", reward)?);
        let probability = probability.map(probability_of).transpose()?;
        self.policy.learn(part, reward, probability);
        Ok(())
    }

    fn __repr__(&self) -> String {
        format!("<Policy of {} strategies>", self.parts)
    }
}

impl PyPolicy {
    /// Reads what a user's estimator says of each strategy.
    fn read(&self, name: &'static str, numbers: &Any<'_>) -> Result<Vec<f64>> {
        let numbers = Floats::point(name, numbers, Some(self.parts))?.copied()?;
        check_finite(name, &numbers, self.parts)?;
        Ok(numbers)
    }
}

/// Reads the probability of a choice that was made.
fn probability_of(probability: &Any<'_>) -> Result<f64> {
    let got = number("probability", probability)?;
    if 0.0 < got && got <= 1.0 {
        return Ok(got);
    }
    Err(Error::Number { name: "probability", must_be: "in (0, 1]", got }.into())
}

/// An index with probability proportional to its weight; uniformly if all are 0.
///
/// Parameters
/// ----------
/// weights : list of float
///     At least one; none is negative.
/// u : float
///     A draw from [0, 1).
///
/// Raises
/// ------
/// ValueError
///     If there are no weights, or `u` is not in [0, 1).
///
/// Examples
/// --------
/// >>> from divbandit._core import proportionally
/// >>> proportionally([1.0, 3.0], 0.2), proportionally([1.0, 3.0], 0.3)
/// (0, 1)
#[pyfunction]
pub(crate) fn proportionally(weights: Vec<f64>, u: f64) -> Result<usize> {
    if weights.is_empty() {
        return Err(Error::Empty { name: "weights" }.into());
    }
    if !(0.0..1.0).contains(&u) {
        return Err(Error::Number { name: "u", must_be: "in [0, 1)", got: u }.into());
    }
    Ok(strategies::proportionally(weights.iter().copied(), u))
}

/// The means' shares of the largest to a power; negative ones count as 0.
///
/// As shares none overflows, and not all vanish. Of the power 1 these are the means themselves.
///
/// Parameters
/// ----------
/// means : list of float
/// power : float
///     Not negative.
///
/// Raises
/// ------
/// ValueError
///     If `power` is negative or not finite.
///
/// Examples
/// --------
/// >>> from divbandit._core import powers
/// >>> powers([-1.0, 2.0, 4.0], 2.0), powers([-1.0, 2.0, 4.0], 1.0)
/// ([0.0, 0.25, 1.0], [0.0, 2.0, 4.0])
#[pyfunction]
pub(crate) fn powers(means: Vec<f64>, power: f64) -> Result<Vec<f64>> {
    if !(power.is_finite() && power >= 0.0) {
        let must_be = "finite and not negative";
        return Err(Error::Number { name: "power", must_be, got: power }.into());
    }
    let mut weights = Vec::with_capacity(means.len());
    policies::powers(&means, power, &mut weights);
    Ok(weights)
}
