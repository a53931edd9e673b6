"""The operator's arrangement of the window: plain data, its text in a file, its fit to a screen.

Pure. Any text gives a layout: impossible values become those of the first start.
"""

from __future__ import annotations

import json
from collections.abc import Mapping, Sequence
from dataclasses import dataclass, field, replace
from typing import Any, Final

from armui.arm.json_fields import finite

_FARTHEST_PX: Final = 100_000
_LEAST_WINDOW_PX: Final = (320, 240)
_MOST_ENTRIES: Final = 64
_MOST_COLUMNS: Final = 64
_MOST_WINDOWS: Final = 16
_WIDEST_COLUMN_PX: Final = 4000
_LEAST_COLUMN_PX: Final = 20


@dataclass(frozen=True, slots=True)
class Place:
    """The place of a window, in pixels of the desktop."""

    x: int
    y: int
    width: int
    height: int


@dataclass(frozen=True, slots=True)
class ColumnLayout:
    """The columns of a table.

    Attributes:
        widths_px: The widths from left to right.
        sorted_by: The column of the order, −1 for none.
        ascending: The direction of the order.
    """

    widths_px: tuple[int, ...]
    sorted_by: int = -1
    ascending: bool = True


@dataclass(frozen=True, slots=True)
class OpenWindow:
    """A page in a window of its own.

    Attributes:
        key: The key of the page.
        subject: The object it works on, if there are several of its kind: the name of a trajectory.
    """

    key: str
    subject: str = ""


@dataclass(frozen=True, slots=True)
class WorkspaceLayout:
    """The arrangement of the window.

    Attributes:
        window: The place of the main window; ``None`` for the first one.
        maximized: True if it is maximized.
        panel_px: The width of the panels; 0 for the first one.
        page_share: The share of the width for pages; 0 for the first one.
        drawer_px: The height of the open drawer; 0 for the first one.
        drawer: The key of the page that it showed when the program ended; "" if it was closed.
        taken_out: The place of each page's window, by the page's key.
        columns: The columns of each table by its name.
        menu_folded: True or False as the operator has left the group of settings in the menu; None
            before.
        operator_view: True if the program ended in the operator's view.
        open_windows: The pages that stood in windows of their own when the program ended.
    """

    window: Place | None = None
    maximized: bool = False
    panel_px: int = 0
    page_share: float = 0.0
    drawer_px: int = 0
    drawer: str = ""
    taken_out: Mapping[str, Place] = field(default_factory=dict)
    columns: Mapping[str, ColumnLayout] = field(default_factory=dict)
    open_windows: tuple[OpenWindow, ...] = ()
    menu_folded: bool | None = None
    operator_view: bool = False


def to_text(layout: WorkspaceLayout) -> str:
    """Return the text of the file."""
    entries = {
        "window": None if layout.window is None else _numbers(layout.window),
        "maximized": layout.maximized,
        "panel_px": layout.panel_px,
        "page_share": round(layout.page_share, 4),
        "drawer_px": layout.drawer_px,
        "drawer": layout.drawer,
        "taken_out": {key: _numbers(place) for key, place in layout.taken_out.items()},
        "columns": {
            name: {
                "widths_px": list(columns.widths_px),
                "sorted_by": columns.sorted_by,
                "ascending": columns.ascending,
            }
            for name, columns in layout.columns.items()
        },
        "open_windows": [[each.key, each.subject] for each in layout.open_windows],
        "menu_folded": layout.menu_folded,
        "operator_view": layout.operator_view,
    }
    return f"{json.dumps(entries, indent=2)}\n"


def from_text(text: str) -> WorkspaceLayout:
    """Return the layout in a file; invalid values become those of the first start."""
    try:
        found = json.loads(text)
    except (ValueError, RecursionError):
        return WorkspaceLayout()
    if not isinstance(found, dict):
        return WorkspaceLayout()
    share = finite(found.get("page_share"))
    return WorkspaceLayout(
        window=_place(found.get("window")),
        maximized=found.get("maximized") is True,
        panel_px=_pixels(found.get("panel_px")),
        page_share=share if share is not None and 0.0 < share < 1.0 else 0.0,
        drawer_px=_pixels(found.get("drawer_px")),
        drawer=str(found.get("drawer", "")),
        taken_out={
            key: place
            for key, entry in _entries(found.get("taken_out"))
            if (place := _place(entry)) is not None
        },
        columns={
            name: columns
            for name, entry in _entries(found.get("columns"))
            if (columns := _columns(entry)) is not None
        },
        open_windows=_open_windows(found.get("open_windows")),
        operator_view=found.get("operator_view") is True,
        menu_folded=folded if isinstance(folded := found.get("menu_folded"), bool) else None,
    )


def fitted(place: Place, screens: Sequence[Place]) -> Place:
    """Return a place that is completely on a screen: the one that shows most of it now.

    Args:
        place: The former place.
        screens: The usable area of each, the main one first; at least one.
    """
    screen = max(screens, key=lambda each: _overlap(place, each))
    width, height = min(place.width, screen.width), min(place.height, screen.height)
    x = min(max(place.x, screen.x), screen.x + screen.width - width)
    y = min(max(place.y, screen.y), screen.y + screen.height - height)
    return replace(place, x=x, y=y, width=width, height=height)


def _overlap(one: Place, other: Place) -> int:
    across = min(one.x + one.width, other.x + other.width) - max(one.x, other.x)
    down = min(one.y + one.height, other.y + other.height) - max(one.y, other.y)
    return max(0, across) * max(0, down)


def _numbers(place: Place) -> list[int]:
    return [place.x, place.y, place.width, place.height]


def _entries(found: object) -> list[tuple[str, Any]]:
    entries = list(found.items()) if isinstance(found, dict) else []
    return [(key, entry) for key, entry in entries if isinstance(key, str)][:_MOST_ENTRIES]


def _open_windows(found: object) -> tuple[OpenWindow, ...]:
    entries = found[:_MOST_WINDOWS] if isinstance(found, list) else []
    pairs = [each for each in entries if isinstance(each, list) and len(each) == 2]
    texts = [each for each in pairs if all(isinstance(text, str) for text in each)]
    return tuple(OpenWindow(key, subject) for key, subject in texts)


def _whole(value: object) -> int | None:
    """Return a value of the file if it is a number of pixels that a desktop can have, else None."""
    if isinstance(value, bool) or not isinstance(value, int) or abs(value) > _FARTHEST_PX:
        return None
    return value


def _pixels(value: object) -> int:
    figure = _whole(value)
    return 0 if figure is None else max(0, figure)


def _place(entry: object) -> Place | None:
    figures = [_whole(each) for each in entry] if isinstance(entry, list) else []
    whole = [each for each in figures if each is not None]
    if len(figures) != 4 or len(whole) != 4:
        return None
    least_width, least_height = _LEAST_WINDOW_PX
    if whole[2] < least_width or whole[3] < least_height:
        return None
    return Place(*whole)


def _columns(entry: object) -> ColumnLayout | None:
    if not isinstance(entry, dict):
        return None
    found = entry.get("widths_px")
    widths = [_whole(each) for each in found] if isinstance(found, list) else []
    whole = tuple(each for each in widths if each is not None)
    if len(whole) != len(widths) or not 0 < len(whole) <= _MOST_COLUMNS:
        return None
    by = _whole(entry.get("sorted_by"))
    return ColumnLayout(
        tuple(min(_WIDEST_COLUMN_PX, max(_LEAST_COLUMN_PX, width)) for width in whole),
        by if by is not None and -1 <= by < len(whole) else -1,
        entry.get("ascending") is not False,
    )
