"""Figure 4 at full size lies where the archived results lie."""

import math

import pytest

from divbandit.paper import comparison, figure4, setting


def test_all_66_means_lie_near_the_archive():
    """Within 4 standard errors, at most 7 beyond 2 (3 are expected), 0.2 % for the 64-gons."""
    compared = comparison.compare(figure4.run(0, repetitions=25), repetitions=25)
    assert len(compared) == 66
    assert sum(c.beyond(4) for c in compared) == 0
    assert sum(c.beyond(2) for c in compared) <= 7


def test_the_archive_has_every_point():
    keys = {point.key for point in figure4.archive()}
    expected = {(d, r) for d in setting.PERTURBATIONS for r in (None, *setting.RATIOS)}
    assert keys == expected


def test_a_point_is_the_mean_and_population_deviation_of_its_explorations():
    import divbandit as db  # noqa: PLC0415

    point = figure4.run(5, n=50, repetitions=3, jobs=1)[0]
    final = [
        db.coverage(
            db.explore(
                setting.arm(), setting.adapt(0.001), 50, rng=setting.seed_of(5, 4, 0, 0, k)
            ).effects,
            setting.TAU,
        )
        for k in range(3)
    ]
    mean = sum(final) / 3
    assert point.key == (0.001, None)
    assert point.mean == pytest.approx(mean, rel=1e-14)
    assert point.std == pytest.approx(math.sqrt(sum((x - mean) ** 2 for x in final) / 3), rel=1e-9)


def test_the_number_of_jobs_changes_nothing():
    assert figure4.run(1, n=60, repetitions=2, jobs=2) == figure4.run(
        1, n=60, repetitions=2, jobs=1
    )


def test_the_seed_changes_the_result():
    assert figure4.run(1, n=60, repetitions=1, jobs=1) != figure4.run(
        2, n=60, repetitions=1, jobs=1
    )


def test_points_survive_being_written(tmp_path):
    points = figure4.archive()
    figure4.save(points, tmp_path / "points.csv")
    lines = (tmp_path / "points.csv").read_text(encoding="utf-8").splitlines()
    assert lines[0] == "d,strategy,motor_ratio,mean,std"
    assert len(lines) == 67
    assert lines[1].split(",")[:3] == ["0.001", "adapt", ""]
    assert float(lines[1].split(",")[3]) == points[0].mean
