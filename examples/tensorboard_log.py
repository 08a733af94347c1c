"""A callback that logs a run to TensorBoard.

Needs ``pip install tensorboardX``; ``tensorboard --logdir runs`` shows it.
"""

from tensorboardX import SummaryWriter

import divbandit as db

strategies = {"motor babbling": db.MotorBabbling(), "goal babbling": db.GoalBabbling(0.05)}
coverage = db.Coverage(0.02)


def log(explorer, _trial):
    """Log diversity, failures, and the share of evaluations that each strategy proposed."""
    history = explorer.history
    coverage.extend(history.effects[len(coverage) :])
    paths = [*history.paths, *(failure.path for failure in history.failures)]
    writer.add_scalar("diversity", coverage.measure, len(paths))
    writer.add_scalar("failures", len(history.failures), len(paths))
    for index, name in enumerate(strategies):
        share = sum(path[0] == index for path in paths) / len(paths)
        writer.add_scalar(f"share/{name}", share, len(paths))


with SummaryWriter("runs/adapt") as writer:
    adapt = db.Adapt(strategies.values(), tau=0.02)
    log_some = db.callbacks.Every(10, log)
    run = db.explore(db.PlanarArm(20), adapt, 500, rng=0, callbacks=[log_some])
print(f"{run.coverage(0.02)[-1]:.3f} square metres after {len(run)} evaluations")
