"""Linear projection is the published formula, in the engine as in Python."""

import numpy as np
import pytest

import divbandit as db
from divbandit.benchmarks import LinearProjection


def published(commands):
    """Return the measures as the paper has them: clipped coordinates, summed by halves."""
    effects = []
    for command in commands:
        clipped = [x if -5.12 <= x <= 5.12 else 5.12 / x for x in command.tolist()]
        half = len(clipped) // 2
        effects.append([sum(clipped[:half]), sum(clipped[half:])])
    return np.array(effects)


@pytest.mark.parametrize("dim", [2, 20, 100])
def test_effects_are_the_published_sums(dim):
    projection, rng = LinearProjection(dim), np.random.default_rng(0)
    commands = np.array([projection.motor_space.sample(rng) for _ in range(200)])
    commands[0], commands[1] = 5.12, np.nextafter(5.12, 6)
    effects = projection(commands)
    assert effects.tolist() == published(commands).tolist()
    assert projection(commands[0]).tolist() == effects[0].tolist()
    assert effects[0] == pytest.approx([2.56 * dim] * 2)
    assert effects[1] == pytest.approx([dim / 2] * 2)
    assert all(map(projection.sensory_space.contains, effects[1:]))


def test_the_engine_explores_it_as_python_does():
    strategy, projection = db.default_strategy(0.5), LinearProjection(20)
    engine, python = (
        db.explore(projection, strategy, 300, rng=0, engine=engine) for engine in ("rust", "python")
    )
    assert engine.effects.tolist() == python.effects.tolist()


@pytest.mark.parametrize(
    ("objective", "best", "worst"),
    [("sphere", 2.048, -5.12), ("plateau", 3.0, 10.24), ("rastrigin", 2.048, None)],
)
def test_objectives(objective, best, worst):
    projection = LinearProjection(6, objective=objective)
    assert projection.quality([best] * 6) == pytest.approx(100)
    if worst is not None:
        assert projection.quality([worst] * 6) == pytest.approx(0)
    within = np.random.default_rng(0).uniform(-5.12, 5.12, (500, 6))
    qualities = projection.quality(within)
    assert qualities.shape == (500,)
    assert 0 <= qualities.min() <= qualities.max() <= 100
    assert LinearProjection(6).quality(within).tolist() == [100.0] * 500


def test_bad_input():
    for dim in (0, 3, -2):
        with pytest.raises(ValueError, match="dim must be"):
            LinearProjection(dim)
    with pytest.raises(ValueError, match="objective must be"):
        LinearProjection(4, objective="cone")
    for command in ([0.0] * 3, [11.0] * 4, [np.nan] * 4):
        with pytest.raises(ValueError, match="command"):
            LinearProjection(4)(command)
