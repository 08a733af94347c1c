"""The most different patterns of a Gray-Scott reaction: gray_scott.py [TRIALS SIZE STEPS]."""

import sys
from pathlib import Path

import matplotlib.pyplot as plt
import numpy as np

import divbandit as db

TRIALS, SIZE, STEPS = map(int, sys.argv[1:] or (500, 64, 500))
LABEL = "feed {:.3f}, kill {:.3f}\ndiffusion {:.3f}, {:.3f}\nstart {:.0f}, {:.0f}, {:.1f}, {:.1f}"
M = db.Box([0.01, 0.04, 0.1, 0.04, 0, 0, 0, -1], [0.08, 0.067, 0.23, 0.12, 40, 40, 9, 4])
FILE, ADAPT, S = Path("gray_scott.run"), db.default_strategy(0.05), db.Box([0] * 3, [1] * 3)


def gray_scott(inputs):
    """Return how much there is of V in the end, and its amount, contrast and edges."""
    (feed, kill, *_, a, b, noise, level), (x, y) = inputs, np.mgrid[:SIZE, :SIZE] / SIZE
    v = np.cos(a * x) + np.cos(b * y) + noise * np.random.default_rng(0).random(x.shape) > level
    uv, rates = np.stack([1 - v, v / 2]), inputs[2:4, None, None]
    for _ in range(STEPS):
        made = uv[0] * uv[1] ** 2
        around = sum(np.roll(uv, step, axis) for step in (-1, 1) for axis in (1, 2)) - 4 * uv
        uv += rates * around + [feed * (1 - uv[0]) - made, made - (feed + kill) * uv[1]]
        uv[uv < 0] = np.nan  # less than nothing: the grid is too coarse, a failed trial
    return uv[1], [uv[1].mean() / 0.5, uv[1].std() / 0.2, np.abs(np.diff(uv[1])).mean() / 0.15]


explorer = db.Explorer.load(FILE) if FILE.exists() else db.Explorer(ADAPT, M, S, rng=0)
box, left = db.FunctionEnvironment(lambda x: gray_scott(x)[1], M), TRIALS - explorer.evaluations
options = {"timeout": 60, "on_error": "record", "checkpoint": FILE}
run = explorer.run(box, left, jobs=2, callbacks=[db.callbacks.Progress()], **options)
print(run.describe())
far = np.full(len(run), np.inf)
for ax in plt.subplots(3, 4, figsize=(11, 10.5), layout="constrained")[1].flat:
    far = np.minimum(far, np.linalg.norm(run.effects - run.effects[i := far.argmax()], axis=1))
    ax.imshow(gray_scott(run.commands[i])[0], vmin=0, vmax=0.6)  # viridis: for all eyes
    ax.set(title=LABEL.format(*run.commands[i]), xticks=[], yticks=[])
plt.savefig("gray_scott.png")
