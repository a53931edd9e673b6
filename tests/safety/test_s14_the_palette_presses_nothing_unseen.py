"""S14: what sends the arm somewhere is only led to from the palette, unless its page was seen."""

import pytest
from PySide6.QtCore import Qt
from PySide6.QtTest import QTest

from armui.control.operations.operation import Consent
from armui.control.run.progress import RunPhase
from armui.protocol.codes import TeachingState
from armui.ui.dialogs.confirm_dialog import ConfirmDialog
from tests.accepted import accepted
from tests.app_driver import PANELS
from tests.operator.test_palette import commands, open_palette, rows, targets
from tests.operator.test_running import BACK, OUT, Operator, to

QUESTIONS = {0x477}
"""What asks for parameters."""


def choose(app_driver, name):
    """Choose one command of the palette; the reason that is told, if it cannot be done."""
    palette = open_palette(app_driver)
    (row,) = [row for row, item in enumerate(rows(palette)) if item.command.name == name]
    palette.list.setCurrentIndex(palette.list.model().index(row, 0))
    QTest.keyClick(palette.search, Qt.Key.Key_Return)
    return palette


def test_every_motion_is_only_led_to(app_driver):
    app_driver.ready()
    app_driver.click("menu_light")
    moving = [
        each
        for each in commands(app_driver)
        if each.operation is not None and each.operation.moves and each.place in PANELS
    ]
    led = []
    for each in moving:
        if each.refusal(app_driver.controller.operating_state):
            continue
        if not (each.shown_first or each.only_led_to):
            continue
        app_driver.click("menu_light")
        app_driver.heard()
        choose(app_driver, each.name).close()
        app_driver.run(0.3)
        assert not app_driver.controller.operating_state.moving, each.name
        assert {frame.arbitration_id for frame in app_driver.heard()} <= QUESTIONS, each.name
        target = targets(app_driver).get(each.name)
        # else it stands in a box that is folded, or cannot be pressed
        if target is not None and target.isEnabled():
            assert target.hasFocus(), each.name
        led.append(each.name)
    assert {"motion.send", "motion.jog", "cartesian.move_p", "gripper.send"} <= set(led)


def test_a_jog_is_only_led_to_where_it_is_seen_too(app_driver):
    app_driver.ready()
    for name in ("motion.jog_step", "motion.jog"):
        choose(app_driver, name)
        app_driver.run(0.5)
        assert not app_driver.controller.operating_state.moving
        assert app_driver.window.focusWidget() is app_driver.find("jog_plus_1")


def test_what_asks_first_asks_whether_its_panel_was_seen_or_not(app_driver):
    app_driver.ready()
    asking = [
        each.name
        for each in commands(app_driver)
        if each.operation is not None
        and each.operation.consent is Consent.PRESS
        and each.place in {"motor", "gripper", "linkage"}
        and not each.refusal(app_driver.controller.operating_state)
    ]
    assert len(asking) > 10
    for name in asking:
        app_driver.click("menu_light")
        app_driver.heard()
        choose(app_driver, name)
        app_driver.dialog(ConfirmDialog).reject()
        assert {frame.arbitration_id for frame in app_driver.heard()} <= QUESTIONS, name


@pytest.mark.parametrize("name", ["run.go_on", "run.pause"])
def test_a_run_that_waits_is_not_set_going(app_driver, name):
    operator = Operator(app_driver, to(OUT), to(BACK))
    operator.child("run_steps").setChecked(True)
    operator.send()
    operator.until(lambda: operator.progress.phase is RunPhase.WAITING)
    choose(app_driver, name).close()
    app_driver.run(0.5)
    assert operator.progress.phase is RunPhase.WAITING


def test_a_run_is_paused_and_ended(app_driver):
    operator = Operator(app_driver, to(OUT), to(BACK))
    operator.send()
    operator.until(lambda: operator.progress.phase is RunPhase.MOVING)
    app_driver.run(0.3)
    choose(app_driver, "run.pause")
    operator.until(lambda: operator.progress.phase is RunPhase.PAUSED)
    choose(app_driver, "run.go_on")
    app_driver.run(0.5)
    assert app_driver.find("run_continue").isVisible(), "it is to be held by hand"
    choose(app_driver, "run.stop")
    operator.until(lambda: operator.progress.phase is RunPhase.STOPPED)


def test_recording_is_ended_by_the_command_that_says_so(app_driver):
    app_driver.ready()
    choose(app_driver, "recording.record")
    assert app_driver.controller.recorder.recording
    palette = choose(app_driver, "recording.record")
    assert app_driver.controller.recorder.recording
    palette.close()
    choose(app_driver, "recording.stop")
    assert not app_driver.controller.recorder.recording


def test_a_paused_replay_of_drag_teaching_is_not_set_going(app_driver):
    app_driver.ready()
    teach = app_driver.controller.teaching.command
    teach(TeachingState.START_RECORDING)
    app_driver.run(0.2)
    app_driver.firmware.hand_guiding.lead_to((40.0, 40.0, -40.0, 0.0, 0.0, 0.0), speed_deg_s=20.0)
    app_driver.run(2.5)
    teach(TeachingState.STOP_RECORDING)
    app_driver.run(0.3)
    accepted(teach(TeachingState.RUN_RECORDING))
    app_driver.run_until(lambda: app_driver.firmware.mechanics.moving)
    app_driver.run(0.3)
    accepted(teach(TeachingState.PAUSE))
    app_driver.run_until(lambda: not app_driver.controller.operating_state.why_pending("teaching"))
    app_driver.run(0.5)
    app_driver.click("menu_light")
    app_driver.heard()
    choose(app_driver, "teaching.continue").close()
    app_driver.run(0.5)
    assert [frame.data[2] for frame in app_driver.heard() if frame.arbitration_id == 0x150] == []
    assert not app_driver.firmware.mechanics.moving
    assert targets(app_driver)["teaching.continue"].hasFocus()
