"""Vectors: a vector environment of Gymnasium, each of whose steps is a whole evaluation.

Everything of an evaluation happens where the sub-environment lives: with a process for each, one
message goes there and one comes back, not two a step of the simulation; and that some episodes
end before others is no matter of the vector environment, which resets nothing by itself.
"""

from __future__ import annotations

import pickle
import warnings
from contextlib import suppress
from dataclasses import dataclass
from functools import partial
from typing import TYPE_CHECKING, Any

import gymnasium
import numpy as np
from gymnasium.vector import AsyncVectorEnv, SyncVectorEnv

if TYPE_CHECKING:
    from collections.abc import Callable

    from numpy.typing import NDArray

    from divbandit.environments.gymnasium import GymnasiumEnvironment


@dataclass(frozen=True)
class _Outcome:
    """What came of an evaluation: an effect, or what was raised."""

    effect: NDArray[np.float64] | None
    error: Exception | None

    def get(self) -> NDArray[np.float64]:
        if self.effect is None:
            raise self.error or AssertionError
        return self.effect


class _Evaluation(gymnasium.Env[Any, Any]):
    """One step is one evaluation: the action is the command; what came of it is in the info."""

    def __init__(self, make: Callable[[], GymnasiumEnvironment], *, is_sent: bool) -> None:
        self._environment = make()
        self._is_sent = is_sent
        space = self._environment.motor_space
        # A row of NaN says that there is nothing to do.
        self.action_space = gymnasium.spaces.Box(space.low, space.high, dtype=np.float64)
        self.observation_space = gymnasium.spaces.Box(0.0, 1.0, (1,), dtype=np.float64)

    def step(
        self, action: NDArray[np.float64]
    ) -> tuple[NDArray[np.float64], float, bool, bool, dict[str, Any]]:
        outcome = None if np.isnan(action[0]) else self._outcome(action)
        return np.zeros(1), 0.0, False, False, {"outcome": outcome}

    def _outcome(self, command: NDArray[np.float64]) -> _Outcome:
        try:
            return _Outcome(self._environment(command), None)
        except Exception as error:  # noqa: BLE001 - it is raised where the batch was asked for
            return _Outcome(None, _sendable(error) if self._is_sent else error)

    def close(self) -> None:
        self._environment.close()


class Vector:
    """Several environments that evaluate side by side.

    Parameters
    ----------
    make : callable
        Makes one of them.
    envs : int
        How many.
    kind : {"sync", "async"}
        Which vector environment: in turns, or a process each.

    Examples
    --------
    >>> import divbandit as db
    >>> keep = db.FunctionController(lambda command, step, _: command, db.Box([-2], [2]))
    >>> def swing():
    ...     return db.GymnasiumEnvironment("Pendulum-v1", keep, lambda e: e.rewards, 5, seed=0)
    >>> vector = Vector(swing, 2, "sync")
    >>> len(vector.evaluate(np.array([[-1.0], [0.0], [1.0]])))
    3
    >>> vector.close()
    """

    def __init__(self, make: Callable[[], GymnasiumEnvironment], envs: int, kind: str) -> None:
        self._is_whole = True
        self._envs: AsyncVectorEnv[Any, Any] | SyncVectorEnv[Any, Any]
        if kind == "sync":
            self._envs = SyncVectorEnv([partial(_Evaluation, make, is_sent=False)] * envs)
            return
        try:
            # Spawned, as forks do not go together with threads.
            self._envs = AsyncVectorEnv(
                [partial(_Evaluation, make, is_sent=True)] * envs, context="spawn"
            )
        except (EOFError, ConnectionError) as error:
            raise RuntimeError(
                "a process of the vector environment died as it began; a script that starts "
                'processes must do so under `if __name__ == "__main__":` alone'
            ) from error

    def evaluate(self, commands: NDArray[np.float64]) -> list[_Outcome]:
        """Return what came of the commands, in order, up to the first round with an error."""
        n, outcomes = self._envs.num_envs, []
        for begin in range(0, len(commands), n):
            some = commands[begin : begin + n]
            padded = np.full((n, commands.shape[1]), np.nan)
            padded[: len(some)] = some
            outcomes += self._round(padded)[: len(some)]
            if any(outcome.error for outcome in outcomes[begin:]):
                break
        return outcomes

    def _round(self, commands: NDArray[np.float64]) -> list[_Outcome]:
        self._is_whole = False
        try:
            *_, infos = self._envs.step(commands)
        except (EOFError, ConnectionError) as error:
            raise RuntimeError("a process of the vector environment died") from error
        self._is_whole = True
        return list(infos["outcome"])

    def close(self) -> None:
        """Close them all; at once, where something went wrong."""
        if self._is_whole:
            self._envs.close()
            return
        with suppress(Exception), warnings.catch_warnings():
            warnings.simplefilter("ignore")  # Gymnasium's, that it is still waiting
            self._envs.close(terminate=True)


def _sendable(error: Exception) -> Exception:
    """Return an error that survives being pickled: itself, or what it says.

    Examples
    --------
    >>> _sendable(KeyError("a"))
    KeyError('a')
    >>> class Odd(Exception):
    ...     def __init__(self, a, b):
    ...         super().__init__(f"{a} is odd, {b} is even")
    >>> _sendable(Odd(1, 2))
    RuntimeError('Odd: 1 is odd, 2 is even')
    """
    try:
        pickle.loads(pickle.dumps(error))  # noqa: S301 - what was just written
    except Exception:  # noqa: BLE001 - it may fail in any way
        return RuntimeError(f"{type(error).__name__}: {error}")
    return error
