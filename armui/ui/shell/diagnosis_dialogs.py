"""Opens the windows about computer, arm and program; creates each when first opened."""

from __future__ import annotations

from typing import TYPE_CHECKING

from PySide6.QtWidgets import QWidget

from armui.ui.background import Background
from armui.ui.dialogs.about_arm import AboutArmDialog, OnlineSince
from armui.ui.dialogs.base import ArmDialog

if TYPE_CHECKING:
    from concurrent.futures import Executor
    from pathlib import Path

    from armui.arm.device import Device
    from armui.control.arm_controller import ArmController
    from armui.ui.dialogs.about import AboutDialog
    from armui.ui.dialogs.doctor import DoctorDialog
    from armui.ui.dialogs.problem_report import ProblemReportDialog
    from armui.ui.dialogs.reference_check import ReferenceDialog


class DiagnosisDialogs:
    """The windows about this computer, the arm and the program.

    Args:
        controller: Gives the arm's state.
        files: Runs work that waits for the operating system.
        window: The main window.
        settings: The program's file of settings.
    """

    def __init__(
        self, controller: ArmController, files: Executor, window: QWidget, settings: Path
    ) -> None:
        self._controller = controller
        self._files = files
        self._window = window
        self._settings = settings
        self._online = OnlineSince(controller, window)
        self._doctor: DoctorDialog | None = None
        self._about_arm: AboutArmDialog | None = None
        self._report: ProblemReportDialog | None = None
        self._reference: ReferenceDialog | None = None
        self._about: AboutDialog | None = None

    def open_doctor(self, device: Device | None = None) -> None:
        """Show the faults of this computer, the bus and the arm.

        Args:
            device: The device that could not be connected; by default all devices.
        """
        from armui.ui.dialogs.doctor import DoctorDialog  # noqa: PLC0415 - cantools

        if self._doctor is None:
            self._doctor = DoctorDialog(self._controller, self._window)
            self._doctor.report_wanted.connect(self.open_report)
        self._doctor.examine_device(device)

    def open_about_arm(self) -> None:
        """Show the facts on the arm and its connection."""
        if self._about_arm is None:
            self._about_arm = AboutArmDialog(
                self._controller, self._online, self._background(), self._window
            )
        self._about_arm.open()

    def open_reference_check(self) -> None:
        """Show the check of whether the joints stand where they report."""
        from armui.ui.dialogs.reference_check import ReferenceDialog  # noqa: PLC0415 - cantools

        if self._reference is None:
            self._reference = ReferenceDialog(self._controller, self._background(), self._window)
        self._reference.open()

    def open_report(self) -> None:
        """Show the contents of a problem report and let the user save it."""
        from armui.ui.dialogs.problem_report import ProblemReportDialog  # noqa: PLC0415 - cantools

        if self._report is None:
            self._report = ProblemReportDialog(
                self._controller, self._background(), self._settings, self._window
            )
        self._report.open()

    def open_about(self) -> None:
        """Show the program's version and the licences of its parts."""
        from armui.ui.dialogs.about import AboutDialog  # noqa: PLC0415 - importlib.metadata

        if self._about is None:
            self._about = AboutDialog(
                self._controller, self._background(), self._settings, self._window
            )
        self._about.open()

    def _background(self) -> Background:
        return Background(self._files, parent=self._window)

    def dialog(self, key: str) -> ArmDialog | None:
        """Return a window by its key, or ``None`` if it is unknown or was never opened."""
        made: dict[str, ArmDialog | None] = {
            "doctor": self._doctor,
            "about_arm": self._about_arm,
            "report": self._report,
            "reference": self._reference,
            "about": self._about,
        }
        return made.get(key)

    def close(self) -> None:
        """Cancel running examinations, because the program ends."""
        for each in (self._doctor, self._report, self._reference):
            if each is not None:
                each.close()
