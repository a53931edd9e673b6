"""What the pictures of ``tests.gallery`` show: states of the window, and every dialog."""

from __future__ import annotations

import errno
import tempfile
from collections.abc import Callable
from dataclasses import dataclass
from pathlib import Path

import can
from PySide6.QtCore import QCoreApplication, Qt
from PySide6.QtTest import QTest
from PySide6.QtWidgets import QApplication, QComboBox, QDialog, QLineEdit, QWidget

from armui.arm.device import Device
from armui.arm.limits import FACTORY_ACCELERATION_DEG_S2, FACTORY_LIMITS
from armui.control.recovery_steps import Kind
from armui.control.situation import LinkState, StopState
from armui.sim.faults import fault
from armui.trajectory.columns import Quantity
from armui.trajectory.library import Library
from armui.ui.dialogs.backup import BackupDialog
from armui.ui.dialogs.confirm import ConfirmDialog
from armui.ui.dialogs.connect import ConnectDialog
from armui.ui.dialogs.files import FileDialog
from armui.ui.dialogs.help import HelpDialog
from armui.ui.dialogs.joint_status import JointStatusDialog
from armui.ui.dialogs.settings import SettingsDialog
from armui.ui.operation_area import OperationArea
from armui.ui.trajectory.columns_dialog import ColumnsDialog
from armui.ui.trajectory.editor_window import EditorWindow
from armui.ui.trajectory.library_window import LibraryWindow
from armui.ui.trajectory.recording_window import RecordingWindow
from tests.desk import Desk
from tests.faulty_arm import FaultyDrivers
from tests.shelf import SHELF

_PUSH = fault("collision", 2)

REACH_OUT_DEG = (35.0, 95.0, -70.0, 20.0, 45.0, -30.0)

ADAPTERS = (
    Device("socketcan", "can0", None),
    Device("gs_usb", "0", serial="0031002F5246501620303538"),
    Device("slcan", "/dev/ttyACM0", serial="206E3599"),
)


@dataclass(frozen=True)
class Scene:
    """One state of the main window.

    Attributes:
        name: For the file.
        play: Brings the window from the scene before to this one.
    """

    name: str
    play: Callable[[Desk], None]


def _no_device(_desk: Desk) -> None:
    """The window as it opens."""


def _online(desk: Desk) -> None:
    desk.connect()


def _preview(desk: Desk) -> None:
    editor = _editor(desk)
    desk.wait(editor.isActiveWindow)
    QTest.keyClick(editor, Qt.Key.Key_E, Qt.KeyboardModifier.ControlModifier)
    editor.table.select_row(4)


def _lights(desk: Desk) -> None:
    close_dialogs()
    desk.click("menu_light")
    desk.click("light_joint_3")
    for channel, value in (("red", 255), ("green", 140), ("blue", 26)):
        desk.type_into(f"{channel}_field", str(value))
    desk.click("light_confirm_button")
    desk.step()


def _lights_refused(desk: Desk) -> None:
    desk.click("all_lamps")
    desk.type_into("lamp_field", "300")


def _joint_settings(desk: Desk) -> None:
    _open(desk, "joint_settings")
    desk.click("joint_settings_edit_button")
    desk.type_into("max_angle_deg_2", "170")
    desk.type_into("max_angle_deg_1", "400")


def _joint_settings_refused(desk: Desk) -> None:
    desk.type_into("max_angle_deg_1", "150")
    desk.type_into("max_speed_deg_s_3", "300")  # more than the motors can do
    desk.click("joint_settings_save_button")
    _settled(desk)


def _joint_settings_corrupt(desk: Desk) -> None:
    desk.click("joint_settings_cancel_button")
    desk.firmware.corrupt_limits(2)
    desk.click("joint_settings_read_button")
    _settled(desk)
    desk.firmware.settings.limits[1] = FACTORY_LIMITS[1]
    desk.firmware.settings.accelerations_deg_s2[1] = FACTORY_ACCELERATION_DEG_S2


def _end_limits(desk: Desk) -> None:
    desk.click("joint_settings_read_button")
    _settled(desk)
    _open(desk, "end_limits")
    desk.click("end_limits_edit_button")
    desk.type_into("max_linear_speed_m_s", "0.5")
    desk.click("end_limits_save_button")
    _settled(desk)


def _levels(desk: Desk) -> None:
    _open(desk, "collision")
    desk.click("collision_edit_button")
    desk.click("collision_level_2_level_0")
    desk.click("collision_level_4_level_8")


def _open(desk: Desk, panel: str) -> None:
    desk.click(f"menu_{panel}")
    _settled(desk)


def _settled(desk: Desk) -> None:
    desk.run_until(lambda: not desk.controller.settings.busy)


def _motors(desk: Desk) -> None:
    desk.click("menu_motor")
    desk.click("enable_motor_2")
    desk.run(0.4)


def _tool(desk: Desk) -> None:
    desk.click("menu_cartesian")
    desk.type_into("tool_field_Z", "80")
    desk.click("capture_start")


def _tool_refused(desk: Desk) -> None:
    """Out of reach, with the keys switched on."""
    desk.click("tool_keys_button")
    desk.type_into("pose_field_X", "900")
    desk.click("move_l_button")


def _joint_keys(desk: Desk) -> None:
    desk.click("tool_keys_button")
    desk.type_into("tool_field_Z", "0")
    desk.click("menu_motion")
    desk.click("load_button")
    desk.click("jog_keys_button")
    step_box = desk.find("jog_step")
    step_box.setCurrentIndex(step_box.count() - 1)


def _linkage(desk: Desk) -> None:
    desk.click("menu_linkage")


def _linkage_question(desk: Desk) -> QDialog:
    desk.click("linkage_input")
    desk.click("linkage_confirm_button")
    return desk.dialog(ConfirmDialog)


def _end_load(desk: Desk) -> None:
    desk.click("menu_end_load")
    desk.click("load_half")
    desk.click("end_feedback_button")
    desk.run_until(lambda: "end_feedback_on" in desk.codes())


def _gripper(desk: Desk) -> None:
    desk.click("menu_gripper")
    desk.run(0.3)
    desk.firmware.gripper.object_width = 24.0
    desk.controller.gripper.move(60.0, 1.0)
    desk.run_until(lambda: "gripper_there" in desk.codes())
    desk.type_into("gripper_opening_field", "10")
    desk.click("gripper_send_button")
    desk.run_until(lambda: "gripper_grips" in desk.codes())


def _moving(desk: Desk) -> None:
    desk.click("collision_cancel_button")
    desk.click("menu_motion")
    desk.enable_by_hand()
    desk.controller.motion.set_speed_percent(20)
    for joint, angle_deg in enumerate(REACH_OUT_DEG, start=1):
        desk.type_into(f"target_field_{joint}", f"{angle_deg}")
    desk.click("send_button")
    desk.run_until(lambda: desk.controller.situation.moving)
    desk.run(1.2)


def _refused(desk: Desk) -> None:
    desk.run_until(lambda: not desk.controller.situation.moving, seconds=60.0)
    desk.type_into("target_field_2", "200")
    desk.click("send_button")


def _stopped(desk: Desk) -> None:
    desk.plug_in()
    desk.wait(lambda: desk.controller.situation.link is not LinkState.LOST)
    desk.run_until(lambda: desk.controller.situation.cannot_enable is None)
    desk.click("load_button")
    desk.click("stop_button")
    desk.run_until(lambda: desk.controller.situation.stop is StopState.STOPPED)
    desk.run(0.3)


def _offline(desk: Desk) -> None:
    desk.click("jog_keys_button")
    desk.find("jog_step").setCurrentIndex(1)
    desk.run(0.2)  # what a dialog's scene did to the arm is over before it falls silent
    desk.powered = False
    desk.run_until(lambda: "offline" in desk.codes())
    desk.powered = True


def _lost(desk: Desk) -> None:
    desk.unplug(can.CanOperationError("gone", error_code=errno.ENODEV))
    desk.wait(lambda: desk.controller.situation.link is LinkState.LOST)


def _collision(desk: Desk) -> None:
    desk.click("recovery_button")
    desk.confirm()
    _until(desk, Kind.MOTORS_OFF)
    desk.click("recovery_button")
    _until(desk, Kind.READY)
    desk.node.faults.start(_PUSH)
    _until(desk, Kind.COLLISION)


def _teaching(desk: Desk) -> None:
    desk.node.faults.end(_PUSH)
    desk.run(0.1)
    desk.click("recovery_button")
    _until(desk, Kind.READY)
    desk.click("menu_teaching")
    desk.click("teaching_start_recording")
    desk.confirm()
    _until(desk, Kind.RECORDING)
    desk.firmware.hand.lead_to(REACH_OUT_DEG)
    desk.run(2.0)


def _way_out(desk: Desk) -> None:
    desk.click("teaching_stop_recording")
    _until(desk, Kind.DRAG_MODE)
    desk.run(0.2)


def _until(desk: Desk, kind: Kind) -> None:
    desk.run_until(lambda: desk.controller.recovery.step.kind is kind)


WINDOW_SCENES = (
    Scene("no-device", _no_device),
    Scene("online", _online),
    Scene("preview", _preview),
    Scene("lights", _lights),
    Scene("lights-refused", _lights_refused),
    Scene("motors", _motors),
    Scene("linkage", _linkage),
    Scene("gripper", _gripper),
    Scene("end-load", _end_load),
    Scene("joint-settings", _joint_settings),
    Scene("joint-settings-refused", _joint_settings_refused),
    Scene("joint-settings-corrupt", _joint_settings_corrupt),
    Scene("end-limits", _end_limits),
    Scene("collision-levels", _levels),
    Scene("moving", _moving),
    Scene("refused", _refused),
    Scene("tool", _tool),
    Scene("tool-refused", _tool_refused),
    Scene("joint-keys", _joint_keys),
    Scene("offline", _offline),
    Scene("lost", _lost),
    Scene("stopped", _stopped),
    Scene("collision", _collision),
    Scene("teaching", _teaching),
    Scene("way-out", _way_out),
)
"""In the order they follow one another."""


# Dialogs ------------------------------------------------------------------------------------------


def _connect(desk: Desk) -> QDialog:
    desk.window.open_connect_dialog()
    dialog = desk.dialog(ConnectDialog)
    # the search finds the simulated arm alone; its answer must not come after this
    desk.wait(dialog.refresh_button.isEnabled)
    desk.controller.devices_found.emit([desk.device, *ADAPTERS])
    return dialog


def _connect_searching(desk: Desk) -> QDialog:
    dialog = _connect(desk)
    desk.controller.searching_changed.emit(True)
    return dialog


def _connect_failed(desk: Desk) -> QDialog:
    desk.broken = can.CanInitializationError("busy", error_code=errno.EBUSY)
    desk.controller.connect_device(ADAPTERS[1])
    desk.wait(lambda: desk.controller.situation.link_problem is not None)
    desk.plug_in()
    return _connect(desk)


def _settings(desk: Desk) -> QDialog:
    desk.window.open_settings_dialog()
    return desk.dialog(SettingsDialog)


def _settings_refused(desk: Desk) -> QDialog:
    dialog = _settings(desk)
    field = dialog.findChild(QLineEdit)
    field.setFocus()
    field.selectAll()
    QTest.keyClicks(field, "99")
    QTest.keyClick(field, Qt.Key.Key_Return)
    return dialog


def _help(desk: Desk) -> QDialog:
    desk.window.open_help_dialog()
    return desk.dialog(HelpDialog)


def _joint_status(desk: Desk) -> QDialog:
    desk.window.open_joint_status_dialog()
    return desk.dialog(JointStatusDialog)


def _joint_status_faults(desk: Desk) -> QDialog:
    drivers = FaultyDrivers(desk.firmware)
    drivers.bits = {2: 0x04, 4: 0x11, 5: 0x80}
    desk.firmware.set_communication_fault(6, present=True)
    desk.run(0.2)
    # gone with the next step of the arm's time, which stands still until then
    desk.firmware.set_communication_fault(6, present=False)
    drivers.mend()
    return _joint_status(desk)


def _file(desk: Desk) -> QDialog:
    dialog = _settings(desk)
    QTest.mouseClick(dialog.browse_button, Qt.MouseButton.LeftButton)
    chooser = desk.dialog(FileDialog)
    chooser.setDirectory(str(Path(__file__).resolve().parent.parent / "urdf"))
    return chooser


def _library(desk: Desk) -> QDialog:
    """Four trajectories, one of them checked; the simulated arm never runs them."""
    library = Library(desk.library_folder)
    if not library.entries():
        for content in SHELF:
            library.save(content)
        library.mark("Warm up", check="ok", length_s=84.0)
    desk.window.open_library_window()
    window = desk.dialog(LibraryWindow)
    window.refresh(["Pick and place"])
    return window


def _editor(desk: Desk) -> QDialog:
    _library(desk).open_trajectory("Pick and place")
    return desk.dialog(EditorWindow)


def _editor_find(desk: Desk) -> QDialog:
    window = _editor(desk)
    QTest.keyClick(window, Qt.Key.Key_F, Qt.KeyboardModifier.ControlModifier)
    return window


def _failed_check(desk: Desk) -> QDialog:
    _library(desk).open_trajectory("Out of reach")
    window = desk.dialog(EditorWindow)
    desk.click(window.findChild(QWidget, "editor_check"))
    return window


def _recording(desk: Desk) -> QDialog:
    _library(desk).open_trajectory("By hand")
    return desk.dialog(RecordingWindow)


def _columns(desk: Desk) -> QDialog:
    """A table that names most of its columns, one of them twice."""
    rows = "".join(
        f"{20 * step},{step},{0.3 + step / 100:.3f},{-0.7 - step / 90:.3f},0.1,0.4,-0.2,{step},41\n"
        for step in range(30)
    )
    window = _library(desk)
    with tempfile.TemporaryDirectory() as folder:
        path = Path(folder) / "welding seam.csv"
        path.write_text(f"time_ms,j1,j2,j3,j4,j5,j6,counter,temperature\n{rows}")
        desk.click(window.findChild(QWidget, "library_import"))
        chooser = desk.dialog(FileDialog)
        chooser.filesSelected.emit([str(path)])
        chooser.close()
        desk.click(window.findChild(QWidget, "library_by_columns"))
    dialog = desk.dialog(ColumnsDialog)
    box = dialog.findChild(QComboBox, "column_quantity_8")
    box.setCurrentIndex(box.findData(Quantity.J1))
    box.activated.emit(box.currentIndex())
    return dialog


def _columns_offered(desk: Desk) -> QDialog:
    _columns(desk).reject()
    return desk.dialog(LibraryWindow)


def _confirm_disable(desk: Desk) -> QDialog:
    desk.click("enable_button")
    return desk.dialog(ConfirmDialog)


def _hold_zero(desk: Desk) -> QDialog:
    desk.click("zero_motor_2")
    dialog = desk.dialog(ConfirmDialog)
    desk.press(dialog.action_button)
    progress = dialog.action_button.progress
    progress.setCurrentTime(progress.duration() * 2 // 3)
    progress.pause()
    return dialog


def _hold_disable(desk: Desk) -> QDialog:
    desk.click("disable_motor_7")
    return desk.dialog(ConfirmDialog)


def _confirm_resume(desk: Desk) -> QDialog:
    desk.click("stop_button")
    return desk.dialog(ConfirmDialog)


def _backup(desk: Desk) -> QDialog:
    """A file that differs from the arm in a few places, beside it."""
    settings = desk.firmware.settings
    settings.end_limits, settings.collision_levels = (1.0,) * 4, (1,) * 6
    desk.window.open_backup_dialog()
    dialog = desk.dialog(BackupDialog)
    _settled(desk)
    with tempfile.TemporaryDirectory() as folder:
        path = Path(folder) / "piper-S-V1.8-5.json"
        desk.click(dialog.save_button)
        desk.dialog(FileDialog).fileSelected.emit(str(path))
        settings.end_limits, settings.collision_levels = (0.25, 1.0, 0.8, 1.0), (1, 1, 5, 1, 1, 1)
        desk.click(dialog.read_button)
        _settled(desk)
        dialog.open_file(path)
    dialog.only_differences.setChecked(True)
    return dialog


def _confirm_unsaved(desk: Desk) -> QDialog:
    desk.click("menu_motion")
    return desk.dialog(ConfirmDialog)


def _confirm_close(desk: Desk) -> QDialog:
    desk.window.close()
    return desk.dialog(ConfirmDialog)


@dataclass(frozen=True)
class DialogScene:
    """One dialog in one state.

    Attributes:
        name: For the file.
        during: The scene of the window in which it is opened.
        open: Opens it.
    """

    name: str
    during: str
    open: Callable[[Desk], QDialog]


DIALOG_SCENES = (
    DialogScene("connect-searching", "no-device", _connect_searching),
    DialogScene("connect-failed", "no-device", _connect_failed),
    DialogScene("connect", "online", _connect),
    DialogScene("settings", "no-device", _settings),
    DialogScene("settings-refused", "no-device", _settings_refused),
    DialogScene("help", "no-device", _help),
    DialogScene("joint-status-unknown", "no-device", _joint_status),
    DialogScene("joint-status", "online", _joint_status),
    DialogScene("joint-status-faults", "refused", _joint_status_faults),
    DialogScene("joint-status-stale", "offline", _joint_status),
    DialogScene("file", "no-device", _file),
    DialogScene("library", "online", _library),
    DialogScene("editor", "online", _editor),
    DialogScene("editor-find", "online", _editor_find),
    DialogScene("editor-check-failed", "online", _failed_check),
    DialogScene("recording", "online", _recording),
    DialogScene("columns-offered", "online", _columns_offered),
    DialogScene("columns", "online", _columns),
    DialogScene("confirm-disable", "refused", _confirm_disable),
    DialogScene("linkage", "linkage", _linkage_question),
    DialogScene("hold-zero", "motors", _hold_zero),
    DialogScene("hold-disable", "motors", _hold_disable),
    DialogScene("backup", "joint-settings-corrupt", _backup),
    DialogScene("confirm-unsaved", "collision-levels", _confirm_unsaved),
    DialogScene("confirm-close", "moving", _confirm_close),
    DialogScene("confirm-resume", "stopped", _confirm_resume),
)


def close_dialogs() -> None:
    """Leave no dialog open for the next picture."""
    for widget in QApplication.topLevelWidgets():
        if isinstance(widget, QDialog) and widget.isVisible():
            widget.reject()
    QCoreApplication.processEvents()


def panels(window: QWidget) -> dict[str, QWidget]:
    """The panels of the operation area by their names."""
    area = window.findChild(OperationArea, "operation_area")
    return {type(panel).__name__.removesuffix("Panel").lower(): panel for panel in area.panels}
