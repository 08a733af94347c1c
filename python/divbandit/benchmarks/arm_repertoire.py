"""ArmRepertoire: a planar arm by the conventions of quality diversity."""

from __future__ import annotations

import math
from dataclasses import dataclass
from typing import TYPE_CHECKING

from divbandit._value import Value
from divbandit.environments import PlanarArm

if TYPE_CHECKING:
    import numpy as np
    from numpy.typing import ArrayLike, NDArray

    from divbandit import _core
    from divbandit.box import Box


@dataclass(frozen=True, init=False, repr=False)
class ArmRepertoire(Value):
    """The planar arm of quality diversity's arm repertoire: each angle in [-pi, pi].

    Its kinematics are those of `PlanarArm`, whose segments have equal length and are together 1 m
    long; the effect is the position of the tip (Cully and Demiris 2018, "Quality and Diversity
    Optimization: A Unifying Modular Framework", IEEE Transactions on Evolutionary Computation
    22(2)).

    Parameters
    ----------
    joints : int
        Number of joints, from 1 to 100,000.

    Attributes
    ----------
    motor_space : Box
        [-pi, pi]^joints, in radians.
    sensory_space : Box
        [-1, 1] x [-1, 1], in metres.

    Raises
    ------
    TypeError, ValueError
        If `joints` is not a whole number in its range.

    Examples
    --------
    >>> import math
    >>> from divbandit.benchmarks import ArmRepertoire
    >>> ArmRepertoire(2)([0, math.pi]).round(12)
    array([0., 0.])
    """

    joints: int

    if TYPE_CHECKING:
        motor_space: Box
        sensory_space: Box
        _arm: PlanarArm
        _kernel: _core.PlanarArm | _core.ObstructedArm

    def __init__(self, joints: int = 12) -> None:
        arm = PlanarArm(joints, limit=math.pi)
        self._set(
            joints=arm.joints,
            motor_space=arm.motor_space,
            sensory_space=arm.sensory_space,
            _arm=arm,
            _kernel=arm._kernel,  # noqa: SLF001 - what the engine explores
        )

    def __call__(self, command: ArrayLike) -> NDArray[np.float64]:
        """Return the position of the tip for one command, or for each of many.

        Parameters
        ----------
        command : array_like, shape (joints,) or (n, joints)
            Angles in radians.

        Returns
        -------
        numpy.ndarray of float64, shape (2,) or (n, 2)
            x and y in metres.

        Raises
        ------
        TypeError, ValueError
            If the shape is wrong, or an angle is not finite or beyond pi.

        Examples
        --------
        >>> from divbandit.benchmarks import ArmRepertoire
        >>> ArmRepertoire(3)([0, 0, 0])
        array([1., 0.])
        """
        return self._arm(command)
