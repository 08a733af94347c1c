"""The estimators and policies in Rust, held to their plain Python bit by bit."""

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st

from divbandit import _core
from divbandit import bandits as b
from tests.generators import state, twins
from tests.reference import estimators, policies

ESTIMATORS = [
    b.Window(3),
    b.Window(1, head_start=0),
    b.Window(50, head_start=7),
    b.RecentWindow(1),
    b.RecentWindow(5),
    b.Discounted(0.9),
    b.Discounted(1.0),
    b.Discounted(0.3, head_start=2),
    b.WholePast(),
]
POLICIES = [
    b.Proportional(),
    b.Proportional(0.0),
    b.Proportional(0.3, power=8.0),
    b.Proportional(0.1, power=0.0),
    b.EpsilonGreedy(0.3),
    b.EpsilonGreedy(1.0),
    b.Softmax(),
    b.Softmax(1e-5),
    b.Softmax(0.5, scaled=False),
    b.UCB(),
    b.UCB(0.0),
    b.Thompson(),
    b.Exp3(),
    b.Exp3(1.0),
    b.Exp3S(),
    b.Exp3S(0.9, 0.3),
    b.RoundRobin(),
    b.Uniform(),
]
rewards = st.one_of(
    st.floats(-3.0, 3.0), st.sampled_from([0.0, -0.0, 1.0, 2.0]), st.floats(-1e6, 1e6)
)
parts_ = st.integers(1, 5)
largest_ = st.sampled_from([0.0, 2.0, 1e-9, 1e6])


def bits(numbers):
    return [None if number is None else float(number).hex() for number in numbers]


def believed(estimates):
    return bits(estimates.means), bits(estimates.counts), bits([estimates.largest])


@pytest.mark.parametrize("value", ESTIMATORS, ids=repr)
@given(parts_, largest_, st.data())
def test_estimators(value, parts, largest, data):
    theirs, ours = estimators.started(value, parts, largest), value.start(parts, largest)
    assert believed(ours) == believed(theirs)
    told = data.draw(st.lists(st.tuples(st.integers(0, parts - 1), rewards), max_size=30))
    for part, reward in told:
        for each in (theirs, ours):
            each.add(part, reward)
        assert believed(ours) == believed(theirs)


@pytest.mark.parametrize("value", POLICIES, ids=repr)
@given(
    st.sampled_from(ESTIMATORS),
    parts_,
    largest_,
    st.integers(0, 2**32 - 1),
    # A choice; or a reward of a choice that has had none yet, whose probability is known or not.
    st.lists(st.none() | st.tuples(st.integers(0, 100), rewards, st.booleans()), max_size=30),
)
def test_policies(value, estimator, parts, largest, seed, steps):
    """Choices and rewards in any order; trials may also be told late."""
    rng, other = twins(np.random.PCG64, seed)
    theirs = estimators.started(estimator, parts, largest), policies.started(value, parts, largest)
    ours = estimator.start(parts, largest), value.start(parts, largest)
    by_hand = value.start(parts, largest)  # the same policy, asked with a user's estimates
    third = twins(np.random.PCG64, seed)[0]
    asked = []
    for step in steps:
        if step is None or not asked:
            index, probability = theirs[1].choose(theirs[0], rng)
            for policy, estimates, draws in (
                (ours[1], ours[0], other),
                (by_hand, theirs[0], third),
            ):
                found, its = policy.choose(estimates, draws)
                assert (found, bits([its])) == (index, bits([probability]))
            asked.append((index, probability))
            continue
        which, reward, is_known = step
        part, probability = asked.pop(which % len(asked))
        for estimates in (theirs[0], ours[0]):
            estimates.add(part, reward)
        for policy in (theirs[1], ours[1], by_hand):
            policy.learn(part, reward, probability if is_known else None)
    assert state(rng) == state(other) == state(third)


@given(st.lists(st.floats(0.0, 1e3), min_size=1, max_size=6), st.floats(0.0, 1.0, exclude_max=True))
def test_proportionally(weights, u):
    assert _core.proportionally(weights, u) == policies.proportionally(weights, u)


@given(
    st.lists(st.floats(-1e300, 1e300), min_size=1, max_size=6),
    st.sampled_from([0.0, 0.5, 1.0, 2.0, 8.0]),
)
def test_powers(means, power):
    assert _core.powers(means, power) == policies.powers(means, power)
