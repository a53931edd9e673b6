"""The pages and windows, each declared once: its titles, its place, its class, how it is created.

A new one is its file, an entry of :data:`PAGES`, its icon and its section of the guides. Classes
are loaded when they are first asked for, so that the program starts without them.
"""

from __future__ import annotations

from collections.abc import Mapping
from pathlib import Path
from typing import TYPE_CHECKING, Final

from armui.ui.actions.command import Command, also, with_simulated
from armui.ui.shell.page_entry import Home, PageEntry
from armui.ui.shell.page_kinds import (
    about_arm_dialog,
    about_dialog,
    backup_dialog,
    bus_page,
    connect_dialog,
    doctor_dialog,
    editor_page,
    event_page,
    export_dialog,
    faults_dialog,
    guide_page,
    inspection_dialog,
    interface_dialog,
    joint_status_page,
    library_page,
    plot_page,
    recording_page,
    reference_dialog,
    replay_window,
    report_dialog,
    sessions_page,
    settings_dialog,
)
from armui.ui.words.settings import setting_label
from armui.ui.words.text import Text
from armui.viewport.view import ArmView

if TYPE_CHECKING:
    from armui.ui.dialogs.base import ArmDialog
    from armui.ui.shell.page_opener import PageOpener
    from armui.ui.widgets.page import Page


def _new_events(pages: PageOpener) -> Page:
    page = event_page()(pages.controller, pages.background)
    page.moment_chosen.connect(pages.move_cursor)
    page.moment_wanted.connect(pages.show_moment)
    return page


def _new_sessions(pages: PageOpener) -> Page:
    page = sessions_page()(pages.controller, pages.background, pages.preferences, pages.replayed)
    page.open_wanted.connect(pages.open_replay)
    page.other_wanted.connect(pages.open_replay)
    page.export_wanted.connect(pages.open_export)
    return page


def _new_replay(pages: PageOpener) -> ArmDialog:
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


def _new_connect(pages: PageOpener) -> ArmDialog:
    from armui.ui.dialogs.kept_models import KeptModels  # noqa: PLC0415 - for its window

    kept = KeptModels(pages.preferences)
    dialog = connect_dialog()(
        pages.controller, pages.window, pages.leave_arm_then, kept, pages.background
    )
    dialog.diagnosis_wanted.connect(pages.open_doctor)
    return dialog


def _new_settings(pages: PageOpener) -> ArmDialog:
    dialog = settings_dialog()(pages.preferences, pages.controller, pages.window)
    pages.view.load_failed.connect(dialog.show_robot_problem)
    dialog.diagnosis_wanted.connect(pages.open_doctor)
    dialog.about_arm_wanted.connect(lambda: pages.show("about_arm"))
    dialog.about_wanted.connect(lambda: pages.show("about"))
    dialog.interface_button.clicked.connect(lambda: pages.show("interface"))
    dialog.faults_button.clicked.connect(lambda: pages.show("simulated"))
    return dialog


def _new_doctor(pages: PageOpener) -> ArmDialog:
    dialog = doctor_dialog()(pages.controller, pages.window)
    dialog.report_wanted.connect(lambda: pages.show("report"))
    return dialog


def _new_about_arm(pages: PageOpener) -> ArmDialog:
    dialog = about_arm_dialog()(pages.controller, pages.online, pages.waiting(), pages.window)
    dialog.inspection_wanted.connect(lambda: pages.show("inspection"))
    return dialog


# The table ----------------------------------------------------------------------------------------

# fmt: off
PAGES: Final[Mapping[str, PageEntry[PageOpener]]] = {
    "library": PageEntry(
        Text("LibraryButton", "Trajectory library"), Home.BESIDE, library_page,
        command=Command("library.open", Text("LibraryButton", "Trajectory library"),
                        synonyms=also("program programs trajectories waypoint 程序 轨迹 路点")),
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
        Text("WatchMenu", "Log"), Home.DRAWER, sessions_page, _new_sessions,
        Text("WatchMenu",
             "Record everything on the bus, save what just happened, replay what was recorded, "
             "here or by another program."),
        command=Command("sessions.open", Text("WatchMenu", "Log"),
                        synonyms=also("logs history session recordings 会话 记录 录制")),
        beside_menu=True),
    "joint_status": PageEntry(
        Text("JointStatusPage", "Joint status"), Home.DRAWER, joint_status_page,
        lambda it: joint_status_page()(it.controller, it.joint_monitor),
        Text("WatchMenu",
             "What each joint says of itself: temperature, current, voltage, faults."),
        command=Command("window.joint_status", Text("Action", "Joint status"),
                        synonyms=also("temperature current voltage errors 温度 电流 电压 故障"))),
    "guide": PageEntry(
        Text("WatchMenu", "Help"), Home.DRAWER, guide_page,
        lambda it: guide_page()(it.background),
        Text("WatchMenu", "How to use the program; F1 opens it at the place where you are."),
        show=lambda it: it.open_guide()),
    "replay": PageEntry(
        Text("Place", "Replay"), Home.WINDOW, replay_window, _new_replay,
        command=Command("replay.open", Text("Action", "Replay a log"),
                        synonyms=also("open recording playback play log 打开 播放 录制"))),
    "export": PageEntry(
        Text("Action", "Export a log"), Home.WINDOW, export_dialog,
        lambda it: export_dialog()(it.controller, it.window),
        command=Command("window.export", Text("Action", "Export a log"),
                        synonyms=also("csv mcap parquet rosbag 导出"))),
    "backup": PageEntry(
        Text("Action", "Back up, compare, restore parameters"), Home.WINDOW, backup_dialog,
        lambda it: backup_dialog()(it.controller, it.background, it.window),
        command=Command("window.backup", Text("Action", "Back up, compare, restore parameters"),
                        risky=True,
                        synonyms=also("backup save restore factory 备份 恢复 出厂 保存参数"))),
    "connect": PageEntry(
        Text("ConnectDialog", "Connect arm"), Home.WINDOW, connect_dialog, _new_connect),
    "settings": PageEntry(
        Text("SettingsDialog", "Settings"), Home.WINDOW, settings_dialog, _new_settings),
    "interface": PageEntry(
        setting_label("interface"), Home.WINDOW, interface_dialog,
        lambda it: interface_dialog()(it.interface, it.preferences, it.controller, it.window)),
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
        Text("ReferenceDialog", "Reference check"), Home.WINDOW, reference_dialog,
        lambda it: reference_dialog()(it.controller, it.waiting(), it.window),
        command=Command("window.reference_check", Text("ReferenceDialog", "Reference check"),
                        synonyms=also("encoder lost zero calibration mark 编码器 零位 校准 丢零"))),
    "inspection": PageEntry(
        Text("InspectionDialog", "Joint inspection"), Home.WINDOW, inspection_dialog,
        lambda it: inspection_dialog()(it.controller, it.waiting(), it.window),
        command=Command("window.inspection", Text("InspectionDialog", "Joint inspection"),
                        synonyms=also("friction stiff wear check 巡检 体检 摩擦 卡滞 磨损"))),
    "report": PageEntry(
        Text("ProblemReportDialog", "Report a problem"), Home.WINDOW, report_dialog,
        lambda it: report_dialog()(it.controller, it.waiting(), it.preferences.path, it.window),
        command=Command("window.report", Text("ProblemReportDialog", "Report a problem"),
                        synonyms=also("bug support zip log 反馈 故障 日志"))),
    "simulated": PageEntry(
        Text("FaultsDialog", "Simulated faults"), Home.WINDOW, faults_dialog,
        lambda it: faults_dialog()(it.controller, it.hand, it.window),
        command=Command("window.faults", Text("FaultsDialog", "Simulated faults"),
                        needs=with_simulated, synonyms=also("inject demo test 演示 测试"))),
    "about": PageEntry(
        Text("AboutDialog", "About armui"), Home.WINDOW, about_dialog,
        lambda it: about_dialog()(it.controller, it.waiting(), it.preferences.path, it.window),
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
