"""The rules of a window's layout: what is cut, stretched, scrolled beside free room, or covered.

`findings` looks at a real, styled window. What may be otherwise is in :data:`ACCEPTED`, each with
its reason.
"""

from __future__ import annotations

import re
from collections.abc import Iterator, Mapping
from dataclasses import dataclass
from itertools import combinations
from typing import Final

from PySide6.QtCore import QPoint, QRect, Qt
from PySide6.QtWidgets import (
    QAbstractButton,
    QAbstractItemView,
    QAbstractScrollArea,
    QAbstractSpinBox,
    QApplication,
    QComboBox,
    QDialog,
    QFrame,
    QGridLayout,
    QHeaderView,
    QLabel,
    QLayout,
    QLineEdit,
    QScrollBar,
    QSizePolicy,
    QSplitter,
    QStackedWidget,
    QStyle,
    QStyleOptionComboBox,
    QStyleOptionFrame,
    QTableView,
    QToolButton,
    QWidget,
)

from armui.ui.shell.status_bar import StatusBar
from armui.ui.shell.step_row import StepRow
from armui.ui.shell.top_bar import EnableButton
from armui.ui.widgets.halt_button import HaltButton
from armui.ui.widgets.stop_button import StopButton
from armui.ui.widgets.text_label import ElidedLabel, ValueLabel
from armui.viewport.view import ArmView

SLACK_PX: Final = 2
"""What a style may round away."""
STRETCH_PX: Final = 6
"""How much higher than its content a row, button or card may be."""
_WORD: Final = re.compile(r"[^\s\u2e80-\uffff]+")
"""What no line can break: Chinese breaks anywhere."""
FREE_PX: Final = 24
"""Room from which a scroll bar, or a cut text, is not needed: a row of a table."""

ACCEPTED: Final[Mapping[tuple[str, str], str]] = {
    ("stretched", "MessageLine "): "keeps room for two lines: nothing slides as it speaks",
    ("covered", "ArmView "): "the picture's own buttons and notes lie on it",
    ("covered", "PageWindow "): "a page that was taken out stands where it stood, then anywhere",
    ("stretched", "QFrame < ReferenceDialog"): "its held buttons stay while the task above changes",
    ("covered", "ColorDialog "): "Qt's choice of a colour has the width of its words",
    ("covered", "GamepadDialog"): "axes beside buttons: nothing moves while it is in front",
    ("scrolled", "ColumnsTable "): "a table: it has as many columns as the file",
}
"""What may break a rule: the rule, a part of the path, and why."""

_STOPS: Final = (StopButton, HaltButton)
_ALWAYS: Final = (StopButton, HaltButton, EnableButton, StepRow, StatusBar)
"""What the main window shows in every state, whole."""
_FIELDS: Final = (QAbstractButton, QAbstractSpinBox, QComboBox, QLineEdit)
_GROWING: Final = (QAbstractScrollArea, QSplitter, QStackedWidget, ArmView)
"""What takes all the room there is: tables, plots, the picture, and what holds them."""


@dataclass(frozen=True, slots=True)
class Finding:
    """One place where a window breaks a rule.

    Attributes:
        rule: ``cut``, ``stretched``, ``scrolled``, ``covered`` or ``hidden``.
        where: The widget, and what it lies in.
        words: By how much, and what.
    """

    rule: str
    where: str
    words: str

    def __str__(self) -> str:
        """Return it as one line."""
        return f"{self.rule}: {self.where}: {self.words}"

    @property
    def exception(self) -> tuple[str, str] | None:
        """The entry of the accepted that it falls under."""
        entries = (each for each in ACCEPTED if each[0] == self.rule and each[1] in self.where)
        return next(entries, None)


def findings(window: QWidget) -> list[Finding]:
    """Return what breaks a rule in a window that is seen."""
    shown = [
        each
        for each in window.findChildren(QWidget)
        if each.isVisible() and each.window() is window
    ]
    found = [
        Finding(rule, path(widget), words)
        for widget in shown
        for rule, words in _faults_of(widget, window)
    ]
    found += _overlaps(window, shown)
    found += _hidden(window, shown)
    return found


def path(widget: QWidget | None) -> str:
    """Return a widget and what it lies in, by their names, at most five."""
    names: list[str] = []
    while widget is not None:
        kind, name = type(widget).__name__, widget.objectName()
        names.append(" ".join(filter(None, (kind, name) if not names else (name or kind,))))
        widget = None if widget.isWindow() else widget.parentWidget()
    return " < ".join(names[:5])


def _faults_of(widget: QWidget, window: QWidget) -> Iterator[tuple[str, str]]:
    """Yield the rules that one widget breaks by itself."""
    if isinstance(widget, QScrollBar) or _is_qts(widget):
        return
    for words in (_cut_text(widget), _cut_by_parent(widget, window)):
        if words:
            yield "cut", words
    if isinstance(widget, QTableView):
        for words in _cut_columns(widget):
            yield "cut", words
    words = _stretched(widget)
    if words:
        yield "stretched", words
    if isinstance(widget, QAbstractScrollArea):
        words = _scrolled(widget)
        if words:
            yield "scrolled", words


def _is_qts(widget: QWidget) -> bool:
    """Return whether Qt has made it as a part of another widget."""
    parent = widget.parentWidget()
    return widget.objectName().startswith("qt_") or isinstance(
        parent, QAbstractSpinBox | QComboBox | QHeaderView | QLineEdit
    )


# Nothing is cut --------------------------------------------------------------------------------


def _cut_text(widget: QWidget) -> str:
    """Return what of a widget's text is not seen."""
    size, hint = widget.size(), widget.sizeHint()
    if isinstance(widget, ElidedLabel):
        missing = widget.fontMetrics().horizontalAdvance(widget.text()) - widget.width()
        cut = missing > SLACK_PX and _room_beside(widget) > FREE_PX
        return f"{missing} px of {widget.text()[:40]!r} beside free room" if cut else ""
    if isinstance(widget, ValueLabel):
        missing = widget.fontMetrics().horizontalAdvance(widget.text()) - widget.width()
        return f"{missing} px of {widget.text()!r}" if missing > SLACK_PX else ""
    if isinstance(widget, QLabel):
        if not widget.text():
            return ""
        wraps = widget.wordWrap()
        high = widget.heightForWidth(size.width()) if wraps else hint.height()
        wide = _longest_word(widget) if wraps else hint.width()
        low, short = high - size.height(), wide - size.width()
        return _missing(short, low, widget.text())
    if isinstance(widget, QComboBox):
        option = QStyleOptionComboBox()
        widget.initStyleOption(option)
        control = QStyle.ComplexControl.CC_ComboBox
        part = QStyle.SubControl.SC_ComboBoxEditField
        field = widget.style().subControlRect(control, option, part, widget)
        needed = widget.fontMetrics().horizontalAdvance(widget.currentText())
        low = widget.minimumSizeHint().height() - size.height()
        return _missing(needed - field.width(), low, widget.currentText())
    if isinstance(widget, QAbstractButton) and widget.text():
        if isinstance(widget, QToolButton) and _only_icon(widget):
            return ""
        low = min(hint.height(), widget.fontMetrics().height()) - size.height()
        return _missing(hint.width() - size.width(), low, widget.text())
    if isinstance(widget, QAbstractSpinBox | QLineEdit):
        line = widget.lineEdit() if isinstance(widget, QAbstractSpinBox) else widget
        text = line.text() or line.placeholderText()
        frame = QStyleOptionFrame()
        line.initStyleOption(frame)
        element = QStyle.SubElement.SE_LineEditContents
        inside = (
            line.style().subElementRect(element, frame, line).marginsRemoved(line.textMargins())
        )
        short = line.fontMetrics().horizontalAdvance(text) - inside.width() + 2 * SLACK_PX
        return _missing(short, widget.fontMetrics().height() - size.height(), text)
    return ""


def _missing(short: int, low: int, text: str) -> str:
    words = [f"{short} px across"] if short > SLACK_PX else []
    words += [f"{low} px down"] if low > SLACK_PX else []
    return f"{', '.join(words)} of {text[:40]!r}" if words else ""


def _longest_word(label: QLabel) -> int:
    if "<" in label.text():
        return 0
    words = _WORD.findall(label.text())
    return max(map(label.fontMetrics().horizontalAdvance, words), default=0)


def _only_icon(button: QToolButton) -> bool:
    icon_only = Qt.ToolButtonStyle.ToolButtonIconOnly
    return button.toolButtonStyle() is icon_only and not button.icon().isNull()


def _room_beside(widget: QWidget) -> int:
    """Return the widest gap between a widget and what stands beside it in its parent."""
    parent = widget.parentWidget()
    if parent is None:
        return 0
    own, inside = widget.geometry(), parent.contentsRect()
    left, right = inside.left(), inside.right()
    for other in _shown_children(parent):
        rect = other.geometry()
        if other is widget or rect.bottom() < own.top() or rect.top() > own.bottom():
            continue
        if rect.right() <= own.left():
            left = max(left, rect.right())
        elif rect.left() >= own.right():
            right = min(right, rect.left())
    return max(own.left() - left, right - own.right())


def _shown_children(parent: QWidget) -> list[QWidget]:
    found = parent.findChildren(QWidget, options=Qt.FindChildOption.FindDirectChildrenOnly)
    return [each for each in found if each.isVisible() and not each.isWindow()]


def _cut_columns(table: QTableView) -> Iterator[str]:
    """Yield the columns that cut a title although others have more than they need, or a cell.

    A cell may be cut by what is fixed beside it: what the operator writes has no width. It may not
    beside a column that only takes what is left, nor beside nothing.
    """
    header, model = table.horizontalHeader(), table.model()
    if model is None or model.rowCount() == 0:
        return
    shown = [place for place in range(header.count()) if not header.isSectionHidden(place)]
    width = {place: header.sectionSize(place) for place in shown}
    title = {place: _title_width(header, place) for place in shown}
    wraps = table.verticalHeader().sectionResizeMode(0) is _BY_CONTENT
    cell = {place: 0 if wraps else table.sizeHintForColumn(place) for place in shown}
    unused = max(0, table.viewport().width() - sum(width.values()))
    slack = {place: max(0, width[place] - max(title[place], cell[place])) for place in shown}
    left = unused + sum(each for place, each in slack.items() if _takes_the_rest(header, place))
    for place in shown:
        for needed, spare in ((title[place], unused + sum(slack.values())), (cell[place], left)):
            missing = needed - width[place]
            if missing > SLACK_PX and spare >= missing:
                name = model.headerData(place, Qt.Orientation.Horizontal)
                yield f"{missing} px of column {place} {name!r}, {spare} px are free"
                break


_BY_CONTENT: Final = QHeaderView.ResizeMode.ResizeToContents
_TITLE_PADDING_PX: Final = 12
"""Of theme.qss, on both sides."""


def _title_width(header: QHeaderView, place: int) -> int:
    """Return what the title of a column needs, with the sign of its order if it has that."""
    if not header.isVisible():
        return 0
    if header.isSortIndicatorShown() and header.sortIndicatorSection() == place:
        return header.sectionSizeHint(place)
    lines = str(header.model().headerData(place, Qt.Orientation.Horizontal) or "").splitlines()
    widest = max(map(header.fontMetrics().horizontalAdvance, lines), default=0)
    return min(header.sectionSizeHint(place), widest + _TITLE_PADDING_PX)


def _takes_the_rest(header: QHeaderView, place: int) -> bool:
    if header.stretchLastSection() and header.visualIndex(place) == header.count() - 1:
        return True
    return header.sectionResizeMode(place) is QHeaderView.ResizeMode.Stretch


def _cut_by_parent(widget: QWidget, window: QWidget) -> str:
    """Return by how much a widget lies outside what holds it and does not scroll there."""
    parent = widget.parentWidget()
    if parent is None or (isinstance(widget, QFrame) and type(widget) is QFrame):
        return ""
    area = parent.parentWidget()
    rect, inside = widget.geometry(), parent.rect()
    across = max(inside.left() - rect.left(), rect.right() - inside.right())
    down = max(inside.top() - rect.top(), rect.bottom() - inside.bottom())
    if isinstance(area, QAbstractScrollArea) and area.viewport() is parent:
        off = Qt.ScrollBarPolicy.ScrollBarAlwaysOff
        if area.horizontalScrollBarPolicy() is not off or isinstance(area, QAbstractItemView):
            across = 0
        if area.verticalScrollBarPolicy() is not off or isinstance(area, QAbstractItemView):
            down = 0
    words = [f"{across} px outside across"] if across > SLACK_PX else []
    words += [f"{down} px outside down"] if down > SLACK_PX else []
    return ", ".join(words)


# Nothing is stretched --------------------------------------------------------------------------


def _stretched(widget: QWidget) -> str:
    """Return by how much a row, button, field or card is higher than what is in it."""
    if isinstance(widget, _FIELDS):
        beyond = widget.height() - max(widget.sizeHint().height(), widget.minimumHeight())
        return f"{beyond} px higher than its content" if beyond > STRETCH_PX else ""
    layout = widget.layout()
    if layout is None or widget.isWindow() or isinstance(widget, _GROWING) or not _is_piece(widget):
        return ""
    beyond = widget.height() - max(_height_of(widget, layout), widget.minimumHeight())
    if beyond <= STRETCH_PX or _grows(widget):
        return ""
    if not widget.property("card") and (_rows_in(widget) == 1 or _has_spare_room(layout)):
        return ""
    return f"{beyond} px higher than its content"


def _is_piece(widget: QWidget) -> bool:
    """Return whether a widget is a card, or a row: it holds no cards or rows itself."""
    if widget.property("card"):
        return True
    return not any(each.layout() is not None for each in _shown_children(widget))


def _rows_in(widget: QWidget) -> int:
    """Return how many lines of parts stand below one another: a single one is not spread."""
    reached, rows = -1, 0
    for rect in sorted((each.geometry() for each in _shown_children(widget)), key=QRect.top):
        rows += rect.top() > reached
        reached = max(reached, rect.bottom())
    return rows


def _has_spare_room(layout: QLayout) -> bool:
    """Return whether a layout leaves what room there is to a space in it, or to an empty row."""
    if isinstance(layout, QGridLayout):
        columns = range(layout.columnCount())
        for row in range(layout.rowCount()):
            held = any(layout.itemAtPosition(row, column) for column in columns)
            if layout.rowStretch(row) and not held:
                return True
    for place in range(layout.count()):
        item = layout.itemAt(place)
        spacer, inner = item.spacerItem(), item.layout()
        if spacer is not None and Qt.Orientation.Vertical & spacer.expandingDirections():
            return True
        if inner is not None and _has_spare_room(inner):
            return True
    return False


def _height_of(widget: QWidget, layout: QLayout) -> int:
    if layout.hasHeightForWidth():
        return layout.totalHeightForWidth(widget.width())
    return layout.totalSizeHint().height()


def _grows(widget: QWidget) -> bool:
    """Return whether something in it takes the room there is."""
    for each in widget.findChildren(QWidget):
        policy = each.sizePolicy().verticalPolicy()
        wants = policy in (QSizePolicy.Policy.Expanding, QSizePolicy.Policy.MinimumExpanding)
        if each.isVisible() and (isinstance(each, _GROWING) or wants):
            return True
    return False


# Nothing scrolls beside free room --------------------------------------------------------------


def _scrolled(area: QAbstractScrollArea) -> str:
    """Return how much room is free beside an area with a scroll bar."""
    bar = area.verticalScrollBar()
    if bar.isVisible() and bar.maximum() > bar.minimum():
        missing = bar.maximum() - bar.minimum()
        if isinstance(area, QAbstractItemView):
            missing = FREE_PX
        free = _room_below(area)
        if free > FREE_PX:
            return f"{missing} px scroll, {free} px are free"
    bar = area.horizontalScrollBar()
    beyond = bar.maximum() - bar.minimum()
    if bar.isVisible() and beyond > 0 and not isinstance(area, QAbstractItemView):
        return f"{beyond} px scroll across"
    return ""


def _room_below(widget: QWidget) -> int:
    """Return the height that nothing uses in the columns that a widget lies in."""
    free, parent = 0, widget.parentWidget()
    while parent is not None and not widget.isWindow() and not isinstance(parent, QSplitter):
        if parent.layout() is not None:
            free = max(free, _gap_in(parent, widget))
        if isinstance(parent.parentWidget(), QAbstractScrollArea):
            break
        widget, parent = parent, parent.parentWidget()
    return free


def _gap_in(parent: QWidget, widget: QWidget) -> int:
    """Return the room in a column that no part has; a message keeps its room while it is silent."""
    own = widget.geometry()
    column = [
        each.geometry()
        for each in _shown_children(parent)
        if each.geometry().right() > own.left() and each.geometry().left() < own.right()
    ]
    column.sort(key=QRect.top)
    layout = parent.layout()
    margins = layout.contentsMargins()
    edge = parent.rect().bottom() - margins.bottom()
    ends = [*(rect.top() for rect in column[1:]), edge]
    reached, gap = column[0].bottom(), 0
    for rect, end in zip(column, ends, strict=True):
        reached = max(reached, rect.bottom())
        gap = max(gap, end - reached)
    return gap


# Nothing covers another ------------------------------------------------------------------------


def _overlaps(window: QWidget, shown: list[QWidget]) -> list[Finding]:
    """Return the siblings that lie over one another, and what lies over a stop."""
    by_parent: dict[QWidget, list[QWidget]] = {}
    for each in shown:
        parent = each.parentWidget()
        if parent is not None and not _is_qts(each) and not isinstance(parent, _GROWING[:3]):
            by_parent.setdefault(parent, []).append(each)
    found = []
    for children in by_parent.values():
        for one, other in combinations(children, 2):
            both = one.geometry().intersected(other.geometry())
            if both.width() > SLACK_PX and both.height() > SLACK_PX:
                words = f"{both.width()}×{both.height()} px lie over {path(other)}"
                found.append(Finding("covered", path(one), words))
    for stop in (each for each in shown if isinstance(each, _STOPS)):
        over = {window.childAt(stop.mapTo(window, point)) for point in _points_of(stop.rect())}
        strange = [
            each for each in over if each and each is not stop and not stop.isAncestorOf(each)
        ]
        found += [Finding("covered", path(stop), f"by {path(each)}") for each in strange]
    return found


def _points_of(rect: QRect) -> tuple[QPoint, ...]:
    inner = rect.adjusted(3, 3, -3, -3)
    return (
        *(inner.topLeft(), inner.topRight(), inner.bottomLeft(), inner.bottomRight()),
        inner.center(),
    )


def covering(dialog: QWidget, main: QWidget) -> list[Finding]:
    """Return what of the main window a dialog hides: its stops, and the picture."""
    found = []
    place = dialog.frameGeometry()
    for kind in (StopButton, HaltButton, ArmView):
        for each in main.findChildren(kind):
            if each.window() is not main or not each.isVisible():
                continue
            there = QRect(each.mapToGlobal(QPoint(0, 0)), each.size()).intersected(place)
            if there.width() > SLACK_PX and there.height() > SLACK_PX:
                words = f"{there.width()}×{there.height()} px over {path(each)}"
                found.append(Finding("covered", path(dialog), words))
    return found


# What is always seen ---------------------------------------------------------------------------


def _hidden(window: QWidget, shown: list[QWidget]) -> list[Finding]:
    """Return what has to be seen whole, always, and is not."""
    kinds = _STOPS if isinstance(window, QDialog) else _ALWAYS
    found = []
    for kind in kinds:
        seen = [each for each in shown if isinstance(each, kind)]
        if not any(_is_whole(each, window) for each in seen):
            found.append(Finding("hidden", path(window), f"no whole {kind.__name__}"))
    return found


def _is_whole(widget: QWidget, window: QWidget) -> bool:
    """Return whether nothing of a widget lies outside the window or a parent."""
    rect = QRect(widget.mapTo(window, QPoint(0, 0)), widget.size())
    hint = widget.minimumSizeHint()
    least = widget.height() >= hint.height() > 0 or not hint.isValid()
    parent = widget.parentWidget()
    while parent is not None:
        if not QRect(parent.mapTo(window, QPoint(0, 0)), parent.size()).contains(rect):
            return False
        parent = None if parent is window else parent.parentWidget()
    return least


def shown_dialogs() -> list[QDialog]:
    """Return the dialogs of the program that are seen."""
    found = QApplication.topLevelWidgets()
    return [each for each in found if isinstance(each, QDialog) and each.isVisible()]
