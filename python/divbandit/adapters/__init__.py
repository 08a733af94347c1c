"""Adapters: parts of other people's libraries as strategies and rules of this one, or the reverse.

Each needs its library only when it is made: ``pip install 'divbandit[ribs]'`` and so on.
"""

from typing import TYPE_CHECKING

from divbandit.adapters.mabwiser import MabwiserRule
from divbandit.adapters.optuna import OptunaSampler
from divbandit.adapters.ribs import RibsEmitter

if TYPE_CHECKING:
    from divbandit.adapters.gymnasium import OneStepEnv

__all__ = ["MabwiserRule", "OneStepEnv", "OptunaSampler", "RibsEmitter"]


def __getattr__(name: str) -> object:
    """Find `OneStepEnv` when it is asked for: it derives from a class of Gymnasium."""
    if name != "OneStepEnv":
        raise AttributeError(f"module {__name__!r} has no attribute {name!r}")
    from divbandit.adapters.gymnasium import OneStepEnv  # noqa: PLC0415

    return OneStepEnv
