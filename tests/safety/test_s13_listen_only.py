"""S13, S1: a connection that only listens sends nothing but an operator's stop."""

from dataclasses import replace

import pytest
from PySide6.QtWidgets import QCheckBox, QTableView

from armui.control.recovery_steps import Kind
from armui.protocol.codes import LinkageRole, TrajectoryCommand
from armui.ui.dialogs.connect import ConnectDialog

STOPS = {0x150, 0x160, 0x170}


@pytest.fixture
def listening(any_bench):
    """An arm somebody else has enabled, listened to."""
    bench = any_bench
    bench.firmware.step(0.0)
    bench.said = []
    on_frame = bench.firmware.on_frame

    def hear(frame):
        bench.said.append(frame.arbitration_id)
        return on_frame(frame)

    bench.firmware.on_frame = hear
    bench.controller.connect_device(replace(bench.device, listen_only=True))
    bench.run(3.0)
    yield bench
    del bench.firmware.on_frame


def test_the_arm_is_shown_and_nothing_was_asked(listening):
    bench = listening
    assert bench.said == []
    assert bench.controller.situation.link.name == "ONLINE"
    assert bench.controller.state.angles_deg() is not None
    assert bench.controller.recovery.step.kind is Kind.LISTEN_ONLY


def test_every_command_is_refused_with_the_reason(listening):
    bench, controller = listening, listening.controller
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
    bench.run(2.0)

    assert {refusal.code for refusal in refusals} == {"listen_only"}
    assert bench.said == []


def test_the_stop_goes_out_and_nothing_else(listening):
    bench, controller = listening, listening.controller
    controller.emergency_stop()
    bench.run(1.0)

    assert set(bench.said) == STOPS
    assert bench.firmware.condition.stopped
    assert controller.halt_and_hold().code == "halt_listen_only"
    said = len(bench.said)
    controller.disconnect_device()
    bench.node.poll(0.02)
    assert len(bench.said) == said


def test_it_is_chosen_where_the_arm_is_connected(desk):
    desk.click("communication_button")
    dialog = desk.dialog(ConnectDialog)
    table = dialog.findChild(QTableView)
    desk.wait(lambda: table.model().rowCount() > 0)
    table.selectRow(0)
    desk.click(dialog.findChild(QCheckBox, "listen_only_box"))
    desk.click(dialog.connect_button)
    desk.run_until(lambda: desk.controller.situation.link.name == "ONLINE")

    assert desk.controller.situation.device.listen_only
    assert desk.controller.situation.cannot_move.code == "listen_only"
