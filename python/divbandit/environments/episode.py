"""Episode: observations, actions and rewards from a reset to the end."""

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
        The observation after the reset and after each step. If observations are not arrays of
        numbers, as in composite spaces, a list of them.
    actions : numpy.ndarray, shape (k, ...)
        The action of each step, as passed to the environment; likewise.
    rewards : numpy.ndarray of float64, shape (k,)
        The reward of each step.
    terminated, truncated : bool
        Whether the last step terminated the episode, or truncated it. Both are False if it was
        left after the requested number of steps.
    info : mapping
        The information returned with the last observation.

    Examples
    --------
    >>> import numpy as np
    >>> from divbandit.environments import Episode
    >>> episode = Episode(np.zeros((3, 4)), np.zeros((2, 1)), np.ones(2), True, False, {})
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
