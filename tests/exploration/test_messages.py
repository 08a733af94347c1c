"""Errors of an exploration say who is to blame, and what to do instead."""

import pytest

import divbandit as db

ARM = db.PlanarArm(2)


class Beyond(db.Strategy):
    def propose(self, history, rng):
        del history, rng
        return [0.0, 99.0]


def test_a_proposal_outside_names_the_strategy_and_its_place():
    explorer = db.Explorer(
        db.Mixture([db.MotorBabbling(), Beyond()], weights=[0, 1]), ARM.motor_space
    )
    with pytest.raises(ValueError, match=r"command\[1\] must be in the range .*Beyond\(\).*\(1,\)"):
        explorer.ask()
    assert len(explorer.history) == 0


def test_a_function_is_told_of_function_environment():
    with pytest.raises(TypeError, match="FunctionEnvironment"):
        db.explore(lambda x: x, db.MotorBabbling(), n=1)


def test_a_scalar_effect_is_told_to_be_a_list():
    class Box:
        motor_space, sensory_space = ARM.motor_space, None

        def __call__(self, command):
            return command[0]

    with pytest.raises(ValueError, match=r"effect .* \(put it in a list\)"):
        db.explore(Box(), db.MotorBabbling(), n=1)


def test_what_a_strategy_has_learned_is_read_from_the_explorer():
    given = db.Adapt([db.MotorBabbling()], tau=0.1)
    explorer = db.Explorer(given, ARM.motor_space, ARM.sensory_space, rng=0)
    for _ in range(60):
        trial = explorer.ask()
        explorer.tell(trial, [1.0, 0.0])
    assert explorer.estimates == (0.0,)
    assert given.estimates is None
