"""The history: a log that grows, cannot be changed from outside, and knows what is near."""

import numpy as np
import pytest

import divbandit as db
from tests.reference.families import FAMILIES, family
from tests.reference.nearest import nearest

SPACE = db.Box([-1, -1, -1], [1, 1, 1])
PLANE = db.Box([-1, -1], [1, 1])


def filled(n, sensory_space=PLANE):
    history = db.History(SPACE, sensory_space)
    commands, effects = family("uniform", n, 3, seed=1), family("uniform", n, 2, seed=2)
    for k in range(n):
        history.append(commands[k], effects[k], path=(k % 3, k))
    return history, commands, effects


@pytest.mark.parametrize("n", [0, 1, 63, 64, 65, 128, 129, 1000])
def test_returns_what_was_appended(n):
    history, commands, effects = filled(n)
    assert len(history) == n
    assert history.commands.tolist() == commands.tolist()
    assert history.effects.tolist() == effects.tolist()
    assert list(history.paths) == [(k % 3, k) for k in range(n)]
    assert (history.commands.shape, history.effects.shape) == ((n, 3), (n, 2))


def test_views_are_read_only_and_keep_what_they_showed():
    history, _, effects = filled(64)
    before = history.effects
    with pytest.raises(ValueError, match="read-only"):
        before[0] = 0
    for _ in range(200):
        history.append([0, 0, 0], [0, 0])
    assert before.tolist() == effects.tolist()


def test_appended_arrays_are_copied():
    history = db.History(SPACE, PLANE)
    command, effect = np.zeros(3), np.zeros(2)
    history.append(command, effect)
    command[:], effect[:] = 1, 1
    assert history.commands.tolist() == [[0, 0, 0]]
    assert history.effects.tolist() == [[0, 0]]


@pytest.mark.parametrize("name", FAMILIES)
def test_nearest_is_brute_force_at_any_moment(name):
    history, effects = db.History(SPACE, PLANE), family(name, 300, 2)
    rng = np.random.default_rng(0)
    for n, effect in enumerate(effects, start=1):
        history.append([0, 0, 0], effect)
        if rng.random() < 0.3:  # the tree catches up with one or with several at a time
            goal = rng.uniform(-1, 1, 2)
            distance, index = nearest(effects[:n], goal)
            assert history.nearest(goal) == (distance[0], index[0])
            k = min(n, 4)
            assert history.nearest(effect, k=k)[1] == pytest.approx(
                nearest(effects[:n], effect, k)[1]
            )


def test_nothing_is_near_in_an_empty_history():
    with pytest.raises(ValueError, match="history must not be empty"):
        db.History(SPACE, PLANE).nearest([0, 0])
