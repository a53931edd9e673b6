"""The bar across the window that says which client has the arm, and takes it back (S29)."""

from __future__ import annotations

from typing import TYPE_CHECKING, Final

from PySide6.QtCore import QRectF, QSize, QTimer
from PySide6.QtWidgets import QLabel, QSizePolicy, QWidget

from armui.ui import format as fmt
from armui.ui.actions.act import Act, HasActs
from armui.ui.actions.command import also
from armui.ui.theme import colors_of
from armui.ui.widgets import icons, painting
from armui.ui.widgets.buttons import named
from armui.ui.widgets.layouts import in_row
from armui.ui.widgets.painting import set_rank
from armui.ui.widgets.text_label import ElidedLabel
from armui.ui.widgets.translated import Translated
from armui.ui.words.arm import operation_title
from armui.ui.words.text import Text

if TYPE_CHECKING:
    from PySide6.QtGui import QPaintEvent

    from armui.control.arm_controller import ArmController
    from armui.interface.interface import Interface
    from armui.interface.interface_view import InterfaceView
    from armui.interface.lease import Lease

_ICON_PX: Final = 18
_SIDE_PX: Final = 14
_PADDING_PX: Final = 3
_GROUND_PX: Final = 8
_TICK_MS: Final = 500
_STREAMS: Final = frozenset({"jog.begin", "stream.target"})
"""The operations that follow a stream of targets."""


class LeaseBar(HasActs, Translated, QWidget):
    """One line under the top bar, shown while the interface is on: a lease moves no widget.

    Args:
        interface: Tells who has the arm, and takes it back.
        controller: Gives the titles of the operations.
    """

    take_back = Act(
        "Take back",
        named="interface_take_back",
        key="interface.take_back",
        title=Text("LeaseBar", "Take the arm back from a program"),
        tip="Ends what the program does: the arm comes to rest with power on.",
        primary=True,
        synonyms=also("revoke lease script api 租约 授权 脚本 接口"),
    )

    def __init__(self, interface: Interface, controller: ArmController) -> None:
        super().__init__()
        self.setObjectName("lease_bar")
        self._interface, self._controller = interface, controller
        self._icon = QLabel()
        self._icon.setFixedWidth(_ICON_PX)
        self._text = named("lease_text", ElidedLabel())
        policy = self.take_back.sizePolicy()
        policy.setRetainSizeWhenHidden(True)
        self.take_back.setSizePolicy(policy)
        margins = (_SIDE_PX, _PADDING_PX, _SIDE_PX, _PADDING_PX)
        row = (self._icon, (self._text, 1), self.take_back)
        in_row(*row, on=self, spacing=10, margins=margins)
        self.setSizePolicy(QSizePolicy.Policy.Expanding, QSizePolicy.Policy.Fixed)
        self._timer = QTimer(self, interval=_TICK_MS)
        self._timer.timeout.connect(self._show_text)
        interface.changed.connect(self._on_changed)
        self._on_changed(interface.view)

    @property
    def text(self) -> str:
        """The present text."""
        return self._text.text()

    @take_back.pressed
    def _on_take_back(self) -> None:
        self._interface.take_back()

    def _on_changed(self, view: InterfaceView) -> None:
        self.setVisible(view.on)
        self.take_back.setVisible(view.lease is not None)
        if view.lease is None:
            self._timer.stop()
        else:
            self._timer.start()
        self.retranslate_ui()

    def retranslate_ui(self) -> None:
        """Set all texts in the operator's language."""
        self.show_acts()
        self._show_text()
        self._recolor()

    def _show_text(self) -> None:
        view = self._interface.view
        text = self._idle(view) if view.lease is None else self._leased(view, view.lease)
        if text != self._text.text():
            self._text.show_text(text)
            self.setAccessibleName(text)

    def _idle(self, view: InterfaceView) -> str:
        names = fmt.listed(fmt.short(each.name) for each in view.clients)
        if not names:
            return self.tr("Local interface: no program is connected")
        return self.tr("Local interface: {names} connected, without the arm").format(names=names)

    def _leased(self, view: InterfaceView, lease: Lease) -> str:
        parts = [
            self.tr("“{client}” has the arm").format(client=str(lease.ask.client)),
            fmt.duration(self._interface.seconds_since(lease.since_s), 0),
            self._doing(view.doing),
        ]
        if lease.ask.moves:
            most = fmt.percent(lease.max_speed_percent)
            parts.append(self.tr("at most {percent}").format(percent=most))
        return " · ".join(parts)

    def _doing(self, name: str) -> str:
        if not name:
            return self.tr("does nothing now")
        if name in _STREAMS:
            return self.tr("streams targets")
        bound = self._controller.operations.get(name)
        return name if bound is None else operation_title(bound.operation.title)

    def _recolor(self) -> None:
        leased = self._interface.view.lease is not None
        colors = colors_of(self)
        set_rank(self._text, "" if leased else "muted")
        ink = colors.accent if leased else colors.muted
        self._icon.setPixmap(icons.pixmap("linkage", ink, _ICON_PX, self.devicePixelRatioF()))
        self.update()

    def sizeHint(self) -> QSize:
        """Return the size of one line."""
        height = self.take_back.sizeHint().height()
        return QSize(300, height + 2 * _PADDING_PX)

    def minimumSizeHint(self) -> QSize:
        """Return the height of one line without a minimal width."""
        return QSize(0, self.sizeHint().height())

    def paintEvent(self, _event: QPaintEvent) -> None:
        """Draw the background while a client has the arm."""
        if self._interface.view.lease is None:
            return
        fill = colors_of(self).accent_pale
        painter = painting.begin(self)
        ground = QRectF(self.rect()).adjusted(_GROUND_PX, 1, -_GROUND_PX, -1)
        painting.panel(painter, ground, fill, fill)
        painter.end()
