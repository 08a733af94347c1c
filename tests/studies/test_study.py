"""study checks its arguments before it writes anything."""

import pytest

from divbandit.studies import study


@pytest.mark.parametrize(
    ("arguments", "error", "named"),
    [
        ({"name": "rulers"}, ValueError, "name"),
        ({"name": 1}, TypeError, "name"),
        ({"repetitions": 0}, ValueError, "repetitions"),
        ({"repetitions": 2.0}, TypeError, "repetitions"),
        ({"steps": 4}, ValueError, "steps"),
        ({"steps": None}, TypeError, "steps"),
        ({"seed": -1}, ValueError, "seed"),
        ({"jobs": 0}, ValueError, "jobs"),
        ({"out": 5}, TypeError, "out"),
    ],
)
def test_bad_arguments_are_named_and_nothing_is_written(arguments, error, named, tmp_path):
    out = tmp_path / "studies"
    with pytest.raises(error, match=named):
        study(**{"name": "rules", "out": out, **arguments})
    assert not out.exists()
