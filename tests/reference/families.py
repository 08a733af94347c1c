"""Families of points that an exploration really meets, and that break naive geometry."""

import numpy as np

FAMILIES = ("uniform", "clustered", "duplicated", "sorted", "collinear")


def family(name, n, dim, seed=0):
    """Return `n` points in R^dim, all within [-1, 1]."""
    rng = np.random.default_rng(seed)
    uniform = rng.uniform(-1, 1, (n, dim))
    match name:
        case "uniform":
            return uniform
        case "clustered":  # thousands of times closer together than the clusters are apart
            return np.round(3 * uniform[rng.integers(min(5, n), size=n)]) / 3 + 1e-9 * uniform
        case "duplicated":
            return uniform[rng.integers(max(1, n // 10), size=n)]
        case "sorted":
            return np.sort(uniform, axis=0)
        case "collinear":
            return uniform[:1] * rng.uniform(-1, 1, (n, 1))
    raise ValueError(name)
