"""A callback that logs a run to MLflow.

Needs ``pip install mlflow-skinny``; ``mlflow ui`` shows it, where all of MLflow is installed.
"""

import mlflow

import divbandit as db

strategies = {"motor babbling": db.MotorBabbling(), "goal babbling": db.GoalBabbling(0.05)}
coverage = db.Coverage(0.02)


def log(explorer, _trial):
    """Log diversity, failures, and the share of evaluations that each strategy proposed."""
    history = explorer.history
    coverage.extend(history.effects[len(coverage) :])
    paths = [*history.paths, *(failure.path for failure in history.failures)]
    metrics = {"diversity": coverage.measure, "failures": len(history.failures)}
    for index, name in enumerate(strategies):
        metrics[f"share/{name}"] = sum(path[0] == index for path in paths) / len(paths)
    mlflow.log_metrics(metrics, step=len(paths))


with mlflow.start_run(run_name="adapt"):
    adapt = db.Adapt(strategies.values(), tau=0.02)
    mlflow.log_param("strategy", repr(adapt))
    log_some = db.callbacks.Every(10, log)
    run = db.explore(db.PlanarArm(20), adapt, 500, rng=0, callbacks=[log_some])
print(f"{run.coverage(0.02)[-1]:.3f} square metres after {len(run)} evaluations")
