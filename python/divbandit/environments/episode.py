"""Episode: what was observed, done and rewarded from a reset to the end."""

from __future__ import annotations

from dataclasses import dataclass
from typing import TYPE_CHECKING, Any

if TYPE_CHECKING:
    from collections.abc import Mapping, Sequence

    import numpy as np
    from numpy.typing import NDArray


@dataclass(frozen=True, eq=False, slots=True)
class Episode:
    """What happened in an episode of k steps.

    Parameters
    ----------
    observations : numpy.ndarray, shape (k + 1, ...)
        What the reset and each step let observe. Where observations are no arrays of numbers, as
        of spaces that are made of others, a list of them.
    actions : numpy.ndarray, shape (k, ...)
        What was done in each step, as the environment was told; likewise.
    rewards : numpy.ndarray of float64, shape (k,)
        What each step earned.
    terminated, truncated : bool
        Whether the last step led to an end of the episode, or to one of its time. Both are False
        where it was left after as many steps as were asked for.
    info : mapping
        What was told beside the last observation.

    Examples
    --------
    >>> import numpy as np
    >>> import divbandit as db
    >>> episode = db.Episode(np.zeros((3, 4)), np.zeros((2, 1)), np.ones(2), True, False, {})
    >>> len(episode), episode.observations[-1]
    (2, array([0., 0., 0., 0.]))
    """

    observations: NDArray[Any] | Sequence[Any]
    actions: NDArray[Any] | Sequence[Any]
    rewards: NDArray[np.float64]
    terminated: bool
    truncated: bool
    info: Mapping[str, Any]

    def __len__(self) -> int:
        return len(self.rewards)
