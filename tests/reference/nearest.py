"""The nearest points by looking at all of them."""

import numpy as np


def nearest(points, query, k=1):
    """Return (distances, indices) of the `k` nearest; of equals, the earliest first.

    Squares are added coordinate by coordinate, so that equal numbers are equal bits.
    """
    points, query = np.asarray(points, dtype=float), np.asarray(query, dtype=float)
    squared = np.zeros(len(points))
    for j in range(points.shape[1]):
        squared += (query[j] - points[:, j]) ** 2
    indices = np.argsort(squared, kind="stable")[:k]
    return np.sqrt(squared[indices]), indices
