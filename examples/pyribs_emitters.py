"""ADAPT chooses among emitters of pyribs, each of which sees what all of them have found.

Needs pyribs: ``pip install 'divbandit[ribs]'``.
"""

from ribs.emitters import GaussianEmitter

import divbandit as db
from divbandit.adapters import RibsEmitter

arm = db.PlanarArm(12)


def small_steps(archive, seed):
    """Make any emitter; its solutions are shares of the motor ranges."""
    return GaussianEmitter(archive, sigma=0.02, x0=[0.5] * archive.solution_dim, seed=seed)


emitters = {
    "steps along lines (MAP-Elites)": RibsEmitter("line", cells=50),
    "evolution strategy (CMA-ME)": RibsEmitter("evolution", cells=50),
    "small steps": RibsEmitter(small_steps, cells=50),
}
adapt = db.Adapt(emitters.values(), tau=0.05)
for name, strategy in {**emitters, "ADAPT": adapt}.items():
    run = db.explore(arm, strategy, n=1000, rng=0)
    print(f"{name:31} covers {run.coverage(0.05)[-1]:.2f} m2")
for index, name in enumerate(emitters):
    print(f"ADAPT chose {name}: {(run.choices == index).mean():.0%}")
