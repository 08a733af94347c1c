"""run_all: results in order, whatever the number of processes; errors come through."""

import pytest

from divbandit.experiments import run_all


def square(x):
    return x * x


def fail_on_three(x):
    if x == 3:
        raise RuntimeError("three is no good")
    return x


@pytest.mark.parametrize("jobs", [1, 2, None])
def test_results_come_in_the_order_of_the_tasks(jobs):
    assert run_all(square, list(range(50)), jobs=jobs) == [x * x for x in range(50)]


@pytest.mark.parametrize("jobs", [1, 2])
def test_progress_is_told_of_every_result(jobs):
    calls = []
    run_all(square, list(range(20)), jobs=jobs, progress=lambda: calls.append(1))
    assert len(calls) == 20


@pytest.mark.parametrize("jobs", [1, 2])
def test_an_error_in_a_task_is_raised(jobs):
    with pytest.raises(RuntimeError, match="three is no good"):
        run_all(fail_on_three, list(range(10)), jobs=jobs)


@pytest.mark.parametrize(("jobs", "error"), [(0, ValueError), (-1, ValueError), (1.5, TypeError)])
def test_jobs_must_be_a_count(jobs, error):
    with pytest.raises(error, match="jobs"):
        run_all(square, [1], jobs=jobs)


def test_no_tasks_give_no_results():
    assert run_all(square, []) == []
