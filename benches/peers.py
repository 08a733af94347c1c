"""The same work done by divbandit and by what a user would write today, in one process.

Each comparison checks that both sides found the same, then prints the time of each, their ratio
and, for unions, the relative error of each against an oracle of the tests. With ``--readme FILE``
the table also replaces the one in that file.

    python benches/peers.py [--quick] [--readme README.md]
"""

import argparse
import math
import sys
from dataclasses import dataclass
from pathlib import Path

import numpy as np
import shapely
from scipy.spatial import cKDTree

import divbandit as db
from timing import fastest

sys.path.append(str(Path(__file__).parents[1]))
from tests.reference.contact import postures, shape
from tests.reference.slices import sliced_volume
from tests.reference.tessellation import tessellated_volume
from tests.reference.union_area import union_area

TAU = 0.02
ARM = db.PlanarArm(20)
PIXELS = 512
OBSTRUCTED_WORK = "arm of 20 links among 10 obstacles to its first contact"
OBSTRUCTED = db.PlanarArm(
    20,
    obstacles=[
        db.environments.Disc([0.3, 0.45], 0.1),
        db.environments.Disc([-0.3, -0.4], 0.05),
        db.environments.Disc([0.8, -0.5], 0.1),
        db.environments.Rectangle([-0.6, -0.8], [-0.3, -0.6]),
        db.environments.Rectangle([0.1, -0.7], [0.3, -0.4]),
        db.environments.Polygon(
            [[0.5, -0.4], [0.8, -0.4], [0.8, -0.35], [0.55, -0.35], [0.55, -0.2], [0.5, -0.2]]
        ),
        db.environments.Polygon([[-0.2, 0.5], [0, 0.9], [-0.4, 0.9], [-0.2, 0.7]]),
        db.environments.Wall([-0.5, 0.2], [-0.3, 0.6], thickness=0.02),
        db.environments.Wall([0.6, 0.4], [0.9, 0.5]),
        db.environments.Wall([-0.9, 0], [-0.5, 0], thickness=0.01),
    ],
)


@dataclass
class Row:
    """The same work: seconds each, and relative errors where there is a truth to compare with."""

    work: str
    peer: str
    theirs: float
    ours: float
    their_error: float | None = None
    our_error: float | None = None

    def __str__(self):
        return (
            f"| {self.work} | {self.peer} | {readable(self.theirs)} | {share(self.their_error)} "
            f"| {readable(self.ours)} | {share(self.our_error)} | {self.theirs / self.ours:.0f}x |"
        )


def share(error):
    """Return a relative error as text; below 1e-15 rounding is all there is."""
    return "" if error is None else f"{max(error, 1e-15):.0e}"


def main():
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("--quick", action="store_true", help="smaller sets, for a first look")
    parser.add_argument("--readme", type=Path, help="a file whose table to replace")
    options = parser.parse_args()
    scale = 10 if options.quick else 1
    rows = [
        kinematics_batch(10000 // scale),
        kinematics_single(10000 // scale),
        obstructed_batch(1000 // scale),
        obstructed_single(1000 // scale),
        nearest_neighbour(10000 // scale),
        growing_union(2000 // scale),
        whole_union(5000 // scale),
        whole_union(20000 // scale),
        raster(20000 // scale),
        union_of_balls(10000 // scale),
    ]
    table = "\n".join(
        [
            "| the same work | peer | peer's time | its error | divbandit | its error | ratio |",
            "|---|---|---:|---:|---:|---:|---:|",
            *map(str, rows),
        ]
    )
    print(table)
    if options.readme:
        replace_table(options.readme, table)


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
    return Row("kinematics, 20 joints, one command of a batch", "NumPy", theirs / n, ours / n)


def kinematics_single(n):
    commands = list(some_commands(n))
    theirs, expected = fastest(lambda: [numpy_kinematics(x) for x in commands], repeat=5)
    ours, found = fastest(lambda: [ARM(x) for x in commands], repeat=5)
    np.testing.assert_allclose(found, expected, atol=1e-14)
    return Row("kinematics, 20 joints, one command a call", "NumPy", theirs / n, ours / n)


def shapely_obstacles():
    """Return the obstacles as thin shapes, and how near to each the arm's axes can come."""
    pairs = [shape(obstacle) for obstacle in OBSTRUCTED.obstacles]
    apart = np.array([radius for _, radius in pairs]) + OBSTRUCTED.thickness / 2
    thin = np.array([each for each, _ in pairs])
    shapely.prepare(thin)
    return thin, apart


def shapely_progress(commands, thin, apart):
    """Advance all arms at once, each by what is safe: its clearance over its largest speed.

    The arm is one line string: link by link there are fewer steps, but each costs far more.
    """
    speeds = np.abs(np.cumsum(commands, axis=1)).sum(axis=1) / commands.shape[1]
    progress = np.ones(len(commands))
    moving, shares = np.arange(len(commands)), np.zeros(len(commands))
    while len(moving):
        lines = shapely.linestrings(postures(shares[:, None] * commands[moving]))
        clearances = (shapely.distance(thin, lines[:, None]) - apart).min(axis=1)
        safe = clearances / speeds[moving]
        stopped = safe < 1e-9
        progress[moving[stopped]] = shares[stopped]
        on = ~stopped & (shares + safe < 1)
        moving, shares = moving[on], (shares + safe)[on]
    return progress


def shapely_progress_of_one(command, thin, apart):
    speed = np.abs(np.cumsum(command)).sum() / len(command)
    share = 0.0
    while share < 1:
        line = shapely.linestrings(postures(share * command))
        safe = (shapely.distance(thin, line) - apart).min() / speed
        if safe < 1e-9:
            return share
        share += safe
    return 1.0


def some_obstructed_commands(n):
    """Commands as an exploration yields them; a good half of them end in contact."""
    strategy = db.Mixture([db.MotorBabbling(), db.GoalBabbling(0.05)])
    commands = db.explore(OBSTRUCTED, strategy, n=n, rng=0).commands
    assert 0.4 < np.mean(OBSTRUCTED.progress(commands) < 1) < 0.8
    return commands


def obstructed_batch(n):
    commands = some_obstructed_commands(n)
    shapes = shapely_obstacles()
    theirs, progress = fastest(lambda: shapely_progress(commands, *shapes), repeat=3)
    ours, tips = fastest(lambda: OBSTRUCTED(commands), repeat=20)
    same_contacts(commands, tips, progress)
    return Row(f"{OBSTRUCTED_WORK}, one of a batch", "NumPy and Shapely", theirs / n, ours / n)


def obstructed_single(n):
    commands = list(some_obstructed_commands(n))
    shapes = shapely_obstacles()
    theirs, progress = fastest(
        lambda: [shapely_progress_of_one(x, *shapes) for x in commands], repeat=3
    )
    ours, tips = fastest(lambda: [OBSTRUCTED(x) for x in commands], repeat=5)
    same_contacts(commands, tips, progress)
    return Row(f"{OBSTRUCTED_WORK}, one a call", "NumPy and Shapely", theirs / n, ours / n)


def same_contacts(commands, tips, progress):
    """Check that both found the same contacts, or none."""
    np.testing.assert_allclose(OBSTRUCTED.progress(commands), progress, rtol=0, atol=1e-7)
    np.testing.assert_allclose(
        tips, numpy_kinematics(np.array(progress)[:, None] * commands), atol=1e-6
    )


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
    return Row(
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

    theirs, polygons = fastest(shapely_steps, repeat=1)
    ours, found = fastest(our_steps, repeat=20)
    errors = against(union_area(effects, TAU), polygons, found)
    return Row(f"union growing by {n} discs", "Shapely union, 64-gons", theirs, ours, *errors)


def whole_union(n):
    effects = some_effects(n)

    def shapely_union():
        return shapely.union_all(shapely.buffer(shapely.points(effects), TAU, quad_segs=16)).area

    theirs, polygons = fastest(shapely_union, repeat=3)
    ours, found = fastest(lambda: db.coverage(effects, TAU), repeat=10)
    errors = against(union_area(effects, TAU), polygons, found)
    return Row(f"union of {n} discs at once", "Shapely union_all, 64-gons", theirs, ours, *errors)


def raster(n):
    effects = some_effects(n)

    def count():
        """Count the pixels whose middle lies within TAU of an effect."""
        low, high = effects.min(axis=0) - TAU, effects.max(axis=0) + TAU
        size = (high - low) / PIXELS
        across, up = (low[i] + size[i] * (np.arange(PIXELS) + 0.5) for i in range(2))
        middles = np.stack(np.meshgrid(across, up), axis=-1).reshape(-1, 2)
        distances, _ = cKDTree(effects).query(middles, distance_upper_bound=TAU)
        return np.count_nonzero(distances < TAU) * size.prod()

    theirs, counted = fastest(count, repeat=3)
    ours, found = fastest(lambda: db.coverage(effects, TAU), repeat=10)
    errors = against(union_area(effects, TAU), counted, found)
    return Row(
        f"union of {n} discs at once",
        f"{PIXELS} x {PIXELS} pixels, SciPy cKDTree",
        theirs,
        ours,
        *errors,
    )


def union_of_balls(n):
    """Balls uniform in cubes that are far apart, each overlapping about 20 others.

    All cubes hold the same hundred balls, moved by whole numbers, so that the slow oracle needs
    to integrate over one of them alone.
    """
    block, copies = 100, n // 100
    side = 4.5
    cube = np.round(np.random.default_rng(0).uniform(0, side, (block, 3)) * 2**16) / 2**16
    places = np.stack(np.meshgrid(*[16.0 * np.arange(10)] * 3), axis=-1).reshape(-1, 3)
    centres = (places[:copies, None, :] + cube).reshape(-1, 3)
    distances = np.linalg.norm(cube[:, None] - cube, axis=-1)
    neighbours = np.count_nonzero(distances < 2) / block - 1

    theirs, expected = fastest(lambda: tessellated_volume(centres, 1.0), repeat=3)
    ours, found = fastest(lambda: db.coverage(centres, 1.0), repeat=3)
    errors = against(copies * sliced_volume(cube, 1.0), expected, found)
    work = f"volume of a union of {n} balls, {neighbours:.0f} neighbours each"
    return Row(work, "voronotalt", theirs, ours, *errors)


def against(truth, theirs, ours):
    """Return the relative errors of both."""
    errors = abs(theirs / truth - 1), abs(ours / truth - 1)
    assert errors[0] < 0.01
    assert errors[1] < 1e-11
    return errors


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
