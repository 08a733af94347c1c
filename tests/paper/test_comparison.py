"""The comparison with the archive counts in standard errors of both sides."""

import csv
from dataclasses import replace

import pytest

from divbandit.paper import comparison, figure4


@pytest.fixture
def archived():
    """One archived point: mean 2.0, standard deviation 0.3 over 25 repetitions."""
    return figure4.Point(d=0.05, motor_ratio=0.5, mean=2.0, std=0.3)


def test_the_standard_error_combines_both_sides(archived):
    point = replace(archived, std=0.4)
    found = comparison.Comparison(point, archived, repetitions=25).standard_error
    assert found == pytest.approx(0.1)  # sqrt(0.4^2 / 25 + 0.3^2 / 25)


def test_fewer_repetitions_mean_a_larger_error(archived):
    found = comparison.Comparison(archived, archived, repetitions=1).standard_error
    assert found == pytest.approx((0.3**2 + 0.3**2 / 25) ** 0.5)


def test_beyond_allows_for_the_polygons(archived):
    errors = (0.3**2 / 25 * 2) ** 0.5
    just_within = replace(archived, mean=2.0 + 2 * errors + 0.002 * 2.0 - 1e-9)
    just_beyond = replace(archived, mean=2.0 + 2 * errors + 0.002 * 2.0 + 1e-9)
    assert not comparison.Comparison(just_within, archived, 25).beyond(2)
    assert comparison.Comparison(just_beyond, archived, 25).beyond(2)


def test_the_table_marks_and_counts_what_lies_beyond():
    points = figure4.archive()
    points[0] = replace(points[0], mean=points[0].mean + 1)
    table = comparison.table(comparison.compare(points, 25)).splitlines()
    assert len(table) == 69
    assert table[1].endswith("**")
    assert sum("*" in line for line in table[1:-2]) == 1
    assert table[-1].startswith("beyond 4 standard errors: 1 of 66; ")
    assert table[-1].endswith("(**): 1")


def test_the_file_has_a_row_for_each_point(tmp_path):
    comparison.save(comparison.compare(figure4.archive(), 25), tmp_path / "c.csv")
    with (tmp_path / "c.csv").open(encoding="utf-8", newline="") as file:
        rows = list(csv.DictReader(file))
    assert len(rows) == 66
    assert rows[0]["mean"] == rows[0]["archived_mean"] == "1.059513"
    assert {row["difference_in_standard_errors"] for row in rows} == {"+0.000"}
