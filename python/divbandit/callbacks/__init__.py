"""Callbacks: what watches a run, and may stop it.

Any function of an explorer and a trial is one. It is called after each evaluation, told or failed,
and stops the run by returning True.
"""

from typing import TYPE_CHECKING

from divbandit.callbacks.every import Every
from divbandit.callbacks.plateau import Plateau
from divbandit.callbacks.progress import Progress
from divbandit.callbacks.protocol import Callback, RunningCallback
from divbandit.callbacks.time_budget import TimeBudget

__all__ = ["Callback", "Every", "Plateau", "Progress", "RunningCallback", "TimeBudget"]

if TYPE_CHECKING:  # what mypy is to hold to the protocol
    _CALLBACKS: tuple[type[Callback], ...] = (Every, Plateau, Progress, TimeBudget)
