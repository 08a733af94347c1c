"""Adapters: parts of other people's libraries as strategies and rules of this one.

Each needs its library only when it is made: ``pip install 'divbandit[ribs]'`` and so on.
"""

from divbandit.adapters.mabwiser import MabwiserRule
from divbandit.adapters.optuna import OptunaSampler
from divbandit.adapters.ribs import RibsEmitter

__all__ = ["MabwiserRule", "OptunaSampler", "RibsEmitter"]
