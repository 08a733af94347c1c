"""Diversity-driven selection of exploration strategies.

A black box f: M -> S can be tried n times. Which motor commands bring about the most different
effects? Several exploration strategies are the arms of a bandit, whose reward is the new volume
that their effects cover (Benureau and Oudeyer, ICDL-EpiRob 2015).

The names follow the data: environment -> strategy -> effect -> gain -> bandit -> exploration ->
experiment -> figure.

- The black box: `Environment` is what it must offer; `PlanarArm` is the paper's,
  `FunctionEnvironment` wraps a function and its spaces. A `Box` is a space of commands, effects
  or goals. More in `environments`: obstacles, pushing, Gymnasium, MuJoCo, external programs;
  `controllers` turn commands into trajectories. The field's own are in `benchmarks`.
- The strategies: `MotorBabbling` and `GoalBabbling`, which takes goal samplers from `goals` and
  inverse models from `inverse`; `Mixture` and `Schedule` combine others in fixed ways. Derive a
  new one from `Strategy` and write ``propose(history, rng)``; it returns a command, or a
  `Trial` with its goal. One made of others derives from `Composite` and writes ``choose``.
- The bandits are strategies, too: start with `default_strategy`. `Adapt` is the paper's;
  `Bandit` combines a reward, an estimator and a policy from `bandits`, which also has UCB1 and
  others.
- The measures of diversity: `coverage` is the area or volume that a set of effects covers,
  `Coverage` grows effect by effect; grids, entropy and others are in `measures`.
  `NearestNeighbors` is a search tree that grows.
- The exploration: `explore` runs it and returns an `Exploration`. For a robot, or anything else
  that cannot be called, an `Explorer` gives out trials, ``ask()``, and learns their effects,
  ``tell()``. The `History` of commands and effects is what strategies see. What watches a run, or
  stops it, is in `callbacks`.
- The experiments: `explore_many` runs many explorations, such as one for each of 25 seeds, in
  parallel; `experiments` has the task that it repeats, and summaries. `plot` draws; it needs
  matplotlib.
- Parts of other libraries - pyribs, Optuna, MABWiser, SciPy, Gymnasium - are in `adapters`.

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
    benchmarks,
    callbacks,
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
    "benchmarks",
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
    "callbacks",
    "explore_many",
    "experiments",
    "plot",
    "adapters",
]
