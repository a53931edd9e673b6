"""The classes of the pages and windows, loaded when they are first asked for."""

from __future__ import annotations

from typing import TYPE_CHECKING

if TYPE_CHECKING:
    from armui.ui.dialogs.about import AboutDialog
    from armui.ui.dialogs.about_arm import AboutArmDialog
    from armui.ui.dialogs.backup import BackupDialog
    from armui.ui.dialogs.connect import ConnectDialog
    from armui.ui.dialogs.doctor import DoctorDialog
    from armui.ui.dialogs.inspection import InspectionDialog
    from armui.ui.dialogs.problem_report import ProblemReportDialog
    from armui.ui.dialogs.reference_check import ReferenceDialog
    from armui.ui.dialogs.settings import SettingsDialog
    from armui.ui.dialogs.simulated_faults import FaultsDialog
    from armui.ui.guide.guide_page import GuidePage
    from armui.ui.interface.interface_dialog import InterfaceDialog
    from armui.ui.trajectory.editor.editor_page import EditorPage
    from armui.ui.trajectory.library.library_page import LibraryPage
    from armui.ui.trajectory.recording.recording_page import RecordingPage
    from armui.ui.watch.bus.bus_page import BusPage
    from armui.ui.watch.events.event_page import EventPage
    from armui.ui.watch.export_dialog import ExportDialog
    from armui.ui.watch.joint_status_page import JointStatusPage
    from armui.ui.watch.plots_area import PlotPage
    from armui.ui.watch.recordings.sessions_page import SessionsPage
    from armui.ui.watch.replay.replay_window import ReplayWindow


def library_page() -> type[LibraryPage]:
    """Return the class of the page 轨迹库."""
    from armui.ui.trajectory.library.library_page import LibraryPage  # noqa: PLC0415 - scipy

    return LibraryPage


def editor_page() -> type[EditorPage]:
    """Return the class of the editor of trajectories."""
    from armui.ui.trajectory.editor.editor_page import EditorPage  # noqa: PLC0415 - scipy

    return EditorPage


def recording_page() -> type[RecordingPage]:
    """Return the class of the page that records trajectories."""
    from armui.ui.trajectory.recording.recording_page import RecordingPage  # noqa: PLC0415 - scipy

    return RecordingPage


def plot_page() -> type[PlotPage]:
    """Return the class of the page 曲线."""
    from armui.ui.watch.plots_area import PlotPage  # noqa: PLC0415 - pyqtgraph, numpy

    return PlotPage


def event_page() -> type[EventPage]:
    """Return the class of the page 事件."""
    from armui.ui.watch.events.event_page import EventPage  # noqa: PLC0415 - cantools

    return EventPage


def bus_page() -> type[BusPage]:
    """Return the class of the page 总线."""
    from armui.ui.watch.bus.bus_page import BusPage  # noqa: PLC0415 - numpy, cantools

    return BusPage


def sessions_page() -> type[SessionsPage]:
    """Return the class of the page 日志."""
    from armui.ui.watch.recordings.sessions_page import SessionsPage  # noqa: PLC0415 - for its page

    return SessionsPage


def joint_status_page() -> type[JointStatusPage]:
    """Return the class of the page 关节状态 (manual 1.0.10)."""
    from armui.ui.watch.joint_status_page import JointStatusPage  # noqa: PLC0415 - for its page

    return JointStatusPage


def guide_page() -> type[GuidePage]:
    """Return the class of the page 使用帮助."""
    from armui.ui.guide.guide_page import GuidePage  # noqa: PLC0415 - for its page

    return GuidePage


def replay_window() -> type[ReplayWindow]:
    """Return the class of the window 回放."""
    from armui.ui.watch.replay.replay_window import ReplayWindow  # noqa: PLC0415 - numpy

    return ReplayWindow


def export_dialog() -> type[ExportDialog]:
    """Return the class of the window 导出."""
    from armui.ui.watch.export_dialog import ExportDialog  # noqa: PLC0415 - cantools

    return ExportDialog


def backup_dialog() -> type[BackupDialog]:
    """Return the class of the window 参数备份."""
    from armui.ui.dialogs.backup import BackupDialog  # noqa: PLC0415 - for its window

    return BackupDialog


def connect_dialog() -> type[ConnectDialog]:
    """Return the class of the window 连接机械臂 (manual 1.0.1)."""
    from armui.ui.dialogs.connect import ConnectDialog  # noqa: PLC0415 - for its window

    return ConnectDialog


def settings_dialog() -> type[SettingsDialog]:
    """Return the class of the window 设置."""
    from armui.ui.dialogs.settings import SettingsDialog  # noqa: PLC0415 - for its window

    return SettingsDialog


def interface_dialog() -> type[InterfaceDialog]:
    """Return the class of the window 本地接口."""
    from armui.ui.interface.interface_dialog import InterfaceDialog  # noqa: PLC0415 - its window

    return InterfaceDialog


def faults_dialog() -> type[FaultsDialog]:
    """Return the class of the window 仿真故障: what breaks the simulated arm."""
    from armui.ui.dialogs.simulated_faults import FaultsDialog  # noqa: PLC0415 - for its window

    return FaultsDialog


def doctor_dialog() -> type[DoctorDialog]:
    """Return the class of the window 诊断: the faults of this computer, the bus and the arm."""
    from armui.ui.dialogs.doctor import DoctorDialog  # noqa: PLC0415 - cantools

    return DoctorDialog


def about_arm_dialog() -> type[AboutArmDialog]:
    """Return the class of the window with the facts on the arm and its connection."""
    from armui.ui.dialogs.about_arm import AboutArmDialog  # noqa: PLC0415 - for its window

    return AboutArmDialog


def reference_dialog() -> type[ReferenceDialog]:
    """Return the class of the reference check, which compares joints with their reported angles."""
    from armui.ui.dialogs.reference_check import ReferenceDialog  # noqa: PLC0415 - cantools

    return ReferenceDialog


def inspection_dialog() -> type[InspectionDialog]:
    """Return the class of the joint inspection."""
    from armui.ui.dialogs.inspection import InspectionDialog  # noqa: PLC0415 - for its window

    return InspectionDialog


def report_dialog() -> type[ProblemReportDialog]:
    """Return the class of the window that shows and saves a problem report."""
    from armui.ui.dialogs.problem_report import ProblemReportDialog  # noqa: PLC0415 - cantools

    return ProblemReportDialog


def about_dialog() -> type[AboutDialog]:
    """Return the class of the window with the program's version and licences."""
    from armui.ui.dialogs.about import AboutDialog  # noqa: PLC0415 - importlib.metadata

    return AboutDialog
