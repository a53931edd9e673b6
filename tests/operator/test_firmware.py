"""An operator and what newer firmware adds: drag assistance, the gripper by angle, mounting."""

from __future__ import annotations

import json
from dataclasses import replace

import pytest
from PySide6.QtWidgets import QAbstractButton, QWidget

from armui.protocol.codes import ControlMode, MoveMode
from armui.protocol.frame import Frame
from armui.settings import SettingsStore
from armui.ui.dialogs.confirm_dialog import ConfirmDialog
from armui.ui.panels.parameters.levels_panel import DragAssistanceDialog
from tests.accepted import accepted
from tests.company import OtherHost
from tests.faulty_arm import HardOfHearing
from tests.named_version import name_version
from tests.operator.workspace.actions import rect_in_window

TODAY = "S-V1.8-9"


def sent(app_driver, arbitration_id):
    return [frame for frame in app_driver.ear.heard if frame.arbitration_id == arbitration_id]


def frame(arbitration_id, payload):
    return Frame(arbitration_id, bytes.fromhex(payload))


def settled(app_driver):
    app_driver.run_until(lambda: not app_driver.controller.settings.busy)


@pytest.fixture
def arm(app_driver):
    app_driver.connect()
    name_version(app_driver.controller, TODAY)
    app_driver.run(0.1)
    app_driver.ear = HardOfHearing(app_driver.firmware)
    return app_driver


# 拖动助力 ------------------------------------------------------------


@pytest.fixture
def assistance(arm):
    arm.click("menu_teaching")
    arm.click("drag_assistance_button")
    arm.window_of_it = arm.dialog(DragAssistanceDialog)
    settled(arm)
    return arm


def button(app_driver, name) -> QAbstractButton:
    found = app_driver.window_of_it.findChild(QAbstractButton, name)
    assert found is not None, name
    return found


def test_what_a_level_was_stands_beside_the_row_and_not_below_its_last_level(assistance):
    assistance.click(button(assistance, "drag_assistance_edit_button"))
    assistance.click(button(assistance, "drag_assistance_2_level_8"))
    note = assistance.window_of_it.findChild(QWidget, "drag_assistance_2_note")
    last = rect_in_window(button(assistance, "drag_assistance_2_level_10"))
    assert note.text() == "was 5"
    assert rect_in_window(note).left() > last.right()
    assert rect_in_window(note).center().y() == pytest.approx(last.center().y(), abs=2)


def test_it_is_read_changed_and_read_back(assistance):
    assert sent(assistance, 0x477) == [frame(0x477, "05 00 00 00 00 00 00 00")]
    assert button(assistance, "drag_assistance_3_level_5").isChecked()
    assistance.click(button(assistance, "drag_assistance_edit_button"))
    assistance.click(button(assistance, "drag_assistance_3_level_10"))
    assert sent(assistance, 0x487) == []
    assistance.click(button(assistance, "drag_assistance_save_button"))
    settled(assistance)
    # joint 3 alone; FF leaves the others
    assert sent(assistance, 0x487) == [frame(0x487, "FF FF 0A FF FF FF 00 00")]
    assert assistance.firmware.settings.drag_assistance == (5, 5, 10, 5, 5, 5)
    assert "drag_assistance" in [name for name, _joint, _value in _saved(assistance)]


def _saved(app_driver):
    return next(
        event.params["values"] for event in app_driver.events if event.code == "settings_sent"
    )


def test_one_click_sets_all_six(assistance):
    assistance.click(button(assistance, "drag_assistance_edit_button"))
    assistance.click(button(assistance, "drag_assistance_all_level_0"))
    assistance.click(button(assistance, "drag_assistance_save_button"))
    settled(assistance)
    assert assistance.firmware.settings.drag_assistance == (0,) * 6


@pytest.mark.parametrize(
    ("version", "said"),
    [("S-V1.7-4", "S-V1.7-4 does not have this: it came with S-V1.8-1"), (None, "not named")],
)
def test_older_firmware_is_not_asked(arm, version, said):
    name_version(arm.controller, version)
    arm.run(0.1)
    arm.click("menu_teaching")
    arm.click("drag_assistance_button")
    arm.window_of_it = arm.dialog(DragAssistanceDialog)
    arm.run(0.3)
    assert sent(arm, 0x477) == []
    assert not button(arm, "drag_assistance_edit_button").isEnabled()
    assert said in button(arm, "drag_assistance_edit_button").toolTip()


# 夹爪: by angle ------------------------------------------------------------


@pytest.fixture
def gripper(arm):
    arm.click("menu_gripper")
    arm.run(0.3)
    arm.ear.heard.clear()
    return arm


def test_the_gripper_is_told_an_angle_and_tells_one(gripper):
    gripper.click("gripper_by_angle")
    assert sent(gripper, 0x159) == []  # nothing moves by choosing
    gripper.type_into("gripper_angle_field", "30")
    gripper.click("gripper_send_button")
    gripper.run(0.02)
    # 30° = 30000 = 0x7530; 1 N·m = 0x3E8; enable and angle: bits 0 and 2
    assert sent(gripper, 0x159) == [frame(0x159, "00 00 75 30 03 E8 05 00")]
    gripper.run_until(lambda: "gripper_there" in gripper.codes())
    assert gripper.read("gripper_angle_measured") == "30.000°"


def test_power_is_given_in_the_measure_the_gripper_tells(gripper):
    """An angle told as an opening would move it."""
    gripper.click("gripper_by_angle")
    gripper.type_into("gripper_angle_field", "30")
    gripper.click("gripper_send_button")
    gripper.run_until(lambda: "gripper_there" in gripper.codes())
    gripper.click("gripper_by_opening")
    gripper.run(0.1)
    assert gripper.read("gripper_opening_measured") == "—"  # it tells an angle now
    accepted(gripper.controller.gripper.enable(1.0))
    gripper.run(0.02)
    assert sent(gripper, 0x159)[-1] == frame(0x159, "00 00 75 30 03 E8 05 00")


def test_back_to_openings(gripper):
    gripper.click("gripper_by_angle")
    gripper.type_into("gripper_angle_field", "30")
    gripper.click("gripper_send_button")
    gripper.run(2.0)
    gripper.click("gripper_by_opening")
    gripper.type_into("gripper_opening_field", "40")
    gripper.click("gripper_send_button")
    gripper.run(2.0)
    assert gripper.read("gripper_opening_measured") == "40.000 mm"
    assert gripper.codes().count("gripper_there") == 2


@pytest.mark.parametrize("version", ["S-V1.8-7", None])
def test_older_firmware_would_take_it_for_an_opening(gripper, version):
    name_version(gripper.controller, version)
    gripper.run(0.1)
    gripper.controller.gripper.by_angle = True
    assert not gripper.find("gripper_by_angle").isEnabled()
    assert "S-V1.8-8" in gripper.find("gripper_by_angle").toolTip()
    accepted(gripper.controller.gripper.move(30.0, 1.0))
    gripper.run(0.02)
    assert sent(gripper, 0x159) == [frame(0x159, "00 00 75 30 03 E8 01 00")]  # 30 mm


# 安装方式 ------------------------------------------------------------


@pytest.fixture
def mounting(arm):
    arm.click("menu_end_load")
    arm.run(0.2)
    arm.ear.heard.clear()
    return arm


def confirm(app_driver):
    app_driver.click("mounting_confirm_button")
    app_driver.dialog(ConfirmDialog).accept()
    app_driver.run(0.1)


@pytest.mark.parametrize(
    ("name", "code"),
    [("level", 1), ("on_the_left_side", 2), ("on_the_right_side", 3), ("upside_down", 4)],
)
def test_a_mounting_is_told_in_the_modes_the_arm_is_in_and_kept(mounting, name, code):
    mounting.click(f"mounting_{name}")
    assert sent(mounting, 0x151) == []
    confirm(mounting)
    # standby, MOVE P, 30 % = 0x1E
    assert sent(mounting, 0x151) == [frame(0x151, f"00 00 1E 00 00 0{code} 00 00")]
    key = mounting.device.arm_key(mounting.controller.state.identity.node_number)
    assert mounting.store.settings.mountings == {key: name}
    assert "does not report it back" in mounting.read("end_load_message")
    told = mounting.find("mounting_told").text()
    assert "Mounting, as last set from here" in told
    assert ("The picture" in told) is (name != "level")


def test_each_arm_has_its_own_mounting(mounting):
    """Kept by the adapter's serial number and the arm's node number."""

    def told():
        return mounting.find("mounting_told").text().splitlines()[0].rpartition(": ")[2]

    def connect(serial):
        mounting.controller.disconnect_device()
        mounting.controller.connect_device(replace(mounting.device, serial=serial))
        mounting.run_until(lambda: mounting.controller.state.identity is not None)
        mounting.run(0.5)

    assert told() == "not set from here yet"
    connect("0031")
    mounting.click("mounting_on_the_left_side")
    confirm(mounting)
    assert told() == "Left side"
    mounting.click("mounting_level")  # chosen, and not told
    connect("0042")
    assert told() == "not set from here yet"
    assert not mounting.find("mounting_level").isChecked()
    assert not mounting.find("mounting_on_the_left_side").isChecked()
    mounting.click("mounting_on_the_right_side")
    confirm(mounting)
    connect("0031")
    assert told() == "Left side"
    assert mounting.find("mounting_on_the_left_side").isChecked()
    assert mounting.store.settings.mountings == {
        "0031 / 15": "on_the_left_side",
        "0042 / 15": "on_the_right_side",
    }


def test_an_answer_that_was_cut_makes_no_other_arm_of_it(mounting):
    mounting.click("mounting_level")
    confirm(mounting)
    name_version(mounting.controller, TODAY)  # and nothing else
    mounting.run(0.3)
    assert mounting.find("mounting_told").text().endswith("Level")


@pytest.mark.parametrize("bad", [5, ["level"], {"a": "hanging"}, {"a": None}])
def test_mountings_in_a_file_that_cannot_be_are_left_out(tmp_path, bad):
    path = tmp_path / "own.json"
    path.write_text(json.dumps({"mountings": bad}))
    store = SettingsStore(path)
    assert store.settings.mountings == {}
    assert [each.params["field"] for each in store.problems] == ["mountings"]


def test_it_asks_first_and_says_what_the_arm_will_do(mounting):
    mounting.click("mounting_level")
    mounting.click("mounting_confirm_button")
    dialog = mounting.dialog(ConfirmDialog)
    assert "sink or rise" in dialog._text.text()
    dialog.reject()
    assert sent(mounting, 0x151) == []


@pytest.mark.parametrize("version", ["S-V1.8-7", None])
def test_upside_down_needs_newer_firmware(mounting, version):
    name_version(mounting.controller, version)
    mounting.run(0.1)
    mounting.click("menu_gripper")
    mounting.click("menu_end_load")
    assert not mounting.find("mounting_upside_down").isEnabled()
    assert "S-V1.8-8" in mounting.find("mounting_upside_down").toolTip()
    assert mounting.find("mounting_level").isEnabled()


@pytest.mark.parametrize("move", [MoveMode.MOVE_M, MoveMode.MOVE_M_FROM_1_8_8, MoveMode.MOVE_CPV])
def test_no_mounting_is_told_in_a_mode_of_another_host(mounting, move):
    """S25: the mode word would leave the joints limp."""
    condition = mounting.firmware.condition
    condition.control_mode, condition.move_mode = ControlMode.CAN_CONTROL, move
    mounting.run(0.5)
    mounting.click("mounting_level")
    assert not mounting.find("mounting_confirm_button").isEnabled()
    assert sent(mounting, 0x151) == []


def test_no_mounting_is_told_in_high_follow(mounting):
    host = OtherHost(mounting)
    host.say("151#010132AD00000000")
    mounting.run(3.0)
    mounting.ear.heard.clear()
    mounting.click("mounting_level")
    assert not mounting.find("mounting_confirm_button").isEnabled()
    host.close()


# The status bar ------------------------------------------------------------


@pytest.mark.parametrize(
    ("word", "said"),
    [
        ("151#010400AD00000000", "MIT by another program"),
        ("151#010600AD00000000", "MIT by another program"),
        ("151#0105320000000000", "CPV by another program"),
        ("151#010132AD00000000", "High-follow by another program"),
    ],
)
def test_the_mode_of_another_host_is_told_in_words(arm, word, said):
    accepted(arm.controller.motors.enable())
    arm.run(1.0)
    host = OtherHost(arm)
    host.say(word)
    arm.run(3.0)
    assert arm.read("status_mode") == said
    host.close()
