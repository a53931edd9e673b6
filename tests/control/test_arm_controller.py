"""The controller against the simulated arm: what the arm receives, what the operator is told."""

import errno
import threading

import can
import pytest

from armui.arm.device import Device
from armui.arm.figures import FIGURE_NOT_WHOLE, WHOLE_OUT_OF_RANGE
from armui.arm.limits import JOINT_NOT_A_NUMBER
from armui.control.devices.motors import NOT_STOPPED
from armui.control.link.link_state import LINK_LOST, NOT_CONNECTED, OFFLINE, LinkState
from armui.control.operating_state import BUSY, StopState
from armui.control.safety.interlocks import NOT_ENABLED, SPEED_ZERO, STOPPED
from armui.protocol.codes import ControlMode
from armui.protocol.frame import Frame
from armui.protocol.generation import Generation
from tests.accepted import accepted
from tests.moments import now

STOP = Frame(0x150, bytes.fromhex("01 00 00 00 00 00 00 00"))
RESUME = Frame(0x150, bytes.fromhex("02 00 00 00 00 00 00 00"))
ENABLE = Frame(0x471, bytes.fromhex("07 02 00 00 00 00 00 00"))
DISABLE = Frame(0x471, bytes.fromhex("07 01 00 00 00 00 00 00"))


def angles(rig):
    return [round(angle, 3) for angle in rig.firmware.joints_deg]


def test_without_a_device_everything_is_refused_and_says_so(rig):
    assert rig.controller.operating_state.link is LinkState.NO_DEVICE
    assert rig.controller.motion.jog(1, 1.0).reason == NOT_CONNECTED
    assert rig.controller.motors.enable().reason == NOT_CONNECTED
    assert rig.controller.motion.send_joints([0] * 6).reason == NOT_CONNECTED
    rig.controller.emergency_stop()
    assert rig.codes()[-1] == "stop_not_sent"


def test_connecting_finds_the_generation_and_reads_the_limits(any_rig):
    any_rig.connect()
    operating_state = any_rig.controller.operating_state
    assert operating_state.link is LinkState.ONLINE
    assert operating_state.generation is any_rig.firmware.generation
    assert operating_state.limits_read == (True,) * 6
    assert (operating_state.limits[1].min_deg, operating_state.limits[1].max_deg) == (0, 180)
    firmware = any_rig.controller.state.firmware
    assert firmware == ("S-V1.8-9" if operating_state.generation is Generation.TWO else None)


def test_connecting_moves_and_enables_nothing(any_rig):
    any_rig.connect()
    any_rig.run(0.5)
    assert any_rig.heard() == []
    assert any_rig.firmware.enabled == (False,) * 6


def test_enable_and_disable_are_over_when_the_drivers_say_so(any_rig):
    rig = any_rig
    rig.connect()
    assert rig.controller.operating_state.enabled == (False,) * 6
    accepted(rig.controller.motors.enable())
    assert rig.controller.motion.jog(1, 1.0).reason == BUSY
    rig.run_until(lambda: "enabled" in rig.codes())
    assert rig.controller.operating_state.enabled == (True,) * 6
    assert rig.heard()[0] == ENABLE
    accepted(rig.controller.motors.disable())
    rig.run_until(lambda: "disabled" in rig.codes())
    assert rig.heard()[0] == DISABLE
    assert rig.controller.motion.jog(1, 1.0).reason == NOT_ENABLED


def test_six_angles_are_sent_as_the_protocol_says_and_reached(any_rig):
    rig = any_rig
    rig.ready()
    rig.heard()
    accepted(rig.controller.motion.send_joints([12, 30, -20, 5, -5, 60]))
    rig.step()
    assert rig.heard() == [
        Frame(0x155, bytes.fromhex("00002EE0 00007530")),  # 12000, 30000
        Frame(0x156, bytes.fromhex("FFFFB1E0 00001388")),  # -20000, 5000
        Frame(0x157, bytes.fromhex("FFFFEC78 0000EA60")),  # -5000, 60000
        Frame(0x151, bytes.fromhex("01 01 1E 00 00 00 00 00")),  # CAN control, MOVE J, 30 %
    ]
    rig.run_until(lambda: rig.controller.operating_state.moving)
    rig.run_until(lambda: not rig.controller.operating_state.moving)
    assert angles(rig) == [12, 30, -20, 5, -5, 60]
    assert rig.controller.state.angles_deg() == (12, 30, -20, 5, -5, 60)


def test_home_is_all_zeros(rig):
    rig.ready()
    rig.controller.motion.send_joints([10, 20, -20, 0, 0, 0])
    rig.run_until(lambda: angles(rig)[0] == 10)
    accepted(rig.controller.motion.go_home())
    rig.run_until(lambda: angles(rig) == [0] * 6)
    assert "went_home" in rig.codes()


def test_a_jog_moves_one_joint_by_one_step(rig):
    rig.ready()
    accepted(rig.controller.motion.jog(2, 1.0))
    rig.run_until(lambda: angles(rig)[1] == 1)
    rig.run(0.2)
    accepted(rig.controller.motion.jog(2, 0.5))
    rig.run_until(lambda: angles(rig)[1] == 1.5)
    assert angles(rig) == [0, 1.5, 0, 0, 0, 0]


def test_steps_add_up_while_the_arm_is_still_moving(rig):
    rig.ready()
    for _ in range(5):
        accepted(rig.controller.motion.jog(1, 2.0))
        rig.step()
    rig.run_until(lambda: angles(rig)[0] == 10)
    assert angles(rig) == [10, 0, 0, 0, 0, 0]


def test_a_held_button_waits_for_an_arm_that_lags(rig):
    rig.ready()
    assert not rig.controller.motion.jog_lagging(1, 5.0)
    for _ in range(3):
        rig.controller.motion.jog(1, 5.0)
    assert rig.controller.motion.jog_lagging(1, 5.0)
    rig.run_until(lambda: angles(rig)[0] == 15)
    rig.run(0.1)
    assert not rig.controller.motion.jog_lagging(1, 5.0)


@pytest.mark.parametrize(
    ("delta_deg", "code"), [(-0.001, "jog_at_limit"), (181.0, "step_beyond_limit")]
)
def test_a_jog_beyond_the_limits_is_refused_and_nothing_is_sent(rig, delta_deg, code):
    rig.ready()
    rig.heard()
    refusal = rig.controller.motion.jog(2, delta_deg)
    assert (refusal.code, refusal.params["joint"]) == (code, 2)
    rig.step()
    assert rig.heard() == []


def test_angles_beyond_the_limits_are_refused_and_nothing_is_sent(rig):
    rig.ready()
    rig.heard()
    refusal = rig.controller.motion.send_joints([0, 0, 0, 0, 70.001, 0])
    assert refusal.params == {"joint": 5, "value": 70.001, "minimum": -70, "maximum": 70}
    assert rig.controller.motion.send_joints([float("nan")] * 6).reason == JOINT_NOT_A_NUMBER
    rig.step()
    assert rig.heard() == []


def test_the_speed_goes_to_the_arm_in_the_mode_it_is_in(rig):
    rig.ready()
    rig.heard()
    accepted(rig.controller.motion.set_speed_percent(55))
    rig.step()
    assert rig.heard() == [Frame(0x151, bytes.fromhex("00 00 37 00 00 00 00 00"))]  # standby
    rig.controller.motion.jog(1, 1.0)
    rig.run_until(lambda: rig.firmware.condition.control_mode is ControlMode.CAN_CONTROL)
    rig.run(0.1)
    rig.heard()
    rig.controller.motion.set_speed_percent(80)
    rig.step()
    assert rig.heard() == [Frame(0x151, bytes.fromhex("01 01 50 00 00 00 00 00"))]
    assert rig.firmware.condition.speed_percent == 80


@pytest.mark.parametrize(
    ("percent", "reason"),
    [(-1, WHOLE_OUT_OF_RANGE), (255, WHOLE_OUT_OF_RANGE), (1.5, FIGURE_NOT_WHOLE)],
)
def test_an_impossible_speed_is_refused(rig, percent, reason):
    rig.connect()
    assert rig.controller.motion.set_speed_percent(percent).reason == reason
    assert rig.controller.operating_state.speed_percent == 30


def test_at_zero_percent_a_motion_is_refused(rig):
    rig.ready()
    rig.controller.motion.set_speed_percent(0)
    assert rig.controller.motion.go_home().reason == SPEED_ZERO


def test_stop_resume_enable_and_on(any_rig):
    rig = any_rig
    rig.ready()
    rig.controller.motion.send_joints([90, 90, -90, 0, 0, 0])
    rig.run(0.5)
    rig.heard()
    rig.controller.emergency_stop()
    assert now(rig.controller.operating_state.stop) is StopState.REQUESTED
    assert rig.heard() == [STOP]  # on the bus before emergency_stop() came back
    rig.run_until(lambda: rig.controller.operating_state.stop is StopState.STOPPED)
    assert rig.firmware.condition.stopped
    assert rig.codes()[-1] == "stop_confirmed"
    assert rig.controller.motion.jog(1, 1.0).reason == STOPPED
    assert rig.controller.motors.enable().reason == STOPPED

    accepted(rig.controller.motors.resume())
    rig.run_until(lambda: rig.controller.operating_state.stop is StopState.RUNNING)
    assert rig.heard()[0] == RESUME
    assert not rig.firmware.condition.stopped
    rig.run(0.3)  # the slow driver feedback has to come round
    assert rig.controller.motion.jog(1, 1.0).reason == NOT_ENABLED

    before = angles(rig)
    accepted(rig.controller.motors.enable())
    rig.run_until(lambda: rig.controller.operating_state.cannot_move is None)
    rig.run(0.5)
    assert angles(rig)[0] == before[0]  # the old target is forgotten


def test_a_stop_drops_what_was_about_to_be_sent(rig):
    rig.ready()
    rig.heard()
    rig.controller.motion.send_joints([10, 10, -10, 0, 0, 0])
    rig.controller.emergency_stop()
    rig.run(0.3)
    frames = rig.heard()
    after_stop = frames[frames.index(STOP) :]
    assert set(after_stop) == {STOP}
    assert rig.firmware.condition.stopped


def test_a_stop_is_repeated_until_the_arm_confirms_it(rig):
    rig.ready()
    rig.heard()
    rig.powered = False
    rig.controller.emergency_stop()
    rig.run(0.7)
    assert rig.controller.operating_state.stop_unconfirmed
    assert "stop_unconfirmed" in rig.codes()
    assert rig.heard().count(STOP) >= 6
    rig.powered = True
    rig.run_until(lambda: rig.controller.operating_state.stop is StopState.STOPPED)
    assert not rig.controller.operating_state.stop_unconfirmed


def test_resume_is_refused_unless_the_arm_is_stopped(rig):
    rig.ready()
    assert rig.controller.motors.resume().reason == NOT_STOPPED


def test_a_silent_arm_is_offline_after_half_a_second_and_moves_no_more(rig):
    rig.ready()
    rig.powered = False
    rig.run(0.44)
    assert now(rig.controller.operating_state.link) is LinkState.ONLINE
    rig.run(0.12)
    assert now(rig.controller.operating_state.link) is LinkState.OFFLINE
    assert rig.controller.operating_state.enabled == (None,) * 6
    assert rig.controller.motion.jog(1, 1.0).reason == OFFLINE
    rig.powered = True
    rig.run_until(lambda: rig.controller.operating_state.link is LinkState.ONLINE)
    assert rig.codes().count("online") == 2


def test_a_stopped_arm_that_falls_silent_can_be_stopped_again_not_resumed(rig):
    rig.ready()
    rig.controller.emergency_stop()
    rig.run_until(lambda: rig.controller.operating_state.stop is StopState.STOPPED)
    rig.powered = False
    rig.run(0.6)
    assert rig.controller.operating_state.stop is StopState.RUNNING
    assert rig.controller.motors.resume().reason == NOT_STOPPED
    rig.heard()
    rig.controller.emergency_stop()
    assert rig.heard() == [STOP]


def test_coming_back_online_is_told_once_and_the_limits_are_read_anew(rig):
    rig.ready()
    rig.powered = False
    rig.run(0.6)
    assert rig.codes()[-1] == "offline"
    rig.powered = True
    rig.run_until(lambda: rig.codes().count("limits_read") == 2)
    rig.run(0.5)
    assert rig.codes().count("limits_read") == 2


def test_an_unplugged_device_is_told_and_taken_up_again(rig, qtbot):
    rig.ready()
    rig.heard()
    rig.unplug(can.CanOperationError("gone", error_code=errno.ENODEV))
    qtbot.waitUntil(lambda: "link_lost" in rig.codes())
    operating_state = rig.controller.operating_state
    assert (operating_state.link, operating_state.link_problem.code) == (LinkState.LOST, "bus_gone")
    assert rig.controller.motion.jog(1, 1.0).reason == LINK_LOST
    rig.plug_in()
    qtbot.waitUntil(lambda: "reconnected" in rig.codes())
    rig.run_until(lambda: rig.controller.operating_state.cannot_move is None)
    assert rig.heard() == []  # nothing was kept and sent late


def test_a_stop_pressed_while_the_device_is_gone_goes_out_when_it_is_back(rig, qtbot):
    rig.ready()
    rig.unplug(can.CanOperationError("gone", error_code=errno.ENODEV))
    qtbot.waitUntil(lambda: "link_lost" in rig.codes())
    rig.controller.emergency_stop()
    assert rig.codes()[-1] == "stop_not_sent"
    rig.plug_in()
    qtbot.waitUntil(lambda: "reconnected" in rig.codes())
    rig.run_until(lambda: rig.controller.operating_state.stop is StopState.STOPPED)
    assert rig.firmware.condition.stopped


def test_a_device_that_cannot_be_opened_is_explained_and_another_may_be_tried(rig, qtbot):
    rig.broken = OSError(errno.EACCES, "Permission denied")
    rig.controller.connect_device(rig.device)
    qtbot.waitUntil(lambda: "connect_failed" in rig.codes())
    operating_state = rig.controller.operating_state
    assert (operating_state.link, operating_state.link_problem.code) == (
        LinkState.NO_DEVICE,
        "bus_permission",
    )
    rig.broken = None
    rig.connect()
    assert rig.controller.operating_state.link is LinkState.ONLINE
    assert rig.controller.operating_state.link_problem is None


def test_disconnecting_forgets_the_arm(rig):
    rig.ready()
    rig.controller.disconnect_device()
    assert rig.controller.operating_state.link is LinkState.NO_DEVICE
    assert rig.controller.state.angles_deg() is None
    assert rig.codes()[-1] == "disconnected"


def test_an_arm_under_another_ones_control_is_not_moved(rig):
    rig.ready()
    rig.firmware.condition.control_mode = ControlMode.TEACHING
    rig.run(0.1)
    refusal = rig.controller.motion.jog(1, 1.0)
    assert (refusal.code, refusal.params) == ("other_control", {"mode": 2})


def test_an_arm_with_a_fault_is_not_moved(rig):
    rig.ready()
    rig.firmware.condition.communication_fault[2] = True
    rig.run(0.1)
    refusal = rig.controller.motion.jog(1, 1.0)
    assert (refusal.code, refusal.params) == ("arm_fault", {"status": 5})


def test_the_search_lists_the_simulated_arm_first(rig, qtbot):
    with qtbot.waitSignal(rig.controller.devices_found) as found:
        rig.controller.search_devices()
    assert found.args[0] == [rig.device]
    qtbot.waitUntil(lambda: rig.controller._finder._search is None)


def test_a_slow_search_does_not_hold_up_the_program(qtbot, rig):
    let_go = threading.Event()

    def find():
        assert let_go.wait(10)
        return [Device("socketcan", "can0", None)]

    rig.controller._finder._find = find
    rig.controller.search_devices()
    rig.connect()
    let_go.set()
    with qtbot.waitSignal(rig.controller.devices_found) as found:
        pass
    assert [device.interface for device in found.args[0]] == ["virtual", "socketcan"]
    qtbot.waitUntil(lambda: rig.controller._finder._search is None)
