"""Adapt's windows, head start and diversities, against numbers worked out on paper.

Effects are either far apart, so that each gains a whole ball, or repeated, so that they gain 0.
"""

import math

import pytest

from tests.bandits.script import Drive, both_engines

BALL = math.pi * 0.5 * 0.5


def drive(engine, **parameters):
    return Drive(engine, **{"tau": 0.5, "window": 3, "alpha": 0.5} | parameters)


def in_balls(*estimates):
    return pytest.approx([BALL * share for share in estimates], rel=1e-15)


#: Parameters, the estimates at first, and after each step: who proposed, whether it was new.
CASES = {
    "the head start counts until the window is full": (
        {},
        (1, 1),
        [
            (0, True, (1, 1)),  # (1 + 1) / 2
            (0, False, (2 / 3, 1)),  # (1 + 1 + 0) / 3
            (0, False, (1 / 3, 1)),  # the head start left: 1 + 0 + 0
            (0, False, (0, 1)),
            (1, False, (0, 1 / 2)),
            (1, False, (0, 1 / 3)),
            (1, True, (0, 1 / 3)),  # 0 + 0 + 1
            (0, True, (1 / 3, 1 / 3)),
        ],
    ),
    "without a head start the mean is over the gains there are": (
        {"head_start": 0},
        (0, 0),
        [
            (0, True, (1, 0)),
            (0, False, (1 / 2, 0)),
            (0, False, (1 / 3, 0)),
            (0, False, (0, 0)),
            (1, True, (0, 1)),
        ],
    ),
    "two head starts leave one by one": (
        {"head_start": 2},
        (1, 1),
        [(0, True, (1, 1)), (0, False, (2 / 3, 1)), (0, False, (1 / 3, 1)), (0, False, (0, 1))],
    ),
    "a window of one remembers the last gain": (
        {"window": 1},
        (1, 1),
        [(0, True, (1, 1)), (0, False, (0, 1)), (1, False, (0, 0)), (1, True, (0, 1))],
    ),
    "what one strategy found gains nothing for another": (
        {"window": 1},
        (1, 1),
        [(0, True, (1, 1)), (1, False, (1, 0))],
    ),
    "a window leaves all others alone": (
        {"count": 3, "window": 1},
        (1, 1, 1),
        [(2, True, (1, 1, 1)), (2, False, (1, 1, 0)), (0, True, (1, 1, 0))],
    ),
}


@both_engines
@pytest.mark.parametrize("case", CASES.values(), ids=CASES)
def test_windows(case, engine):
    parameters, first, steps = case
    run = drive(engine, **parameters)
    assert run.estimates == in_balls(*first)
    for index, new, expected in steps:
        assert run.step(index, new=new) == in_balls(*expected)


@both_engines
def test_gains_between_nothing_and_a_ball(engine):
    """Two discs one radius apart: the second gains its area less their lens."""
    run = drive(engine, window=1)
    for index, x in enumerate((0.0, 0.5)):
        run.explorer.tell(run.ask(0.0, 0.25 + 0.5 * index), [x, 0.0])
    lens = 0.25 * (2 * math.pi / 3 - math.sqrt(3) / 2)
    assert run.estimates == pytest.approx((BALL, BALL - lens), rel=1e-15)


@both_engines
def test_effects_of_others_count_before_its_own(engine):
    """What stands in the history already has been covered, whoever put it there."""
    run = drive(engine, window=1)
    run.explorer.add_past([[0.5]] * 2, [[0.0, 0.0], [10.0, 0.0]])
    assert run.step(0, new=False) == in_balls(0, 1)
    assert run.step(0, new=True) == in_balls(0, 1)
    run.explorer.add_past([[0.5]], [[50.0, 0.0]])
    run.fresh = 4
    assert run.step(0, new=True) == in_balls(0, 1)
    assert run.step(1, new=True) == in_balls(0, 1)
