"""Evaluating: a black box called with commands, and all that can go wrong said in a word.

`evaluate` is what runs in a worker, wherever that is: nothing that a black box raises gets past it.
"""

from __future__ import annotations

import pickle
from typing import TYPE_CHECKING, Any, NamedTuple

import numpy as np

if TYPE_CHECKING:
    from collections.abc import Sequence

    from numpy.typing import NDArray

    from divbandit.environments import Environment


class Outcome(NamedTuple):
    """What came of an evaluation: an effect, not yet checked, or what was raised."""

    effect: Any
    error: BaseException | None = None


def evaluate(
    environment: Environment, commands: Sequence[NDArray[np.float64]], *, pickled: bool = False
) -> list[Outcome]:
    """Call a black box with each of the commands; with all at once where it takes arrays.

    Examples
    --------
    >>> import divbandit as db
    >>> box = db.FunctionEnvironment(lambda x: 1 / float(x[0]), db.Box([0], [1]))
    >>> [outcome.error for outcome in evaluate(box, [[0.5], [0]])]
    [None, ZeroDivisionError('float division by zero')]
    """
    if len(commands) > 1 and getattr(environment, "vectorized", False):
        try:
            return [Outcome(effect) for effect in np.asarray(environment(np.stack(commands)))]
        except Exception:  # noqa: BLE001, S110 - which of them it was, is found one by one
            pass
    outcomes = []
    for command in commands:
        try:
            outcomes.append(Outcome(environment(command)))
        except BaseException as error:  # noqa: BLE001, PERF203 - a black box may raise anything
            outcomes.append(Outcome(None, portable(error) if pickled else error))
    return outcomes


def portable(error: BaseException) -> BaseException:
    """Return an exception that survives being sent to another process: itself, if it does.

    Examples
    --------
    >>> portable(ValueError("no"))
    ValueError('no')
    """
    try:
        pickle.loads(pickle.dumps(error))  # noqa: S301 - our own
    except Exception:  # noqa: BLE001 - it may fail in any way
        return RuntimeError(reason_of(error))
    return error


def reason_of(error: BaseException) -> str:
    """Return what was raised in a line: its type, and what it says.

    Examples
    --------
    >>> reason_of(ValueError("no"))
    'ValueError: no'
    """
    kind = type(error).__name__
    try:
        text = str(error)
    except Exception:  # noqa: BLE001 - of a user's class
        return f"{kind}, whose message cannot be shown"
    return f"{kind}: {text}" if text else kind
