"""Maze: the published rules, step by step; walls stay closed; the engine runs it in Rust."""

import copy
import hashlib
import pickle

import numpy as np
import pytest
import shapely

import divbandit as db
from divbandit.benchmarks import Maze
from tests.reference import maze as published

MAZE = Maze()

#: A robot that arrives at the goal, found by 30,000 steps of `db.default_strategy(4.0)`.
# fmt: off
ARRIVING = np.array([
    0.5, -0.8, -1.6, -0.4, 2.3, 2.3, 0.0, -0.2, 1.1, -0.6, -0.2,
    0.4, -0.7, -1.9, 2.8, 2.7, -2.2, -2.1, -2.1, 0.8, -1.6, -1.5,
    0.0, 2.4, -1.6, 2.0, -0.7, 2.0, -1.2, 3.0, -2.2, 1.1, 0.7,
    -1.0, 1.9, 0.8, 0.9, -2.4, -0.3, -0.7, -1.3, 2.3, 1.6, 0.2,
    -2.2, -0.3, -1.9, 1.0, -0.2, -1.8, -2.3, -1.7, -0.3, 1.0, 0.8,
    0.4, 1.1, 1.5, -0.9, -1.6, 1.4,
    2.0, -0.2, 1.0, -0.7, 0.4, 1.0,
])
# fmt: on


def drawn(n, seed=0):
    """Return commands, every second of them near the robot that arrives: these get far."""
    rng = np.random.default_rng(seed)
    commands = rng.uniform(-3, 3, (n, 67))
    near = ARRIVING + rng.uniform(-0.1, 0.1, (n // 2, 67))
    commands[1::2] = np.clip(near, -3, 3)
    return commands


COMMANDS = drawn(100)


def test_the_published_maze():
    assert [(*start, *end) for start, end in MAZE.walls] == published.WALLS
    assert MAZE.goal == published.GOAL
    assert MAZE.sensory_space == db.Box([3, 5], [195, 202])
    assert MAZE.motor_space == db.Box([-3] * 67, [3] * 67)


def test_a_hundred_robots_go_by_the_published_rules():
    gaps = []
    for command in COMMANDS:
        path, expected = MAZE.path(command), np.array(published.path(command.tolist()))
        assert path.shape == expected.shape
        gaps.append(np.abs(path - expected).max())
    # What is rounded otherwise grows where a robot brushes past the end of a wall, or along one.
    assert max(gaps) < 1e-4
    assert np.mean(np.array(gaps) < 1e-9) > 0.9


def test_some_of_them_get_far():
    assert np.ptp(MAZE(COMMANDS), axis=0).min() > 150
    arrived = np.hypot(*(MAZE(COMMANDS) - MAZE.goal).T) < 5
    assert 0 < arrived.sum() < 50


def test_one_that_arrives_stays():
    path = MAZE.path(ARRIVING)
    from_goal = np.hypot(*(path - MAZE.goal).T)
    assert len(path) == 394
    assert from_goal[-1] < 5 <= from_goal[:-1].min()


def test_the_path_leads_from_the_start_to_the_effect():
    for command in COMMANDS:
        path = MAZE.path(command)
        assert tuple(path[0]) == published.START
        assert path[-1].tolist() == MAZE(command).tolist()
        assert np.hypot(*np.diff(path, axis=0).T).max() < 3 + 1e-12


def test_no_robot_touches_a_wall():
    walls = shapely.MultiLineString(MAZE.walls)
    touched = 0
    for command in COMMANDS:
        path = MAZE.path(command)
        assert shapely.distance(walls, shapely.points(path)).min() > 8 - 1e-9
        assert not shapely.LineString(path).intersects(walls)
        touched += (np.diff(path, axis=0) == 0).all(axis=1).any()
    assert touched > 20  # moves were refused


def test_effects_lie_in_the_sensory_space():
    assert all(MAZE.sensory_space.contains(effect) for effect in MAZE(COMMANDS))


@pytest.mark.parametrize("n", [0, 1, 10])
def test_many_at_once_are_the_same_bits_as_one_by_one(n):
    effects = MAZE(COMMANDS[:n])
    assert effects.shape == (n, 2)
    assert effects.tolist() == [MAZE(command).tolist() for command in COMMANDS[:n]]


def test_the_same_bits_on_every_machine():
    effects = MAZE(COMMANDS).astype("<f8").tobytes()
    assert hashlib.sha256(effects).hexdigest() == (
        "544e619a25025594b0a0f0acf614f3e4e0737fd6ee3c794691037e290acb3736"
    )


def test_the_largest_weights_are_allowed():
    for sign in (-1, 1):
        assert np.isfinite(MAZE(np.full(67, 3.0 * sign))).all()


def put(index, value):
    command = np.zeros(67)
    command[index] = value
    return command


@pytest.mark.parametrize(
    ("command", "message"),
    [
        (np.zeros(66), r"command must have shape \(67,\) or \(n, 67\), got \(66,\)"),
        (np.zeros((2, 68)), r"command must have shape \(67,\) or \(n, 67\), got \(2, 68\)"),
        (0.0, r"command must have shape"),
        (put(3, np.nan), r"command\[3\] must be finite, got NaN"),
        (put(66, -np.inf), r"command\[66\] must be finite, got -inf"),
        (put(0, 3.5), r"command\[0\] must be a weight in \[-3.0, 3.0\], got 3.5"),
        ([np.zeros(67), put(5, -4)], r"command\[1, 5\] must be a weight in .*, got -4.0"),
    ],
)
def test_what_is_no_command_is_refused(command, message):
    with pytest.raises(ValueError, match=message):
        MAZE(command)
    with pytest.raises(ValueError, match=r"command"):
        MAZE.path(command)


@pytest.mark.parametrize("command", ["weights", None, [None] * 67, np.zeros(67, dtype=complex)])
def test_what_holds_no_numbers_is_refused(command):
    for call in (MAZE, MAZE.path):
        with pytest.raises(TypeError, match="command must be an array of real numbers"):
            call(command)


def explored(engine):
    return db.explore(MAZE, db.default_strategy(4.0), n=150, rng=3, engine=engine)


def test_both_engines_explore_it_alike():
    rust, python = explored("rust"), explored("python")
    assert rust.commands.tolist() == python.commands.tolist()
    assert rust.effects.tolist() == python.effects.tolist()
    assert MAZE(rust.commands).tolist() == rust.effects.tolist()


def test_the_engine_runs_it_without_python(monkeypatch):
    def called(_self, _command):
        raise AssertionError("called back")

    monkeypatch.setattr(Maze, "__call__", called)
    assert len(explored("rust")) == 150


def test_a_maze_is_a_value():
    assert repr(MAZE) == "Maze()"
    assert MAZE == Maze() == copy.deepcopy(MAZE) == pickle.loads(pickle.dumps(MAZE))  # noqa: S301
    assert hash(MAZE) == hash(Maze())
    with pytest.raises(AttributeError):
        MAZE.walls = ()
