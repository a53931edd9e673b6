"""A row of controls that wraps into further lines where there is no room."""

from __future__ import annotations

from typing import Final

from PySide6.QtCore import QMargins, QRect, QSize, Qt
from PySide6.QtWidgets import QLayout, QLayoutItem, QSizePolicy, QWidget

from armui.ui.widgets.layouts import in_row

_SPACING_PX: Final = 6


class Flow(QLayout):
    """Lays its widgets out from left to right, in lines like text.

    A widget with an expanding size policy takes the rest of its line; one added by :meth:`push` is
    at the right end of it. A widget lower than its line is centred in it, or at the top if so
    aligned.

    Args:
        owner: The widget whose layout it becomes.
        spacing_px: The space between two widgets, and between two lines.
        most: The most widgets in a line; ``None`` for as many as fit.
    """

    def __init__(
        self, owner: QWidget | None = None, spacing_px: int = _SPACING_PX, most: int | None = None
    ) -> None:
        super().__init__(owner)
        self._most = most
        self._items: list[QLayoutItem] = []
        self._pushed: set[QWidget] = set()
        self.setSpacing(spacing_px)
        self.setContentsMargins(0, 0, 0, 0)

    def push(self, widget: QWidget) -> None:
        """Add a widget at the right end of its line."""
        self._pushed.add(widget)
        self.addWidget(widget)

    def insert(self, place: int, widget: QWidget) -> None:
        """Add a widget before another."""
        self.addWidget(widget)
        self._items.insert(place, self._items.pop())
        self.invalidate()

    # What Qt asks of a layout -----------------------------------------------------------------

    def addItem(self, item: QLayoutItem) -> None:  # noqa: N802 - Qt's
        """Add an item; called by Qt."""
        self._items.append(item)

    def count(self) -> int:
        """Return the number of items."""
        return len(self._items)

    def itemAt(self, index: int) -> QLayoutItem | None:  # noqa: N802 - Qt's
        """Return the item at an index."""
        return self._items[index] if 0 <= index < len(self._items) else None

    def takeAt(self, index: int) -> QLayoutItem | None:  # noqa: N802 - Qt's
        """Remove and return the item at an index."""
        return self._items.pop(index) if 0 <= index < len(self._items) else None

    def expandingDirections(self) -> Qt.Orientation:  # noqa: N802 - Qt's
        """Return horizontal: the height is that of the lines."""
        return Qt.Orientation.Horizontal

    def hasHeightForWidth(self) -> bool:  # noqa: N802 - Qt's
        """Return true: a narrower layout is higher."""
        return True

    def heightForWidth(self, width: int) -> int:  # noqa: N802 - Qt's
        """Return the height of all lines."""
        return self._arrange(QRect(0, 0, width, 0), place=False)

    def sizeHint(self) -> QSize:
        """Return the size of all items in one line."""
        hints = [item.sizeHint() for item in self._shown()]
        width = sum(hint.width() for hint in hints) + self.spacing() * max(0, len(hints) - 1)
        height = max((hint.height() for hint in hints), default=0)
        return self._with_margins(QSize(width, height))

    def minimumSize(self) -> QSize:  # noqa: N802 - Qt's
        """Return the width of the widest item and the height of one line."""
        width = max((item.minimumSize().width() for item in self._shown()), default=0)
        height = max((item.sizeHint().height() for item in self._shown()), default=0)
        return self._with_margins(QSize(width, height))

    def setGeometry(self, rect: QRect) -> None:  # noqa: N802 - Qt's
        """Place the items."""
        super().setGeometry(rect)
        self._arrange(rect, place=True)

    # The lines --------------------------------------------------------------------------------

    def _shown(self) -> list[QLayoutItem]:
        return [item for item in self._items if not item.isEmpty()]

    def _with_margins(self, size: QSize) -> QSize:
        margins: QMargins = self.contentsMargins()
        return size.grownBy(margins)

    def _arrange(self, rect: QRect, *, place: bool) -> int:
        room = rect.marginsRemoved(self.contentsMargins())
        y = room.y()
        for line in self._lines(room.width()):
            height = max(item.sizeHint().height() for item in line)
            if place:
                self._place(line, QRect(room.x(), y, room.width(), height))
            y += height + self.spacing()
        margins = self.contentsMargins()
        return max(0, y - self.spacing() - room.y()) + margins.top() + margins.bottom()

    def _lines(self, width: int) -> list[list[QLayoutItem]]:
        lines: list[list[QLayoutItem]] = []
        used = 0
        for item in self._shown():
            wanted = item.sizeHint().width()
            full = bool(lines) and len(lines[-1]) == self._most
            if lines and not full and used + self.spacing() + wanted <= width:
                lines[-1].append(item)
                used += self.spacing() + wanted
            else:
                lines.append([item])
                used = wanted
        return lines

    def _place(self, line: list[QLayoutItem], room: QRect) -> None:
        gaps = self.spacing() * (len(line) - 1)
        left = max(0, room.width() - gaps - sum(item.sizeHint().width() for item in line))
        growing = [item for item in line if _grows(item)]
        pushed = next((item for item in line if item.widget() in self._pushed), None)
        x = room.x()
        for item in line:
            hint = item.sizeHint()
            width = min(hint.width(), room.width())
            if item in growing:
                width += left // len(growing)
            elif item is pushed and not growing:
                x += left
            top = bool(item.alignment() & Qt.AlignmentFlag.AlignTop)
            below = 0 if top else (room.height() - hint.height()) // 2
            item.setGeometry(QRect(x, room.y() + below, width, hint.height()))
            x += width + self.spacing()


def _grows(item: QLayoutItem) -> bool:
    widget = item.widget()
    policy = QSizePolicy.Policy.Fixed if widget is None else widget.sizePolicy().horizontalPolicy()
    return policy == QSizePolicy.Policy.Expanding


def in_flow(*widgets: QWidget, on: QWidget | None = None, spacing_px: int = _SPACING_PX) -> Flow:
    """Put widgets beside one another, and below where there is no room.

    Args:
        widgets: The widgets from left to right.
        on: The widget whose layout it becomes.
        spacing_px: The space between two, and between two lines.
    """
    flow = Flow(on, spacing_px)
    for widget in widgets:
        flow.addWidget(widget)
    return flow


def pair(label: QWidget, field: QWidget) -> QWidget:
    """Return a label and its field as one widget, which a flow does not separate."""
    both = QWidget()
    in_row(label, field, on=both, spacing=_SPACING_PX, margins=0)
    return both
