"""UntriedGoals draws what a few plain lines draw from the same stream, and counts as they do."""

import numpy as np
from hypothesis import given, settings
from hypothesis import strategies as st

import divbandit as db
from divbandit.goals import UntriedGoals
from tests.generators import state
from tests.known import SEEDS, histories
from tests.reference.nearest import nearest

TAUS = st.sampled_from([1e-9, 0.05, 0.3, 10.0])


def plainly(history, counts, rng, tau, candidates, tries, reach):
    """Return the goal, and count it."""
    box, best, least = history.sensory_space, None, None
    for _ in range(candidates):
        for _ in range(tries):
            goal = box.sample(rng)
            distances, indices = nearest(history.effects, goal, 1)
            distance, index = float(distances[0]), int(indices[0])
            if distance > tau:
                break
        if best is None or counts[index] < counts[least]:
            best, least = goal, index
            if distance > reach * tau:
                effect = history.effects[index]
                best = effect + (goal - effect) * (reach * tau / distance)
                best = np.clip(best, box.low, box.high)
            if counts[index] == 0:
                break
    counts[least] += 1
    return best


@given(
    histories(), TAUS, st.integers(1, 8), st.integers(1, 8), st.sampled_from([1.0, 1.5, 4.0]), SEEDS
)
@settings(max_examples=100, deadline=None, derandomize=True)
def test_goals_are_those_of_a_plain_search(history, tau, candidates, tries, reach, seed):
    rng, plain = np.random.default_rng(seed), np.random.default_rng(seed)
    value = UntriedGoals(tau, candidates=candidates, tries=tries, reach=reach)
    goals = value.start(history)
    counts = [0] * 200
    for _ in range(8):
        goal = goals.sample(history, rng)
        expected = plainly(history, counts, plain, tau, candidates, tries, reach)
        assert goal.tolist() == expected.tolist()
        assert state(rng) == state(plain)
        assert history.sensory_space.contains(goal)
        for _ in range(9):  # more effects than there was room to count for
            history.append(history.motor_space.sample(rng), goal)
        plain.bit_generator.state = rng.bit_generator.state


def line():
    history = db.History(db.Box([0], [1]), db.Box([0], [1]))
    for effect in (0.0, 1.0):
        history.append([0.5], [effect])
    return history


def test_effects_take_turns():
    history, rng = line(), np.random.default_rng(0)
    goals = UntriedGoals(0.1, reach=1.0).start(history)
    drawn = [round(float(goals.sample(history, rng)[0]), 12) for _ in range(20)]
    assert all(set(drawn[i : i + 2]) == {0.1, 0.9} for i in range(0, 20, 2))


def test_what_was_counted_belongs_to_one_start():
    goals, history = UntriedGoals(0.1), line()

    def drawn():
        at_work, rng = goals.start(history), np.random.default_rng(3)
        return [at_work.sample(history, rng).tolist() for _ in range(4)]

    first = drawn()
    assert first == drawn()
    rng = np.random.default_rng(3)
    assert first != [goals.sample(history, rng).tolist() for _ in range(4)]  # the counts tell


def test_with_nothing_observed_goals_are_uniform():
    history = db.History(db.Box([0], [1]), db.Box([5], [7]))
    goal = UntriedGoals(0.1).sample(history, np.random.default_rng(0))
    assert goal.tolist() == history.sensory_space.sample(np.random.default_rng(0)).tolist()
