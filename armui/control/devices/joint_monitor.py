"""Watches the six joints all the time, also while their window is closed."""

from __future__ import annotations

from collections.abc import Callable
from datetime import datetime
from typing import TYPE_CHECKING, Final

from PySide6.QtCore import QObject, Signal

from armui.arm import joint_status
from armui.arm.joint_status import Item, JointHistory, StatusCell, StatusVerdict, Word, Worst
from armui.control.link.link_state import LinkState
from armui.control.operating_state import OperatingState

if TYPE_CHECKING:
    from armui.arm.state import ArmState
    from armui.control.arm_controller import ArmController
    from armui.protocol.generation import Generation

_SILENT: Final = frozenset({LinkState.OFFLINE, LinkState.LOST})


def _now() -> datetime:
    return datetime.now().astimezone()


class JointMonitor(QObject):
    """Keeps the reports of every joint, the time since when they hold, and the worst state.

    Args:
        controller: The controller of the arm it watches.
        wall_clock: The local time, for «since when».

    Signals:
        updated: Something was heard, or the way to the arm has changed.
        worst_changed: :attr:`worst` or :attr:`faults` differ from before.
    """

    updated = Signal()
    worst_changed = Signal()

    def __init__(
        self,
        controller: ArmController,
        wall_clock: Callable[[], datetime] = _now,
        parent: QObject | None = None,
    ) -> None:
        super().__init__(parent)
        self._controller = controller
        self._wall_clock = wall_clock
        self._history = JointHistory()
        self._worst = Worst(StatusVerdict.UNKNOWN)
        self._faults: list[tuple[int, Item, Word]] = []
        controller.state_changed.connect(self._follow)
        controller.operating_state_changed.connect(self._follow)
        self._follow()

    @property
    def generation(self) -> Generation | None:
        """The protocol generation of the arm, or ``None`` while it is unknown."""
        return self._controller.operating_state.generation

    @property
    def worst(self) -> Worst:
        """The worst of the six states."""
        return self._worst

    @property
    def faults(self) -> list[tuple[int, Item, Word]]:
        """Every fault that the arm reports: the joint, the item and its word."""
        return list(self._faults)

    def cell(self, item: Item, joint: int) -> StatusCell:
        """Return one cell of the table; all are stale while nothing is heard."""
        cell = self._history.cell(self._controller.state, self.generation, item, joint)
        if self._controller.operating_state.link is LinkState.ONLINE:
            return cell
        return cell._replace(stale=cell.word is not None or cell.value is not None)

    def _follow(self, _news: ArmState | OperatingState | None = None) -> None:
        state, generation = self._controller.state, self.generation
        faults = self._faults
        if self._history.add_state(state, generation, self._wall_clock()):
            faults = joint_status.faults(state, generation)
        if self._controller.operating_state.link in _SILENT:
            worst = Worst(StatusVerdict.OFFLINE)
        else:
            worst = joint_status.worst(state, generation, faults)
        if (worst, faults) != (self._worst, self._faults):
            self._worst, self._faults = worst, faults
            self.worst_changed.emit()
        self.updated.emit()
