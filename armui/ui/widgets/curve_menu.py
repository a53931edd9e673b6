"""The context menu of figures: shows them as curves.

A widget declares its quantities by :func:`set_quantities`; one that shows several of them in
different places has a method ``quantities_at``.
"""

from __future__ import annotations

from collections.abc import Sequence
from typing import Final, Protocol, runtime_checkable

from PySide6.QtCore import QCoreApplication, QObject, QPoint, Qt
from PySide6.QtGui import QContextMenuEvent
from PySide6.QtWidgets import QMenu, QWidget

from armui.ui.widgets.buttons import named

_PROPERTY: Final = "quantities"


@runtime_checkable
class ManyFigures(Protocol):
    """A widget that shows several quantities in different places."""

    def quantities_at(self, place: QPoint) -> Sequence[str]:
        """Return the keys of the quantities at a place of the widget."""


@runtime_checkable
class ShowsCurves(Protocol):
    """A window that can show quantities as curves: the main window."""

    def show_as_curves(self, keys: Sequence[str]) -> None:
        """Show quantities as curves."""


def set_quantities(widget: QWidget, *keys: str) -> None:
    """Declare the quantities of a widget, by their keys (`armui.telemetry.quantities`)."""
    widget.setProperty(_PROPERTY, list(keys))


def quantities_under(window: QWidget, place: QPoint) -> list[str]:
    """Return the keys of the quantities at a place of a window."""
    widget = window.childAt(place) or window
    while True:
        keys: Sequence[str] = widget.property(_PROPERTY) or ()
        if isinstance(widget, ManyFigures):
            keys = widget.quantities_at(widget.mapFrom(window, place))
        parent = widget.parentWidget()
        if keys or widget is window or parent is None:
            return list(keys)
        widget = parent


def offer_curves(window: QWidget, event: QContextMenuEvent) -> None:
    """Open the menu of a figure, if there is one under the mouse."""
    keys = quantities_under(window, event.pos())
    shower = _shower(window)
    if not keys or shower is None:
        event.ignore()
        return
    event.accept()
    menu = named("curve_menu", QMenu(window))
    menu.setAttribute(Qt.WidgetAttribute.WA_DeleteOnClose)
    text = QCoreApplication.translate("CurveMenu", "Show as curve")
    menu.addAction(text, lambda: shower.show_as_curves(keys))
    menu.popup(event.globalPos())


def _shower(window: QObject | None) -> ShowsCurves | None:
    while window is not None and not isinstance(window, ShowsCurves):
        window = window.parent()
    return window


def show_curves(widget: QWidget, keys: Sequence[str]) -> None:
    """Show quantities as curves, if the program around a widget supports it."""
    shower = _shower(widget.window())
    if shower is not None and keys:
        shower.show_as_curves(keys)
