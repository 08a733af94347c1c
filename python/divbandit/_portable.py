"""Exceptions said in a line, and sent to another process."""

from __future__ import annotations

import pickle


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
