"""The preview in the picture: the tool's path and speed in a planned motion.

It does not load numpy: the view uses it, and the view is created before the libraries are loaded.
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
    """A finding of a check, at its place.

    Attributes:
        place_mm: its place in the base frame.
        is_error: true if it forbids a run; else it is a warning.
        row: the row it concerns, from 0; None: the whole.
        text: for the operator.
        joints_deg: the six joint angles there, as on the bus, if known.
        touching: the links that touch there: 0 for the base, 1–6 for what the joint turns.
    """

    place_mm: tuple[float, float, float]
    is_error: bool
    row: int | None
    text: str
    joints_deg: tuple[float, ...] | None = None
    touching: tuple[int, ...] = ()


@dataclass(frozen=True, eq=False)
class PathPicture:
    """A path of the tool with its points; compared by identity, because it never changes.

    Attributes:
        places_mm: (n, 3) the places of the tool, in the base frame.
        speeds_mm_s: (n,) the speeds of the tool.
        marks_mm: (k, 3) the points of the trajectory.
        rows: the row of each mark, from 0.
        bad_rows: rows in which a check found an error.
        findings: the findings of the check, at their places.
        is_numbered: true to show the numbers of the rows at the marks.
    """

    places_mm: Array
    speeds_mm_s: Array
    marks_mm: Array
    rows: tuple[int, ...]
    bad_rows: frozenset[int] = frozenset()
    findings: tuple[FindingMark, ...] = ()
    is_numbered: bool = True

    def outermost_m(self) -> tuple[tuple[float, float, float], ...]:
        """Return the outermost places in each direction, for a view that shows all of the path.

        Points with errors are left out: an unreachable one may be anywhere, and the arm would look
        small beside it. Its sign is then at the picture's rim.
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
    """Everything that is shown beside the arm itself.

    Attributes:
        path: the tool's path, or None.
        selected_row: the row whose mark stands out, or None.
        ghost_deg: the six joint angles, as on the bus, of a second, transparent arm.
        finding: the finding at whose place that arm stands, so that its links stand out.
        current_row: the row to which the arm moves while the trajectory runs, or None.
    """

    path: PathPicture | None = None
    selected_row: int | None = None
    ghost_deg: tuple[float, ...] | None = None
    finding: FindingMark | None = None
    current_row: int | None = None


@dataclass(frozen=True, slots=True)
class Trail:
    """The measured and the commanded way of the tool, the newest place last.

    Attributes:
        driven: places in the base frame, three 32-bit floats each, mm.
        commanded: likewise, of the setpoints that were sent.
    """

    driven: bytes = b""
    commanded: bytes = b""


@dataclass(frozen=True, slots=True)
class Reach:
    """The figures from which the tool's reach is computed.

    Attributes:
        limits_deg: of each joint, the lowest and the highest angle.
        tool_m: the tool centre point in the flange.
    """

    limits_deg: tuple[tuple[float, float], ...]
    tool_m: tuple[float, float, float] = (0.0, 0.0, 0.0)


NOTHING = Preview()
