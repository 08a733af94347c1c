"""Adapt: the paper's algorithm, strategies chosen in proportion to their diversity.

ADAPT(w, tau, alpha) (Benureau and Oudeyer, ICDL-EpiRob 2015), at each step:

1. *Choose.* With probability alpha a strategy uniformly at random; otherwise strategy j with
   probability proportional to its diversity (uniformly where all are zero).
2. *Try.* The strategy proposes a motor command x; the environment answers with an effect y = f(x).
3. *Reward.* The gain of the effect is div_tau(y, E) = C_tau(E + y) - C_tau(E): the area by which
   its disc of radius tau enlarges the union of the discs around all effects E observed before,
   whichever strategy produced them. A trial that fails has no effect, and gains 0.
4. *Remember.* The diversity of a strategy is the mean of its last w gains, or of all while
   there are fewer. A head start of k fictitious gains, each of a whole disc, comes first in its
   window, so that it is likely to be tried; they count until w real gains have followed.

In the paper w = 50, alpha = 0.1, k = 1 and tau = 0.02.
"""

from __future__ import annotations

from dataclasses import dataclass
from typing import TYPE_CHECKING

from divbandit._checks import real, whole
from divbandit._core import powers, proportionally
from divbandit.bandits.bandit import RewardedValue, tau_or_reward
from divbandit.bandits.estimators import Window
from divbandit.bandits.estimators.window import LONGEST
from divbandit.bandits.running import RunningBandit
from divbandit.strategies.composite import strategies_of

if TYPE_CHECKING:
    from collections.abc import Iterable

    import numpy as np
    from numpy.random import Generator
    from numpy.typing import NDArray

    from divbandit._core import Trial
    from divbandit.bandits.bandit import Rewarding
    from divbandit.bandits.rewards import Reward
    from divbandit.history import History
    from divbandit.strategies.base import Starter, Strategy


#: The paper's radius of the discs.
_TAU = 0.02


@dataclass(frozen=True, init=False, repr=False)
class Adapt(RewardedValue):
    """ADAPT(w, tau, alpha) (Benureau and Oudeyer 2015, figures 3 and 4).

    With probability alpha a strategy uniformly at random; otherwise strategy j with probability
    proportional to its diversity, the mean gain of the last w effects that it produced. The gain
    of an effect is the area that its disc of radius tau adds to those of all effects observed
    before it, whichever strategy produced them; or what another reward makes of it.

    Parameters
    ----------
    strategies : iterable of Strategy
        Those to choose among; they may be bandits themselves.
    tau : float, optional
        Radius of the discs, in the units of the effects; positive. 0.02 by default, the paper's,
        for effects of the order of 1. Where it is far too small every effect gains a whole disc,
        where far too large none gains anything: then all strategies look alike. Effects beyond
        the plane have balls instead of discs, in the dimensions that `Coverage` takes.
    reward : Reward or callable, optional
        In place of the discs' area, for instance ``Gain(divbandit.measures.GridCoverage(0.05))``,
        or a function ``(effect, history) -> float``. A strategy whose mean reward is negative
        counts as one of diversity 0.
    window : int
        w, how many gains a strategy's diversity is averaged over; from 1 to a million.
    alpha : float
        Share of choices made uniformly at random, in [0, 1].
    head_start : int
        How many fictitious gains come first in each window, from 0 to `window`: each of a whole
        disc, or of what no reward exceeds (0 for a reward without a bound, as a function is). With
        0 all strategies begin with diversity 0 and are chosen uniformly until one gains.
    power : float
        Not negative. Strategies are chosen in proportion to this power of their diversity; 1 is the
        paper's.

    Attributes
    ----------
    strategies : tuple of Strategy
    tau : float or None
        None where a reward was given.
    reward, window, alpha, head_start, power
        As given.

    Raises
    ------
    TypeError, ValueError
        If a strategy is not one, a number is out of range, or `tau` and `reward` are both given.

    Examples
    --------
    >>> import divbandit as db
    >>> adapt = db.Adapt([db.MotorBabbling(), db.GoalBabbling(0.05)], tau=0.02)
    >>> run = db.explore(db.PlanarArm(20), adapt, n=1000, rng=0)
    >>> run.estimates.shape
    (1000, 2)
    """

    strategies: tuple[Strategy, ...]
    tau: float | None
    reward: Reward | None
    window: int
    alpha: float
    head_start: int
    power: float

    def __init__(
        self,
        strategies: Iterable[Strategy],
        *,
        tau: float | None = None,
        reward: Rewarding | None = None,
        window: int = 50,
        alpha: float = 0.1,
        head_start: int = 1,
        power: float = 1.0,
    ) -> None:
        every = strategies_of(strategies)
        radius, paid = tau_or_reward(_TAU if tau is None and reward is None else tau, reward)
        size = whole("window", window, low=1, high=LONGEST)
        self._set(
            strategies=every,
            tau=radius,
            reward=paid,
            window=size,
            alpha=real("alpha", alpha, low=0.0, high=1.0),
            head_start=whole("head_start", head_start, low=0, high=size),
            power=real("power", power, low=0.0),
        )

    def start(self, start: Starter) -> Strategy:
        """Return ADAPT under way."""
        return _Adapting(self, start)


class _Adapting(RunningBandit):
    """ADAPT under way: `estimator` holds the last w gains of each strategy."""

    def __init__(self, adapt: Adapt, start: Starter) -> None:
        window = Window(adapt.window, head_start=adapt.head_start)
        super().__init__(adapt.strategies, adapt.rewarding, window, start)
        self._alpha, self._power = adapt.alpha, adapt.power

    def choose(self, history: History, rng: Generator) -> int:
        """Choose the strategy that is to propose next; always two draws, ``rng.random()``."""
        del history
        diversities = self.estimator.means
        uniformly, u = rng.random() < self._alpha, rng.random()
        if uniformly:
            return int(u * len(diversities))
        return proportionally(powers(diversities, self._power), u)

    def observe(self, trial: Trial, effect: NDArray[np.float64]) -> None:
        """Remember the gain of a strategy's effect, which the history holds by now."""
        gain = self.reward_of(trial, effect)
        self.strategies[trial.path[0]].observe(trial.inner, effect)  # type: ignore[arg-type]
        self.estimator.add(trial.path[0], gain)
