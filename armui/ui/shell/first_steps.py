"""Highlights the next button at the first start, until the arm has been moved once."""

from __future__ import annotations

from collections.abc import Callable
from typing import TYPE_CHECKING

from PySide6.QtCore import QObject
from PySide6.QtWidgets import QPushButton, QWidget

from armui.control.link.link_state import LinkState
from armui.control.motion.motion_command import Mover
from armui.ui.widgets.buttons import show_primary

if TYPE_CHECKING:
    from armui.control.arm_controller import ArmController
    from armui.control.operating_state import OperatingState
    from armui.settings import SettingsStore


class FirstSteps(QObject):
    """Highlights the button of the first jog.

    Connecting and enabling are always highlighted by the line of the next step.

    Args:
        window: The main window.
        first_jog: Returns the button that jogs joint 1 upwards, or ``None`` if it was not created
            yet.
        controller: Gives the moments when the arm may be moved, and when it is.
        store: Stores that the arm has been moved.
    """

    def __init__(
        self,
        window: QWidget,
        first_jog: Callable[[], QPushButton | None],
        controller: ArmController,
        store: SettingsStore,
    ) -> None:
        super().__init__(window)
        self._first_jog = first_jog
        self._store = store
        self._done = store.settings.has_jogged
        if not store.settings.has_jogged:
            controller.operating_state_changed.connect(self._follow)

    def _follow(self, now: OperatingState) -> None:
        self._done = self._done or (now.moving and now.mover is Mover.OURS)
        if self._done and now.link is LinkState.NO_DEVICE and not self._store.settings.has_jogged:
            # it is stored only now because no file is written while a device is open
            self._store.change(has_jogged=True)
        button = self._first_jog()
        if button is not None:
            wanted = now.cannot_move is None and not self._done
            show_primary(button, wanted=wanted)
