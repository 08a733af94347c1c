"""The elementary functions, against arithmetic of 40 digits, and what they refuse."""

import math

import mpmath
import numpy as np
import pytest

from divbandit import _core

RNG = np.random.default_rng(0)


@pytest.mark.parametrize("x", [-745.0, -1.0, 0.0, 1e-300, 709.0, *RNG.uniform(-50, 50, 200)])
def test_exp(x):
    with mpmath.workdps(40):
        assert _core.exp(x) == pytest.approx(float(mpmath.exp(x)), rel=3e-16, abs=5e-324)


@pytest.mark.parametrize("x", [5e-324, 0.5, 1.0, 2.0, 1e308, *10.0 ** RNG.uniform(-5, 5, 200)])
def test_log(x):
    with mpmath.workdps(40):
        assert _core.log(x) == pytest.approx(float(mpmath.log(x)), rel=3e-16)


@pytest.mark.parametrize("x", [0.5, 1.0, *RNG.uniform(0, 3, 100)])
@pytest.mark.parametrize("y", [0.0, 0.5, 1.0, 7.3, -2.0])
def test_power(x, y):
    with mpmath.workdps(40):
        assert _core.power(x, y) == pytest.approx(float(mpmath.mpf(x) ** y), rel=3e-16)


@pytest.mark.parametrize("p", [1e-10, 0.3, 0.5, 0.99, *RNG.random(100)])
def test_normal_quantile(p):
    with mpmath.workdps(40):
        x = mpmath.sqrt(2) * mpmath.erfinv(2 * mpmath.mpf(p) - 1)
        assert _core.normal_quantile(p) == pytest.approx(float(x), rel=1e-14, abs=1e-16)


@pytest.mark.parametrize(
    ("name", "arguments"),
    [
        ("exp", (710.0,)),
        ("exp", (math.nan,)),
        ("exp", (-math.inf,)),
        ("log", (0.0,)),
        ("log", (-1.0,)),
        ("log", (math.inf,)),
        ("power", (0.0, -1.0)),
        ("power", (-1.0, 0.5)),
        ("power", (10.0, 400.0)),
        ("normal_quantile", (0.0,)),
        ("normal_quantile", (1.0,)),
        ("normal_quantile", (math.nan,)),
    ],
)
def test_what_leads_to_no_number_is_refused(name, arguments):
    with pytest.raises(ValueError, match=r"^(x|base|p) must be .* got"):
        getattr(_core, name)(*arguments)
