"""The volume of a union of balls by Voronota-LT (Olechnovic and Grudinin 2025), a peer."""

import math

import numpy as np
import voronotalt


def tessellated_volume(centres, tau):
    """Return the volume of the union of the balls of radius `tau` around `centres`, (n, 3)."""
    balls = np.unique(np.asarray(centres, dtype=float), axis=0) / tau
    try:
        tessellation = voronotalt.RadicalTessellation(
            [voronotalt.Ball(*ball, 1.0) for ball in balls.tolist()], probe=0.0
        )
    except RuntimeError:  # it refuses balls of which none meet
        return len(balls) * 4 * math.pi / 3 * tau**3
    return tau**3 * math.fsum(cell.volume for cell in tessellation.cells)
