"""A slow black box, tried four at a time on a Dask cluster: here two processes of this machine.

Needs Dask: ``pip install 'divbandit[dask]'``. On a real cluster only the client's address differs.
"""

import time
from collections import Counter

from distributed import Client, LocalCluster, get_worker

import divbandit as db

arm = db.PlanarArm(7)


def simulate(command):
    """Return the position of the arm's tip, after some time."""
    time.sleep(0.005)
    get_worker().log_event("tries", get_worker().name)
    return arm(command)


def main():
    """Explore; a script that starts processes must not do so while they import it."""
    environment = db.FunctionEnvironment(simulate, arm.motor_space, arm.sensory_space)
    strategy = db.Adapt([db.MotorBabbling(), db.GoalBabbling(0.05)], tau=0.05)
    with (
        LocalCluster(n_workers=2, threads_per_worker=1, dashboard_address=None) as cluster,
        Client(cluster) as client,
        client.get_executor() as executor,
    ):
        run = db.explore(environment, strategy, n=200, rng=0, executor=executor, in_flight=4)
        tries = Counter(name for _, name in client.get_events("tries"))
    print(f"{len(run.effects)} effects cover {run.coverage(0.05)[-1]:.2f} m2")
    for worker, count in sorted(tries.items()):
        print(f"process {worker} made {count} tries")


if __name__ == "__main__":
    main()
