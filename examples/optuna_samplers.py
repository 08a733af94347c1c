"""ADAPT chooses among samplers of Optuna: some find what was not found before, others the best.

Needs Optuna: ``pip install 'divbandit[optuna]'``.
"""

from functools import partial

import optuna

import divbandit as db
from divbandit.adapters import OptunaSampler
from divbandit.bandits import Gain

arm = db.PlanarArm(6)
GAIN = Gain(db.measures.BallCoverage(0.05))
TPE = partial(optuna.samplers.TPESampler, n_startup_trials=20)
parts = {
    "random": OptunaSampler(optuna.samplers.RandomSampler, reward=GAIN),
    "CMA-ES": OptunaSampler(optuna.samplers.CmaEsSampler, reward=GAIN),
    "TPE": OptunaSampler(TPE, reward=GAIN),
    # A sampler optimises what each of its effects newly covers, or whatever else is wanted.
    "TPE, to the right": OptunaSampler(TPE, reward=lambda effect, _: float(effect[0])),
}
adapt = db.Adapt(parts.values(), tau=0.05)
for name, strategy in {**parts, "ADAPT": adapt}.items():
    run = db.explore(arm, strategy, n=200, rng=0)
    covered, right = run.coverage(0.05)[-1], run.effects[-50:, 0].mean()
    print(f"{name:18} covers {covered:.2f} m2, ends around x = {right:.2f} m")
