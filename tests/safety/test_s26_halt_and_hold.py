"""S26: 停住 ends any motion with power on, and the joints hold where they come to rest."""

from dataclasses import replace

import can
import pytest
from PySide6.QtCore import Qt
from PySide6.QtTest import QTest

from armui.control.situation import StopState
from armui.protocol.codes import LinkageRole, TeachingState
from armui.protocol.frame import Frame
from armui.sim.settings import Linkage
from armui.ui.widgets.halt_button import HaltButton
from tests.control.jogger import fastest_deg_s
from tests.control.under_way import RUNS, joint_jog, motion_paused, tool_jog
from tests.faulty_arm import HardOfHearing
from tests.sim.talk import STOP, mode, ready, target, tell

ABORT = bytes.fromhex("00 06 00 00 00 00 00 00")
STEP_S = 0.002


def single_motion(bench):
    bench.controller.motion.set_speed_percent(100)
    assert bench.controller.motion.send_joints((100.0, 0.0, 0.0, 0.0, 0.0, 0.0)) is None
    bench.run(0.5)
    assert fastest_deg_s(bench) > 50


def teaching_replay(bench):
    """The arm's own recording of a hand, run by the arm itself."""
    teach = bench.controller.teaching.command
    teach(TeachingState.START_RECORDING)
    bench.run(0.1)
    bench.firmware.hand.lead_to((40.0, 40.0, -40.0, 0.0, 0.0, 0.0), speed_deg_s=20.0)
    bench.run(2.5)
    teach(TeachingState.STOP_RECORDING)
    bench.run(0.2)
    teach(TeachingState.RUN_RECORDING)
    bench.run_until(lambda: bench.firmware.status == 0x0C and bench.firmware.body.moving)


MOTIONS = {
    **RUNS,
    **{
        each.__name__: each
        for each in (single_motion, joint_jog, tool_jog, motion_paused, teaching_replay)
    },
}


@pytest.mark.parametrize("begin", MOTIONS.values(), ids=MOTIONS)
def test_it_ends_whatever_is_under_way_and_nothing_comes_back(any_bench, begin):
    bench = any_bench
    if begin not in (joint_jog, tool_jog):
        bench.ready()
    begin(bench)
    assert bench.controller.halt_and_hold() is None
    bench.run(1.0)
    assert fastest_deg_s(bench) == 0.0
    held_deg = bench.firmware.joints_deg
    assert all(bench.firmware.enabled)
    bench.run(3.0)
    assert bench.firmware.joints_deg == held_deg
    situation = bench.controller.situation
    assert not situation.running
    assert not situation.jogging
    assert not situation.holds
    assert situation.stop is StopState.RUNNING
    assert "halt_at_rest" in bench.codes()


def test_the_literal_frames_go_out_on_all_three_identifiers(bench):
    bench.ready()
    bench.heard()
    assert bench.controller.halt_and_hold() is None
    bench._settle()
    said = []
    while (message := bench._arm_bus.recv(0)) is not None:
        said.append(Frame(message.arbitration_id, bytes(message.data)))
    assert said == [Frame(each, ABORT) for each in (0x150, 0x160, 0x170)]


def test_it_reaches_an_arm_whose_control_offset_is_not_proven(any_bench):
    bench = any_bench
    bench.firmware.settings.linkage = Linkage(LinkageRole.MOTION_OUTPUT, 0x10, 0x20)
    bench.firmware._take_linkage()
    bench.controller.connect_device(bench.device)
    bench.run_until(lambda: "linkage_found" in bench.codes())
    bench.run_until(lambda: "limits_read" in bench.codes())
    assert not bench.controller.situation.control_certain
    bench.controller.motors.enable()
    bench.run_until(lambda: all(bench.firmware.enabled))
    with can.Bus(interface="virtual", channel=bench.channel) as other:
        for line in (*target(100, 0, 0, 0, 0, 0), mode(100)):
            identifier, data = line.split("#")
            other.send(
                can.Message(
                    arbitration_id=int(identifier, 16) + 0x20,
                    data=bytes.fromhex(data),
                    is_extended_id=False,
                )
            )
        bench.run(0.5)
    assert fastest_deg_s(bench) > 50
    assert bench.controller.halt_and_hold() is None
    bench.run(1.0)
    assert fastest_deg_s(bench) == 0.0
    assert all(bench.firmware.enabled)


def test_what_waits_to_be_sent_is_dropped(bench):
    bench.ready()
    held = []
    bench._host_bus.send = lambda *_args, **_kwargs: held.append(1) or _full()
    bench.controller.motion.send_joints((10.0, 0.0, 0.0, 0.0, 0.0, 0.0))
    bench.controller.halt_and_hold()
    del bench._host_bus.send
    bench.run(1.0)
    assert bench.firmware.joints_deg == (0.0,) * 6


def _full():
    raise can.CanOperationError("Transmit buffer full")


def test_refused_only_where_nothing_can_be_reached(bench):
    assert bench.controller.halt_and_hold().code == "not_connected"
    bench.device = replace(bench.device, listen_only=True)
    bench.controller.connect_device(bench.device)
    bench.run(1.0)
    assert bench.controller.halt_and_hold().code == "halt_listen_only"
    bench.controller.emergency_stop()
    bench._settle()
    said = []
    while (message := bench._arm_bus.recv(0)) is not None:
        said.append(message.arbitration_id)
    assert said == [0x150, 0x160, 0x170]  # the operator's stop is all that is ever sent


def test_an_arm_that_does_not_come_to_rest_is_said(bench):
    bench.ready()
    ear = HardOfHearing(bench.firmware)
    bench.controller.motion.set_speed_percent(20)
    bench.controller.motion.send_joints((140.0, 0.0, 0.0, 0.0, 0.0, 0.0))
    bench.run(0.5)
    ear.deaf_to = {0x150, 0x160, 0x170}
    bench.controller.halt_and_hold()
    bench.run(0.9)
    assert "cancel_unheeded" not in bench.codes()
    bench.run(0.4)
    assert bench.codes().count("cancel_unheeded") == 1


# The means: measured in the simulated arm ---------------------------------------------------------


def rest_after(arm, act):
    """Seconds from the press to rest, and degrees the joint has passed over meanwhile."""
    begin = last = arm.body.positions_deg[0]
    act()
    elapsed_s = passed_deg = 0.0
    at_rest_s = None
    while elapsed_s < 3.0:
        arm.step(STEP_S)
        elapsed_s += STEP_S
        now = arm.body.positions_deg[0]
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
        by_target, lambda: tell(by_target, *target(*by_target.body.positions_deg), mode(100))
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


def halts(desk):
    return desk.codes().count("halt_sent")


def test_the_button_and_the_key_act_on_the_press(desk):
    desk.connect_by_hand()
    desk.enable_by_hand()
    button = desk.find("halt_button")
    assert (button.text(), button.isEnabled()) == ("Halt", True)
    desk.press(button)
    assert halts(desk) == 1
    QTest.mouseRelease(button, Qt.MouseButton.LeftButton)
    assert halts(desk) == 1
    QTest.keyPress(desk.window, Qt.Key.Key_F9)
    assert halts(desk) == 2
    assert desk.firmware.stopped is False


def test_it_is_smaller_than_the_stop_and_beside_it(desk):
    halt, stop = desk.find("halt_button"), desk.find("stop_button")
    assert halt.width() < 0.7 * stop.width()
    assert 0 < stop.geometry().left() - halt.geometry().right() <= 16
    assert halt.width() >= halt.minimumSizeHint().width()


def test_dialogs_have_it(desk):
    desk.window.open_settings_dialog()
    desk.window.open_connect_dialog()
    dialogs = [dialog for dialog in desk.window._dialogs.values() if dialog.isVisible()]
    assert len(dialogs) == 2
    for dialog in dialogs:
        assert dialog.findChild(HaltButton).isVisible()


def test_chinese(desk):
    desk.store.change(language="zh")
    desk.wait(lambda: desk.find("halt_button").text() == "停住")
