"""OneStepEnv: the other way round - a black box as a Gymnasium environment of one step.

Importing this registers it with Gymnasium, under the id `ID`.
"""

from __future__ import annotations

from typing import TYPE_CHECKING, Any

import numpy as np

from divbandit._checks import real, truth
from divbandit._core import as_point
from divbandit._library import library
from divbandit.box import Box
from divbandit.environments import Environment

library("gymnasium", user="OneStepEnv")

import gymnasium  # noqa: E402 - once it is known to be there
from gymnasium import spaces  # noqa: E402

if TYPE_CHECKING:
    from collections.abc import Callable

    from numpy.typing import NDArray

    from divbandit.box import BoxLike

    Array = NDArray[np.float64]
    Reward = Callable[[Array, Array], float]

#: The id under which it is registered.
ID = "divbandit/OneStep-v0"

#: How far outside its box an effect is taken for rounding: of its coordinate, or of 1 if larger.
SLACK = 1e-9


class OneStepEnv(gymnasium.Env[Any, Any]):
    """A black box as a Gymnasium environment of one step: the action is the motor command.

    The observation after the step is the effect; after a reset it is the middle of the observation
    space (0 in a coordinate that is not bounded on both sides, or the bound nearest to 0).

    Parameters
    ----------
    environment : Environment
        The black box.
    reward : callable, optional
        ``(command, effect) -> float``, what the step earns. Without one, 0.
    observation_space : Box or object with ``low`` and ``high``, optional
        A box that holds every effect; infinite bounds are allowed. Without one, the sensory space.
        An effect outside is an error; one that is outside by a share of `SLACK` at most, by
        rounding, is moved to the border.
    normalize : bool
        Whether actions lie in [-1, 1]^m, which is mapped onto M, as most learning algorithms expect
        and Gymnasium's checker recommends. Otherwise an action is the command itself.

    Attributes
    ----------
    environment, reward, normalize
        As given.
    action_space, observation_space : gymnasium.spaces.Box of float64

    Raises
    ------
    ModuleNotFoundError
        When this module is imported and Gymnasium is not installed.
    TypeError, ValueError
        If an argument is not what it must be, or there is no observation space.

    Examples
    --------
    >>> import divbandit as db
    >>> from divbandit.adapters.gymnasium import OneStepEnv
    >>> env = OneStepEnv(db.PlanarArm(2), reward=lambda command, tip: tip[0])
    >>> env.reset(seed=0)
    (array([0., 0.]), {})
    >>> env.step([0.0, 0.0])
    (array([1., 0.]), 1.0, True, False, {})

    By its id, as for a library that makes its environments by itself:

    >>> import gymnasium
    >>> env = gymnasium.make("divbandit/OneStep-v0", environment=db.PlanarArm(2), normalize=True)
    >>> env.action_space
    Box(-1.0, 1.0, (2,), float64)
    """

    metadata: dict[str, Any] = {"render_modes": []}  # noqa: RUF012 - as Gymnasium has it
    render_mode = None

    def __init__(
        self,
        environment: Environment,
        *,
        reward: Reward | None = None,
        observation_space: BoxLike | None = None,
        normalize: bool = False,
    ) -> None:
        if not isinstance(environment, Environment):
            raise TypeError(
                "environment must be callable and have motor_space and sensory_space, "
                f"got {type(environment).__name__}"
            )
        if reward is not None and not callable(reward):
            raise TypeError(f"reward must be callable, got {type(reward).__name__}")
        self.environment, self.reward = environment, reward
        self.normalize = truth("normalize", normalize)
        self._motor_space = Box.of(environment.motor_space, name="environment.motor_space")
        ones = np.ones(self._motor_space.dim)
        self._actions = Box(-ones, ones) if self.normalize else self._motor_space
        self.action_space = spaces.Box(self._actions.low, self._actions.high, dtype=np.float64)
        self._effects = _space_of(environment, observation_space)
        self.observation_space = self._effects
        self._is_ready = False

    def reset(
        self, *, seed: int | None = None, options: dict[str, Any] | None = None
    ) -> tuple[Array, dict[str, Any]]:
        """Get ready for a step.

        Parameters
        ----------
        seed : int, optional
            Seeds ``np_random``, from which nothing is drawn.
        options : dict, optional
            Not used.

        Returns
        -------
        numpy.ndarray of float64, shape (s,)
            The middle of the observation space.
        dict
            Empty.

        Examples
        --------
        >>> import divbandit as db
        >>> from divbandit.adapters.gymnasium import OneStepEnv
        >>> shift = db.FunctionEnvironment(lambda x: x + 4, db.Box([0], [1]), db.Box([4], [5]))
        >>> OneStepEnv(shift).reset()
        (array([4.5]), {})
        """
        super().reset(seed=seed, options=options)
        self._is_ready = True
        return _middle(self._effects), {}

    def step(self, action: Array) -> tuple[Array, float, bool, bool, dict[str, Any]]:
        """Evaluate a command, which ends the episode.

        Parameters
        ----------
        action : array_like, shape (m,)

        Returns
        -------
        numpy.ndarray of float64, shape (s,)
            The effect.
        float
            The reward.
        bool
            True: terminated.
        bool
            False: not truncated.
        dict
            Empty.

        Raises
        ------
        gymnasium.error.ResetNeeded
            If there was no reset, or a step since.
        TypeError, ValueError
            If the action is not a point of the action space, the effect not one of the observation
            space, or the reward not a finite number.
        Exception
            What the environment or `reward` raises.

        Examples
        --------
        >>> import divbandit as db
        >>> from divbandit.adapters.gymnasium import OneStepEnv
        >>> double = db.FunctionEnvironment(lambda x: 2 * x, db.Box([0], [1]), db.Box([0], [2]))
        >>> env = OneStepEnv(double, normalize=True)
        >>> _ = env.reset()
        >>> env.step([0.5])
        (array([1.5]), 0.0, True, False, {})
        """
        if not self._is_ready:
            raise gymnasium.error.ResetNeeded("an episode has one step: reset must be called first")
        command = self._command(action)
        low, high = self._effects.low, self._effects.high
        effect = as_point("effect", self.environment(command), len(low))
        observed = np.clip(effect, low, high)
        if (np.abs(observed - effect) > SLACK * np.maximum(1.0, np.abs(observed))).any():
            raise ValueError(f"observation_space must hold every effect, got {effect.tolist()}")
        reward = 0.0 if self.reward is None else real("reward", self.reward(command, effect))
        self._is_ready = False
        return observed, reward, True, False, {}

    def _command(self, action: Array) -> Array:
        """Return the command that an action stands for."""
        point = as_point("action", action, self._actions.dim)
        if not self._actions.contains(point):
            raise ValueError(f"action must lie in {self._actions}, got {point.tolist()}")
        if not self.normalize:
            return point
        low, high = self._motor_space.low, self._motor_space.high
        # Weighted so that -1 and 1 are exactly the corners, and clipped as sums are rounded.
        command: Array = low * ((1.0 - point) / 2.0) + high * ((1.0 + point) / 2.0)
        return np.clip(command, low, high)

    def __repr__(self) -> str:
        return f"OneStepEnv({self.environment!r}, normalize={self.normalize})"


def _space_of(environment: Environment, wanted: BoxLike | None) -> spaces.Box:
    """Return the box of effects as Gymnasium has it; unlike ours it may be unbounded."""
    name = "observation_space"
    if wanted is None:
        if environment.sensory_space is None:
            raise ValueError(f"{name} must be given where environment.sensory_space is None")
        wanted = Box.of(environment.sensory_space, name="environment.sensory_space")
    if not (hasattr(wanted, "low") and hasattr(wanted, "high")):
        raise TypeError(f"{name} must have .low and .high, got {type(wanted).__name__}")
    try:
        low, high = (np.asarray(bound, dtype=np.float64) for bound in (wanted.low, wanted.high))
    except (TypeError, ValueError):
        raise TypeError(
            f"{name} must have corners of numbers, got {wanted.low!r}, {wanted.high!r}"
        ) from None
    if low.ndim != 1 or low.shape != high.shape or low.size == 0 or not (low <= high).all():
        raise ValueError(
            f"{name} must have low <= high, both of shape (s,), got {low.tolist()}, {high.tolist()}"
        )
    return spaces.Box(low, high, dtype=np.float64)


def _middle(space: spaces.Box) -> Array:
    bounded = np.isfinite(space.low) & np.isfinite(space.high)
    low, high = (np.where(bounded, bound, 0.0) for bound in (space.low, space.high))
    return np.clip(low / 2 + high / 2, space.low, space.high)


if ID not in gymnasium.registry:
    gymnasium.register(ID, entry_point=f"{__name__}:OneStepEnv")
