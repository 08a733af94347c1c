"""Diversity-driven selection of exploration strategies.

A black box f: M -> S can be tried n times. Which motor commands bring about the most different
effects? Several exploration strategies are the arms of a bandit, whose reward is the new volume
that their effects cover (Benureau and Oudeyer, ICDL-EpiRob 2015).

The names follow the data: environment -> strategy -> effect -> gain -> bandit -> exploration ->
experiment -> figure.

- The black box: `Environment` is what it must offer; `PlanarArm` is the paper's,
  `FunctionEnvironment` makes one of a function, `Box` is a space of commands, effects or goals.
  More in `environments` (obstacles, pushing, Gymnasium, MuJoCo, processes) and `controllers`
  (commands as movements).
- The strategies: `MotorBabbling`, `GoalBabbling`, and fixed combinations of others, `Mixture` and
  `Schedule`. `goals` has other ways to draw goals, `inverse` other inverse models. User-defined
  ones derive from `Strategy`, or from `Composite`; a `Trial` is what they may propose.
- The bandits, strategies too: `Adapt` is the paper's, `default_strategy` the library's own
  composition, `Bandit` is made of a reward, an estimator and a policy from `bandits`, which also
  has UCB1 and others by name.
- The measures of diversity: `coverage` is the volume of a union of balls, `Coverage` grows effect
  by effect; grids, entropy and others are in `measures`. `NearestNeighbors` is a search tree that
  grows.
- The exploration: `explore` runs it and returns an `Exploration`; an `Explorer` is asked for trials
  and told their effects; the `History` is what strategies see.
- The experiments: `explore_many` runs many at once; `experiments` has tasks and summaries of them.
  `plot` draws; it needs matplotlib.
- Parts of other libraries, pyribs, Optuna, MABWiser, SciPy and Gymnasium, are in `adapters`.

Examples
--------
>>> import divbandit as db
>>> strategies = [db.MotorBabbling(), db.GoalBabbling(0.05)]
>>> run = db.explore(db.PlanarArm(20), db.Adapt(strategies, tau=0.02), n=1000, rng=0)
>>> f"{run.coverage(0.02)[-1]:.1f} square metres"
'0.8 square metres'
"""

from divbandit import (
    adapters,
    bandits,
    controllers,
    environments,
    experiments,
    goals,
    inverse,
    measures,
    plot,
)
from divbandit._core import NearestNeighbors
from divbandit.bandits import Adapt, Bandit, default_strategy
from divbandit.box import Box
from divbandit.environments import Environment, FunctionEnvironment, PlanarArm
from divbandit.experiments import explore_many
from divbandit.exploration import Exploration, Explorer, explore
from divbandit.history import History
from divbandit.measures import Coverage, coverage
from divbandit.strategies import (
    Composite,
    GoalBabbling,
    Mixture,
    MotorBabbling,
    Schedule,
    Strategy,
    Trial,
)

__all__ = [  # noqa: RUF022 - in the order of the data
    "Box",
    "Environment",
    "PlanarArm",
    "FunctionEnvironment",
    "environments",
    "controllers",
    "Strategy",
    "Trial",
    "MotorBabbling",
    "GoalBabbling",
    "goals",
    "inverse",
    "Composite",
    "Mixture",
    "Schedule",
    "Coverage",
    "coverage",
    "NearestNeighbors",
    "measures",
    "Adapt",
    "Bandit",
    "default_strategy",
    "bandits",
    "History",
    "explore",
    "Exploration",
    "Explorer",
    "explore_many",
    "experiments",
    "plot",
    "adapters",
]
