"""Every plot function draws its data, into the axes given, and returns them."""

import matplotlib.pyplot as plt
import numpy as np
import pytest

import divbandit as db
from divbandit import plot

ADAPT = db.Adapt([db.MotorBabbling(), db.GoalBabbling(0.05)], tau=0.02)
RUN = db.explore(db.PlanarArm(5), ADAPT, 60, rng=0)
POSTURES = [db.PlanarArm(5).posture(command) for command in RUN.commands[:3]]
OBSTACLES = [db.environments.Disc([0.5, 0.5], 0.1), db.environments.Wall([-1, 0.8], [1, 0.8])]
MIXTURES = [[0.0, 1.0, 0.1], [0.5, 2.0, 0.2], [1.0, 1.5, 0.1]]


def series(ax, **options):
    """Draw two lines over two places."""
    ax = plot.series([2, 4], LINES, labels=["a", "b"], unit="m²", ax=ax, **options)
    ax.set_xlabel("strategies")
    return ax


RANKS = [[2.0, 0.1], [1.0, 0.2]]
LINES = [[[2.0, 0.1], [3.0, 0.2]], [[1.0, 0.1], [2.0, 0.3]]]
CASES = {
    "ranking": lambda ax: plot.ranking(RANKS, labels=["a", "b"], unit="m²", ax=ax),
    "series": lambda ax: series(ax, baseline=[1.0, 2.0]),
    "spread": lambda ax: plot.spread(RUN, tau=0.02, unit="m", ax=ax),
    "scene": lambda ax: plot.scene(OBSTACLES, unit="m", ax=ax),
    "postures": lambda ax: plot.postures(POSTURES, unit="m", ax=ax),
    "estimates": lambda ax: plot.estimates(RUN, labels=["a", "b"], unit="m²", ax=ax),
    "usage": lambda ax: plot.usage(RUN, labels=["a", "b"], ax=ax),
    "mixtures": lambda ax: plot.mixtures(MIXTURES, adapt=(2.1, 0.1), unit="m²", ax=ax),
}


@pytest.fixture(autouse=True)
def _close():
    yield
    plt.close("all")


@pytest.mark.parametrize("name", CASES)
def test_it_draws_into_the_axes_given(name):
    figure, (left, right) = plt.subplots(1, 2)
    assert CASES[name](right) is right
    assert not left.has_data()
    assert right.has_data()
    assert right.get_xlabel()
    assert right.get_ylabel() or name == "ranking"  # which has names instead
    figure.canvas.draw()


@pytest.mark.parametrize("name", CASES)
def test_it_makes_a_figure_of_its_own(name):
    ax = CASES[name](None)
    assert ax.figure.number in plt.get_fignums()


def test_spread_draws_each_effect_and_its_disc():
    ax = plot.spread(RUN, tau=0.02)
    np.testing.assert_array_equal(ax.lines[0].get_xydata(), RUN.effects)
    (discs,) = ax.collections
    np.testing.assert_array_equal(discs.get_offsets(), RUN.effects)
    np.testing.assert_allclose(discs.get_widths(), 0.04)


def test_spread_without_a_radius_draws_no_discs():
    assert not plot.spread(RUN.effects).collections


def test_estimates_draws_what_the_bandit_believed():
    ax = plot.estimates(RUN)
    for index, line in enumerate(ax.lines):
        np.testing.assert_array_equal(line.get_ydata(), RUN.estimates[:, index])


def test_usage_is_in_per_cent():
    ax = plot.usage(RUN)
    total = sum(line.get_ydata() for line in ax.lines)
    np.testing.assert_allclose(total, 100)


def test_ranking_draws_the_first_on_top_and_the_marks():
    ax = plot.ranking(RANKS, labels=["a", "b"], marks={"bar": 1.5}, highlight=1)
    bottom, top = ax.get_ylim()
    assert bottom > top
    dots = [line.get_xydata()[0].tolist() for line in ax.lines if line.get_marker() in "oD"]
    assert dots == [[2.0, 0.0], [1.0, 1.0]]
    (mark,) = [line for line in ax.lines if line.get_label() == "bar"]
    assert mark.get_xdata() == [1.5, 1.5]


def test_series_draws_a_line_for_each_and_what_they_compare_with():
    ax = series(None, baseline=[1.5, 2.5], baseline_label="alone")
    lines = {line.get_label(): line.get_ydata().tolist() for line in ax.lines}
    assert lines == {"alone": [1.5, 2.5], "a": [2.0, 3.0], "b": [1.0, 2.0]}
    assert [text.get_text() for text in ax.get_xticklabels()] == ["2", "4"]
    assert len(ax.collections) == 2  # their deviations


def test_mixtures_draws_means_and_the_bandits_band():
    ax = plot.mixtures(MIXTURES, adapt=(2.1, 0.1), archive=[[0.5, 1.9]])
    labels = ax.get_legend_handles_labels()[1]
    assert set(labels) == {"mixture, ± 1 s.d.", "ADAPT, ± 1 s.d.", "archived mixture"}
    assert any(np.allclose(line.get_ydata(), 2.1) for line in ax.lines)


@pytest.mark.parametrize(
    ("draw", "named"),
    [
        (lambda: plot.spread(np.zeros((3, 3))), "data"),
        (lambda: plot.spread(RUN, tau=0.0), "tau"),
        (lambda: plot.spread(RUN, tau=-1.0), "tau"),
        (lambda: plot.postures(np.zeros(4)), "data"),
        (lambda: plot.postures(np.zeros((0, 3, 2))), "data"),
        (lambda: plot.postures(POSTURES, thickness=0.0), "thickness"),
        (lambda: plot.estimates(RUN, labels=["one"]), "labels"),
        (lambda: plot.usage(RUN, labels=["one"]), "labels"),
        (lambda: plot.usage([-1, 0]), "data"),
        (lambda: plot.spread("abc"), "data"),
        (lambda: plot.spread([[1, 2], [3]]), "data"),
        (lambda: plot.postures(np.empty((2, 0, 2))), "data"),
        (lambda: plot.mixtures(MIXTURES, adapt=(1.0,)), "adapt"),
        (lambda: plot.mixtures([[1, 2]]), "data"),
        (lambda: plot.mixtures(MIXTURES, archive=[1.0]), "archive"),
        (lambda: plot.ranking([1.0, 2.0], labels=["a", "b"]), "data"),
        (lambda: plot.ranking([[1.0, -0.1]], labels=["a"]), "data"),
        (lambda: plot.ranking(RANKS, labels=["a"]), "labels"),
        (lambda: plot.series([0, 2], LINES, labels=["a", "b"]), "places"),
        (lambda: plot.series([2], LINES, labels=["a", "b"]), "data"),
        (lambda: plot.series([2, 4], LINES, labels=["a"]), "labels"),
        (lambda: plot.series([2, 4], LINES, labels=["a", "b"], baseline=[1.0]), "baseline"),
    ],
)
def test_bad_input_is_named_and_makes_no_figure(draw, named):
    with pytest.raises(ValueError, match=named):
        draw()
    assert not plt.get_fignums()
