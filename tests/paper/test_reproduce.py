"""reproduce checks its arguments before it writes anything."""

import pytest

from divbandit.paper import reproduce


@pytest.mark.parametrize(
    ("arguments", "error", "named"),
    [
        ({"figures": 1}, TypeError, "figures"),
        ({"figures": [5]}, ValueError, "figures"),
        ({"figures": ["1"]}, TypeError, "figures"),
        ({"repetitions": 0}, ValueError, "repetitions"),
        ({"repetitions": 2.0}, TypeError, "repetitions"),
        ({"seed": -1}, ValueError, "seed"),
        ({"seed": None}, TypeError, "seed"),
        ({"jobs": 0}, ValueError, "jobs"),
        ({"out": 5}, TypeError, "out"),
    ],
)
def test_bad_arguments_are_named_and_nothing_is_written(arguments, error, named, tmp_path):
    out = tmp_path / "figures"
    with pytest.raises(error, match=named):
        reproduce(**{"figures": [1], "out": out, **arguments})
    assert not out.exists()


def test_any_seed_will_do(tmp_path):
    assert reproduce([1], out=tmp_path, seed=2**64) == []
    assert (tmp_path / "figure1.png").exists()
