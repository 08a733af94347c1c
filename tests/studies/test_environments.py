"""The figures of the environment study say each thing once."""

import numpy as np
import pytest

from divbandit.studies import environments
from divbandit.studies.cases import Outcome

plt = pytest.importorskip("matplotlib.pyplot")


def test_a_legend_names_what_is_in_the_scene_and_the_best_mixture():
    values = np.array([[1.0], [2.0]])
    found = {key: Outcome(case, 0, values) for key, case in environments.cases(10).items()}
    figures = environments.draw(found)
    named = {
        name: [text.get_text() for text in figure.legends[0].get_texts()]
        for name, figure in figures.items()
    }
    plt.close("all")
    assert named == {
        "environments_empty_space": ["best mixture"],
        "environments_corridor": ["obstacle", "best mixture"],
        "environments_cluttered_room": ["obstacle", "best mixture"],
        "environments_pushing": ["ball", "best mixture"],
        "environments_mujoco_pusher": ["best mixture"],
    }
