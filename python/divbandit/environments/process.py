"""ProcessEnvironment: any program as a black box."""

from __future__ import annotations

import contextlib
import json
import os
import selectors
import signal
import subprocess
import time
from typing import TYPE_CHECKING, Any

from divbandit._checks import positive
from divbandit.box import Box, BoxLike
from divbandit.environments._one_by_one import one_by_one

if TYPE_CHECKING:
    from collections.abc import Sequence

    import numpy as np
    from numpy.typing import ArrayLike, NDArray

#: How much of a program's output an error shows.
_SHOWN = 500
#: How much a program may write to its standard output, in bytes, and how much is read at once.
_MOST, _CHUNK = 2**26, 2**16
#: The longest time-out, in seconds; beyond some more the system has no number for it.
_LONGEST = 1e6


class ProcessEnvironment:
    """A program: the motor command goes onto its command line, the effect comes out as JSON.

    The numbers of a command follow the words of the command line, each so that it reads back as the
    same float. The program writes the effect to its standard output: a list of numbers, a single
    number, or an object of which one entry is the effect, at most 64 MiB of it. It is started anew
    each time, without a shell. With threads as the executor of `explore` several run at once; then
    Ctrl-C waits for those under way, where without an executor it kills the one.

    Parameters
    ----------
    command_line : sequence of str
        The program and its first arguments. Many programs, those with Python's argparse among
        them, take ``-1e-05`` for an option; let ``"--"`` be the last word for these.
    motor_space : Box or object with ``low`` and ``high``
        M, the box of all motor commands.
    sensory_space : Box or object with ``low`` and ``high``, optional
        A box in S from which goals make sense.
    timeout : float, optional
        After so many seconds, at most a million, the program is killed, with all that it has
        started.
    entry : str, optional
        Which entry of an object is the effect.

    Raises
    ------
    TypeError, ValueError
        If an argument is not what it must be.

    Examples
    --------
    >>> import sys
    >>> import divbandit as db
    >>> words = [sys.executable, "-c", "import sys; print([float(x) for x in sys.argv[:0:-1]])"]
    >>> program = db.ProcessEnvironment(words, db.Box([0, 0], [1, 1]), timeout=60)
    >>> program([0.25, 0.5])              # here the effect is the command, backwards
    array([0.5 , 0.25])
    """

    motor_space: Box
    sensory_space: Box | None

    def __init__(
        self,
        command_line: Sequence[str],
        motor_space: BoxLike,
        sensory_space: BoxLike | None = None,
        *,
        timeout: float | None = None,
        entry: str | None = None,
    ) -> None:
        if isinstance(command_line, (str, bytes)):
            raise TypeError("command_line must be a list of words, got one text")
        try:
            self.command_line = list(command_line)
        except TypeError:
            kind = type(command_line).__name__
            raise TypeError(f"command_line must be a list of words, got {kind}") from None
        if not self.command_line:
            raise ValueError("command_line must not be empty")
        for index, word in enumerate(self.command_line):
            if type(word) is not str or "\0" in word:
                raise TypeError(
                    f"command_line[{index}] must be a text without zero bytes, got {word!r}"
                )
        self.motor_space = Box.of(motor_space, name="motor_space")
        self.sensory_space = (
            None if sensory_space is None else Box.of(sensory_space, name="sensory_space")
        )
        self.timeout = None if timeout is None else positive("timeout", timeout)
        if self.timeout is not None and self.timeout > _LONGEST:
            raise ValueError(f"timeout must be at most {_LONGEST:.0f} seconds, got {timeout!r}")
        if entry is not None and not isinstance(entry, str):
            raise TypeError(f"entry must be a text, got {type(entry).__name__}")
        self.entry = entry

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
            If a command is no point of the motor space, or the program's output no finite point of
            the sensory space.
        RuntimeError
            If the program fails, or its output is no JSON, or too long, or has no such entry.
        TimeoutError
            If it takes too long.
        OSError
            If it cannot be started.

        Examples
        --------
        >>> import sys
        >>> import divbandit as db
        >>> words = [sys.executable, "-c", "import sys; print(1 / (float(sys.argv[1]) - 1))"]
        >>> program = db.ProcessEnvironment(words, db.Box([0], [1]))
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
                f"the program must end within timeout = {self.timeout!r} s, it has not"
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

    def __repr__(self) -> str:
        return (
            f"ProcessEnvironment({self.command_line!r}, {self.motor_space!r}, "
            f"{self.sensory_space!r}, timeout={self.timeout!r}, entry={self.entry!r})"
        )


def _outputs(process: subprocess.Popen[bytes], timeout: float | None) -> tuple[bytes, bytes]:
    """Return what a program writes until it ends, all of its output and the end of its errors."""
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
    """Kill a program that has not ended, and what it has started; leave nothing open."""
    if process.returncode is None:
        with contextlib.suppress(ProcessLookupError, PermissionError):
            os.killpg(process.pid, signal.SIGKILL)
        process.wait()
    for pipe in (process.stdout, process.stderr):
        if pipe is not None:
            pipe.close()
