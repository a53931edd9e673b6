"""An operator who tries other things while a run is under way: bytes, buttons, questions."""

import pytest
from PySide6.QtWidgets import QTableView, QWidget

from armui.control.run.progress import RunPhase
from armui.protocol.frame import Frame
from armui.trajectory.library.store import Library
from armui.trajectory.points.program import Trajectory
from armui.ui import words
from armui.ui.dialogs.confirm_dialog import ConfirmDialog
from armui.ui.dialogs.connect import ConnectDialog
from armui.ui.trajectory.editor.editor_page import EditorPage
from armui.ui.trajectory.library.library_page import LibraryPage
from tests.accepted import accepted
from tests.control.under_way import BACK, OUT, RUNS, joint_jog, motion_paused, phase, to
from tests.faulty_arm import HardOfHearing
from tests.generations import ONE_IS_ENOUGH
from tests.moments import now

ABORT = Frame(0x150, bytes.fromhex("00 06 00 00 00 00 00 00"))
STOP = Frame(0x150, bytes.fromhex("01 00 00 00 00 00 00 00"))
BUTTONS = {
    "motion": ["home_button", "send_button"],
    "cartesian": ["move_p_button", "move_l_button"],
    "linkage": ["linkage_confirm_button"],
    "joint_settings": ["joint_settings_save_button"],
    "collision": ["collision_save_button"],
    "end_limits": ["end_limits_save_button", "end_limits_reset_button"],
    "motor": ["enable_motor_1", "zero_motor_1", "zero_motor_7", "clear_motor_2"],
    "gripper": ["gripper_send_button", "gripper_enable_button"],
    "end_load": ["load_confirm_button"],
    "teaching": ["plan_pause", "plan_continue"],
}
"""What is switched off beside a run, by the panel it is on."""
RUNNING = "under way"


@pytest.fixture
def ready(any_driver):
    any_driver.ready()
    any_driver.ear = HardOfHearing(any_driver.firmware)
    return any_driver


def begun(app_driver, how):
    RUNS[how](app_driver)
    app_driver.ear.heard.clear()
    return app_driver


def test_what_would_disturb_a_run_is_off_and_says_why(ready):
    begun(ready, "run_dwelling")
    for panel, names in BUTTONS.items():
        ready.click(f"menu_{panel}")
        edit = ready.window.findChild(QWidget, f"{panel}_edit_button")
        if edit is not None:
            ready.run(0.3)
            ready.click(edit)
            for field in ready.window.findChildren(QWidget, "collision_all_level_3"):
                ready.click(field)
        for name in names:
            button = ready.find(name)
            assert not button.isEnabled(), name
            changed = "save" not in name or "collision" in name
            assert RUNNING in button.toolTip() or not changed, (name, button.toolTip())
            ready.click(name)
        if edit is not None:
            ready.click(f"{panel}_cancel_button")
    ready.run(0.1)
    questions = {0x472, 0x477}
    assert {frame.arbitration_id for frame in ready.ear.heard} <= questions
    assert phase(ready) is RunPhase.DWELLING


@ONE_IS_ENOUGH
def test_the_speed_at_the_top_is_that_of_a_run_too(ready):
    begun(ready, "run_paused")
    for name in ("speed_slider", "speed_field"):
        assert ready.find(name).isEnabled()
        assert RUNNING not in ready.find(name).toolTip()
    ready.type_into("speed_field", "7")
    assert ready.controller.player.speed_percent == 7


@ONE_IS_ENOUGH
def test_disabling_and_stopping_stay_on(ready):
    begun(ready, "run_dwelling")
    ready.click("menu_motor")
    assert ready.find("disable_motor_7").isEnabled()
    assert ready.find("enable_button").isEnabled()
    ready.click("disable_motor_7")
    ready.hold()
    ready.step()
    assert [frame.arbitration_id for frame in ready.ear.heard] == [0x150, 0x471]
    failed = next(event for event in ready.events if event.code == "run_failed")
    assert "Motors were disabled while it ran" in words.event(failed)


@pytest.mark.parametrize("how", RUNS)
@ONE_IS_ENOUGH
def test_closing_ends_a_run_in_good_order(ready, how):
    begun(ready, how)
    ready.window.close()
    question = ready.dialog(ConfirmDialog)
    assert question.windowTitle() == "A run is under way"
    assert "end its motion where it is" in question.text()
    ready.run(0.1)
    assert ABORT not in ready.ear.heard
    ready.confirm()
    ready.run_until(lambda: not ready.window.isVisible())
    assert ABORT in ready.ear.heard
    assert max(map(abs, ready.firmware.mechanics.speeds_deg_s)) < 0.1
    assert STOP not in ready.ear.heard


@ONE_IS_ENOUGH
def test_the_run_goes_on_when_the_question_is_declined(ready):
    begun(ready, "run_moving")
    ready.window.close()
    ready.dialog(ConfirmDialog).close()
    ready.run_until(lambda: phase(ready) is RunPhase.DONE)
    assert ready.window.isVisible()


@ONE_IS_ENOUGH
def test_a_stop_pressed_meanwhile_keeps_the_window(ready):
    begun(ready, "run_moving")
    ready.window.close()
    ready.confirm()
    ready.click("stop_button")
    ready.run_until(lambda: "stop_confirmed" in ready.codes())
    assert ready.window.isVisible()


@ONE_IS_ENOUGH
def test_a_stop_that_is_not_confirmed_is_not_left_without_a_question(ready):
    ready.ear.deaf_to = {0x150}
    ready.click("stop_button")
    ready.run(0.2)
    ready.window.close()
    assert ready.dialog(ConfirmDialog).windowTitle() == "The stop is not confirmed"
    assert ready.window.isVisible()
    ready.confirm()
    assert not ready.window.isVisible()


@ONE_IS_ENOUGH
def test_closing_drops_a_motion_that_is_paused(ready):
    motion_paused(ready)
    ready.window.close()
    assert ready.dialog(ConfirmDialog).windowTitle() == "A motion is held back"
    ready.confirm()
    assert not ready.window.isVisible()
    ready.step()
    assert ready.ear.heard[-1] == ABORT


@ONE_IS_ENOUGH
def test_closing_ends_a_jog_without_a_question(any_driver):
    joint_jog(any_driver)
    any_driver.window.close()
    assert not any_driver.controller.jogging.active


@pytest.mark.parametrize("how", ["run_dwelling", "run_paused", "replay_moving"])
@ONE_IS_ENOUGH
def test_disconnecting_ends_a_run_in_good_order(ready, how):
    begun(ready, how)
    ready.click("communication_button")
    dialog = ready.dialog(ConnectDialog)
    ready.wait(lambda: dialog.findChild(QTableView).model().rowCount() > 0)
    ready.click(dialog.disconnect_button)
    assert ready.dialog(ConfirmDialog).windowTitle() == "A run is under way"
    ready.confirm()
    ready.run_until(lambda: "disconnected" in ready.codes())
    assert ABORT in ready.ear.heard
    assert max(map(abs, ready.firmware.mechanics.speeds_deg_s)) < 0.1
    dialog.close()


def test_after_a_new_zero_nothing_old_is_gone_on_with(ready):
    Library(ready.library_folder).save(Trajectory("Test", points=(to(OUT, dwell_s=60.0), to(BACK))))
    ready.click("library_button")
    ready.page(LibraryPage).open_trajectory("Test")
    editor = ready.page(EditorPage)
    ready.wait(editor.isActiveWindow)
    RUNS["run_dwelling"](ready)
    ready.controller.player.stop()
    ready.run_until(lambda: not ready.controller.player.running)
    assert ready.read("target_field_1")
    assert now(ready.controller.player.progress.phase) is RunPhase.STOPPED
    ready.run(0.3)
    accepted(ready.controller.zeroing.set_zero(1))
    ready.run_until(lambda: "zero_set_joint" in ready.codes())
    assert now(ready.controller.player.progress.phase) is RunPhase.IDLE
    assert not editor.findChild(QWidget, "run_resume").isVisible()
    measured = [f"{angle:.3f}" for angle in ready.firmware.joints_deg]
    assert [ready.read(f"target_field_{joint}") for joint in range(1, 7)] == measured
    ready.ear.heard.clear()
    ready.run(1.0)
    assert ready.ear.heard == []
