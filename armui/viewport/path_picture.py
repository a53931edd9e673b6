"""The preview in the picture: the tool's path and speed in a motion that has not happened.

No numpy at run time: the view knows these, and the view is made before the libraries are loaded.
"""

from __future__ import annotations

from dataclasses import dataclass
from typing import TYPE_CHECKING

if TYPE_CHECKING:
    import numpy as np
    from numpy.typing import NDArray

    Array = NDArray[np.float64]


@dataclass(frozen=True, slots=True)
class FindingMark:
    """Something that a check has found, where it would happen.

    Attributes:
        place_mm: in the base frame.
        is_error: whether it forbids a run; else it is a warning.
        row: the row it concerns, from 0; None: the whole.
        text: for the operator.
    """

    place_mm: tuple[float, float, float]
    is_error: bool
    row: int | None
    text: str


@dataclass(frozen=True, eq=False)
class PathPicture:
    """A path of the tool with its points; compared by identity, for it is never changed.

    Attributes:
        places_mm: (n, 3) where the tool goes, in the base frame.
        speeds_mm_s: (n,) how fast.
        marks_mm: (k, 3) the points of the trajectory.
        rows: the row of each mark, from 0.
        bad_rows: rows in which a check found an error.
        findings: what the check has found, where it would happen.
        is_numbered: whether the numbers of the rows stand at the marks.
    """

    places_mm: Array
    speeds_mm_s: Array
    marks_mm: Array
    rows: tuple[int, ...]
    bad_rows: frozenset[int] = frozenset()
    findings: tuple[FindingMark, ...] = ()
    is_numbered: bool = True

    def outermost_m(self) -> tuple[tuple[float, float, float], ...]:
        """Return the places that reach furthest in each direction, for a view that shows all of it.

        Points that a check found to be wrong are left out: one that can't be reached may be
        anywhere, and the arm would be small beside it. Its sign stands at the picture's rim then.
        """
        outermost: list[tuple[float, float, float]] = []
        right = [row not in self.bad_rows for row in self.rows]
        for places in (self.places_mm, self.marks_mm[right]):
            if len(places):
                chosen = {int(way) for way in (*places.argmin(axis=0), *places.argmax(axis=0))}
                outermost += [(x, y, z) for x, y, z in places[sorted(chosen)].tolist()]
        return tuple((x / 1e3, y / 1e3, z / 1e3) for x, y, z in outermost)


@dataclass(frozen=True, slots=True)
class Preview:
    """Everything shown beside the arm itself.

    Attributes:
        path: the tool's path, or None.
        selected_row: the row whose mark stands out, or None.
        ghost_deg: where a second, transparent arm stands; six joint angles as on the bus.
        current_row: the row the arm is on its way to while the trajectory runs, or None.
    """

    path: PathPicture | None = None
    selected_row: int | None = None
    ghost_deg: tuple[float, ...] | None = None
    current_row: int | None = None


@dataclass(frozen=True, slots=True)
class Trail:
    """The measured and the commanded way of the tool; the newest place last.

    Attributes:
        driven: places in the base frame, three 32-bit floats each, mm.
        commanded: likewise, of the setpoints that were sent.
    """

    driven: bytes = b""
    commanded: bytes = b""


@dataclass(frozen=True, slots=True)
class Reach:
    """The figures that the tool's reach is worked out from.

    Attributes:
        limits_deg: of each joint, the lowest and the highest angle.
        tool_m: the tool centre point in the flange.
    """

    limits_deg: tuple[tuple[float, float], ...]
    tool_m: tuple[float, float, float] = (0.0, 0.0, 0.0)


NOTHING = Preview()
