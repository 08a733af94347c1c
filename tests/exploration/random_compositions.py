"""Compositions drawn at random: built-in strategies, nested, with shared parts and used ones."""

import numpy as np
from hypothesis import strategies as st

import divbandit as db

#: How deep composites nest; a single strategy is 0 deep.
DEEPEST = 4

SHARES = st.one_of(st.sampled_from([0, 1e-3, 0.05, 0.5, 1]), st.floats(0, 1))
WEIGHTS = st.one_of(st.sampled_from([0.0, 1e-300, 0.3, 1.0, 1e300]), st.floats(0, 10))
TAUS = st.one_of(st.sampled_from([1e-3, 0.02, 0.1, 10.0]), st.floats(-3, 1).map(lambda x: 10.0**x))
CORNERS = st.one_of(st.sampled_from([0.0, -0.0, 1.0, 1e6, -1e9, 1e200]), st.floats(-2, 2))
WIDTHS = st.one_of(st.sampled_from([0.0, 1e-9, 1e6]), st.floats(0, 3))


@st.composite
def planes(draw):
    """Draw a box in the plane: around the arm, far away, or flat."""
    low = [draw(CORNERS), draw(CORNERS)]
    return db.Box(low, [corner + draw(WIDTHS) for corner in low])


@st.composite
def compositions(draw, *, needs_goals=False):
    """Draw a strategy; with `needs_goals` all goal babbling in it has goals of its own.

    A part may be the very same object as another one, whose state it then shares. A schedule may
    have proposed before, and the whole may have explored another arm.
    """
    strategy = _part(draw, DEEPEST, needs_goals, [])
    if draw(st.integers(0, 4)) == 0:
        _use(strategy, draw(st.integers(1, 40)))
    return strategy


def _part(draw, deepest, needs_goals, made):
    """Draw a strategy at most `deepest` deep, perhaps one of those made so far."""
    known = [part for part, depth in made if depth <= deepest]
    if known and draw(st.integers(0, 4)) == 0:
        return draw(st.sampled_from(known))
    kinds = [_motor_babbling, _goal_babbling]
    if deepest > 0:
        kinds = [_adapt, _adapt, _mixture, _schedule, *kinds]
    part = draw(st.sampled_from(kinds))(draw, deepest, needs_goals, made)
    made.append((part, depth_of(part)))
    return part


def depth_of(strategy):
    """Return how deep composites nest in it; 0 if it is none."""
    return 1 + max(map(depth_of, strategy.strategies)) if hasattr(strategy, "strategies") else 0


def _parts(draw, deepest, needs_goals, made):
    return [_part(draw, deepest - 1, needs_goals, made) for _ in range(draw(st.integers(1, 4)))]


def _motor_babbling(draw, deepest, needs_goals, made):
    del draw, deepest, needs_goals, made
    return db.MotorBabbling()


def _goal_babbling(draw, deepest, needs_goals, made):
    del deepest, made
    goals = draw(planes()) if needs_goals or draw(st.booleans()) else None
    return db.GoalBabbling(draw(SHARES), goals=goals)


def _mixture(draw, *limits):
    parts = _parts(draw, *limits)
    if draw(st.booleans()):
        return db.Mixture(parts)
    weights = [draw(WEIGHTS) for _ in parts]
    if not any(weights):
        weights[draw(st.integers(0, len(parts) - 1))] = 1.0
    return db.Mixture(parts, weights=weights)


def _schedule(draw, *limits):
    parts = _parts(draw, *limits)
    steps = [draw(st.integers(1, 20)) for _ in parts]
    if draw(st.booleans()):
        steps[-1] = None
    schedule = db.Schedule(zip(steps, parts, strict=True))
    if draw(st.booleans()):
        for _ in range(draw(st.integers(1, 30))):
            schedule.choose(None, None)
    return schedule


def _adapt(draw, *limits):
    parts = _parts(draw, *limits)
    window, tau = draw(st.integers(1, 60)), draw(TAUS)
    by = {"measure": db.Coverage(tau)} if draw(st.integers(0, 3)) == 0 else {"tau": tau}
    head_start = draw(st.one_of(st.sampled_from([0, 1, window]), st.integers(0, window)))
    power = draw(st.sampled_from([1.0, 1.0, 1.0, 0.0, 0.5, 3.0]))
    return db.Adapt(
        parts, window=window, alpha=draw(SHARES), head_start=head_start, power=power, **by
    )


def _use(strategy, steps):
    """Let it propose and observe in another history: its schedules go on, its bandits learn."""
    arm, rng = db.PlanarArm(2), np.random.default_rng(0)
    history = db.History(arm.motor_space, arm.sensory_space)
    for _ in range(steps):
        trial = strategy.propose(history, rng)
        effect = arm(trial.command)
        history.append(trial.command, effect, path=trial.path)
        strategy.observe(trial, effect)
