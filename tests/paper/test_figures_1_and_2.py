"""Figures 1 and 2: the strategies, the sizes and the panels of the paper."""

import matplotlib.pyplot as plt
import numpy as np

from divbandit.paper import figure1, figure2, setting


def test_figure_1_babbles_in_motor_space():
    run = figure1.run(0, n=200)
    assert run.commands.shape == (200, 20)
    assert run.paths.shape == (200, 0)


def test_figure_1_shows_effects_and_the_last_five_postures():
    run = figure1.run(0, n=200)
    figure = figure1.draw(run)
    (ax,) = figure.axes
    chains = [line.get_xydata() for line in ax.lines if len(line.get_xydata()) == 21]
    np.testing.assert_array_equal(ax.lines[0].get_xydata(), run.effects)
    np.testing.assert_array_equal([chain[-1] for chain in chains], run.effects[-5:])
    assert (ax.get_xlabel(), ax.get_ylabel()) == ("x (m)", "y (m)")
    plt.close(figure)


def test_figure_2_babbles_10_commands_then_goals():
    runs = figure2.run(0, n=50, jobs=1)
    assert len(runs) == len(setting.PERTURBATIONS)
    for run in runs:
        assert run.choices.tolist() == [0] * 10 + [1] * 40


def test_figure_2_stays_near_earlier_commands():
    for d, run in zip(setting.PERTURBATIONS, figure2.run(0, n=200, jobs=1), strict=True):
        reach = d * 2 * setting.arm().limit
        for step in (10, 50, 199):
            distance = np.abs(run.commands[:step] - run.commands[step]).max(axis=1).min()
            assert distance <= reach * (1 + 1e-12)


def test_figure_2_has_a_panel_for_each_perturbation():
    figure = figure2.draw(figure2.run(0, n=50, jobs=1))
    assert [ax.get_title()[4:] for ax in figure.axes] == [
        f"goal babbling, d = {d}" for d in setting.PERTURBATIONS
    ]
    plt.close(figure)
