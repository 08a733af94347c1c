"""Evaluating: a black box called with commands, and all that can go wrong said in a word.

`evaluate` is what runs in a worker, wherever that is: nothing that a black box raises gets past it.
"""

from __future__ import annotations

import sys
from contextlib import suppress
from typing import TYPE_CHECKING, Any, NamedTuple

import numpy as np

from divbandit._core import as_point
from divbandit._portable import portable, reason_of

if TYPE_CHECKING:
    from collections.abc import Sequence

    from numpy.typing import NDArray

    from divbandit.environments import Environment


class Outcome(NamedTuple):
    """What came of an evaluation: an effect, or what was raised, also in words."""

    effect: NDArray[np.float64] | None
    error: BaseException | None = None
    reason: str = ""

    @classmethod
    def of(cls, error: BaseException) -> Outcome:
        """Return the outcome of a failed evaluation."""
        return cls(None, error, reason_of(error))


def evaluate(
    environment: Environment,
    commands: Sequence[NDArray[np.float64]],
    dim: int | None = None,
    *,
    pickled: bool = False,
) -> list[Outcome]:
    """Call a black box with each of the commands; with all at once where it takes arrays.

    Its effects must have `dim` numbers, if that is known. With `pickled`, outcomes can be sent to
    another process, and Ctrl-C is one of them.

    Examples
    --------
    >>> import divbandit as db
    >>> box = db.FunctionEnvironment(lambda x: 1 / int(x[0]), db.Box([0], [1]))
    >>> [outcome.reason for outcome in evaluate(box, [[1], [0]])]
    ['', 'ZeroDivisionError: division by zero']
    """
    effects = _at_once(environment, commands)
    outcomes = []
    for index, command in enumerate(commands):
        try:
            effect = environment(command) if effects is None else effects[index]
            outcomes.append(Outcome(as_point("effect", effect, dim)))
        except BaseException as error:  # noqa: PERF203 - a black box may raise anything
            if isinstance(error, KeyboardInterrupt) and not pickled:
                raise
            outcome = Outcome.of(error)
            outcomes.append(outcome._replace(error=portable(error)) if pickled else outcome)
    return outcomes


def _at_once(environment: Environment, commands: Sequence[NDArray[np.float64]]) -> list[Any] | None:
    """Return the effects of all commands; None if which of them fail is to be found one by one."""
    if len(commands) > 1 and getattr(environment, "vectorized", False):
        with suppress(Exception, SystemExit):
            effects = list(np.asarray(environment(np.stack(commands))))
            return effects if len(effects) == len(commands) else None
    return None


def note(error: BaseException, text: str) -> None:
    """Add a line to what an exception shows, from Python 3.11 on."""
    if sys.version_info >= (3, 11):
        error.add_note(text)
