"""The same work done by divbandit and by what a user would write today, in one process.

Each comparison checks that both sides found the same, then prints the time of each and their
ratio. With ``--readme FILE`` the table also replaces the one in that file.

    python benches/peers.py [--quick] [--readme README.md]
"""

import argparse
import math
import time
from pathlib import Path

import numpy as np
import shapely
from scipy.spatial import cKDTree

import divbandit as db

TAU = 0.02
ARM = db.PlanarArm(20)


def main():
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("--quick", action="store_true", help="smaller sets, for a first look")
    parser.add_argument("--readme", type=Path, help="a file whose table to replace")
    options = parser.parse_args()
    scale = 10 if options.quick else 1
    rows = [
        kinematics_batch(10000 // scale),
        kinematics_single(10000 // scale),
        nearest_neighbour(10000 // scale),
        growing_union(2000 // scale),
        whole_union(5000 // scale),
        whole_union(20000 // scale),
    ]
    table = "\n".join(
        [
            "| the same work | peer | peer's time | divbandit | ratio |",
            "|---|---|---:|---:|---:|",
            *(
                f"| {work} | {peer} | {readable(peers)} | {readable(ours)} | {peers / ours:.0f}x |"
                for work, peer, peers, ours in rows
            ),
        ]
    )
    print(table)
    if options.readme:
        replace_table(options.readme, table)


def fastest(work, *, repeat):
    """Return the least time that `work` took, and its result."""
    times = []
    for _ in range(repeat):
        start = time.perf_counter()
        result = work()
        times.append(time.perf_counter() - start)
    return min(times), result


def numpy_kinematics(commands):
    angles = np.cumsum(commands, axis=-1)
    tips = (np.cos(angles).sum(axis=-1), np.sin(angles).sum(axis=-1))
    return np.stack(tips, axis=-1) / commands.shape[-1]


def some_commands(n):
    space = ARM.motor_space
    return np.random.default_rng(0).uniform(space.low, space.high, (n, space.dim))


def some_effects(n):
    """Effects as explorations yield them: half motor babbling, half goal babbling."""
    strategy = db.Mixture([db.MotorBabbling(), db.GoalBabbling(0.05)])
    return db.explore(ARM, strategy, n=n, rng=0).effects


def kinematics_batch(n):
    commands = some_commands(n)
    theirs, expected = fastest(lambda: numpy_kinematics(commands), repeat=20)
    ours, found = fastest(lambda: ARM(commands), repeat=20)
    np.testing.assert_allclose(found, expected, atol=1e-14)
    return "kinematics, 20 joints, one command of a batch", "NumPy", theirs / n, ours / n


def kinematics_single(n):
    commands = list(some_commands(n))
    theirs, expected = fastest(lambda: [numpy_kinematics(x) for x in commands], repeat=5)
    ours, found = fastest(lambda: [ARM(x) for x in commands], repeat=5)
    np.testing.assert_allclose(found, expected, atol=1e-14)
    return "kinematics, 20 joints, one command a call", "NumPy", theirs / n, ours / n


def nearest_neighbour(n):
    """Every step adds an effect and looks for the one nearest to a goal."""
    effects = some_effects(n)
    goals = np.random.default_rng(1).uniform(-1, 1, (n, 2))

    def scipy_steps():
        found = []
        tree, size = None, 0
        for i in range(n):
            if i + 1 - size >= 100:
                size = i + 1
                tree = cKDTree(effects[:size])
            distance, index = (math.inf, -1) if tree is None else tree.query(goals[i])
            rest = effects[size : i + 1]
            if len(rest):
                squared = ((rest - goals[i]) ** 2).sum(axis=1)
                j = int(squared.argmin())
                if squared[j] < distance**2:
                    index = size + j
            found.append(index)
        return found

    def our_steps():
        tree = db.NearestNeighbors(2)
        found = []
        for i in range(n):
            tree.add(effects[i])
            found.append(tree.nearest(goals[i])[1])
        return found

    theirs, expected = fastest(scipy_steps, repeat=3)
    ours, found = fastest(our_steps, repeat=3)
    assert found == expected
    return (
        f"nearest neighbour while {n} effects arrive, one step",
        "SciPy cKDTree rebuilt every 100, brute force on the rest",
        theirs / n,
        ours / n,
    )


def growing_union(n):
    """Every step adds a disc to the union and asks for the area that it added."""
    effects = some_effects(n)

    def shapely_steps():
        union = shapely.Polygon()
        for effect in effects:
            union = union.union(shapely.Point(effect).buffer(TAU, quad_segs=16))
        return union.area

    def our_steps():
        coverage = db.Coverage(TAU)
        for effect in effects:
            coverage.add(effect)
        return coverage.measure

    theirs, expected = fastest(shapely_steps, repeat=1)
    ours, found = fastest(our_steps, repeat=20)
    same_but_for_polygons(found, expected)
    return f"union growing by {n} discs", "Shapely union, 64-gons", theirs, ours


def whole_union(n):
    effects = some_effects(n)

    def shapely_union():
        return shapely.union_all(shapely.buffer(shapely.points(effects), TAU, quad_segs=16)).area

    theirs, expected = fastest(shapely_union, repeat=3)
    ours, found = fastest(lambda: db.coverage(effects, TAU), repeat=10)
    same_but_for_polygons(found, expected)
    return f"union of {n} discs at once, ours exact", "Shapely union_all, 64-gons", theirs, ours


def same_but_for_polygons(exact, polygons):
    """A 64-gon is 0.16 % smaller than its disc; a union loses at most that share."""
    assert 0.998 * exact < polygons < exact


def readable(seconds):
    for unit, size in (("s", 1.0), ("ms", 1e-3), ("us", 1e-6)):
        if seconds >= size:
            return f"{seconds / size:.3g} {unit}"
    return f"{seconds / 1e-9:.3g} ns"


def replace_table(path, table):
    begin, end = "<!-- peers -->\n", "<!-- /peers -->"
    text = path.read_text(encoding="utf-8")
    before, rest = text.split(begin)
    after = rest.split(end)[1]
    path.write_text(f"{before}{begin}{table}\n{end}{after}", encoding="utf-8")


if __name__ == "__main__":
    main()
