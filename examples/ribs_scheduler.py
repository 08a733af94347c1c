"""ADAPT in a script for pyribs: the line that makes the scheduler changes, and no other.

Needs pyribs: ``pip install 'divbandit[ribs]'``.
"""

import numpy as np
from ribs.archives import GridArchive
from ribs.emitters import GaussianEmitter, IsoLineEmitter
from ribs.schedulers import BanditScheduler

import divbandit as db
from divbandit.adapters import RibsScheduler

JOINTS = 12


def reach(angles):
    """Return where the tips of planar arms of length 1 are."""
    turned = np.cumsum(angles, axis=1)
    return np.stack([np.cos(turned), np.sin(turned)], axis=2).mean(axis=1)


def script(make_scheduler):
    """Explore as any script for pyribs does; smooth postures are the better ones."""
    archive = GridArchive(solution_dim=JOINTS, dims=[50, 50], ranges=[(-1, 1), (-1, 1)], seed=0)
    start = {"x0": np.zeros(JOINTS), "bounds": [(-2.6, 2.6)] * JOINTS, "batch_size": 20, "seed": 0}
    emitters = [GaussianEmitter(archive, sigma=sigma, **start) for sigma in (0.001, 0.1, 0.5)]
    scheduler = make_scheduler(archive, [*emitters, IsoLineEmitter(archive, **start)])
    for _ in range(300):
        solutions = scheduler.ask()
        scheduler.tell(-np.var(solutions, axis=1), reach(solutions))
    return scheduler


theirs = script(lambda *parts: BanditScheduler(*parts, num_active=1, reselect="all"))
ours = script(lambda *parts: RibsScheduler(*parts, lambda each: db.Adapt(each, tau=0.04), rng=0))
print(f"UCB1, of pyribs  covers {theirs.archive.stats.coverage:.2f} of the cells")
print(f"ADAPT            covers {ours.archive.stats.coverage:.2f} of the cells")
print("ADAPT asked", ", ".join(map(str, ours.asked)))
