"""An operator breaks the simulated arm by the buttons, and mends it; a real arm is left alone."""

import socket
from dataclasses import replace

import pytest

from armui.protocol.frame_records import RECORD_BYTES, unpack
from armui.protocol.generation import Generation
from armui.sim.arm_choice import HAND, ArmChoice
from armui.sim.arm_process import LineHand
from armui.sim.faults.schedule import FAULTS, Fault, FaultParameter, fault
from armui.sim.line_arm import LineArm
from armui.system.record_socket import RecordSocket
from armui.ui import words
from armui.ui.dialogs.connect import ConnectDialog
from armui.ui.dialogs.doctor import judge_connected
from armui.ui.dialogs.settings import SettingsDialog
from armui.ui.dialogs.simulated_faults import _ONCE, AT_A_JOINT, OF_THE_ARM, FaultsDialog

REASON = "Only a simulated arm has them: connect one."


@pytest.fixture
def online(app_driver):
    app_driver.connect()
    return app_driver


@pytest.fixture
def ready(app_driver):
    app_driver.ready()
    return app_driver


def opened(app_driver):
    """The window, by the way that an operator sees."""
    app_driver.window.pages.show("settings")
    settings = app_driver.dialog(SettingsDialog)
    assert settings.faults_button.isEnabled()
    app_driver.click(settings.faults_button)
    settings.close()
    return app_driver.dialog(FaultsDialog)


def offered(app_driver):
    """Its row in the palette."""
    items = app_driver.window.window_actions.palette_items().now()
    return next(each for each in items if each.command.name == "window.faults")


def test_the_faults_of_a_joint_and_of_the_arm_stand_in_the_same_columns(online):
    dialog = opened(online)
    places = [{dialog.switches[n].x() for n in faults} for faults in (AT_A_JOINT, OF_THE_ARM)]
    assert places[0] == places[1]
    assert len(places[0]) == 3


def test_a_hot_motor_is_warned_of_until_it_is_let_cool(ready):
    dialog = opened(ready)
    dialog.joint_box.setCurrentIndex(1)
    button = dialog.switches["motor-overtemperature"]
    ready.click(button)
    assert dialog._message.text() == "On: Motor too hot J2"
    ready.run(0.5)
    assert "Too hot, joint 2: 95 °C" in ready.read("recovery_text")
    dialog.joint_box.setCurrentIndex(0)
    assert not button.isChecked()  # joint 1 is cool
    dialog.joint_box.setCurrentIndex(1)
    assert button.isChecked()
    ready.click(button)
    assert dialog._message.text() == "Pressed, a fault begins; pressed again, it ends."
    ready.run_until(lambda: "Too hot" not in ready.read("recovery_text"), seconds=120.0)


@pytest.mark.parametrize("name", ["bus-off", "feedback-stopped"])
def test_a_silent_arm_is_offline_until_it_speaks_again(ready, name):
    button = opened(ready).switches[name]
    ready.click(button)
    ready.run(0.6)
    assert "Offline" in ready.find("communication_button").accessibleName()
    assert button.isEnabled()  # or nothing brought it back
    assert button.isChecked()
    ready.click(button)
    ready.run_until(lambda: ready.controller.operating_state.cannot_move is None)
    assert "Online" in ready.find("communication_button").accessibleName()


def test_a_deaf_adapter_is_told_from_a_silent_arm(ready):
    dialog = opened(ready)
    ready.click(dialog.switches["deaf-adapter"])
    ready.node.heard.clear()
    ready.run(4.0)
    assert not ready.node.heard  # an arm that was heard is not asked
    ready.controller.emergency_stop()
    ready.run(0.5)
    assert 0x150 in {each.arbitration_id for each in ready.node.heard}
    assert "bus_deaf" in [each.code for each in ready.events]
    ready.click(dialog.switches["deaf-adapter"])
    ready.run(1.0)
    assert "deaf" not in ready.read("recovery_text")
    codes = [each.code for each in ready.events]
    assert [codes.count(code) for code in ("bus_deaf", "bus_hears")] == [1, 1]


def test_an_adapter_that_is_deaf_from_the_beginning(app_driver):
    app_driver.node.faults.start(fault("deaf-adapter"))
    app_driver.window.pages.show("connect")
    app_driver.controller.connect_device(app_driver.device)
    app_driver.run(4.0)
    assert app_driver.heard() == []  # nothing was commanded: only asked
    assert [each.arbitration_id for each in app_driver.node.heard] == [0x472] * 3
    assert "hears nothing, not even errors" in app_driver.read("recovery_text")
    reason = app_driver.controller.operating_state.link_problem
    assert "is deaf: it has sent 3 frames, heard none" in words.refusal(reason)
    dialog = app_driver.dialog(ConnectDialog)
    assert words.refusal(reason) in dialog._message.text()
    found = judge_connected(app_driver.controller, frames=0, seconds=2.0)
    assert [each.code for each in found] == ["bus_deaf"]


def test_a_silent_arm_that_answers_is_not_called_deaf(app_driver):
    app_driver.node.faults.start(fault("feedback-stopped"))
    app_driver.controller.connect_device(app_driver.device)
    app_driver.run(5.0)
    assert [each.arbitration_id for each in app_driver.node.heard].count(0x472) >= 1
    assert app_driver.controller.operating_state.link_problem is None
    assert "Nothing is heard from the arm" in app_driver.read("recovery_text")


def test_switched_off_and_on_it_starts_anew(ready):
    button = opened(ready).switches["power-off"]
    ready.click(button)
    ready.run(0.6)
    assert "Offline" in ready.find("communication_button").accessibleName()
    ready.click(button)
    ready.run_until(lambda: ready.controller.operating_state.enabled == (False,) * 6)


def test_what_happens_once_may_happen_again(ready):
    dialog = opened(ready)
    dialog.joint_box.setCurrentIndex(3)
    ready.click(dialog.switches["corrupt-limits"])
    assert not dialog.switches["corrupt-limits"].isChecked()
    assert ready.node.faults.active == []


def test_no_frame_is_sent_for_any_of_them(online):
    dialog = opened(online)
    online.run(0.5)
    online.heard()
    for button in dialog.switches.values():
        online.click(button)
    assert online.heard() == []
    assert len(online.hand.faults) == len(FAULTS) - len(_ONCE)


def test_a_real_arm_is_left_alone(app_driver):
    """As one is connected while the window is open; and no other way leads there, either."""
    app_driver.window.pages.show("simulated")
    app_driver.device = replace(app_driver.device, simulated=False)
    app_driver.ready()
    dialog = app_driver.dialog(FaultsDialog)
    assert dialog._message.text() == REASON
    for name, button in dialog.switches.items():
        assert not button.isEnabled()
        assert button.toolTip() == REASON
        dialog._on_switch(name)  # as a click under way would
    assert app_driver.hand.faults == set()
    assert app_driver.node.faults.active == []
    assert offered(app_driver).reason == REASON
    app_driver.window.pages.show("settings")
    button = app_driver.dialog(SettingsDialog).faults_button
    assert not button.isEnabled()
    assert button.toolTip() == REASON


def test_the_palette_offers_them_with_a_simulated_arm_alone(app_driver):
    assert offered(app_driver).reason == REASON
    app_driver.connect()
    assert offered(app_driver).reason == ""


def test_every_fault_there_is_has_a_button():
    at_a_joint = {name for name, it in FAULTS.items() if it.parameter is FaultParameter.JOINT}
    assert set(AT_A_JOINT) == at_a_joint
    assert set(OF_THE_ARM) == set(FAULTS) - at_a_joint


def test_the_hand_of_another_process_breaks_the_arm_there_by_its_own_line():
    (frames, there), (hands, hand_there) = socket.socketpair(), socket.socketpair()
    line, hand = RecordSocket(frames, RECORD_BYTES), LineHand(RecordSocket(hands, HAND.size))
    theirs = RecordSocket(there, RECORD_BYTES), RecordSocket(hand_there, HAND.size)
    arm = LineArm(ArmChoice(Generation.TWO), *theirs)
    for name in FAULTS:
        hand.switch(name, 3 if name in AT_A_JOINT else 0, begins=True)
    hand.switch("bus-off", 0, begins=False)
    arm.poll(0.02)
    own = {name: 3.0 if name in AT_A_JOINT else it.default for name, it in FAULTS.items()}
    assert arm.faults.active == [Fault(*each) for each in own.items() if each[0] != "bus-off"]
    assert arm.received == 0  # nothing of it came as a frame
    for name, joint in tuple(hand.faults):
        hand.switch(name, joint, begins=False)
    arm.poll(0.02)
    assert (arm.faults.active, hand.faults) == ([], set())
    arm.poll(0.1)
    assert unpack(line.receive())
    for each in (line, hand._line, *theirs):
        each.close()
