"""The operator's view leaves jog, run and stop, and takes what changes the arm or the library."""

import importlib
import pkgutil

import pytest
from PySide6.QtCore import Qt
from PySide6.QtTest import QTest

import armui.ui
from armui.control.arm_controller import ArmController
from armui.control.operations.operation import _ATTRIBUTE
from armui.trajectory.library.store import Library
from armui.trajectory.points.program import Trajectory
from armui.ui.actions.act import HasActs
from armui.ui.actions.operator_view import operator_view, set_operator_view, why_taken
from armui.ui.trajectory.editor.editor_page import EditorPage
from armui.ui.trajectory.library.library_page import LibraryPage
from armui.ui.widgets.hold_button import HOLD_MS
from tests.operator.library.actions import POINT
from tests.operator.test_palette import palette_items

REASON = "Operator's view: hold Unlock to change this."
STAY_COMMANDS = {
    *("everywhere.stop", "everywhere.halt", "everywhere.slower", "everywhere.faster"),
    *("window.resume", "window.next_step", "window.come_inside", "window.enable", "window.speed"),
    *("window.connect", "run.stop", "run.pause", "run.go_on", "motion.jog", "library.open"),
}
STAY_ACTS = {
    *("run_stop", "run_pause", "run_continue", "teaching_abort", "teaching_pause"),
    *("plan_abort", "plan_pause", "gripper_enable_button", "home_button", "send_button"),
    *(f"{act}_motor_{joint}" for act in ("enable", "disable") for joint in range(1, 8)),
    *("connect_connect", "connect_disconnect", "failure_close_button", "linkage_back_button"),
}
TAKEN_ACTS = {
    *("settings_button", "gripper_zero_button", "cell_delete_button", "cell_tool_apply"),
    *("library_delete", "library_import", "library_create", "load_confirm_button"),
    *("joint_settings_save_button", "collision_edit_button", "light_confirm_button"),
    *("joint_settings_backup_button", *(f"zero_motor_{joint}" for joint in range(1, 8))),
}


@pytest.fixture
def locked(app_driver):
    Library(app_driver.library_folder).save(Trajectory("one", points=(POINT, POINT)))
    app_driver.ready()
    item(app_driver, "window.operator_view").target.trigger()
    app_driver.run(0.1)
    yield app_driver
    set_operator_view(wanted=False)


def item(driver, name):
    return next(each for each in palette_items(driver) if each.command.name == name)


def test_what_is_dropped_on_the_library_is_not_imported(locked, tmp_path):
    Library(tmp_path).save(Trajectory("two", points=(POINT, POINT)))
    locked.click("library_button")
    page = locked.page(LibraryPage)
    page._exchange.import_files(list(tmp_path.glob("two*")))
    locked.run(0.3)
    assert page._message.text() == REASON
    assert [each.name for each in Library(locked.library_folder).entries()] == ["one"]


def hold(driver, button):
    QTest.mousePress(button, Qt.MouseButton.LeftButton)
    driver.wait(lambda: not operator_view())
    QTest.mouseRelease(button, Qt.MouseButton.LeftButton)


def every_act():
    for module in pkgutil.walk_packages(armui.ui.__path__, "armui.ui."):
        importlib.import_module(module.name)
    kinds = [HasActs]
    for kind in kinds:
        kinds += kind.__subclasses__()
    return {act for kind in kinds for act in kind.acts}


def test_of_all_acts_none_that_stops_or_brings_the_arm_to_rest_is_taken(qapp):
    acts = {act.named: act for act in every_act()}
    set_operator_view(wanted=True)
    try:
        taken = {n for n, act in acts.items() if why_taken(act.key or n, act.operation)}
    finally:
        set_operator_view(wanted=False)
    assert acts.keys() >= STAY_ACTS | TAKEN_ACTS
    assert taken & STAY_ACTS == set()
    assert taken >= TAKEN_ACTS
    ends = ("stop", "halt", "abort", "pause", "disable", "release", "cancel", "close", "back")
    words = {n for n in acts if any(each in n.split("_") for each in ends)}
    assert {n for n in taken & words if "backup" not in n and n != "bin_back"} == set()


def test_the_stops_are_no_operation_that_it_could_take():
    assert not hasattr(ArmController.emergency_stop, _ATTRIBUTE)
    assert not hasattr(ArmController.halt_and_hold, _ATTRIBUTE)


def test_it_takes_settings_and_leaves_jog_run_and_stop(locked):
    reasons = {each.command.name: each.reason for each in palette_items(locked)}
    for name in ("light.open", "joint_settings.save", "motor.zero_2", "window.settings"):
        assert reasons[name] == REASON
    for name in ("library.delete", "library.import", "cell.delete", "window.backup"):
        assert reasons[name] == REASON
    assert {n for n in STAY_COMMANDS & reasons.keys() if reasons[n] == REASON} == set()
    assert not locked.find("settings_button").isEnabled()
    assert not locked.find("set_own_home_button").isEnabled()
    assert REASON in locked.find("set_own_home_button").toolTip()
    assert not locked.find("menu_fold").isVisible()
    assert not locked.find("menu_joint_settings").isVisible()
    assert locked.find("stop_button").isEnabled()
    assert locked.find("jog_plus_1").isEnabled()


def test_nothing_is_edited_until_unlock_is_held(locked):
    locked.click("library_button")
    locked.page(LibraryPage).open_trajectory("one")
    locked.run(0.3)
    assert not locked.window.findChildren(EditorPage)
    unlock = locked.find("unlock_button")
    QTest.mouseClick(unlock, Qt.MouseButton.LeftButton)
    locked.run(0.1)
    assert operator_view()
    hold(locked, unlock)
    locked.run(0.1)
    assert HOLD_MS >= 1000
    assert not unlock.isVisible()
    assert locked.find("settings_button").isEnabled()
    locked.page(LibraryPage).open_trajectory("one")
    locked.page(EditorPage)
    assert item(locked, "window.operator_view").reason == "Close the trajectory editor first."


def test_a_page_of_settings_is_left(app_driver):
    app_driver.click("menu_light")
    item(app_driver, "window.operator_view").target.trigger()
    app_driver.run(0.1)
    assert app_driver.find("operation_area").current_key == "motion"
    set_operator_view(wanted=False)
