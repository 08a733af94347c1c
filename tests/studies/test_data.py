"""The studies' numbers: what they are of, and that nothing but the seed changes them."""

import numpy as np
import pytest

import divbandit as db
from divbandit.paper import figure4, setting
from divbandit.studies import composition, rules, strategies
from divbandit.studies.cases import Case, Outcome, outcomes
from divbandit.studies.contenders import CONTENDERS, PAPER, RIVALS
from divbandit.studies.processes import over_processes
from divbandit.studies.repeating import Repeating

CASES = {
    "motor": Case(db.MotorBabbling(), at=(10, 40), place=(0,)),
    "adapt": Case(setting.adapt(0.05), at=(10, 40), place=(1,)),
}


def test_an_outcome_is_the_coverage_of_its_explorations():
    found = outcomes(CASES, seed=5, repetitions=3, jobs=1)
    assert found.keys() == CASES.keys()
    for name, outcome in found.items():
        case = CASES[name]
        for repetition in range(3):
            seed = setting.seed_of(5, *case.place, repetition)
            run = db.explore(setting.arm(), case.strategy, 40, rng=seed)
            covered = run.coverage(setting.TAU)[[9, 39]]
            np.testing.assert_allclose(outcome.values[repetition], covered, rtol=1e-13)
            if repetition == 0:
                np.testing.assert_array_equal(outcome.example, run.effects)


def test_means_and_deviations_are_over_repetitions():
    outcome = Outcome(CASES["motor"], 0, np.array([[1.0, 2.0], [3.0, 6.0]]))
    assert outcome.summary.tolist() == [[2.0, 1.0], [4.0, 2.0]]
    assert (outcome.mean, outcome.deviation) == (4.0, 2.0)


def test_what_a_process_raises_is_raised():
    with pytest.raises(TypeError):
        over_processes(abs, [1, "no number", 2], jobs=2)


def test_progress_is_told_of_each():
    told = []
    assert over_processes(abs, [-1, -2, -3], jobs=1, progress=lambda: told.append(1)) == [1, 2, 3]
    assert len(told) == 3


def test_the_papers_contender_is_adapt_step_by_step():
    babblings = [db.MotorBabbling(), db.GoalBabbling(0.05)]
    run = db.explore(setting.arm(), PAPER.over(babblings), 300, rng=0)
    adapt = db.explore(setting.arm(), setting.adapt(0.05), 300, rng=0)
    np.testing.assert_array_equal(run.commands, adapt.commands)


def test_no_two_contenders_have_a_name_in_common():
    assert len({each.name for each in CONTENDERS}) == len(CONTENDERS)
    assert set(RIVALS) <= set(CONTENDERS)


def test_the_mixtures_are_those_of_figure_4():
    found = outcomes(rules.cases(60), seed=2, repetitions=2, jobs=1)
    points = {(p.d, repr(p.motor_ratio)): p.mean for p in figure4.run(2, n=60, repetitions=2)}
    mixtures = {(d, parts): each for (d, name, parts), each in found.items() if name == "mixture"}
    assert len(mixtures) == 63
    for key, outcome in mixtures.items():
        assert outcome.mean == pytest.approx(points[key], rel=1e-12)


def test_the_best_mixture_is_the_bar():
    reached = {"mixture": 1.0, "hindsight": 3.0}
    found = {
        key: Outcome(case, 0, np.array([[reached.get(key[1], 1.9)]]))
        for key, case in rules.cases(5).items()
    }
    best = (0.001, "mixture", "0.35")
    found[best] = Outcome(found[best].case, 0, np.array([[2.0]]))
    panel = rules.panels(found)[0]
    assert (panel.d, panel.ratio, panel.best.mean) == (0.001, 0.35, 2.0)
    assert [each.case.place for each in panel.bandits] == [(5, 0, j) for j in range(16)]
    assert panel.relative(panel.bandits[0]) == pytest.approx(-0.05)
    assert panel.hindsight.mean == 3.0


def test_good_strategies_are_spread_geometrically():
    assert [each.d for each in strategies.good(4)] == pytest.approx([0.02, 0.04, 0.08, 0.16])
    assert [each.d for each in strategies.good(1)] == pytest.approx([np.sqrt(0.02 * 0.16)])


@pytest.mark.parametrize("size", strategies.SIZES)
def test_a_mix_has_as_many_strategies_as_it_says(size):
    for mix, count in (("half", size // 2), ("one", 1)):
        good, bad = strategies.mixed(mix, size)
        assert (len(good), len(good) + len(bad)) == (count, size)


def test_good_ones_alone_cover_more_than_bad_ones():
    """Over 3 seeds and 3000 steps: 0.9 m² at least against 0.85 at most."""

    def reached(strategy):
        return np.mean(
            [
                db.explore(setting.arm(), strategy, 3000, rng=k).coverage(setting.TAU)[-1]
                for k in range(3)
            ]
        )

    assert min(reached(each) for each in strategies.good(3)) > 0.9
    assert max(reached(each) for each in strategies.bad(4)) < 0.85


def test_repeating_has_one_effect():
    run = db.explore(setting.arm(), Repeating(), 20, rng=0)
    assert len(np.unique(run.effects, axis=0)) == 1


def test_compositions_differ_from_each_other():
    found = outcomes(composition.cases(300), seed=0, repetitions=1, jobs=1)
    assert {each.case.at for each in found.values()} == {(300,)}
    assert len({each.mean for each in found.values()}) == len(found)
