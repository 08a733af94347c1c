"""ProcessEnvironment: any program as a black box."""

from __future__ import annotations

import contextlib
import json
import math
import os
import selectors
import signal
import subprocess
import time
from concurrent.futures import Future
from dataclasses import dataclass
from pathlib import Path
from threading import Event, Thread
from typing import IO, TYPE_CHECKING, Any, cast

from divbandit._checks import positive
from divbandit._value import Value
from divbandit.box import Box, BoxLike, box_or_none
from divbandit.environments._one_by_one import one_by_one

if TYPE_CHECKING:
    from collections.abc import Callable, Iterator, Sequence

    import numpy as np
    from numpy.typing import ArrayLike, NDArray

#: Number of characters of a program's output that an error shows.
_SHOWN = 500
#: Limit of a program's standard output, in bytes, and how much is read at once.
_MOST, _CHUNK = 2**26, 2**16
#: Seconds between looks at whether the program has ended, or is to be stopped.
_GLANCE = 0.05
#: The longest timeout, in seconds; the operating system cannot represent much longer ones.
_LONGEST = 1e6


@dataclass(frozen=True, init=False, repr=False)
class ProcessEnvironment(Value):
    """A program: motor commands are passed on its command line, effects are returned as JSON.

    The numbers of a command follow the words of the command line, each written so that it reads
    back as the same float. The program writes the effect to its standard output, at most 64 MiB: a
    list of numbers, a single number, or an object that has the effect as one entry. It is started
    once for each command, without a shell; what it leaves running in the background is not waited
    for. With a thread pool as the executor of `explore`, several run at once; Ctrl-C then waits for
    those that are running. Without an executor it kills the program.

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
        million. A daemon, whose parent has ended and which has left its session, is not found;
        outside of Linux nor is anything else that has left its group of processes.
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
        outcome: Future[str] = Future()
        stop = Event()
        # Ctrl-C interrupts the main thread alone: in this one, what was started is always ended.
        thread = Thread(target=_carry_out, args=(words, self.timeout, stop, outcome))
        try:
            thread.start()
            text = outcome.result()
        finally:
            stop.set()
            if thread.is_alive():
                thread.join()
        return self._effect_of(text)

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


def _carry_out(words: list[str], timeout: float | None, stop: Event, outcome: Future[str]) -> None:
    """Run a program, and report its output or what went wrong."""
    try:
        outcome.set_result(_output_of(words, timeout, stop))
    except BaseException as error:  # noqa: BLE001 - raised where the outcome is waited for
        outcome.set_exception(error)


def _output_of(words: list[str], timeout: float | None, stop: Event) -> str:
    """Return the output of a program, which is killed if it takes too long or is to stop."""
    with subprocess.Popen(  # noqa: S603 - the program is what is explored
        words,
        stdin=subprocess.DEVNULL,
        stdout=subprocess.PIPE,
        stderr=subprocess.PIPE,
        start_new_session=True,
    ) as process:
        try:
            out, err = _outputs(process, timeout, stop)
        finally:
            if process.returncode is None:
                _kill(process.pid)
    if process.returncode != 0:
        told = err.decode(errors="replace").strip()[-_SHOWN:]
        raise RuntimeError(f"the program ended with status {process.returncode}: {told}")
    return out.decode(errors="replace")


def _outputs(
    process: subprocess.Popen[bytes], timeout: float | None, stop: Event
) -> tuple[bytes, bytes]:
    """Wait for a program; return its output and the last part of its error output."""
    deadline = time.monotonic() + (math.inf if timeout is None else timeout)
    out, err = bytearray(), bytearray()
    with selectors.DefaultSelector() as selector:
        for pipe, kept in ((process.stdout, out), (process.stderr, err)):
            selector.register(cast("IO[bytes]", pipe), selectors.EVENT_READ, kept)
        while True:
            # What the program has started may keep the pipes open after its end.
            ended = process.poll() is not None
            ready = selector.select(0 if ended else _GLANCE) if selector.get_map() else []
            for key, _ in ready:
                read = os.read(key.fd, _CHUNK)
                key.data.extend(read)
                if not read:
                    selector.unregister(key.fileobj)
            del err[:-_CHUNK]
            if ended and not ready:
                return bytes(out), bytes(err)
            if len(out) > _MOST:
                raise RuntimeError(
                    f"the program must write at most {_MOST} bytes to its standard output, "
                    f"got more, beginning with {out[:_SHOWN].decode(errors='replace')!r}"
                )
            if stop.is_set():
                raise InterruptedError
            if time.monotonic() > deadline:
                raise TimeoutError(
                    f"the program must end within timeout = {timeout!r} s, but did not"
                )
            if not selector.get_map():
                with contextlib.suppress(subprocess.TimeoutExpired):
                    process.wait(_GLANCE / 10)


def _kill(root: int) -> None:
    """Kill a process with all that it has started; on Linux, in sessions of their own, too."""
    found, new = set[int](), {root}
    while new:
        for pid in new:
            _send(os.kill, pid, signal.SIGSTOP)  # it shall start no more
        found |= new
        new = {pid for pid, relatives in _relatives() if relatives & found} - found
    _send(os.killpg, root, signal.SIGKILL)
    for pid in found:
        _send(os.kill, pid, signal.SIGKILL)


def _relatives() -> Iterator[tuple[int, set[int]]]:
    """Yield each process with its parent and the leaders of its group and its session."""
    for path in Path("/proc").glob("[0-9]*/stat"):  # none but on Linux
        with contextlib.suppress(OSError):  # it has ended
            fields = path.read_text(errors="replace").rpartition(")")[2].split()
            yield int(path.parent.name), set(map(int, fields[1:4]))


def _send(send: Callable[[int, int], None], pid: int, number: int) -> None:
    """Send a signal, if the process is still there and may be reached."""
    with contextlib.suppress(ProcessLookupError, PermissionError):
        send(pid, number)
