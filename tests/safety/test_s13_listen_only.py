"""S13, S1: a connection that only listens sends nothing but an operator's stop."""

from dataclasses import replace

import pytest
from PySide6.QtWidgets import QCheckBox, QTableView

from armui.control.link.link_state import LISTEN_ONLY
from armui.control.safety.recovery_steps import StepKind
from armui.control.safety.stopping import HALT_LISTEN_ONLY
from armui.protocol.codes import LinkageRole, TrajectoryCommand
from armui.ui.dialogs.connect import ConnectDialog

STOPS = {0x150, 0x160, 0x170}


@pytest.fixture
def listening(any_rig):
    """An arm somebody else has enabled, listened to."""
    rig = any_rig
    rig.firmware.step(0.0)
    rig.said = []
    on_frame = rig.firmware.on_frame

    def hear(frame):
        rig.said.append(frame.arbitration_id)
        return on_frame(frame)

    rig.firmware.on_frame = hear
    rig.controller.connect_device(replace(rig.device, listen_only=True))
    rig.run(3.0)
    yield rig
    del rig.firmware.on_frame


def test_the_arm_is_shown_and_nothing_was_asked(listening):
    rig = listening
    assert rig.said == []
    assert rig.controller.operating_state.link.name == "ONLINE"
    assert rig.controller.state.angles_deg() is not None
    assert rig.controller.recovery.step.kind is StepKind.LISTEN_ONLY


def test_every_command_is_refused_with_the_reason(listening):
    rig, controller = listening, listening.controller
    refusals = [
        controller.motion.jog(6, 1.0),
        controller.motion.go_home(),
        controller.motors.enable(),
        controller.motors.disable(),
        controller.zeroing.set_zero(1),
        controller.linkage.set(LinkageRole.MOTION_OUTPUT),
        controller.planned_motion.command(TrajectoryCommand.ABORT),
    ]
    controller.motion.set_speed_percent(80)
    rig.run(2.0)

    assert {refusal.code for refusal in refusals} == {"listen_only"}
    assert rig.said == []


def test_the_stop_goes_out_and_nothing_else(listening):
    rig, controller = listening, listening.controller
    controller.emergency_stop()
    rig.run(1.0)

    assert set(rig.said) == STOPS
    assert rig.firmware.condition.stopped
    assert controller.halt_and_hold().reason == HALT_LISTEN_ONLY
    said = len(rig.said)
    controller.disconnect_device()
    rig.node.poll(0.02)
    assert len(rig.said) == said


def test_it_is_chosen_where_the_arm_is_connected(app_driver):
    app_driver.click("communication_button")
    dialog = app_driver.dialog(ConnectDialog)
    table = dialog.findChild(QTableView)
    app_driver.wait(lambda: table.model().rowCount() > 0)
    table.selectRow(0)
    app_driver.click(dialog.findChild(QCheckBox, "listen_only_box"))
    app_driver.click(dialog.connect_button)
    app_driver.run_until(lambda: app_driver.controller.operating_state.link.name == "ONLINE")

    assert app_driver.controller.operating_state.device.listen_only
    assert app_driver.controller.operating_state.cannot_move.reason == LISTEN_ONLY
