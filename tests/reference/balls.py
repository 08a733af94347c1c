"""Families of unit balls in space: scattered, crowded, on lattices, and degenerate."""

import numpy as np

SCATTERED = ("sparse", "random", "coplanar", "collinear", "duplicated", "shell")
CROWDED = ("dense", "clustered", "crowded", "jittered")
LATTICES = ("cubic", "body-centred", "face-centred")
# Of lattices: where balls touch, where spheres meet in common points, and between.
EDGES = (0.5, 0.9, 1.0, 2**0.5, 1.5, 2.0, 2.5, 8**0.5, 3.0)


def balls(name, n, seed=0):
    """Return the centres of `n` unit balls."""
    rng = np.random.default_rng(seed)
    if name in _STRETCHED:
        return rng.uniform(-1, 1, (n, 3)) * _STRETCHED[name](n)
    return _DRAWN[name](n, rng)


# Places uniform in [-1, 1]^3, by what they are multiplied with.
_STRETCHED = {
    "sparse": lambda n: 1.5 * n ** (1 / 3),
    "random": lambda n: 0.8 * n ** (1 / 3),
    "dense": lambda n: 0.4 * n ** (1 / 3),
    "coplanar": lambda n: 0.8 * n**0.5 * np.array([1, 1, 0]),
}


def _collinear(n, rng):
    return 0.6 * n * rng.uniform(-1, 1, (n, 1)) * np.array([1, 2, 2]) / 3


def _duplicated(n, rng):
    places = rng.uniform(-1, 1, (n, 3)) * 0.8 * n ** (1 / 3)
    return places[rng.integers(max(1, n // 5), size=n)]


def _clustered(n, rng):
    clusters = rng.uniform(-1, 1, (max(1, n // 20), 3)) * n ** (1 / 3)
    return clusters[rng.integers(len(clusters), size=n)] + 0.2 * rng.standard_normal((n, 3))


def _jittered(n, rng):
    places = lattice("cubic", int(np.ceil(n ** (1 / 3) - 1e-9)), 1.2)
    return rng.permutation(places)[:n] + 0.01 * rng.standard_normal((n, 3))


def _directions(n, rng):
    normal = rng.standard_normal((n, 3))
    return normal / np.linalg.norm(normal, axis=1, keepdims=True)


_DRAWN = {
    "collinear": _collinear,
    "duplicated": _duplicated,
    "clustered": _clustered,
    "crowded": lambda n, rng: 0.3 * rng.standard_normal((n, 3)),
    "jittered": _jittered,
    # All centres on one sphere: larger than a ball, and as large.
    "shell": lambda n, rng: 0.8 * (1 + n ** (1 / 3)) * _directions(n, rng),
    "through a point": _directions,
}


def lattice(name, cells, edge):
    """Return the points of `cells` cubed cells of a lattice whose cubes have this edge."""
    basis = {
        "cubic": [[0, 0, 0]],
        "body-centred": [[0, 0, 0], [0.5, 0.5, 0.5]],
        "face-centred": [[0, 0, 0], [0.5, 0.5, 0], [0.5, 0, 0.5], [0, 0.5, 0.5]],
    }[name]
    corners = np.stack(np.meshgrid(*[np.arange(cells)] * 3), axis=-1).reshape(-1, 1, 3)
    return edge * (corners + np.array(basis)).reshape(-1, 3)
