"""What a step of the Python loop costs: ADAPT over motor and goal babbling on the paper's arm.

python benches/loop.py
"""

import time

import divbandit as db
from divbandit.paper import setting

N = 10_000


def main():
    arm = setting.arm()
    print("| d | us per step, n = 10000 (best of 5) | diversity |")
    print("|---|---:|---:|")
    for d in setting.PERTURBATIONS:
        times = []
        for seed in range(5):
            start = time.perf_counter()
            run = db.explore(arm, setting.adapt(d), N, rng=seed)
            times.append(time.perf_counter() - start)
        print(f"| {d} | {min(times) / N * 1e6:.1f} | {run.coverage(setting.TAU)[-1]:.3f} m² |")


if __name__ == "__main__":
    main()
