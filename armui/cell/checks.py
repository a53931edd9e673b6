"""The checks of names and figures that all parts of a cell share."""

from __future__ import annotations

from collections.abc import Iterable, Sequence
from typing import Final

from armui.arm.json_fields import finite
from armui.arm.refusal import Reason, Refusal

CELL_NAME_BAD = Reason(
    "cell_name_bad",
    '“{value}” cannot be a name. Enter 1 to {maximum} characters without < > : " / \\ | ? *, '
    "and none of . ~ at its beginning, nor a dot or a space at its end.",
)
CELL_NAME_TAKEN = Reason(
    "cell_name_taken", "“{value}” exists already in this list. Enter another name."
)
CELL_FIGURE_BAD = Reason(
    "cell_figure_bad",
    "“{name}”, {field}: {value} is not possible. Enter a figure from {minimum} to {maximum}.",
)

LONGEST_NAME: Final = 40
FIGURES: Final = ("x_mm", "y_mm", "z_mm", "rx_deg", "ry_deg", "rz_deg")
"""The figures of a pose as a cell's file names them."""
SIZES: Final = ("size_x_mm", "size_y_mm", "size_z_mm")
"""The edges of a box as a cell's file names them."""
_TURN_DEG: Final = 180.0
_PORTS: Final = [f"{port}{number}" for port in ("com", "lpt") for number in range(10)]
_DEVICES: Final = frozenset(("con", "prn", "aux", "nul", *_PORTS))
"""Names that Windows keeps for devices, with any suffix."""


def check_name(name: str) -> Refusal | None:
    """Return why a text cannot name a cell or a thing in it, or ``None``.

    The name of a cell is the name of its file, so what file systems forbid is refused for all.
    """
    possible = 0 < len(name) <= LONGEST_NAME and name.isprintable()
    if possible and not set(name) & set('<>:"/\\|?*') and _stands_alone(name):
        return None
    return CELL_NAME_BAD(value=name[: 2 * LONGEST_NAME], maximum=LONGEST_NAME)


def check_names(names: Iterable[str]) -> Refusal | None:
    """Return why names cannot stand in one list: a bad one, or one that is there twice."""
    seen: set[str] = set()
    for name in names:
        refusal = check_name(name)
        if refusal is not None:
            return refusal
        if name.casefold() in seen:
            return CELL_NAME_TAKEN(value=name)
        seen.add(name.casefold())
    return None


def check_figure(
    name: str, field: str, value: object, minimum: float, maximum: float
) -> Refusal | None:
    """Return why a figure is not possible, or ``None``.

    Args:
        name: The thing that it belongs to.
        field: The figure's name, with its unit.
        value: The figure, of whatever type.
        minimum: The least allowed value.
        maximum: The greatest allowed value.
    """
    figure = finite(value)
    if figure is not None and minimum <= figure <= maximum:
        return None
    shown = str(value)[:LONGEST_NAME] if figure is None else figure
    return CELL_FIGURE_BAD(name=name, field=field, value=shown, minimum=minimum, maximum=maximum)


def check_pose(name: str, pose: Sequence[float], furthest_mm: float) -> Refusal | None:
    """Return why the figures of a pose are not possible, or ``None``.

    Args:
        name: The thing that it belongs to.
        pose: X, Y, Z in mm, RX, RY, RZ in degrees.
        furthest_mm: The most of X, Y and Z.
    """
    mosts = (furthest_mm,) * 3 + (_TURN_DEG,) * 3
    checks = (
        check_figure(name, field, value, -most, most)
        for field, value, most in zip(FIGURES, pose, mosts, strict=True)
    )
    return next(filter(None, checks), None)


def check_sizes(
    name: str, sizes_mm: Sequence[float], smallest_mm: float, largest_mm: float
) -> Refusal | None:
    """Return why the edges of a box are not possible, or ``None``."""
    checks = (
        check_figure(name, field, value, smallest_mm, largest_mm)
        for field, value in zip(SIZES, sizes_mm, strict=True)
    )
    return next(filter(None, checks), None)


def _stands_alone(name: str) -> bool:
    """Return whether no file system takes a name for another one, or hides it."""
    if name.partition(".")[0].casefold() in _DEVICES:
        return False
    return name == name.strip() and not name.startswith((".", "~")) and not name.endswith(".")
