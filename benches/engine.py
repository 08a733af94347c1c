"""What a step of a whole exploration costs, beside what it could at least cost and a peer.

ADAPT over motor and goal babbling, as in the paper: 20 joints, tau = 0.02, all recorded that the
paper records. The yardstick of every row is the plainest forward kinematics of as many commands:
a scalar loop over the standard library's sine and cosine (`benches/scalar_arm`). Each time is the
median over seeds of the best of some repetitions - of threads the best for all seeds together, of
the long runs the only one - and all are taken in one process.

Beside it stand the library's own composition, ADAPT over a function in Python that does nothing,
the loop in Python, and asking and telling. What each may cost at most is said at the end.

    python benches/engine.py [--quick]
"""

import argparse
import math
import statistics
from concurrent.futures import ThreadPoolExecutor
from dataclasses import dataclass

import numpy as np
from ribs.archives import GridArchive
from ribs.emitters import GaussianEmitter
from ribs.schedulers import Scheduler

import divbandit as db
import scalar_arm
from ask_tell import STEPS, singly
from divbandit.paper import setting
from timing import fastest

ARM = setting.arm()
JOINTS = ARM.motor_space.dim
MIDDLE = setting.PERTURBATIONS[1]
THREADS = 2
BATCH = 10


@dataclass(frozen=True)
class Size:
    """How much is done."""

    n: int = 10_000
    long: int = 1_000_000
    seeds: int = 10
    repeat: int = 3


@dataclass
class Row:
    """The cost of a step in seconds, and the diversity at the end in square metres."""

    work: str
    step: float
    diversity: float | None = None

    def line(self, yardstick):
        area = "" if self.diversity is None else f"{self.diversity:.3f} m²"
        ratio = self.step / yardstick
        return (
            f"| {self.work} | {self.step * 1e9:.0f} | {ratio:.{1 if ratio < 20 else 0}f} | {area} |"
        )


def main():
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("--quick", action="store_true", help="less of all, for a first look")
    size = Size(2_000, 100_000, 3, 2) if parser.parse_args().quick else Size()

    yardstick = plain_kinematics(size)
    engines = [engine(d, size) for d in setting.PERTURBATIONS]
    own, nothing = default_engine(size), idle_function(size)
    loops, asking = [python_loop(d, size) for d in setting.PERTURBATIONS], ask_and_tell(size)
    several = [threads(d, size) for d in setting.PERTURBATIONS]
    long = [long_engine(d, size) for d in setting.PERTURBATIONS]
    rows = [
        yardstick,
        *engines,
        *(row for row, _ in several),
        *long,
        own,
        nothing,
        *loops,
        asking,
        *draws(size),
        pyribs(size),
    ]
    print(f"| one step of n = {size.n} | ns | of the plain kinematics | diversity |")
    print("|---|---:|---:|---:|")
    for row in rows:
        print(row.line(yardstick.step))

    print(f"\nMedian over {size.seeds} seeds of the best of {size.repeat}; long runs: once.")
    for d, (_, gain) in zip(setting.PERTURBATIONS, several, strict=True):
        print(f"d = {d}: {THREADS} threads do {gain:.2f} times what one does.")
    for d, one, other in zip(setting.PERTURBATIONS, engines, long, strict=True):
        growth = other.step / one.step
        print(f"d = {d}: a step of {size.long} costs {growth:.2f} times one of {size.n}.")

    adapt = engines[1].step
    limits = [
        ("ADAPT in Rust, of the plain kinematics", adapt / yardstick.step, 3.3),
        ("the library's own composition in Rust, of ADAPT", own.step / adapt, 8.0),
        ("ADAPT over an idle function, us", nothing.step * 1e6, 3.0),
        ("ADAPT in Python, us", loops[1].step * 1e6, 10.0),
        ("a trial asked and told, us", asking.step * 1e6, 10.0),
    ]
    for work, found, most in limits:
        print(f"{work}: {found:.2f}, at most {most}" + ("" if found <= most else ": EXCEEDED"))


def over_seeds(work, size):
    """Return the median over seeds of the least time a step of `work(seed)`, and all results."""
    timed = [fastest(lambda s=seed: work(s), repeat=size.repeat) for seed in range(size.seeds)]
    return statistics.median(seconds for seconds, _ in timed) / size.n, [run for _, run in timed]


def explored(d, n, seed, *, by="rust"):
    return db.explore(ARM, setting.adapt(d), n, rng=seed, engine=by)


def median_diversity(runs):
    return statistics.median(db.coverage(run.effects, setting.TAU) for run in runs)


def engine(d, size):
    step, runs = over_seeds(lambda seed: explored(d, size.n, seed), size)
    return Row(f"exploration in Rust, d = {d}", step, median_diversity(runs))


def python_loop(d, size):
    step, runs = over_seeds(lambda seed: explored(d, size.n, seed, by="python"), size)
    again = explored(d, size.n, 0)
    for name in ("commands", "effects", "paths", "estimates"):
        assert np.array_equal(getattr(again, name), getattr(runs[0], name)), name
    return Row(f"exploration in Python, d = {d}", step, median_diversity(runs))


def default_engine(size):
    strategy = db.default_strategy(setting.TAU)
    step, runs = over_seeds(lambda seed: db.explore(ARM, strategy, size.n, rng=seed), size)
    return Row("exploration in Rust, default_strategy", step, median_diversity(runs))


def idle_function(size):
    """Explore what costs nothing: a function in Python whose effect is always the same."""
    effect = np.zeros(2)
    idle = db.FunctionEnvironment(lambda _: effect, ARM.motor_space, ARM.sensory_space)
    strategy = setting.adapt(MIDDLE)
    step, _ = over_seeds(lambda seed: db.explore(idle, strategy, size.n, rng=seed), size)
    return Row("exploration in Rust, an idle function in Python", step)


def ask_and_tell(size):
    step = min(singly(ARM, MIDDLE) for _ in range(size.repeat))
    return Row(f"ask() and tell(), n = {STEPS}", step)


def threads(d, size):
    """Explore with all seeds, several at once: the time that passes, for each of all steps.

    Returns the row, and how many times as much is done as by one thread, taken alike.
    """
    least, runs = {}, {}
    with ThreadPoolExecutor(1) as one, ThreadPoolExecutor(THREADS) as several:
        pools = {1: one, THREADS: several}
        for _ in range(size.repeat):
            for count, pool in pools.items():
                seconds, runs[count] = fastest(lambda p=pool: all_seeds(p, d, size), repeat=1)
                least[count] = min(seconds, least.get(count, math.inf))
    for alone, beside in zip(runs[1], runs[THREADS], strict=True):
        assert np.array_equal(alone.commands, beside.commands)
    step = least[THREADS] / size.n / size.seeds
    work = f"exploration in Rust, {THREADS} threads, d = {d}"
    return Row(work, step, median_diversity(runs[THREADS])), least[1] / least[THREADS]


def all_seeds(pool, d, size):
    return list(pool.map(lambda seed: explored(d, size.n, seed), range(size.seeds)))


def long_engine(d, size):
    seconds, run = fastest(lambda: explored(d, size.long, 0), repeat=1)
    work = f"exploration in Rust, d = {d}, n = {size.long}"
    return Row(work, seconds / size.long, median_diversity([run]))


def plain_kinematics(size):
    """The kinematics of the very commands that explorations made."""
    runs = [explored(MIDDLE, size.n, seed) for seed in range(size.seeds)]
    step, effects = over_seeds(lambda seed: scalar_arm.effects(runs[seed].commands), size)
    for run, found in zip(runs, effects, strict=True):
        np.testing.assert_allclose(found, ARM(run.commands), rtol=0, atol=1e-12)
        np.testing.assert_allclose(found, run.effects, rtol=0, atol=1e-12)
    return Row(f"plain kinematics alone, {JOINTS} joints, scalar", step)


def count_draws(run):
    """Count an exploration's uniform numbers: 2 to choose, m for a command, s for a goal.

    The first command has no goal, whichever strategy proposes it: nothing is known to start from.
    """
    goals = np.count_nonzero(run.choices[1:] == setting.LABELS.index("goal babbling"))
    return len(run) * (2 + run.commands.shape[1]) + int(goals) * run.effects.shape[1]


def draws(size):
    """NumPy's draws of as many uniform numbers, all at once and one by one."""
    counts = []
    for seed in range(size.seeds):
        used, apart = np.random.default_rng(seed), np.random.default_rng(seed)
        run = explored(MIDDLE, size.n, used)
        counts.append(count_draws(run))
        apart.bit_generator.advance(counts[-1])
        assert apart.random() == used.random(), "the exploration drew another number of times"

    def at_once(seed):
        return np.random.default_rng(seed).random(counts[seed])

    def one_by_one(seed):
        draw = np.random.default_rng(seed).random
        for _ in range(counts[seed]):
            draw()

    each = statistics.mean(counts) / size.n
    return [
        Row(f"its {each:.1f} draws alone, NumPy, in one call", over_seeds(at_once, size)[0]),
        Row(f"its {each:.1f} draws alone, NumPy, a call each", over_seeds(one_by_one, size)[0]),
    ]


def pyribs(size):
    """Let elites of a grid beget commands, in batches; the arm is ours and costs next to nothing.

    The noise has the deviation of the inverse model's perturbation.
    """
    bounds = list(zip(ARM.motor_space.low, ARM.motor_space.high, strict=True))
    reach = MIDDLE * (ARM.motor_space.high - ARM.motor_space.low)

    def illuminate(seed):
        archive = GridArchive(
            solution_dim=JOINTS, dims=[100, 100], ranges=[(-1, 1), (-1, 1)], seed=seed
        )
        emitter = GaussianEmitter(
            archive,
            sigma=reach / math.sqrt(3),
            x0=np.zeros(JOINTS),
            bounds=bounds,
            batch_size=BATCH,
            seed=seed,
        )
        scheduler = Scheduler(archive, [emitter])
        objectives = np.zeros(BATCH)
        effects = []
        for _ in range(size.n // BATCH):
            measures = ARM(scheduler.ask())
            scheduler.tell(objectives, measures)
            effects.append(measures)
        return effects

    illuminate(0)  # compiles
    step, runs = over_seeds(illuminate, size)
    found = [db.coverage(np.concatenate(effects), setting.TAU) for effects in runs]
    return Row(f"pyribs, Gaussian emitter, batches of {BATCH}", step, statistics.median(found))


if __name__ == "__main__":
    main()
