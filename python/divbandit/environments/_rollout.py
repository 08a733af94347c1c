"""Rollout: an episode of a Gymnasium environment, from its reset to its end."""

from __future__ import annotations

import copy
from typing import TYPE_CHECKING, Any

import gymnasium
import numpy as np
from gymnasium.spaces import Box

from divbandit.environments.episode import Episode

if TYPE_CHECKING:
    from collections.abc import Callable

    from gymnasium.spaces import Space

    from divbandit.controllers.protocol import Policy

    Env = gymnasium.Env[Any, Any]


def made(make: str | Callable[[], Env]) -> Env:
    """Return the environment of an id, or what a callable makes."""
    if isinstance(make, str):
        try:
            return gymnasium.make(make)
        except gymnasium.error.DependencyNotInstalled:
            raise
        except (gymnasium.error.Error, ModuleNotFoundError) as error:
            if isinstance(error, ModuleNotFoundError) and ":" not in make:
                raise  # the environment is registered; a module that it needs is missing
            raise ValueError(
                f"make must be the id of a registered environment, got {make!r}: {error}"
            ) from error
    env = make()
    if not isinstance(env, gymnasium.Env):
        raise TypeError(f"make must return a gymnasium.Env, got {type(env).__name__}")
    return env


def rollout(env: Env, policy: Policy, steps: int, seed: int) -> Episode:
    """Reset an environment and let a policy act, for at most `steps` steps."""
    if not callable(policy):
        raise TypeError(
            f"controller.begin must return a callable policy, got {type(policy).__name__}"
        )
    observation, info = env.reset(seed=seed)
    observations = [_kept(observation, env.observation_space)]
    actions: list[Any] = []
    rewards: list[float] = []
    terminated = truncated = False
    while len(actions) < steps and not (terminated or truncated):
        action = _allowed(policy(len(actions), observations[-1]), env.action_space)
        observation, reward, terminated, truncated, info = env.step(action)
        actions.append(action)
        observations.append(_kept(observation, env.observation_space))
        rewards.append(float(reward))
    return Episode(
        _together(observations, env.observation_space),
        _together(actions, env.action_space),
        np.array(rewards),
        bool(terminated),
        bool(truncated),
        dict(info),
    )


def _allowed(action: Any, space: Space[Any]) -> Any:  # noqa: ANN401 - of any space
    """Return an action clipped to a box, or check that it is a member of another space."""
    if not isinstance(space, Box):
        if not space.contains(action):
            raise ValueError(f"action must be a member of {space}, got {action!r}")
        return action
    try:
        wanted = np.asarray(action, dtype=np.float64)
    except (TypeError, ValueError):
        raise TypeError(
            f"action must be an array of numbers of shape {space.shape}, got {action!r}"
        ) from None
    if wanted.shape != space.shape:
        raise ValueError(f"action must be of shape {space.shape}, got {wanted.shape}")
    if not np.isfinite(wanted).all():
        raise ValueError(f"action must be finite, got {wanted.tolist()}")
    return np.clip(wanted, space.low, space.high).astype(space.dtype)


def _kept(observation: Any, space: Space[Any]) -> Any:  # noqa: ANN401 - of any space
    """Return a copy of an observation, as an environment may overwrite the one it returned."""
    if _holds_arrays(space):
        return np.array(observation, dtype=space.dtype)
    return copy.deepcopy(observation)


def _together(items: list[Any], space: Space[Any]) -> Any:  # noqa: ANN401 - of any space
    return np.stack(items) if _holds_arrays(space) else items


def _holds_arrays(space: Space[Any]) -> bool:
    """Return whether the members of a space are numbers or arrays of numbers."""
    return isinstance(space.dtype, np.dtype) and space.dtype.kind in "biuf"
