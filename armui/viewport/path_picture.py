"""What the picture shows of a motion that has not happened: where the tool would go, and how fast.

No numpy at run time: the view knows these, and the view is made before the libraries are loaded.
"""

from __future__ import annotations

from dataclasses import dataclass
from typing import TYPE_CHECKING

if TYPE_CHECKING:
    import numpy as np
    from numpy.typing import NDArray

    Array = NDArray[np.float64]


@dataclass(frozen=True, eq=False)
class PathPicture:
    """A path of the tool with its points; compared by identity, for it is never changed.

    Attributes:
        places_mm: (n, 3) where the tool goes, in the base frame.
        speeds_mm_s: (n,) how fast.
        marks_mm: (k, 3) the points of the trajectory.
        rows: the row of each mark, from 0.
        bad_rows: rows in which a check found an error.
    """

    places_mm: Array
    speeds_mm_s: Array
    marks_mm: Array
    rows: tuple[int, ...]
    bad_rows: frozenset[int] = frozenset()


@dataclass(frozen=True)
class Preview:
    """Everything shown beside the arm itself.

    Attributes:
        path: the tool's path, or None.
        selected_row: the row whose mark stands out, or None.
        ghost_deg: where a second, transparent arm stands; six joint angles as on the bus.
    """

    path: PathPicture | None = None
    selected_row: int | None = None
    ghost_deg: tuple[float, ...] | None = None


NOTHING = Preview()
