"""Obstacles, the ball and thick links are drawn where they are, as large as they are."""

from types import SimpleNamespace

import matplotlib.pyplot as plt
import numpy as np
import pytest
import shapely
from matplotlib import colors

import divbandit as db
from divbandit import plot
from divbandit.environments import Disc, Polygon, Rectangle, Wall
from divbandit.plot import style
from divbandit.plot.data import capsule
from tests.reference.contact import shape

SOLID = [
    Disc([0.3, 0.4], 0.2),
    Rectangle([-0.5, 0.2], [-0.1, 0.9]),
    Polygon([[0.5, -0.5], [0.9, -0.5], [0.9, -0.4], [0.6, -0.4], [0.6, -0.1]]),
    Wall([-0.5, -0.3], [-0.2, -0.8], thickness=0.1),
    Wall([-0.8, -0.3], [-0.8, -0.8], thickness=1e-6),
]
LINE = Wall([0.5, 0.2], [0.9, 0.6])
ARM = db.PlanarArm(4, thickness=0.02, obstacles=[*SOLID, LINE])


@pytest.fixture(autouse=True)
def _close():
    yield
    plt.close("all")


def outline(patch):
    """Return what a patch covers."""
    return shapely.Polygon(patch.axes.transData.inverted().transform(patch.get_verts()))


def test_each_obstacle_is_drawn_as_large_as_it_is():
    ax = plot.scene(SOLID)
    assert len(ax.patches) == len(SOLID)
    for patch, obstacle in zip(ax.patches, SOLID, strict=True):
        thin, radius = shape(obstacle)
        truth = thin.buffer(radius, quad_segs=64)
        difference = outline(patch).symmetric_difference(truth).area
        assert difference <= 0.01 * truth.area
        assert patch.get_facecolor() == colors.to_rgba(style.OBSTACLE)
        assert patch.get_linewidth() > 0  # else a thin wall could not be seen


def test_a_wall_of_no_thickness_is_a_line():
    ax = plot.scene([LINE])
    (line,) = ax.lines
    assert not ax.patches
    np.testing.assert_array_equal(line.get_xydata(), [LINE.start, LINE.end])


def test_an_arm_and_its_obstacles_are_drawn_alike():
    of_arm, of_list = plot.scene(ARM), plot.scene(iter(ARM.obstacles))
    assert len(of_arm.patches) == len(of_list.patches) == len(SOLID)
    assert len(of_arm.lines) == len(of_list.lines) == 1
    assert of_arm.dataLim.bounds == of_list.dataLim.bounds


def test_all_of_it_is_in_view_and_in_proportion():
    ax = plot.scene(ARM)
    (left, right), (bottom, top) = ax.get_xlim(), ax.get_ylim()
    assert left < -0.8
    assert right > 0.9
    assert bottom < -0.8
    assert top > 0.9
    assert ax.get_aspect() == 1


def test_obstacles_have_one_entry_in_the_legend():
    ax = plot.postures(ARM.posture(np.zeros(4)), ax=plot.scene(ARM))
    assert ax.get_legend_handles_labels()[1] == ["obstacle", "tip", "base"]


def test_they_lie_under_postures_and_effects():
    ax = plot.scene(ARM)
    under = [artist.get_zorder() for artist in (*ax.patches, *ax.lines)]
    drawn = plot.postures(ARM.posture(np.zeros(4)), ax=plt.figure().add_subplot())
    drawn = plot.spread(np.zeros((3, 2)), ax=drawn)
    assert max(under) < min(line.get_zorder() for line in drawn.lines)


def test_a_ball_is_drawn_where_it_is_at_first():
    pushing = SimpleNamespace(obstacles=(SOLID[0],), ball=np.array([0.5, -0.2]), ball_radius=0.06)
    ball = plot.scene(pushing).patches[1]
    assert ball.get_center() == (0.5, -0.2)
    assert ball.get_radius() == 0.06
    assert ball.get_label() == "ball"
    assert len(plot.scene(SimpleNamespace(obstacles=())).patches) == 0


def test_an_arm_without_obstacles_has_none():
    ax = plot.scene(db.PlanarArm(3), unit="m")
    assert not ax.patches
    assert ax.get_xlabel() == "x (m)"


@pytest.mark.parametrize(
    "data", [3, None, "abc", [SOLID[0], 3], SimpleNamespace(obstacles=[(0, 0)]), db.MotorBabbling()]
)
def test_what_is_no_scene_is_refused_and_makes_no_figure(data):
    with pytest.raises(TypeError, match="data"):
        plot.scene(data)
    assert not plt.get_fignums()


def test_links_are_drawn_as_thick_as_they_are():
    posture = ARM.posture([0.5, -0.4, 0.3, 0.6])
    (links,) = plot.postures(posture, thickness=0.02).collections
    drawn = [shapely.Polygon(path.vertices) for path in links.get_paths()]
    assert len(drawn) == 4
    truth = shapely.LineString(posture).buffer(0.01, quad_segs=64)
    assert shapely.union_all(drawn).symmetric_difference(truth).area <= 0.01 * truth.area


@pytest.mark.parametrize("end", [[1.0, 0.0], [-0.3, 0.7], [0.0, -1.0], [0.2, 0.1]])
def test_a_capsule_is_what_is_around_a_segment(end):
    truth = shapely.LineString([[0.2, 0.1], end]).buffer(0.15, quad_segs=64)
    found = shapely.Polygon(capsule([0.2, 0.1], end, 0.3))
    assert found.is_valid
    assert found.symmetric_difference(truth).area <= 0.01 * truth.area
