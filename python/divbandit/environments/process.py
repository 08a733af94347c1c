"""ProcessEnvironment: any program as a black box."""

from __future__ import annotations

import contextlib
import json
import os
import selectors
import signal
import subprocess
import time
from dataclasses import dataclass
from typing import TYPE_CHECKING, Any

from divbandit._checks import positive
from divbandit._value import Value
from divbandit.box import Box, BoxLike, box_or_none
from divbandit.environments._one_by_one import one_by_one

if TYPE_CHECKING:
    from collections.abc import Sequence

    import numpy as np
    from numpy.typing import ArrayLike, NDArray

#: Number of characters of a program's output that an error shows.
_SHOWN = 500
#: Limit of a program's standard output, in bytes, and how much is read at once.
_MOST, _CHUNK = 2**26, 2**16
#: The longest timeout, in seconds; the operating system cannot represent much longer ones.
_LONGEST = 1e6


@dataclass(frozen=True, init=False, repr=False)
class ProcessEnvironment(Value):
    """A program: motor commands are passed on its command line, effects are returned as JSON.

    The numbers of a command follow the words of the command line, each written so that it reads
    back as the same float. The program writes the effect to its standard output, at most 64 MiB: a
    list of numbers, a single number, or an object that has the effect as one entry. It is started
    once for each command, without a shell. With a thread pool as the executor of `explore`, several
    run at once; Ctrl-C then waits for those that are running. Without an executor it kills the
    program.

    Parameters
    ----------
    command_line : sequence of str
        The program and its first arguments. Many programs, such as those that use Python's
        argparse, take ``-1e-05`` for an option; end the command line of these with ``"--"``.
    motor_space : Box or object with ``low`` and ``high``
        M, the box of all motor commands.
    sensory_space : Box or object with ``low`` and ``high``, optional
        A box in S to draw goals from.
    timeout : float, optional
        The program and all that it has started are killed after this many seconds, at most a
        million.
    entry : str, optional
        The entry of an object that is the effect.

    Raises
    ------
    TypeError, ValueError
        If an argument is not what it must be.

    Examples
    --------
    >>> import sys
    >>> import divbandit as db
    >>> words = [sys.executable, "-c", "import sys; print([float(x) for x in sys.argv[:0:-1]])"]
    >>> program = db.environments.ProcessEnvironment(words, db.Box([0, 0], [1, 1]), timeout=60)
    >>> program([0.25, 0.5])              # the effect is the reversed command
    array([0.5 , 0.25])
    """

    command_line: tuple[str, ...]
    motor_space: Box
    sensory_space: Box | None
    timeout: float | None
    entry: str | None

    def __init__(
        self,
        command_line: Sequence[str],
        motor_space: BoxLike,
        sensory_space: BoxLike | None = None,
        *,
        timeout: float | None = None,
        entry: str | None = None,
    ) -> None:
        if timeout is not None:
            timeout = positive("timeout", timeout)
            if timeout > _LONGEST:
                raise ValueError(f"timeout must be at most {_LONGEST:.0f} seconds, got {timeout!r}")
        if entry is not None and not isinstance(entry, str):
            raise TypeError(f"entry must be a string, got {type(entry).__name__}")
        self._set(
            command_line=_words(command_line),
            motor_space=Box.of(motor_space, name="motor_space"),
            sensory_space=box_or_none("sensory_space", sensory_space),
            timeout=timeout,
            entry=entry,
        )

    def __call__(self, command: ArrayLike) -> NDArray[np.float64]:
        """Return the effect of one command, or the effects of many, one by one.

        Parameters
        ----------
        command : array_like, shape (m,) or (n, m)

        Returns
        -------
        numpy.ndarray of float64, shape (s,) or (n, s)

        Raises
        ------
        TypeError, ValueError
            If a command is not a point of the motor space, or the program's output is not a finite
            point of the sensory space.
        RuntimeError
            If the program fails, or its output is not JSON, is too long, or lacks the entry.
        TimeoutError
            If it takes too long.
        OSError
            If it cannot be started.

        Examples
        --------
        >>> import sys
        >>> import divbandit as db
        >>> words = [sys.executable, "-c", "import sys; print(1 / (float(sys.argv[1]) - 1))"]
        >>> program = db.environments.ProcessEnvironment(words, db.Box([0], [1]))
        >>> program([[0.0], [0.5]]).ravel()
        array([-1., -2.])
        >>> program([1.0])
        Traceback (most recent call last):
            ...
        RuntimeError: the program ended with status 1: ...
        """
        return one_by_one(self._run, command, self.motor_space, self.sensory_space)

    def _run(self, command: NDArray[np.float64]) -> Any:  # noqa: ANN401 - what JSON can say
        words = [*self.command_line, *map(repr, command.tolist())]
        process = subprocess.Popen(  # noqa: S603 - the program is what is explored
            words,
            stdin=subprocess.DEVNULL,
            stdout=subprocess.PIPE,
            stderr=subprocess.PIPE,
            start_new_session=True,
        )
        try:
            out, err = _outputs(process, self.timeout)
        except subprocess.TimeoutExpired:
            raise TimeoutError(
                f"the program must end within timeout = {self.timeout!r} s, but did not"
            ) from None
        finally:
            _end(process)
        if process.returncode != 0:
            told = err.decode(errors="replace").strip()[-_SHOWN:]
            raise RuntimeError(f"the program ended with status {process.returncode}: {told}")
        return self._effect_of(out.decode(errors="replace"))

    def _effect_of(self, text: str) -> Any:  # noqa: ANN401
        try:
            effect = json.loads(text)
        except (ValueError, RecursionError):
            raise RuntimeError(
                f"the program must write JSON to its standard output, got {text[:_SHOWN]!r}"
            ) from None
        if self.entry is not None:
            if not isinstance(effect, dict) or self.entry not in effect:
                raise RuntimeError(
                    f"the program must write a JSON object with {self.entry!r}, "
                    f"got {text[:_SHOWN]!r}"
                )
            effect = effect[self.entry]
        is_number = isinstance(effect, (int, float)) and not isinstance(effect, bool)
        return [effect] if is_number else effect


def _words(command_line: Sequence[str]) -> tuple[str, ...]:
    """Return the words of a command line, or say what is wrong with them."""
    if isinstance(command_line, (str, bytes)):
        raise TypeError("command_line must be a list of words, got a single string")
    try:
        words = tuple(command_line)
    except TypeError:
        kind = type(command_line).__name__
        raise TypeError(f"command_line must be a list of words, got {kind}") from None
    if not words:
        raise ValueError("command_line must not be empty")
    for index, word in enumerate(words):
        if type(word) is not str or "\0" in word:
            raise TypeError(
                f"command_line[{index}] must be a string without null characters, got {word!r}"
            )
    return words


def _outputs(process: subprocess.Popen[bytes], timeout: float | None) -> tuple[bytes, bytes]:
    """Wait for a program; return its output and the last part of its error output."""
    deadline = None if timeout is None else time.monotonic() + timeout
    out, err = bytearray(), bytearray()
    with selectors.DefaultSelector() as selector:
        for pipe, kept in ((process.stdout, out), (process.stderr, err)):
            if pipe is not None:
                selector.register(pipe, selectors.EVENT_READ, kept)
        while selector.get_map():
            left = None if deadline is None else deadline - time.monotonic()
            if timeout is not None and left is not None and left <= 0:
                raise subprocess.TimeoutExpired(process.args, timeout)
            for key, _ in selector.select(left):
                read = os.read(key.fd, _CHUNK)
                key.data.extend(read)
                if not read:
                    selector.unregister(key.fileobj)
            del err[:-_CHUNK]
            if len(out) > _MOST:
                raise RuntimeError(
                    f"the program must write at most {_MOST} bytes to its standard output, "
                    f"got more, beginning with {out[:_SHOWN].decode(errors='replace')!r}"
                )
    process.wait(None if deadline is None else max(0.0, deadline - time.monotonic()))
    return bytes(out), bytes(err)


def _end(process: subprocess.Popen[bytes]) -> None:
    """Kill a program that is still running, with all that it started, and close its pipes."""
    if process.returncode is None:
        with contextlib.suppress(ProcessLookupError, PermissionError):
            os.killpg(process.pid, signal.SIGKILL)
        process.wait()
    for pipe in (process.stdout, process.stderr):
        if pipe is not None:
            pipe.close()
