"""Environments drawn at random: the library's arms, functions, and classes of a user's."""

import numpy as np
from hypothesis import strategies as st

import divbandit as db
from divbandit.environments import Disc, PushArm, Wall
from tests.exploration.random_compositions import boxes

#: What a range of a motor space may be.
RANGES = {"wide": (-3.0, 3.0), "part": (-0.25, 1.5), "point": (0.7, 0.7), "zero": (-0.0, 0.0)}

#: How a function may hand back an effect.
FORMS = {
    "list": list,
    "tuple": tuple,
    "array": np.array,
    "column": lambda effect: np.repeat(effect, 2)[::2],
    "float32": lambda effect: np.array(effect, dtype=np.float32),
    "mixed": lambda effect: [np.float64(effect[0]), *effect[1:]],
    "whole": lambda effect: [round(10 * number) for number in effect],
}
#: And if it has one coordinate.
SCALARS = {
    "float": float,
    "NumPy's": np.float64,
    "float32": np.float32,
    "whole": lambda effect: round(10 * effect),
}


@st.composite
def environments(draw):
    """Draw an environment, and the dimension of its effects."""
    if draw(st.sampled_from([True, False, False])):
        return draw(arms()), 2
    dim = draw(st.integers(1, 4))
    return draw(functions(dim)), dim


@st.composite
def arms(draw):
    """Draw an arm of 1 to 40 joints, perhaps with obstacles, perhaps with a ball."""
    limit = draw(st.one_of(st.floats(0.01, 3.14), st.sampled_from([1e-300, 40.0])))
    walls = [Wall([-1, 0.2], [1, 0.2]), Wall([0.3, -0.5], [0.3, -0.05], thickness=0.01)]
    discs = [Disc([x, y], 0.05) for x in (-0.5, 0, 0.6) for y in (-0.3, 0.15)]
    among = {"obstacles": [*walls, *discs], "thickness": 0.001}
    around = draw(st.sampled_from([{}, {}, among, {**among, "self_contact": True}]))
    joints = draw(st.integers(1, 40))
    if draw(st.sampled_from([True, False, False])):
        return PushArm(joints, limit=limit, thickness=0.001, ball=(0.3, 0.4))
    return db.PlanarArm(joints, limit=limit, **around)


@st.composite
def functions(draw, dim):
    """Draw a function with effects of `dim` coordinates, in a FunctionEnvironment or a class."""
    ranges = draw(st.lists(st.sampled_from([*RANGES.values()]), min_size=1, max_size=5))
    motor_space = db.Box(*zip(*ranges, strict=True))
    sensory_space = draw(st.one_of(st.none(), boxes(dim)))
    black_box = BlackBox(len(ranges), dim, draw(st.integers(0, 99)))
    if draw(st.sampled_from([True, False, False])):
        black_box.form = FORMS[draw(st.sampled_from([*FORMS]))]
        black_box.motor_space, black_box.sensory_space = motor_space, sensory_space
        return black_box
    names = [*FORMS, *SCALARS] if dim == 1 else [*FORMS]
    name = draw(st.sampled_from(names))
    black_box.form = FORMS.get(name) or (lambda effect: SCALARS[name](effect[0]))
    scalars = draw(st.booleans())
    f = black_box.of_numbers if scalars else black_box
    return db.FunctionEnvironment(f, motor_space, sensory_space, scalars=scalars)


class BlackBox:
    """Waves of sums of the command's coordinates."""

    def __init__(self, joints, dim, seed):
        self.weights = np.random.default_rng(seed).uniform(-1, 1, (dim, joints))
        self.form = list

    def __call__(self, command):
        assert isinstance(command, np.ndarray)
        return self.form([float(x) for x in np.cos(self.weights @ command) * 1.2])

    def of_numbers(self, *command):
        assert all(type(x) is float for x in command)
        return self(np.array(command))
