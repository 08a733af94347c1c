"""Adapters: parts of other libraries as parts of this one, and the reverse.

Strategies: `RibsEmitter` (pyribs), `OptunaSampler` (Optuna), `QuasiRandomBabbling` (SciPy). A
policy of bandits: `MabwiserPolicy` (MABWiser). A black box as an environment of Gymnasium:
`OneStepEnv`. A bandit over pyribs' own emitters: `RibsScheduler`. Each imports its library when it
is first used: ``pip install 'divbandit[ribs]'``, for instance.
"""

from typing import TYPE_CHECKING

from divbandit.adapters.mabwiser import MabwiserPolicy
from divbandit.adapters.optuna import OptunaSampler
from divbandit.adapters.quasi_random import QuasiRandomBabbling
from divbandit.adapters.ribs import RibsEmitter
from divbandit.adapters.ribs_scheduler import RibsScheduler

if TYPE_CHECKING:
    from divbandit.adapters.gymnasium import OneStepEnv

__all__ = [
    "MabwiserPolicy",
    "OneStepEnv",
    "OptunaSampler",
    "QuasiRandomBabbling",
    "RibsEmitter",
    "RibsScheduler",
]


def __getattr__(name: str) -> object:
    """Import `OneStepEnv` on first use: it derives from a class of Gymnasium."""
    if name != "OneStepEnv":
        raise AttributeError(f"module {__name__!r} has no attribute {name!r}")
    from divbandit.adapters.gymnasium import OneStepEnv  # noqa: PLC0415

    return OneStepEnv
