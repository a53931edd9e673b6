"""The pages and windows, each declared once: its titles, its place, its class, how it is created.

A new one is its file, an entry of :data:`PAGES`, its icon and its section of the guides. Classes
are loaded when they are first asked for, so that the program starts without them.
"""

from __future__ import annotations

import enum
from collections.abc import Callable, Mapping
from dataclasses import dataclass
from pathlib import Path
from typing import TYPE_CHECKING, Final

from armui.ui.actions.command import Command, also
from armui.ui.words.text import Text
from armui.viewport.view import ArmView

if TYPE_CHECKING:
    from armui.ui.dialogs.about import AboutDialog
    from armui.ui.dialogs.about_arm import AboutArmDialog
    from armui.ui.dialogs.backup import BackupDialog
    from armui.ui.dialogs.base import ArmDialog
    from armui.ui.dialogs.connect import ConnectDialog
    from armui.ui.dialogs.doctor import DoctorDialog
    from armui.ui.dialogs.problem_report import ProblemReportDialog
    from armui.ui.dialogs.reference_check import ReferenceDialog
    from armui.ui.dialogs.settings import SettingsDialog
    from armui.ui.guide.guide_page import GuidePage
    from armui.ui.guide.help_page import HelpPage
    from armui.ui.shell.page_opener import PageOpener
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
    from armui.ui.widgets.page import Page


class Home(enum.Enum):
    """The part of the program that shows a page."""

    BESIDE = enum.auto()
    """Beside the 3D picture, in the place of the panels."""
    DRAWER = enum.auto()
    """A tab of the drawer."""
    WINDOW = enum.auto()
    """A window of its own."""


@dataclass(frozen=True, slots=True)
class PageEntry:
    """A page or window.

    Attributes:
        title: Its title.
        home: Where it is shown; a page can be moved from there into a window of its own.
        kind: Loads and returns its class, which declares its commands.
        make: Creates it when it is first opened; ``None`` if that is left to `show`.
        tip: Its purpose, for its tab and its button.
        short_title: The text of its tab and its button, if that is not the title.
        command: Opens it from the command palette.
        beside_menu: True if it has a button below the menu, of the name ``<key>_button``.
        show: Shows it, if that is more than to create and open it.
    """

    title: Text
    home: Home
    kind: Callable[[], type[Page | ArmDialog]]
    make: Callable[[PageOpener], Page | ArmDialog] | None = None
    tip: Text | None = None
    short_title: Text | None = None
    command: Command | None = None
    beside_menu: bool = False
    show: Callable[[PageOpener], object] | None = None

    @property
    def movable(self) -> bool:
        """True if it can be moved into a window of its own."""
        return self.home is not Home.WINDOW

    @property
    def tab_title(self) -> Text:
        """The text of its tab and its button."""
        return self.short_title or self.title

    @property
    def tip_text(self) -> str:
        """Its purpose in the present language; empty if none is declared."""
        return "" if self.tip is None else self.tip.text()


# The classes, and how they are created ------------------------------------------------------------


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
    """Return the class of the page 会话记录."""
    from armui.ui.watch.recordings.sessions_page import SessionsPage  # noqa: PLC0415 - for its page

    return SessionsPage


def joint_status_page() -> type[JointStatusPage]:
    """Return the class of the page 关节状态 (manual 1.0.10)."""
    from armui.ui.watch.joint_status_page import JointStatusPage  # noqa: PLC0415 - for its page

    return JointStatusPage


def guide_page() -> type[GuidePage]:
    """Return the class of the page 使用指南."""
    from armui.ui.guide.guide_page import GuidePage  # noqa: PLC0415 - for its page

    return GuidePage


def help_page() -> type[HelpPage]:
    """Return the class of the page 使用帮助: how the 3D picture is used."""
    from armui.ui.guide.help_page import HelpPage  # noqa: PLC0415 - for its page

    return HelpPage


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


def doctor_dialog() -> type[DoctorDialog]:
    """Return the class of the window 诊断: the faults of this computer, the bus and the arm."""
    from armui.ui.dialogs.doctor import DoctorDialog  # noqa: PLC0415 - cantools

    return DoctorDialog


def about_arm_dialog() -> type[AboutArmDialog]:
    """Return the class of the window with the facts on the arm and its connection."""
    from armui.ui.dialogs.about_arm import AboutArmDialog  # noqa: PLC0415 - for its window

    return AboutArmDialog


def reference_dialog() -> type[ReferenceDialog]:
    """Return the class of the check of whether the joints stand where they report."""
    from armui.ui.dialogs.reference_check import ReferenceDialog  # noqa: PLC0415 - cantools

    return ReferenceDialog


def report_dialog() -> type[ProblemReportDialog]:
    """Return the class of the window that shows and saves a problem report."""
    from armui.ui.dialogs.problem_report import ProblemReportDialog  # noqa: PLC0415 - cantools

    return ProblemReportDialog


def about_dialog() -> type[AboutDialog]:
    """Return the class of the window with the program's version and licences."""
    from armui.ui.dialogs.about import AboutDialog  # noqa: PLC0415 - importlib.metadata

    return AboutDialog


def _new_events(pages: PageOpener) -> EventPage:
    page = event_page()(pages.controller, pages.background)
    page.moment_chosen.connect(pages.move_cursor)
    page.moment_wanted.connect(pages.show_moment)
    return page


def _new_sessions(pages: PageOpener) -> SessionsPage:
    page = sessions_page()(pages.controller, pages.background, pages.preferences)
    page.open_wanted.connect(pages.open_replay)
    page.other_wanted.connect(pages.open_replay)
    page.export_wanted.connect(pages.open_export)
    return page


def _new_replay(pages: PageOpener) -> ReplayWindow:
    from armui.session.recording.recorded_session import RecordedSession  # noqa: PLC0415 - numpy

    urdf_path = pages.preferences.settings.urdf_path

    def make_view() -> ArmView:
        own = pages.preferences.settings.urdf_path
        return ArmView(Path(own) if own else None)

    window = replay_window()(
        pages.controller,
        pages.background,
        make_view,
        pages.window,
        open_own=RecordedSession,
        urdf_path=urdf_path,
    )
    window.export_wanted.connect(pages.open_export)
    return window


def _new_connect(pages: PageOpener) -> ConnectDialog:
    from armui.ui.dialogs.kept_models import KeptModels  # noqa: PLC0415 - for its window

    kept = KeptModels(pages.preferences)
    dialog = connect_dialog()(
        pages.controller, pages.window, pages.leave_arm_then, kept, pages.background
    )
    dialog.diagnosis_wanted.connect(pages.open_doctor)
    return dialog


def _new_settings(pages: PageOpener) -> SettingsDialog:
    dialog = settings_dialog()(pages.preferences, pages.controller, pages.window)
    pages.view.load_failed.connect(dialog.show_robot_problem)
    dialog.diagnosis_wanted.connect(pages.open_doctor)
    dialog.about_arm_wanted.connect(lambda: pages.show("about_arm"))
    dialog.about_wanted.connect(lambda: pages.show("about"))
    return dialog


def _new_doctor(pages: PageOpener) -> DoctorDialog:
    dialog = doctor_dialog()(pages.controller, pages.window)
    dialog.report_wanted.connect(lambda: pages.show("report"))
    return dialog


def _new_about_arm(pages: PageOpener) -> AboutArmDialog:
    return about_arm_dialog()(pages.controller, pages.online, pages.waiting(), pages.window)


def _new_reference(pages: PageOpener) -> ReferenceDialog:
    return reference_dialog()(pages.controller, pages.waiting(), pages.window)


def _new_report(pages: PageOpener) -> ProblemReportDialog:
    path = pages.preferences.path
    return report_dialog()(pages.controller, pages.waiting(), path, pages.window)


def _new_about(pages: PageOpener) -> AboutDialog:
    path = pages.preferences.path
    return about_dialog()(pages.controller, pages.waiting(), path, pages.window)


# The table ----------------------------------------------------------------------------------------

# fmt: off
PAGES: Final[Mapping[str, PageEntry]] = {
    "library": PageEntry(
        Text("LibraryButton", "Trajectory library"), Home.BESIDE, library_page,
        command=Command("library.open", Text("LibraryButton", "Trajectory library"),
                        synonyms=also("program programs trajectories 程序 轨迹")),
        show=lambda it: it.trajectories.open_library()),
    "editor": PageEntry(
        Text("Place", "Trajectory editor"), Home.BESIDE, editor_page,
        show=lambda it: it.trajectories.open_editor()),
    "recording": PageEntry(
        Text("RecordingPage", "Recording"), Home.BESIDE, recording_page,
        show=lambda it: it.trajectories.open_recorder()),
    "plots": PageEntry(
        Text("WatchMenu", "Curves"), Home.DRAWER, plot_page,
        lambda it: plot_page()(it.controller, it.background, it.preferences.path),
        Text("WatchMenu",
             "Feedback and commands of the last half hour. Right-click any figure to show it "
             "here."),
        command=Command("plots.open", Text("WatchMenu", "Curves"),
                        synonyms=also("chart graph plot scope 图表 示波器")),
        beside_menu=True),
    "events": PageEntry(
        Text("WatchMenu", "Events"), Home.DRAWER, event_page, _new_events,
        Text("WatchMenu",
             "What happened: every command and its result, every change of the arm's status, "
             "every fault with its beginning and end."),
        command=Command("events.open", Text("WatchMenu", "Events"),
                        synonyms=also("log messages alarms 日志 报警 消息")),
        beside_menu=True),
    "bus": PageEntry(
        Text("WatchMenu", "Bus"), Home.DRAWER, bus_page, lambda it: bus_page()(it.controller),
        Text("WatchMenu",
             "Every frame on the CAN bus: what it says, how often it comes, who sends it."),
        command=Command("bus.open", Text("WatchMenu", "Bus"),
                        synonyms=also("can frames monitor sniffer 报文 帧")),
        beside_menu=True),
    "sessions": PageEntry(
        Text("SessionsPage", "Session recordings"), Home.DRAWER, sessions_page, _new_sessions,
        Text("WatchMenu",
             "Record everything on the bus, save what just happened, replay what was recorded, "
             "here or by another program."),
        short_title=Text("WatchMenu", "Record"),
        command=Command("sessions.open", Text("SessionsPage", "Session recordings"),
                        synonyms=also("logs history 日志 录制")),
        beside_menu=True),
    "joint_status": PageEntry(
        Text("JointStatusPage", "Joint status"), Home.DRAWER, joint_status_page,
        lambda it: joint_status_page()(it.controller, it.joint_monitor),
        Text("WatchMenu",
             "What each joint says of itself: temperature, current, voltage, faults."),
        command=Command("window.joint_status", Text("Action", "Joint status"),
                        synonyms=also("temperature current voltage errors 温度 电流 电压 故障"))),
    "guide": PageEntry(
        Text("WatchMenu", "Guide"), Home.DRAWER, guide_page,
        lambda it: guide_page()(it.background),
        Text("WatchMenu", "How to use the program; F1 opens it at the place where you are."),
        show=lambda it: it.open_guide()),
    "help": PageEntry(
        Text("HelpPage", "Help: 3D view"), Home.DRAWER, help_page, lambda _: help_page()(),
        Text("WatchMenu", "Mouse, keys and figures of the 3D picture."),
        short_title=Text("WatchMenu", "Help")),
    "replay": PageEntry(
        Text("Place", "Replay"), Home.WINDOW, replay_window, _new_replay,
        command=Command("replay.open", Text("Action", "Replay a recording"),
                        synonyms=also("playback play log 播放"))),
    "export": PageEntry(
        Text("Action", "Export a recording"), Home.WINDOW, export_dialog,
        lambda it: export_dialog()(it.controller, it.window),
        command=Command("window.export", Text("Action", "Export a recording"),
                        synonyms=also("csv mcap parquet rosbag 导出"))),
    "backup": PageEntry(
        Text("Action", "Back up, compare, restore parameters"), Home.WINDOW, backup_dialog,
        lambda it: backup_dialog()(it.controller, it.background, it.window),
        command=Command("window.backup", Text("Action", "Back up, compare, restore parameters"),
                        risky=True, synonyms=also("restore factory 恢复 出厂"))),
    "connect": PageEntry(
        Text("ConnectDialog", "Connect arm"), Home.WINDOW, connect_dialog, _new_connect),
    "settings": PageEntry(
        Text("SettingsDialog", "Settings"), Home.WINDOW, settings_dialog, _new_settings),
    "doctor": PageEntry(
        Text("DoctorDialog", "Diagnosis"), Home.WINDOW, doctor_dialog, _new_doctor,
        command=Command("window.diagnosis", Text("DoctorDialog", "Diagnosis"),
                        synonyms=also("doctor troubleshoot problem 排查 自检")),
        show=lambda it: it.open_doctor()),
    "about_arm": PageEntry(
        Text("AboutArmDialog", "About this arm"), Home.WINDOW, about_arm_dialog, _new_about_arm,
        command=Command("window.about_arm", Text("AboutArmDialog", "About this arm"),
                        synonyms=also("version firmware serial 版本 固件 序列号"))),
    "reference": PageEntry(
        Text("ReferenceDialog", "Reference check"), Home.WINDOW, reference_dialog, _new_reference,
        command=Command("window.reference_check", Text("ReferenceDialog", "Reference check"),
                        synonyms=also("encoder lost zero calibration mark 编码器 零位 校准 丢零"))),
    "report": PageEntry(
        Text("ProblemReportDialog", "Report a problem"), Home.WINDOW, report_dialog, _new_report,
        command=Command("window.report", Text("ProblemReportDialog", "Report a problem"),
                        synonyms=also("bug support zip log 反馈 故障 日志"))),
    "about": PageEntry(
        Text("AboutDialog", "About armui"), Home.WINDOW, about_dialog, _new_about,
        command=Command("window.about", Text("AboutDialog", "About armui"),
                        synonyms=also("version licence license 版本 许可证"))),
}
# fmt: on
"""The pages and windows by their keys, in the order in which they are listed."""

PLACES: Final[Mapping[str, Text]] = {
    "everywhere": Text("Place", "In every window"),
    "window": Text("Place", "Main window"),
    "view": Text("Place", "3D view"),
    "jogging": Text("Place", "Jogging by keys"),
    "parameters": Text("Place", "Panels with parameters"),
    **{key: page.title for key, page in PAGES.items()},
    "drawer": Text("Place", "Drawer"),
    "run": Text("Place", "Run"),
}
"""The titles of the pages, and of the other places; `operation_area.PANELS` has the panels."""
