"""The controller against the simulated arm: what the arm receives, what the operator is told."""

import errno
import threading

import can
import pytest

from armui.arm.device import Device
from armui.control.situation import LinkState, StopState
from armui.protocol.codes import ControlMode
from armui.protocol.frame import Frame
from armui.protocol.generation import Generation

STOP = Frame(0x150, bytes.fromhex("01 00 00 00 00 00 00 00"))
RESUME = Frame(0x150, bytes.fromhex("02 00 00 00 00 00 00 00"))
ENABLE = Frame(0x471, bytes.fromhex("07 02 00 00 00 00 00 00"))
DISABLE = Frame(0x471, bytes.fromhex("07 01 00 00 00 00 00 00"))


def angles(bench):
    return [round(angle, 3) for angle in bench.firmware.joints_deg]


def test_without_a_device_everything_is_refused_and_says_so(bench):
    assert bench.controller.situation.link is LinkState.NO_DEVICE
    assert bench.controller.motion.jog(1, 1.0).code == "not_connected"
    assert bench.controller.motors.enable().code == "not_connected"
    assert bench.controller.motion.send_joints([0] * 6).code == "not_connected"
    bench.controller.emergency_stop()
    assert bench.codes()[-1] == "stop_not_sent"


def test_connecting_finds_the_generation_and_reads_the_limits(any_bench):
    any_bench.connect()
    situation = any_bench.controller.situation
    assert situation.link is LinkState.ONLINE
    assert situation.generation is any_bench.firmware.generation
    assert situation.limits_read == (True,) * 6
    assert (situation.limits[1].min_deg, situation.limits[1].max_deg) == (0, 180)
    firmware = any_bench.controller.state.firmware
    assert firmware == ("S-V1.8-5" if situation.generation is Generation.TWO else None)


def test_connecting_moves_and_enables_nothing(any_bench):
    any_bench.connect()
    any_bench.run(0.5)
    assert any_bench.heard() == []
    assert any_bench.firmware.enabled == (False,) * 6


def test_enable_and_disable_are_over_when_the_drivers_say_so(any_bench):
    bench = any_bench
    bench.connect()
    assert bench.controller.situation.enabled == (False,) * 6
    assert bench.controller.motors.enable() is None
    assert bench.controller.motion.jog(1, 1.0).code == "busy"
    bench.run_until(lambda: "enabled" in bench.codes())
    assert bench.controller.situation.enabled == (True,) * 6
    assert bench.heard()[0] == ENABLE
    assert bench.controller.motors.disable() is None
    bench.run_until(lambda: "disabled" in bench.codes())
    assert bench.heard()[0] == DISABLE
    assert bench.controller.motion.jog(1, 1.0).code == "not_enabled"


def test_six_angles_are_sent_as_the_protocol_says_and_reached(any_bench):
    bench = any_bench
    bench.ready()
    bench.heard()
    assert bench.controller.motion.send_joints([12, 30, -20, 5, -5, 60]) is None
    bench.step()
    assert bench.heard() == [
        Frame(0x155, bytes.fromhex("00002EE0 00007530")),  # 12000, 30000
        Frame(0x156, bytes.fromhex("FFFFB1E0 00001388")),  # -20000, 5000
        Frame(0x157, bytes.fromhex("FFFFEC78 0000EA60")),  # -5000, 60000
        Frame(0x151, bytes.fromhex("01 01 1E 00 00 00 00 00")),  # CAN control, MOVE J, 30 %
    ]
    bench.run_until(lambda: bench.controller.situation.moving)
    bench.run_until(lambda: not bench.controller.situation.moving)
    assert angles(bench) == [12, 30, -20, 5, -5, 60]
    assert bench.controller.state.angles_deg() == (12, 30, -20, 5, -5, 60)


def test_home_is_all_zeros(bench):
    bench.ready()
    bench.controller.motion.send_joints([10, 20, -20, 0, 0, 0])
    bench.run_until(lambda: angles(bench)[0] == 10)
    assert bench.controller.motion.go_home() is None
    bench.run_until(lambda: angles(bench) == [0] * 6)
    assert "went_home" in bench.codes()


def test_a_jog_moves_one_joint_by_one_step(bench):
    bench.ready()
    assert bench.controller.motion.jog(2, 1.0) is None
    bench.run_until(lambda: angles(bench)[1] == 1)
    bench.run(0.2)
    assert bench.controller.motion.jog(2, 0.5) is None
    bench.run_until(lambda: angles(bench)[1] == 1.5)
    assert angles(bench) == [0, 1.5, 0, 0, 0, 0]


def test_steps_add_up_while_the_arm_is_still_moving(bench):
    bench.ready()
    for _ in range(5):
        assert bench.controller.motion.jog(1, 2.0) is None
        bench.step()
    bench.run_until(lambda: angles(bench)[0] == 10)
    assert angles(bench) == [10, 0, 0, 0, 0, 0]


def test_a_held_button_waits_for_an_arm_that_lags(bench):
    bench.ready()
    assert not bench.controller.motion.jog_lagging(1, 5.0)
    for _ in range(3):
        bench.controller.motion.jog(1, 5.0)
    assert bench.controller.motion.jog_lagging(1, 5.0)
    bench.run_until(lambda: angles(bench)[0] == 15)
    bench.run(0.1)
    assert not bench.controller.motion.jog_lagging(1, 5.0)


@pytest.mark.parametrize("delta_deg", [-0.001, 181.0])
def test_a_jog_beyond_the_limits_is_refused_and_nothing_is_sent(bench, delta_deg):
    bench.ready()
    bench.heard()
    refusal = bench.controller.motion.jog(2, delta_deg)
    assert (refusal.code, refusal.params["joint"]) == ("joint_out_of_limits", 2)
    bench.step()
    assert bench.heard() == []


def test_angles_beyond_the_limits_are_refused_and_nothing_is_sent(bench):
    bench.ready()
    bench.heard()
    refusal = bench.controller.motion.send_joints([0, 0, 0, 0, 70.001, 0])
    assert refusal.params == {"joint": 5, "value": 70.001, "minimum": -70, "maximum": 70}
    assert bench.controller.motion.send_joints([float("nan")] * 6).code == "joint_not_a_number"
    bench.step()
    assert bench.heard() == []


def test_the_speed_goes_to_the_arm_in_the_mode_it_is_in(bench):
    bench.ready()
    bench.heard()
    assert bench.controller.motion.set_speed_percent(55) is None
    bench.step()
    assert bench.heard() == [Frame(0x151, bytes.fromhex("00 00 37 00 00 00 00 00"))]  # standby
    bench.controller.motion.jog(1, 1.0)
    bench.run_until(lambda: bench.firmware.control_mode is ControlMode.CAN_CONTROL)
    bench.run(0.1)
    bench.heard()
    bench.controller.motion.set_speed_percent(80)
    bench.step()
    assert bench.heard() == [Frame(0x151, bytes.fromhex("01 01 50 00 00 00 00 00"))]
    assert bench.firmware.speed_percent == 80


@pytest.mark.parametrize("percent", [-1, 100.5, 255])
def test_an_impossible_speed_is_refused(bench, percent):
    bench.connect()
    assert bench.controller.motion.set_speed_percent(percent).code == "speed_out_of_range"
    assert bench.controller.situation.speed_percent == 30


def test_at_zero_percent_a_motion_is_refused(bench):
    bench.ready()
    bench.controller.motion.set_speed_percent(0)
    assert bench.controller.motion.go_home().code == "speed_zero"


def test_stop_resume_enable_and_on(any_bench):
    bench = any_bench
    bench.ready()
    bench.controller.motion.send_joints([90, 90, -90, 0, 0, 0])
    bench.run(0.5)
    bench.heard()
    bench.controller.emergency_stop()
    assert bench.controller.situation.stop is StopState.REQUESTED
    assert bench.heard() == [STOP]  # on the bus before emergency_stop() came back
    bench.run_until(lambda: bench.controller.situation.stop is StopState.STOPPED)
    assert bench.firmware.stopped
    assert bench.codes()[-1] == "stop_confirmed"
    assert bench.controller.motion.jog(1, 1.0).code == "stopped"
    assert bench.controller.motors.enable().code == "stopped"

    assert bench.controller.motors.resume() is None
    bench.run_until(lambda: bench.controller.situation.stop is StopState.RUNNING)
    assert bench.heard()[0] == RESUME
    assert not bench.firmware.stopped
    bench.run(0.3)  # the slow driver feedback has to come round
    assert bench.controller.motion.jog(1, 1.0).code == "not_enabled"

    before = angles(bench)
    assert bench.controller.motors.enable() is None
    bench.run_until(lambda: bench.controller.situation.cannot_move is None)
    bench.run(0.5)
    assert angles(bench)[0] == before[0]  # the old target is forgotten


def test_a_stop_drops_what_was_about_to_be_sent(bench):
    bench.ready()
    bench.heard()
    bench.controller.motion.send_joints([10, 10, -10, 0, 0, 0])
    bench.controller.emergency_stop()
    bench.run(0.3)
    frames = bench.heard()
    after_stop = frames[frames.index(STOP) :]
    assert set(after_stop) == {STOP}
    assert bench.firmware.stopped


def test_a_stop_is_repeated_until_the_arm_confirms_it(bench):
    bench.ready()
    bench.heard()
    bench.powered = False
    bench.controller.emergency_stop()
    bench.run(0.7)
    assert bench.controller.situation.stop_unconfirmed
    assert "stop_unconfirmed" in bench.codes()
    assert bench.heard().count(STOP) >= 6
    bench.powered = True
    bench.run_until(lambda: bench.controller.situation.stop is StopState.STOPPED)
    assert not bench.controller.situation.stop_unconfirmed


def test_resume_is_refused_unless_the_arm_is_stopped(bench):
    bench.ready()
    assert bench.controller.motors.resume().code == "not_stopped"


def test_a_silent_arm_is_offline_after_half_a_second_and_moves_no_more(bench):
    bench.ready()
    bench.powered = False
    bench.run(0.44)
    assert bench.controller.situation.link is LinkState.ONLINE
    bench.run(0.12)
    assert bench.controller.situation.link is LinkState.OFFLINE
    assert bench.controller.situation.enabled == (None,) * 6
    assert bench.controller.motion.jog(1, 1.0).code == "offline"
    bench.powered = True
    bench.run_until(lambda: bench.controller.situation.link is LinkState.ONLINE)
    assert bench.codes().count("online") == 2


def test_a_stopped_arm_that_falls_silent_can_be_stopped_again_not_resumed(bench):
    bench.ready()
    bench.controller.emergency_stop()
    bench.run_until(lambda: bench.controller.situation.stop is StopState.STOPPED)
    bench.powered = False
    bench.run(0.6)
    assert bench.controller.situation.stop is StopState.RUNNING
    assert bench.controller.motors.resume().code == "not_stopped"
    bench.heard()
    bench.controller.emergency_stop()
    assert bench.heard() == [STOP]


def test_coming_back_online_is_told_once_and_the_limits_are_read_anew(bench):
    bench.ready()
    bench.powered = False
    bench.run(0.6)
    assert bench.codes()[-1] == "offline"
    bench.powered = True
    bench.run_until(lambda: bench.codes().count("limits_read") == 2)
    bench.run(0.5)
    assert bench.codes().count("limits_read") == 2


def test_an_unplugged_device_is_told_and_taken_up_again(bench, qtbot):
    bench.ready()
    bench.heard()
    bench.unplug(can.CanOperationError("gone", error_code=errno.ENODEV))
    qtbot.waitUntil(lambda: "link_lost" in bench.codes())
    situation = bench.controller.situation
    assert (situation.link, situation.link_problem.code) == (LinkState.LOST, "bus_gone")
    assert bench.controller.motion.jog(1, 1.0).code == "link_lost"
    bench.plug_in()
    qtbot.waitUntil(lambda: "reconnected" in bench.codes())
    bench.run_until(lambda: bench.controller.situation.cannot_move is None)
    assert bench.heard() == []  # nothing was kept and sent late


def test_a_stop_pressed_while_the_device_is_gone_goes_out_when_it_is_back(bench, qtbot):
    bench.ready()
    bench.unplug(can.CanOperationError("gone", error_code=errno.ENODEV))
    qtbot.waitUntil(lambda: "link_lost" in bench.codes())
    bench.controller.emergency_stop()
    assert bench.codes()[-1] == "stop_not_sent"
    bench.plug_in()
    qtbot.waitUntil(lambda: "reconnected" in bench.codes())
    bench.run_until(lambda: bench.controller.situation.stop is StopState.STOPPED)
    assert bench.firmware.stopped


def test_a_device_that_cannot_be_opened_is_explained_and_another_may_be_tried(bench, qtbot):
    bench.broken = OSError(errno.EACCES, "Permission denied")
    bench.controller.connect_device(bench.device)
    qtbot.waitUntil(lambda: "connect_failed" in bench.codes())
    situation = bench.controller.situation
    assert (situation.link, situation.link_problem.code) == (
        LinkState.NO_DEVICE,
        "bus_permission",
    )
    bench.broken = None
    bench.connect()
    assert bench.controller.situation.link is LinkState.ONLINE
    assert bench.controller.situation.link_problem is None


def test_disconnecting_forgets_the_arm(bench):
    bench.ready()
    bench.controller.disconnect_device()
    assert bench.controller.situation.link is LinkState.NO_DEVICE
    assert bench.controller.state.angles_deg() is None
    assert bench.codes()[-1] == "disconnected"


def test_an_arm_under_another_ones_control_is_not_moved(bench):
    bench.ready()
    bench.firmware.condition.control_mode = ControlMode.TEACHING
    bench.run(0.1)
    refusal = bench.controller.motion.jog(1, 1.0)
    assert (refusal.code, refusal.params) == ("other_control", {"mode": 2})


def test_an_arm_with_a_fault_is_not_moved(bench):
    bench.ready()
    bench.firmware.condition.communication_fault[2] = True
    bench.run(0.1)
    refusal = bench.controller.motion.jog(1, 1.0)
    assert (refusal.code, refusal.params) == ("arm_fault", {"status": 5})


def test_the_search_lists_the_simulated_arm_first(bench, qtbot):
    with qtbot.waitSignal(bench.controller.devices_found) as found:
        bench.controller.search_devices()
    assert found.args[0] == [bench.device]
    qtbot.waitUntil(lambda: bench.controller._finder._search is None)


def test_a_slow_search_does_not_hold_up_the_program(qtbot, bench):
    let_go = threading.Event()

    def find():
        assert let_go.wait(10)
        return [Device("socketcan", "can0", None)]

    bench.controller._finder._find = find
    bench.controller.search_devices()
    bench.connect()
    let_go.set()
    with qtbot.waitSignal(bench.controller.devices_found) as found:
        pass
    assert [device.interface for device in found.args[0]] == ["virtual", "socketcan"]
    qtbot.waitUntil(lambda: bench.controller._finder._search is None)
