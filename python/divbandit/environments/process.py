"""ProcessEnvironment: any program as a black box."""

from __future__ import annotations

import contextlib
import json
import os
import signal
import subprocess
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


class ProcessEnvironment:
    """A program: the motor command goes onto its command line, the effect comes out as JSON.

    The numbers of a command follow the words of the command line, each so that it reads back as the
    same float. The program writes the effect to its standard output: a list of numbers, a single
    number, or an object of which one entry is the effect. It is started anew each time, without a
    shell. With threads as the executor of `explore` several run at once.

    Parameters
    ----------
    command_line : sequence of str
        The program and its first arguments.
    motor_space : Box or object with ``low`` and ``high``
        M, the box of all motor commands.
    sensory_space : Box or object with ``low`` and ``high``, optional
        A box in S from which goals make sense.
    timeout : float, optional
        After so many seconds the program, with all that it has started, is killed.
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
        self.command_line = list(command_line)
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
            If the program fails, or its output is no JSON, or has no such entry.
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
            out, err = process.communicate(timeout=self.timeout)
        except BaseException as error:
            _end(process)
            if isinstance(error, subprocess.TimeoutExpired):
                raise TimeoutError(
                    f"the program must end within timeout = {self.timeout!r} s, it has not"
                ) from None
            raise
        if process.returncode != 0:
            told = err.decode(errors="replace").strip()[-_SHOWN:]
            raise RuntimeError(f"the program ended with status {process.returncode}: {told}")
        return self._effect_of(out.decode(errors="replace"))

    def _effect_of(self, text: str) -> Any:  # noqa: ANN401
        try:
            effect = json.loads(text)
        except ValueError:
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


def _end(process: subprocess.Popen[bytes]) -> None:
    """Kill a program and what it has started, a Ctrl-C having come perhaps; leave nothing open."""
    with contextlib.suppress(ProcessLookupError, PermissionError):
        os.killpg(process.pid, signal.SIGKILL)
    process.wait()
    for pipe in (process.stdout, process.stderr):
        if pipe is not None:
            pipe.close()
