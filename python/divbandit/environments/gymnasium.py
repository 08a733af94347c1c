"""GymnasiumEnvironment: an episode as a black box, from a command to an effect."""

from __future__ import annotations

from dataclasses import dataclass
from threading import Lock
from typing import TYPE_CHECKING, Any
from uuid import uuid4

from divbandit._checks import whole
from divbandit._core import as_point
from divbandit._library import library
from divbandit._value import Value
from divbandit.box import Box, box_or_none
from divbandit.environments._one_by_one import one_by_one
from divbandit.environments._pool import Pool

if TYPE_CHECKING:
    from collections.abc import Callable

    import numpy as np
    from gymnasium import Env
    from numpy.typing import ArrayLike, NDArray
    from typing_extensions import Self

    from divbandit.box import BoxLike
    from divbandit.controllers import Controller
    from divbandit.environments.episode import Episode

    Make = str | Callable[[], Env[Any, Any]]


@dataclass(frozen=True, init=False, repr=False)
class GymnasiumEnvironment(Value):
    """An episode of a Gymnasium environment as a black box.

    From a reset on, the controller of a motor command answers each observation with an action,
    until the episode ends or `steps` actions are done; the effect is computed from all that
    happened. Every episode is reset with the same seed, so that equal commands have equal effects
    as far as the simulation is deterministic. Nothing is rendered.

    Gymnasium's environments are created on demand, one for each thread that runs an episode, and
    reused. They are not part of copies and pickles: each process creates its own, once for all the
    commands that an executor sends there.

    Parameters
    ----------
    make : str or callable
        The id of a registered environment, such as ``"Reacher-v5"``, or a function without
        arguments that makes one, such as ``functools.partial(gymnasium.make, "Reacher-v5", ...)``.
    controller : Controller
        Has ``motor_space`` and ``begin(command)``, which returns ``policy(step, observation)``,
        such as `Tracking`, `OpenLoop` and `FunctionController`.
    effect : callable
        Takes the finished `Episode` and returns the effect, an array of shape (s,).
    steps : int
        Maximal number of steps of an episode; it may terminate or be truncated before.
    seed : int
        Seed of every reset; at least 0.
    sensory_space : Box or object with ``low`` and ``high``, optional
        A box in S to draw goals from. Without it, goal babbling needs its own goals.

    Attributes
    ----------
    motor_space : Box
        That of the controller.

    Raises
    ------
    ModuleNotFoundError
        If Gymnasium is not installed: ``pip install 'divbandit[gymnasium]'``.
    TypeError, ValueError
        If an argument is not what it must be. What `make` makes is checked when the first
        environment is needed.

    Notes
    -----
    An action of a ``Box`` is clipped to it, as a motor's torque is limited; it must be a finite
    array of the right shape. Actions of other spaces must be members of them.

    Commands are evaluated one by one. To run several episodes at once, use an executor:
    ``explore(..., executor=ProcessPoolExecutor(2), in_flight=2)``.

    Examples
    --------
    How far does a cart get before its pole falls, if it is pushed as the command says?

    >>> import divbandit as db
    >>> from divbandit.controllers import FunctionController
    >>> from divbandit.environments import GymnasiumEnvironment
    >>> def push(command, step, observation):
    ...     return int(observation[2] + command[0] * observation[3] > command[1])
    >>> controller = FunctionController(push, db.Box([0, -0.1], [1, 0.1]))
    >>> def stop(episode):
    ...     return episode.observations[-1][:1]
    >>> with GymnasiumEnvironment("CartPole-v1", controller, stop, 100, seed=0) as cart:
    ...     effects = cart([[0.5, 0.02], [0.5, 0.05]])
    ...     steps = len(cart.episode([0.0, 0.1]))
    >>> effects.shape, steps < 100
    ((2, 1), True)
    """

    make: Make
    controller: Controller
    effect: Callable[[Episode], ArrayLike]
    steps: int
    seed: int
    sensory_space: Box | None

    if TYPE_CHECKING:
        motor_space: Box
        _envs: Pool[Env[Any, Any]]
        _key: str

    def __init__(
        self,
        make: Make,
        controller: Controller,
        effect: Callable[[Episode], ArrayLike],
        steps: int,
        seed: int,
        *,
        sensory_space: BoxLike | None = None,
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
        self._set(
            make=make,
            controller=controller,
            effect=effect,
            steps=whole("steps", steps, low=1),
            seed=whole("seed", seed, low=0),
            sensory_space=box_or_none("sensory_space", sensory_space),
            motor_space=Box.of(controller.motor_space, name="controller.motor_space"),
            _envs=Pool(self._new_env),
            _key=uuid4().hex,
        )

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
            If a command is not a point of the motor space, `make` does not make an environment, the
            controller does not return an action, or `effect` does not return a finite point of the
            sensory space.
        Exception
            What the environment or the controller raises.

        Examples
        --------
        >>> import divbandit as db
        >>> from divbandit.controllers import FunctionController
        >>> from divbandit.environments import GymnasiumEnvironment
        >>> swing = GymnasiumEnvironment(
        ...     "Pendulum-v1",
        ...     FunctionController(lambda command, step, _: command, db.Box([-2], [2])),
        ...     lambda episode: episode.observations[-1, :2],
        ...     steps=20,
        ...     seed=0,
        ... )
        >>> swing([[-1.0], [0.0], [1.0]]).shape
        (3, 2)
        """
        return one_by_one(self._effect, command, self.motor_space, self.sensory_space)

    def episode(self, command: ArrayLike) -> Episode:
        """Return the whole episode of a command.

        Parameters
        ----------
        command : array_like, shape (m,)

        Raises
        ------
        TypeError, ValueError, Exception
            As for a call.

        Examples
        --------
        >>> import divbandit as db
        >>> from divbandit.controllers import FunctionController
        >>> from divbandit.environments import GymnasiumEnvironment
        >>> swing = GymnasiumEnvironment(
        ...     "Pendulum-v1",
        ...     FunctionController(lambda command, step, _: command, db.Box([-9], [9])),
        ...     lambda episode: episode.observations[-1],
        ...     steps=2,
        ...     seed=0,
        ... )
        >>> swing.episode([7.0]).actions  # the torque is limited
        array([[2.],
               [2.]], dtype=float32)
        """
        return self._episode(
            self.motor_space.bounds.commands(as_point("command", command, self.motor_space.dim))
        )

    def close(self) -> None:
        """Close Gymnasium's environments, those in use when their episode ends.

        Later calls create new ones.

        Examples
        --------
        >>> import divbandit as db
        >>> from divbandit.controllers import FunctionController
        >>> from divbandit.environments import GymnasiumEnvironment
        >>> keep = FunctionController(lambda command, step, _: command, db.Box([-2], [2]))
        >>> swing = GymnasiumEnvironment("Pendulum-v1", keep, lambda e: e.rewards, 5, seed=0)
        >>> first = swing([1.0])
        >>> swing.close()
        >>> bool((swing([1.0]) == first).all())
        True
        """
        self._envs.close()

    def __enter__(self) -> Self:
        return self

    def __exit__(self, *_: object) -> None:
        self.close()

    def _effect(self, command: NDArray[np.float64]) -> ArrayLike:
        return self.effect(self._episode(command))

    def _episode(self, command: NDArray[np.float64]) -> Episode:
        from divbandit.environments._rollout import rollout  # noqa: PLC0415 - needs Gymnasium

        with self._envs.borrow() as env:
            return rollout(env, self.controller.begin(command), self.steps, self.seed)

    def _new_env(self) -> Env[Any, Any]:
        from divbandit.environments._rollout import made  # noqa: PLC0415 - needs Gymnasium

        return made(self.make)

    def __reduce__(self) -> tuple[Any, ...]:
        return _arrived, (self._key, *super().__reduce__())


#: The last environments that were unpickled in this process, by the keys of the originals.
_ARRIVED: dict[str, GymnasiumEnvironment] = {}
_LOCK = Lock()
#: How many of them are kept.
_MOST_ARRIVED = 8


def _arrived(
    key: str, make: Callable[..., GymnasiumEnvironment], arguments: tuple[Any, ...]
) -> GymnasiumEnvironment:
    """Return the environment of a key: an executor sends it again with each command."""
    with _LOCK:
        environment = _ARRIVED.pop(key, None) or make(*arguments)
        _ARRIVED[key] = environment
        while len(_ARRIVED) > _MOST_ARRIVED:
            del _ARRIVED[next(iter(_ARRIVED))]
    return environment
