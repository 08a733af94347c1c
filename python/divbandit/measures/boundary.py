"""Boundary: the loops of arcs around a union of discs, and polygons made of them."""

from __future__ import annotations

from dataclasses import dataclass
from math import pi
from typing import TYPE_CHECKING

import numpy as np

from divbandit._checks import real, whole
from divbandit._value import Value

if TYPE_CHECKING:
    from collections.abc import Iterable

    import shapely
    from numpy.typing import ArrayLike, NDArray


@dataclass(frozen=True, init=False, repr=False, eq=False)
class Loop(Value):
    """A closed loop of arcs of circles of radius `tau`, each counter-clockwise around its centre.

    Each arc ends where the next one begins, and the last one where the first does. The union of
    the discs lies on the left: a loop around a part of it is counter-clockwise, one around a hole
    clockwise.

    Parameters
    ----------
    arcs : array_like, shape (k, 4)
        An arc a row: centre x, centre y, start angle, end angle, in radians. The end is greater
        than the start, by 2 pi at most: then the arc is a whole circle, and a loop of its own.
    tau : float
        Radius of the circles, in the units of the centres, in [1e-100, 1e100].

    Attributes
    ----------
    arcs : numpy.ndarray of float64, shape (k, 4)
        The arcs, read-only.
    tau : float
    area : float
        The signed area inside: negative for a hole.

    Raises
    ------
    TypeError, ValueError
        If `arcs` is not a finite array of this shape with at least one row, an arc does not go
        counter-clockwise, or `tau` is not a radius. That each arc ends where the next one begins is
        not checked.

    See Also
    --------
    to_shapely : polygons with holes.

    Examples
    --------
    Two discs whose circles pass through each other's centres:

    >>> from math import pi
    >>> from divbandit.measures.boundary import Loop
    >>> loop = Loop([[0, 0, pi / 3, 5 * pi / 3], [1, 0, 4 * pi / 3, 8 * pi / 3]], tau=1)
    >>> round(loop.area, 6), round(loop.perimeter / pi, 6), loop.is_hole
    (5.054816, 2.666667, False)
    """

    __slots__ = ("arcs", "area", "tau")

    arcs: NDArray[np.float64]
    tau: float

    if TYPE_CHECKING:
        area: float

    def __init__(self, arcs: ArrayLike, tau: float) -> None:
        tau, rows = real("tau", tau, low=1e-100, high=1e100), _as_arcs(arcs)
        self._set(arcs=rows, tau=tau, area=_area(rows, tau))

    @property
    def is_hole(self) -> bool:
        """Whether the loop goes clockwise, around a hole of the union."""
        return self.area < 0.0

    @property
    def perimeter(self) -> float:
        """The length of the arcs, in the units of `tau`."""
        return float(np.sum(self.arcs[:, 3] - self.arcs[:, 2])) * self.tau

    def vertices(self, quad_segs: int = 16) -> NDArray[np.float64]:
        """Return the corners of a polygon inscribed in the loop.

        Every arc's start is among them as it is, and each arc is divided evenly into chords that
        span a quarter circle over `quad_segs` at most. Chords lie inside of the union: the
        polygon of an outer loop is smaller than what the loop encloses, that of a hole larger.

        Parameters
        ----------
        quad_segs : int
            Chords for a quarter circle, from 1 to 100,000.

        Returns
        -------
        numpy.ndarray of float64, shape (n, 2)
            In the loop's direction; the first corner is not repeated at the end.

        Raises
        ------
        TypeError, ValueError
            If `quad_segs` is not a whole number in that range.

        Examples
        --------
        >>> from math import tau
        >>> from divbandit.measures.boundary import Loop
        >>> Loop([[5, 0, 0, tau]], 1).vertices(quad_segs=1).round(6) + 0.0
        array([[ 6.,  0.],
               [ 5.,  1.],
               [ 4.,  0.],
               [ 5., -1.]])
        """
        quad_segs = whole("quad_segs", quad_segs, low=1, high=100_000)
        x, y, start, end = self.arcs.T
        # What rounding adds to a whole number of quarters must not add a chord.
        chords = np.ceil((end - start) / (pi / 2) * quad_segs - 1e-9).astype(np.int64)
        chords = np.maximum(chords, 1)
        arc = np.repeat(np.arange(len(chords)), chords)
        step = np.arange(len(arc)) - np.repeat(np.cumsum(chords) - chords, chords)
        angle = start[arc] + (end - start)[arc] * (step / chords[arc])
        return np.column_stack(
            [x[arc] + self.tau * np.cos(angle), y[arc] + self.tau * np.sin(angle)]
        )

    def __len__(self) -> int:
        return len(self.arcs)

    def __eq__(self, other: object) -> bool:
        if not isinstance(other, Loop):
            return NotImplemented
        return self.tau == other.tau and np.array_equal(self.arcs, other.arcs)

    def __hash__(self) -> int:
        return hash((self.tau, *self.arcs.ravel().tolist()))

    def __repr__(self) -> str:
        kind = "hole" if self.is_hole else "outer loop"
        return f"<Loop of {len(self)} arcs, {kind}, area={self.area}>"


def to_shapely(loops: Iterable[Loop], *, quad_segs: int = 16) -> shapely.Polygon:
    """Return the union inside of `loops` as a polygon of shapely, holes and all.

    Parameters
    ----------
    loops : iterable of Loop
        All loops of a boundary, in any order.
    quad_segs : int
        Chords for a quarter circle, as in `Loop.vertices`.

    Returns
    -------
    shapely.Polygon or shapely.MultiPolygon
        The latter if there are several outer loops; an empty polygon if there are none. Where
        loops all but touch, rounding may make it invalid in shapely's sense;
        ``shapely.make_valid`` repairs that.

    Raises
    ------
    ImportError
        If shapely is not installed.
    TypeError, ValueError
        If an element is not a Loop, `quad_segs` is out of range or a hole lies in no outer loop.

    Examples
    --------
    >>> from math import pi, tau
    >>> from divbandit.measures.boundary import Loop, to_shapely
    >>> discs = to_shapely([Loop([[0, 0, 0, tau]], 1), Loop([[3, 0, 0, tau]], 1)], quad_segs=64)
    >>> discs.geom_type, round(discs.area / pi, 2)
    ('MultiPolygon', 2.0)
    """
    try:
        import shapely  # noqa: PLC0415 - only these polygons need it
    except ImportError as error:
        raise ImportError("polygons need shapely: pip install 'divbandit[peers]'") from error
    loops = list(loops)
    for index, loop in enumerate(loops):
        if not isinstance(loop, Loop):
            raise TypeError(f"loops[{index}] must be a Loop, got {type(loop).__name__}")
    outers = [loop for loop in loops if not loop.is_hole]
    holes = [loop for loop in loops if loop.is_hole]
    shells = [loop.vertices(quad_segs) for loop in outers]
    inside: list[list[NDArray[np.float64]]] = [[] for _ in shells]
    rings = [hole.vertices(quad_segs) for hole in holes]
    tree = shapely.STRtree([shapely.Polygon(shell) for shell in shells])
    points = [shapely.Polygon(ring).representative_point() for ring in rings]
    pairs = tree.query(np.array(points, dtype=object), predicate="within")
    # Of the loops around a point of the hole, those of parts that lie in the hole are smaller than
    # it, and those of parts in whose holes it lies larger than its own: the smallest of the rest.
    around = {
        hole: outer
        for hole, outer in sorted(pairs.T.tolist(), key=lambda pair: -outers[pair[1]].area)
        if outers[outer].area > -holes[hole].area
    }
    if len(around) < len(holes):
        raise ValueError("loops must have an outer loop around every hole")
    for hole, outer in sorted(around.items()):
        inside[outer].append(rings[hole])
    polygons = list(map(shapely.Polygon, shells, inside))
    if len(polygons) > 1:
        return shapely.MultiPolygon(polygons)
    return polygons[0] if polygons else shapely.Polygon()


def _as_arcs(arcs: ArrayLike) -> NDArray[np.float64]:
    """Return arcs as a new, read-only array, or say what is wrong with them."""
    try:
        rows = np.array(arcs, dtype=np.float64)
    except (TypeError, ValueError) as error:
        raise type(error)(f"arcs must be an array of numbers of shape (k, 4): {error}") from None
    if rows.ndim != 2 or rows.shape[1] != 4 or not len(rows):
        raise ValueError(f"arcs must have shape (k, 4) with k at least 1, got {rows.shape}")
    finite = np.isfinite(rows)
    if not finite.all():
        row, column = np.argwhere(~finite)[0].tolist()
        raise ValueError(f"arcs[{row}, {column}] must be finite, got {rows[row, column]}")
    span = rows[:, 3] - rows[:, 2]
    wrong = (span <= 0.0) | (span > 2.0 * pi + 1e-12)
    if wrong.any():
        row = int(np.argmax(wrong))
        start, end = rows[row, 2:].tolist()
        raise ValueError(f"arcs[{row}] must end at most 2 pi after its start {start}, got {end}")
    rows.flags.writeable = False
    return rows


def _area(arcs: NDArray[np.float64], tau: float) -> float:
    """Return the area of the polygon of the arcs' starts and of the segments beyond its edges.

    Seen from the first start and in units of the radius, so that the place does not matter and a
    tiny hole keeps its sign.
    """
    start, end = arcs[:, 2], arcs[:, 3]
    direction = np.column_stack([np.cos(start), np.sin(start)])
    points = (arcs[:, :2] - arcs[0, :2]) / tau + (direction - direction[0])
    x, y = points.T
    polygon = x * np.roll(y, -1) - y * np.roll(x, -1)
    segments = (end - start) - np.sin(end - start)
    return 0.5 * float(np.sum(polygon) + np.sum(segments)) * tau * tau
