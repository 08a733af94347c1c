"""GymnasiumEnvironment: an episode as a black box - command, controller, rollout, effect."""

from __future__ import annotations

from functools import partial
from typing import TYPE_CHECKING, Any

import numpy as np

from divbandit._checks import one_of, whole
from divbandit._core import as_point
from divbandit._library import library, named
from divbandit.box import Box
from divbandit.environments._pool import Pool

if TYPE_CHECKING:
    from collections.abc import Callable, Iterator
    from types import TracebackType
    from typing import Literal, Self

    from gymnasium import Env
    from numpy.typing import ArrayLike, NDArray

    from divbandit.box import BoxLike
    from divbandit.controllers import Controller
    from divbandit.environments._vectors import Vector
    from divbandit.environments.episode import Episode

    Make = str | Callable[[], Env[Any, Any]]

#: The kinds of Gymnasium's vector environments.
VECTORS = ("sync", "async")


class GymnasiumEnvironment:
    """An episode of a Gymnasium environment as a black box.

    A motor command begins a controller; from a reset on it answers each observation by an action,
    until the episode ends or `steps` are done; the effect is computed from all that happened.
    Each episode is reset with the same seed, so that equal commands have equal effects, as far as
    the simulation is deterministic. Nothing is rendered.

    Gymnasium's environments are made when they are needed, one for each thread that is in an
    episode, and used again. They are no part of pickles: a process makes its own.

    Parameters
    ----------
    make : str or callable
        The id of a registered environment, such as ``"Reacher-v5"``, or what makes one when it is
        called without arguments, such as ``functools.partial(gymnasium.make, "Reacher-v5", ...)``.
    controller : Controller
        Has ``motor_space`` and ``begin(command)``, which returns ``policy(step, observation)``:
        `Tracking`, `OpenLoop`, `FunctionController` or one's own.
    effect : callable
        Takes the finished `Episode` and returns the effect, an array of shape (s,).
    steps : int
        How many steps an episode has at most; one that terminates or is truncated has fewer.
    seed : int
        What each episode is reset with; at least 0.
    sensory_space : Box or object with ``low`` and ``high``, optional
        A box in S from which goals make sense. Without one, goal babbling must be given goals.
    envs : int
        How many episodes of a batch of commands to have side by side, in a vector environment of
        Gymnasium whose every step is an episode. Effects are the same as one by one.
    vector : {"sync", "async"}
        Which one: ``"sync"`` takes turns and is no faster than one by one; ``"async"`` has a
        process for each. These are spawned: `make`, `controller` and `effect` are sent there by
        cloudpickle, and a script that calls this must guard what it does by
        ``if __name__ == "__main__":``. It takes about a second until they are there. Pusher's
        episodes, of 5 ms, took a sixth more processor time in two processes than one by one: it
        is of use where cores are free.

    Attributes
    ----------
    make, controller, effect, steps, seed, envs, vector
        As given.
    motor_space : Box
        That of the controller.
    sensory_space : Box or None

    Raises
    ------
    ModuleNotFoundError
        If Gymnasium is not installed: ``pip install 'divbandit[gymnasium]'``.
    TypeError, ValueError
        If an argument is not what it must be. Whether `make` makes an environment shows when the
        first is needed.

    Notes
    -----
    An action of a ``Box`` is clipped to it, as a motor's torque is limited; one that is no finite
    array of its shape is refused. Of other spaces it must be a member.

    An exploration asks for one command after the other, so that `envs` is of use to
    ``environment(commands)`` alone. With an executor of processes ``explore(..., executor=)`` has
    several episodes at once as well.

    Examples
    --------
    How far a cart gets that is pushed as the command says, while the pole on it stands.

    >>> import divbandit as db
    >>> def push(command, step, observation):
    ...     return int(observation[2] + command[0] * observation[3] > command[1])
    >>> controller = db.FunctionController(push, db.Box([0, -0.1], [1, 0.1]))
    >>> def stop(episode):
    ...     return episode.observations[-1][:1]
    >>> with db.GymnasiumEnvironment("CartPole-v1", controller, stop, 100, seed=0) as cart:
    ...     effects = cart([[0.5, 0.02], [0.5, 0.05]])
    ...     steps = len(cart.episode([0.0, 0.1]))
    >>> effects.shape, steps < 100
    ((2, 1), True)
    """

    motor_space: Box
    sensory_space: Box | None

    def __init__(
        self,
        make: Make,
        controller: Controller,
        effect: Callable[[Episode], ArrayLike],
        steps: int,
        seed: int,
        *,
        sensory_space: BoxLike | None = None,
        envs: int = 1,
        vector: Literal["sync", "async"] = "sync",
    ) -> None:
        library("gymnasium", user="GymnasiumEnvironment")
        if not isinstance(make, str) and not callable(make):
            raise TypeError(
                "make must be the id of an environment or callable without arguments, "
                f"got {type(make).__name__}"
            )
        begin = getattr(controller, "begin", None)
        if not (callable(begin) and hasattr(controller, "motor_space")):
            raise TypeError(
                "controller must have motor_space and begin(command), "
                f"got {type(controller).__name__}"
            )
        if not callable(effect):
            raise TypeError(f"effect must be callable, got {type(effect).__name__}")
        self.make, self.controller, self.effect = make, controller, effect
        self.steps = whole("steps", steps, low=1)
        self.seed = whole("seed", seed, low=0)
        self.envs = whole("envs", envs, low=1)
        self.vector = one_of("vector", vector, VECTORS)
        self.motor_space = Box.of(controller.motor_space, name="controller.motor_space")
        self.sensory_space = (
            None if sensory_space is None else Box.of(sensory_space, name="sensory_space")
        )
        self._envs = Pool(self._new_env)
        self._vectors = Pool(self._new_vector)

    def __call__(self, command: ArrayLike) -> NDArray[np.float64]:
        """Return the effect of one command, or the effects of many.

        Parameters
        ----------
        command : array_like, shape (m,) or (n, m)

        Returns
        -------
        numpy.ndarray of float64, shape (s,) or (n, s)

        Raises
        ------
        TypeError, ValueError
            If a command is no point of the motor space, `make` makes no environment, the
            controller returns no action, or `effect` no finite point of the sensory space.
        Exception
            What the environment or the controller raises.

        Examples
        --------
        >>> import divbandit as db
        >>> swing = db.GymnasiumEnvironment(
        ...     "Pendulum-v1",
        ...     db.FunctionController(lambda command, step, _: command, db.Box([-2], [2])),
        ...     lambda episode: episode.observations[-1, :2],
        ...     steps=20,
        ...     seed=0,
        ... )
        >>> swing([[-1.0], [0.0], [1.0]]).shape
        (3, 2)
        """
        commands = self.motor_space.bounds.commands(command)
        length = None if self.sensory_space is None else self.sensory_space.dim
        if commands.ndim == 1:
            return as_point("effect", self.effect(self._episode(commands)), length)
        effects = []
        for effect in self._effects(commands):
            effects.append(as_point("effect", effect, length))
            length = len(effects[0])
        return np.stack(effects) if effects else np.empty((0, length or 0))

    def episode(self, command: ArrayLike) -> Episode:
        """Return all that happens in the episode of a command.

        Parameters
        ----------
        command : array_like, shape (m,)

        Raises
        ------
        TypeError, ValueError, Exception
            As a call does.

        Examples
        --------
        >>> import divbandit as db
        >>> swing = db.GymnasiumEnvironment(
        ...     "Pendulum-v1",
        ...     db.FunctionController(lambda command, step, _: command, db.Box([-9], [9])),
        ...     lambda episode: episode.observations[-1],
        ...     steps=2,
        ...     seed=0,
        ... )
        >>> swing.episode([7.0]).actions  # the pendulum's motor has a limit
        array([[2.],
               [2.]], dtype=float32)
        """
        return self._episode(
            self.motor_space.bounds.commands(as_point("command", command, self.motor_space.dim))
        )

    def close(self) -> None:
        """Close Gymnasium's environments, those in an episode when it ends.

        If there is another episode, it is in a new one.

        Examples
        --------
        >>> import divbandit as db
        >>> keep = db.FunctionController(lambda command, step, _: command, db.Box([-2], [2]))
        >>> swing = db.GymnasiumEnvironment("Pendulum-v1", keep, lambda e: e.rewards, 5, seed=0)
        >>> first = swing([1.0])
        >>> swing.close()
        >>> bool((swing([1.0]) == first).all())
        True
        """
        self._envs.close()
        self._vectors.close()

    def __enter__(self) -> Self:
        return self

    def __exit__(
        self,
        kind: type[BaseException] | None,
        error: BaseException | None,
        traceback: TracebackType | None,
    ) -> None:
        self.close()

    def _effects(self, commands: NDArray[np.float64]) -> Iterator[ArrayLike]:
        """Yield what `effect` returns for each command, in order."""
        if self.envs == 1 or len(commands) <= 1:
            for command in commands:
                yield self.effect(self._episode(command))
            return
        with self._vectors.borrow() as vector:
            outcomes = vector.evaluate(commands)
        for outcome in outcomes:
            yield outcome.get()

    def _episode(self, command: NDArray[np.float64]) -> Episode:
        from divbandit.environments._rollout import rollout  # noqa: PLC0415 - needs Gymnasium

        with self._envs.borrow() as env:
            return rollout(env, self.controller.begin(command), self.steps, self.seed)

    def _new_env(self) -> Env[Any, Any]:
        from divbandit.environments._rollout import made  # noqa: PLC0415

        return made(self.make)

    def _new_vector(self) -> Vector:
        from divbandit.environments._vectors import Vector  # noqa: PLC0415

        alone = {**self._arguments(), "envs": 1}
        return Vector(partial(type(self), **alone), self.envs, self.vector)

    def _arguments(self) -> dict[str, Any]:
        names = ("make", "controller", "effect", "steps", "seed", "sensory_space", "envs", "vector")
        return {name: getattr(self, name) for name in names}

    def __repr__(self) -> str:
        made = repr(self.make) if isinstance(self.make, str) else named(self.make)
        text = f"{made}, {self.controller!r}, {named(self.effect)}, {self.steps}, {self.seed}"
        text += f", sensory_space={self.sensory_space!r}"
        if self.envs > 1:
            text += f", envs={self.envs}, vector={self.vector!r}"
        return f"GymnasiumEnvironment({text})"

    def __reduce__(self) -> tuple[object, ...]:
        return _rebuild, (type(self), self._arguments())


def _rebuild(kind: type[GymnasiumEnvironment], arguments: dict[str, Any]) -> GymnasiumEnvironment:
    return kind(**arguments)
