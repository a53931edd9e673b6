"""S26: 停住 ends any motion with power on, and the joints hold where they come to rest."""

from dataclasses import replace

import can
import pytest
from PySide6.QtCore import Qt
from PySide6.QtTest import QTest

from armui.control.link.link_state import NOT_CONNECTED
from armui.control.operating_state import StopState
from armui.control.run.progress import Run
from armui.control.safety.stopping import HALT_LISTEN_ONLY
from armui.protocol.codes import LinkageRole, MoveMode, TeachingState, TrajectoryCommand
from armui.protocol.frame import Frame
from armui.sim.parameters.settings import LinkageSettings
from armui.trajectory.points.program import GripperAngle, GripperOpening, Waypoint
from armui.ui.widgets.halt_button import HaltButton
from tests.accepted import accepted
from tests.control.jogger import fastest_deg_s
from tests.control.under_way import RUNS, joint_jog, motion_paused, tool_jog
from tests.faulty_arm import HardOfHearing
from tests.sim.talk import STOP, mode, ready, target, tell

ABORT = bytes.fromhex("00 06 00 00 00 00 00 00")
STEP_S = 0.002


def single_motion(rig):
    rig.controller.motion.set_speed_percent(100)
    accepted(rig.controller.motion.send_joints((100.0, 0.0, 0.0, 0.0, 0.0, 0.0)))
    rig.run(0.5)
    assert fastest_deg_s(rig) > 50


def teaching_replay(rig):
    """The arm's own recording of a hand, run by the arm itself."""
    teach = rig.controller.teaching.command
    teach(TeachingState.START_RECORDING)
    rig.run(0.1)
    rig.firmware.hand_guiding.lead_to((40.0, 40.0, -40.0, 0.0, 0.0, 0.0), speed_deg_s=20.0)
    rig.run(2.5)
    teach(TeachingState.STOP_RECORDING)
    rig.run(0.2)
    teach(TeachingState.RUN_RECORDING)
    rig.run_until(lambda: rig.firmware.condition.status == 0x0C and rig.firmware.mechanics.moving)


MOTIONS = {
    **RUNS,
    **{
        each.__name__: each
        for each in (single_motion, joint_jog, tool_jog, motion_paused, teaching_replay)
    },
}


@pytest.mark.each_value(full="each motion in both generations")
@pytest.mark.parametrize("begin", MOTIONS.values(), ids=MOTIONS)
def test_it_ends_whatever_is_under_way_and_nothing_comes_back(any_rig, begin):
    rig = any_rig
    if begin not in (joint_jog, tool_jog):
        rig.ready()
    begin(rig)
    assert rig.controller.halt_and_hold() is None
    rig.run(1.0)
    assert fastest_deg_s(rig) == 0.0
    held_deg = rig.firmware.joints_deg
    assert all(rig.firmware.enabled)
    rig.run(3.0)
    assert rig.firmware.joints_deg == held_deg
    operating_state = rig.controller.operating_state
    assert not operating_state.running
    assert not operating_state.jogging
    assert not operating_state.holds
    assert operating_state.stop is StopState.RUNNING
    assert "halt_at_rest" in rig.codes()


@pytest.mark.each_value(full="each end in both generations")
@pytest.mark.parametrize("end", ["halt", "stop"])
def test_a_pause_of_the_arms_own_recording_is_not_told_again_after_it(any_rig, end):
    """The arm misses the pause (0x150 byte 2 = 4), which is repeated after 0.5 s else."""
    rig, controller = any_rig, any_rig.controller
    rig.ready()
    teaching_replay(rig)
    rig.node.link.lose_to_arm(0x150)
    accepted(controller.teaching.command(TeachingState.PAUSE))
    rig.step()
    rig.heard()
    if end == "halt":
        assert controller.halt_and_hold() is None
    else:
        controller.emergency_stop()
    rig.run(2.0)
    sent = [frame.data[2] for frame in rig.heard() if frame.arbitration_id == 0x150]
    assert TeachingState.PAUSE not in sent
    assert controller.teaching.pending is None


def test_the_literal_frames_go_out_on_all_three_identifiers(rig):
    rig.ready()
    rig.heard()
    assert rig.controller.halt_and_hold() is None
    rig._settle()
    said = []
    while (message := rig._arm_bus.recv(0)) is not None:
        said.append(Frame(message.arbitration_id, bytes(message.data)))
    assert said == [Frame(each, ABORT) for each in (0x150, 0x160, 0x170)]


def test_it_reaches_an_arm_whose_control_offset_is_not_proven(any_rig):
    rig = any_rig
    rig.firmware.settings.linkage = LinkageSettings(LinkageRole.MOTION_OUTPUT, 0x10, 0x20)
    rig.firmware._linkage.take_effect()
    rig.controller.connect_device(rig.device)
    rig.run_until(lambda: "linkage_found" in rig.codes())
    rig.run_until(lambda: "limits_read" in rig.codes())
    assert not rig.controller.operating_state.control_certain
    rig.controller.motors.enable()
    rig.run_until(lambda: all(rig.firmware.enabled))
    with can.Bus(interface="virtual", channel=rig.channel) as other:
        for line in (*target(100, 0, 0, 0, 0, 0), mode(100)):
            identifier, data = line.split("#")
            other.send(
                can.Message(
                    arbitration_id=int(identifier, 16) + 0x20,
                    data=bytes.fromhex(data),
                    is_extended_id=False,
                )
            )
        rig.run(0.5)
    assert fastest_deg_s(rig) > 50
    assert rig.controller.halt_and_hold() is None
    rig.run(1.0)
    assert fastest_deg_s(rig) == 0.0
    assert all(rig.firmware.enabled)


def test_what_waits_to_be_sent_is_dropped(rig):
    rig.ready()
    held = []

    def hold_up(*_args, **_kwargs):
        held.append(1)
        _full()

    rig._host_bus.send = hold_up
    rig.controller.motion.send_joints((10.0, 0.0, 0.0, 0.0, 0.0, 0.0))
    rig.controller.halt_and_hold()
    del rig._host_bus.send
    rig.run(1.0)
    assert rig.firmware.joints_deg == (0.0,) * 6


def _full():
    raise can.CanOperationError("Transmit buffer full")


def test_refused_only_where_nothing_can_be_reached(rig):
    assert rig.controller.halt_and_hold().reason == NOT_CONNECTED
    rig.device = replace(rig.device, listen_only=True)
    rig.controller.connect_device(rig.device)
    rig.run(1.0)
    assert rig.controller.halt_and_hold().reason == HALT_LISTEN_ONLY
    rig.controller.emergency_stop()
    rig._settle()
    said = []
    while (message := rig._arm_bus.recv(0)) is not None:
        said.append(message.arbitration_id)
    assert said == [0x150, 0x160, 0x170]  # the operator's stop is all that is ever sent


def test_an_arm_that_does_not_come_to_rest_is_said(rig):
    rig.ready()
    ear = HardOfHearing(rig.firmware)
    rig.controller.motion.set_speed_percent(20)
    rig.controller.motion.send_joints((140.0, 0.0, 0.0, 0.0, 0.0, 0.0))
    rig.run(0.5)
    ear.deaf_to = {0x150, 0x160, 0x170}
    rig.controller.halt_and_hold()
    rig.run(0.9)
    assert "cancel_unheeded" not in rig.codes()
    rig.run(0.4)
    assert rig.codes().count("cancel_unheeded") == 1


# The means: measured in the simulated arm ---------------------------------------------------------


def rest_after(arm, act):
    """Seconds from the press to rest, and degrees the joint has passed over meanwhile."""
    begin = last = arm.mechanics.positions_deg[0]
    act()
    elapsed_s = passed_deg = 0.0
    at_rest_s = None
    while elapsed_s < 3.0:
        arm.step(STEP_S)
        elapsed_s += STEP_S
        now = arm.mechanics.positions_deg[0]
        passed_deg = max(passed_deg, abs(now - begin))
        if abs(now - last) > 1e-6:
            at_rest_s = None
        elif at_rest_s is None:
            at_rest_s = elapsed_s
        last = now
    return at_rest_s, passed_deg


def at_full_speed(generation):
    arm = ready(generation)
    tell(arm, *target(140, 0, 0, 0, 0, 0), mode(100))
    for _ in range(450):
        arm.step(STEP_S)
    return arm


def test_no_other_means_is_faster(generation):
    by_abort = at_full_speed(generation)
    abort_s, abort_deg = rest_after(by_abort, lambda: tell(by_abort, "150#0006000000000000"))
    by_target = at_full_speed(generation)
    back_s, back_deg = rest_after(
        by_target, lambda: tell(by_target, *target(*by_target.mechanics.positions_deg), mode(100))
    )
    by_pause = at_full_speed(generation)
    pause_s, pause_deg = rest_after(by_pause, lambda: tell(by_pause, "150#0001000000000000"))
    # from 148°/s with 5 rad/s²: the drivers' own limit, and no way round it with power on
    assert (abort_s, abort_deg) == pytest.approx((0.518, 37.9), rel=0.01)
    # a target where the arm just was is passed as far, and driven back to
    assert back_s > 2 * abort_s
    assert back_deg == pytest.approx(abort_deg, abs=0.1)
    # a pause is as fast, and keeps a target that would come back
    assert (pause_s, pause_deg) == pytest.approx((abort_s, abort_deg))
    assert all(by_abort.enabled)


def test_the_stop_stays_the_stop(generation):
    arm = at_full_speed(generation)
    tell(arm, STOP)
    arm.step(STEP_S)
    assert not any(arm.enabled)


# At hand ------------------------------------------------------------------------------------------


def halts(app_driver):
    return app_driver.codes().count("halt_sent")


def test_the_button_and_the_key_act_on_the_press(app_driver):
    app_driver.connect_by_hand()
    app_driver.enable_by_hand()
    button = app_driver.find("halt_button")
    assert (button.text(), button.isEnabled()) == ("Halt", True)
    app_driver.press(button)
    assert halts(app_driver) == 1
    QTest.mouseRelease(button, Qt.MouseButton.LeftButton)
    assert halts(app_driver) == 1
    QTest.keyPress(app_driver.window, Qt.Key.Key_F9)
    assert halts(app_driver) == 2
    assert app_driver.firmware.condition.stopped is False


@pytest.mark.styled
def test_it_is_smaller_than_the_stop_and_beside_it(app_driver):
    halt, stop = app_driver.find("halt_button"), app_driver.find("stop_button")
    assert halt.width() < 0.7 * stop.width()
    assert 0 < stop.geometry().left() - halt.geometry().right() <= 16
    assert halt.width() >= halt.minimumSizeHint().width()


def test_dialogs_have_it(app_driver):
    app_driver.window.pages.show("settings")
    app_driver.window.pages.show("connect")
    dialogs = [dialog for dialog in app_driver.window.pages._windows.values() if dialog.isVisible()]
    assert len(dialogs) == 2
    for dialog in dialogs:
        assert dialog.findChild(HaltButton).isVisible()


def test_chinese(app_driver):
    app_driver.store.change(language="zh")
    app_driver.wait(lambda: app_driver.find("halt_button").text() == "停住")


@pytest.mark.each_value(full="each way in both generations")
@pytest.mark.parametrize("way", ["move", "close"])
def test_a_gripper_under_way_ends_where_it_is(any_rig, way):
    """It closes on whatever lies between its fingers: who halts the arm means it, too."""
    rig = any_rig
    rig.ready()
    gripper, control = rig.firmware.gripper, rig.controller.gripper
    accepted(control.move(60.0, 1.0))
    if way == "close":
        rig.run_until(lambda: "gripper_there" in rig.codes(), seconds=20.0)
        accepted(control.move_to_end(opened=False))
    rig.run_until(lambda: 10.0 < gripper.travel < 40.0, seconds=10.0)
    assert rig.controller.halt_and_hold() is None
    at_halt = gripper.travel
    rig.run(2.0)
    assert gripper.travel == pytest.approx(at_halt, abs=5.0)
    assert gripper.enabled
    (told,) = [each for each in rig.events if each.code == "gripper_held"]
    assert told.params["value"] == pytest.approx(at_halt, abs=5.0)


@pytest.mark.each_value(full="each way in both generations")
@pytest.mark.parametrize("way", ["end", "clear", "end of a run"])
def test_the_end_of_a_motion_is_that_of_a_gripper_under_way(any_rig, way):
    rig = any_rig
    rig.ready()
    control, gripper = rig.controller, rig.firmware.gripper
    if way == "end of a run":
        by_angle = control.state.gripper.value.opening_mm is None
        wide = GripperAngle(60.0) if by_angle else GripperOpening(60.0)
        point = Waypoint(MoveMode.MOVE_J, (0.0,) * 6, gripper=wide, dwell_s=5.0)
        accepted(control.player.start(Run("wide", (point,), (1.0,))))
    else:
        accepted(control.gripper.move(60.0, 1.0))
    rig.run_until(lambda: 10.0 < gripper.travel < 40.0, seconds=10.0)
    if way == "end of a run":
        control.player.stop()
    else:
        ends = TrajectoryCommand.ABORT if way == "end" else TrajectoryCommand.CLEAR_ALL
        accepted(control.planned_motion.command(ends))
    at_end = gripper.travel
    rig.run(2.0)
    assert gripper.travel == pytest.approx(at_end, abs=5.0)
    assert gripper.enabled


def test_a_gripper_that_stands_is_told_nothing(any_rig):
    rig = any_rig
    rig.ready()
    rig.heard()
    assert rig.controller.halt_and_hold() is None
    rig.run(0.5)
    assert 0x159 not in {frame.arbitration_id for frame in rig.heard()}


@pytest.mark.parametrize("halts", [1, 3])
def test_a_gripper_whose_report_is_late_is_not_sent_back_to_where_it_was(rig, halts):
    rig.ready()
    gripper = rig.firmware.gripper
    accepted(rig.controller.gripper.move(60.0, 1.0))
    rig.run_until(lambda: gripper.travel > 20.0, seconds=10.0)
    rig.node.link.mute_on.add(0x2A8)
    rig.run(0.2)
    at_halt = gripper.travel
    for _ in range(halts):
        assert rig.controller.halt_and_hold() is None
    rig.run(0.1)
    assert gripper.travel > at_halt
    rig.node.link.mute_on.clear()
    rig.run(0.04)
    heard_at = gripper.travel
    rig.run(2.0)
    assert gripper.travel == pytest.approx(heard_at, abs=3.0)
    assert gripper.travel > at_halt


def test_what_a_run_sends_the_gripper_to_is_not_ended_by_a_halt_of_before(rig):
    rig.ready()
    accepted(rig.controller.gripper.move(60.0, 1.0))
    rig.run_until(lambda: rig.firmware.gripper.travel > 20.0, seconds=10.0)
    rig.node.link.mute_on.add(0x2A8)
    rig.run(0.2)
    assert rig.controller.halt_and_hold() is None
    rig.controller.gripper.note_travel(60.0, 1.0)
    rig.node.link.mute_on.clear()
    rig.heard()
    rig.run(0.2)
    assert 0x159 not in {frame.arbitration_id for frame in rig.heard()}
