"""Opens the windows 诊断 and «About this arm», created when they are first opened."""

from __future__ import annotations

from typing import TYPE_CHECKING

from PySide6.QtWidgets import QWidget

from armui.ui.background import Background
from armui.ui.dialogs.about_arm import AboutArmDialog, OnlineSince
from armui.ui.dialogs.base import ArmDialog

if TYPE_CHECKING:
    from concurrent.futures import Executor

    from armui.arm.device import Device
    from armui.control.arm_controller import ArmController
    from armui.ui.dialogs.doctor import DoctorDialog


class DiagnosisDialogs:
    """The windows 诊断 and «About this arm».

    Args:
        controller: Gives the arm's state.
        files: Runs work that waits for the operating system.
        window: The main window.
    """

    def __init__(self, controller: ArmController, files: Executor, window: QWidget) -> None:
        self._controller = controller
        self._files = files
        self._window = window
        self._online = OnlineSince(controller, window)
        self._doctor: DoctorDialog | None = None
        self._about_arm: AboutArmDialog | None = None

    def open_doctor(self, device: Device | None = None) -> None:
        """Show the faults of this computer, the bus and the arm.

        Args:
            device: The device that could not be connected; by default all devices.
        """
        from armui.ui.dialogs.doctor import DoctorDialog  # noqa: PLC0415 - cantools

        if self._doctor is None:
            self._doctor = DoctorDialog(self._controller, self._window)
        self._doctor.examine_device(device)

    def open_about_arm(self) -> None:
        """Show the facts on the arm and its connection."""
        if self._about_arm is None:
            background = Background(self._files, parent=self._window)
            self._about_arm = AboutArmDialog(
                self._controller, self._online, background, self._window
            )
        self._about_arm.open()

    def dialog(self, key: str) -> ArmDialog | None:
        """Return a window by its key, or ``None`` if it was never opened."""
        return {"doctor": self._doctor, "about_arm": self._about_arm}.get(key)

    def close(self) -> None:
        """Cancel an examination, because the program ends."""
        if self._doctor is not None:
            self._doctor.close()
