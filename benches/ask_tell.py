"""What asking and telling costs, one trial at a time and a hundred, without the environment.

ADAPT over motor and goal babbling on the 20-joint arm; the effects are computed between the calls
and not counted.
"""

import statistics
import time

import numpy as np

import divbandit as db

STEPS = 10_000
REPEATS = 5


def strategy(d):
    return db.Adapt([db.MotorBabbling(), db.GoalBabbling(d)], tau=0.02)


def singly(arm, d):
    explorer = db.Explorer(strategy(d), arm.motor_space, arm.sensory_space, rng=0)
    spent, clock = 0.0, time.perf_counter
    for _ in range(STEPS):
        begin = clock()
        trial = explorer.ask()
        spent += clock() - begin
        effect = arm(trial.command)
        begin = clock()
        explorer.tell(trial, effect)
        spent += clock() - begin
    return spent / STEPS


def in_batches(arm, d, size=100):
    explorer = db.Explorer(strategy(d), arm.motor_space, arm.sensory_space, rng=0)
    spent, clock = 0.0, time.perf_counter
    for _ in range(STEPS // size):
        begin = clock()
        trials = explorer.ask(size)
        spent += clock() - begin
        effects = arm(np.array([trial.command for trial in trials]))
        begin = clock()
        explorer.tell(trials, effects)
        spent += clock() - begin
    return spent / STEPS


def main():
    arm = db.PlanarArm(20)
    print(f"us a trial, n = {STEPS}, least and median of {REPEATS} runs")
    for name, run in {"ask(), tell()": singly, "ask(100), tell()": in_batches}.items():
        for d in (0.001, 0.05, 0.5):
            times = [1e6 * run(arm, d) for _ in range(REPEATS)]
            print(f"  {name:18} d = {d:<6} {min(times):6.2f} {statistics.median(times):6.2f}")


if __name__ == "__main__":
    main()
