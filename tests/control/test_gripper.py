"""夹爪控制: the literal bytes of 0x159, what the gripper then does, what is told of it."""

import errno

import can
import pytest

from armui.arm.figures import FIGURE_NOT_A_NUMBER, FIGURE_OUT_OF_RANGE
from armui.arm.parameters import Parameter
from armui.arm.state import GripperFault, gripper_of
from armui.control.devices.gripper import GRIPPER_SILENT
from armui.control.devices.gripper_ranges import gripper_figures
from armui.control.link.link_state import LINK_LOST, NOT_CONNECTED, OFFLINE
from armui.control.operations.started import Ending, refusal_of
from armui.control.safety.interlocks import OTHER_CONTROL, STOPPED
from armui.protocol.frame import Frame
from armui.protocol.generation import Generation
from tests.accepted import accepted
from tests.faulty_arm import FaultyDrivers, HardOfHearing

ONE, TWO = Generation.ONE, Generation.TWO


def command(payload):
    return Frame(0x159, bytes.fromhex(payload))


@pytest.fixture
def arm(any_rig):
    any_rig.connect()
    any_rig.ear = HardOfHearing(any_rig.firmware)
    any_rig.gripper = any_rig.controller.gripper
    return any_rig


@pytest.fixture
def arm2(rig):
    rig.connect()
    rig.ear = HardOfHearing(rig.firmware)
    rig.gripper = rig.controller.gripper
    return rig


def sent(arm):
    return [frame for frame in arm.ear.heard if frame.arbitration_id == 0x159]


def told(arm, code):
    return [event.params for event in arm.events if event.code == code]


def test_opened(arm, generation):
    accepted(arm.gripper.move(42.5, 1.5))
    arm.run_until(lambda: told(arm, "gripper_there"))
    # 42.5 = 42500 = A604; 1.5 N·m or rad/s = 1500 = 05DC; byte 6: enable
    assert sent(arm) == [command("0000A604 05DC 01 00")]
    assert arm.firmware.gripper.travel == 42.5
    assert told(arm, "gripper_there") == [
        {"value": 42.5, "unit": "mm" if generation is TWO else "°"}
    ]


def test_power_without_a_motion(arm):
    arm.firmware.gripper.travel = arm.firmware.gripper._target = 12.0
    arm.run(0.1)
    accepted(arm.gripper.enable(1.0))
    arm.run_until(lambda: told(arm, "gripper_act_done"))
    # 12 = 12000 = 2EE0: where it is; 1 = 1000 = 03E8
    assert sent(arm) == [command("00002EE0 03E8 01 00")]
    assert arm.firmware.gripper.enabled
    arm.run(0.5)
    assert arm.firmware.gripper.travel == 12.0
    accepted(arm.gripper.disable())
    arm.run_until(lambda: len(told(arm, "gripper_act_done")) == 2)
    assert sent(arm)[1:] == [command("00000000 0000 00 00")]
    assert not arm.firmware.gripper.enabled
    assert [each["act"] for each in told(arm, "gripper_act_done")] == ["enable", "disable"]


def test_an_error_is_told_and_cleared(arm2):
    arm2.firmware.gripper.fail(GripperFault.OVERCURRENT)
    arm2.run(0.1)
    assert arm2.controller.state.gripper.value.faults == {GripperFault.OVERCURRENT}
    accepted(arm2.gripper.clear_error())
    arm2.run_until(lambda: told(arm2, "gripper_act_done"))
    assert sent(arm2) == [command("00000000 0000 02 00")]
    assert arm2.controller.state.gripper.value.faults == frozenset()


def test_what_ends_as_it_is_told_is_not_sent(arm2):
    """As a failure of a window that is told of it does."""
    gripper = arm2.gripper
    arm2.controller.noticed.connect(
        lambda event: gripper.halt() if event.code == "gripper_act_sent" else None
    )
    started = accepted(gripper.clear_error())
    arm2.run(0.5)
    assert sent(arm2) == []
    assert started.ending is Ending.CUT_OFF


def test_its_zero(arm2):
    arm2.firmware.gripper.travel = arm2.firmware.gripper._target = 7.0
    arm2.run(0.1)
    accepted(arm2.gripper.set_zero())
    arm2.run_until(lambda: told(arm2, "gripper_act_done"))
    assert sent(arm2) == [command("00000000 0000 00 AE")]
    assert arm2.firmware.gripper.travel == 0.0


def test_a_gripper_that_moves_gets_no_zero(arm2):
    accepted(arm2.gripper.move(60.0, 1.0))
    arm2.run_until(lambda: arm2.firmware.gripper.travel > 5.0)
    before = sent(arm2)
    assert refusal_of(arm2.gripper.set_zero()).code == "gripper_moves"
    arm2.run_until(lambda: told(arm2, "gripper_there"))
    assert sent(arm2) == before


def test_generation_1_has_no_zero(any_rig, generation):
    any_rig.connect()
    refusal = refusal_of(any_rig.controller.gripper.set_zero())
    assert (None if refusal is None else refusal.code) == (
        "gripper_no_zero" if generation is ONE else None
    )


def test_something_between_the_jaws(arm2):
    arm2.gripper.move(60.0, 1.0)
    arm2.run_until(lambda: told(arm2, "gripper_there"))
    arm2.firmware.gripper.object_width = 25.0
    arm2.gripper.move(0.0, 2.0)
    arm2.run_until(lambda: told(arm2, "gripper_grips"))
    assert told(arm2, "gripper_grips") == [{"value": 25.0, "unit": "mm", "torque": 2.0}]
    assert arm2.controller.gripper.heading("mm") < 25.0, "what it holds with is the target as sent"
    accepted(arm2.controller.gripper.disable())
    assert arm2.controller.gripper.heading("mm") == 25.0


def test_one_that_hears_nothing(arm):
    arm.ear.deaf_to = {0x159}
    arm.gripper.move(30.0, 1.0)
    arm.run_until(lambda: told(arm, "gripper_not_there"))
    assert told(arm, "gripper_not_there")[0]["target"] == 30.0
    assert told(arm, "gripper_not_there")[0]["value"] == 0.0
    arm.gripper.enable(1.0)
    arm.run_until(lambda: told(arm, "gripper_act_failed"))
    assert told(arm, "gripper_act_failed") == [{"act": "enable"}]


def test_one_that_stays_without_power(arm):
    arm.firmware.gripper.command = lambda _signals, **_more: None
    arm.gripper.enable(1.0)
    arm.run_until(lambda: told(arm, "gripper_act_failed"))
    assert len(sent(arm)) == 3  # given again, and again


def test_a_motion_is_sent_once(arm):
    arm.ear.deaf_to = {0x159}
    arm.gripper.move(30.0, 1.0)
    arm.step()
    arm.ear.deaf_to = set()
    arm.run(3.0)
    assert sent(arm) == []  # it must not close late


def test_not_beyond_the_stroke(arm2):
    assert arm2.controller.settings.read([Parameter("stroke_limit_mm").batch]) is None
    arm2.run_until(lambda: not arm2.controller.settings.busy)
    assert arm2.gripper.figures.stroke_read
    refusal = arm2.gripper.move(70.001, 1.0)
    assert refusal.reason == FIGURE_OUT_OF_RANGE
    assert refusal.params["maximum"] == 70.0
    assert arm2.gripper.move(20.0, 5.001).params["figure"] == "torque"
    assert arm2.gripper.move(float("nan"), 1.0).reason == FIGURE_NOT_A_NUMBER
    arm2.step()
    assert sent(arm2) == []
    accepted(arm2.gripper.move(70.0, 5.0))


def test_not_in_a_stop_and_a_stop_ends_it(arm):
    arm.gripper.enable(1.0)
    arm.step()
    arm.ear.heard.clear()
    arm.controller.emergency_stop()
    arm.run_until(lambda: "stop_confirmed" in arm.codes())
    arm.run(2.0)
    assert sent(arm) == []
    for refusal in (arm.gripper.move(1.0, 1.0), arm.gripper.enable(1.0), arm.gripper.disable()):
        assert refusal.reason == STOPPED


def test_not_while_the_arm_is_led_by_hand(arm):
    arm.firmware.condition.control_mode = 2
    arm.run(0.1)
    assert arm.gripper.move(5.0, 1.0).reason == OTHER_CONTROL
    accepted(arm.gripper.disable())


def test_not_where_no_gripper_is_heard(arm):
    feedback = FaultyDrivers(arm.firmware)
    feedback.missing = {0x2A8}
    arm.run(0.7)
    assert arm.gripper.move(5.0, 1.0).reason == GRIPPER_SILENT
    assert arm.gripper.disable().reason == GRIPPER_SILENT
    feedback.mend()
    arm.run(0.1)
    accepted(arm.gripper.move(5.0, 1.0))


def test_a_link_lost_half_way(arm):
    arm.gripper.move(80.0, 0.2)
    arm.unplug(can.CanOperationError("gone", error_code=errno.ENODEV))
    arm.run_until(lambda: arm.controller.operating_state.unreachable is not None)
    assert arm.gripper.move(5.0, 1.0).reason in {LINK_LOST, OFFLINE}
    arm.run(1.0)
    assert told(arm, "gripper_there") == told(arm, "gripper_not_there") == []


def test_nothing_is_known_without_an_arm(any_rig):
    assert any_rig.controller.gripper.move(5.0, 1.0).reason == NOT_CONNECTED
    assert any_rig.controller.gripper.figures.travel.name == "opening"


def test_what_it_says(generation):
    one = gripper_of({"Angle": 30.0, "Speed": 0.5, "Enabled": 1})
    assert (one.travel, one.speed_rad_s, one.enabled, one.homed) == (30.0, 0.5, True, None)
    bits = {fault.value: 0 for fault in GripperFault}
    two = gripper_of({"Opening": 12.0, "Torque": -0.4, "Enabled": 0, "Homed": 0, **bits})
    assert (two.travel, two.torque_nm, two.homed, two.faults) == (12.0, -0.4, False, frozenset())
    for fault in GripperFault:
        said = gripper_of({"Opening": 0.0, "Torque": 0.0, "Enabled": 0, **bits, fault.value: 1})
        assert said.faults == {fault}


def test_no_stroke_limit_means_the_widest(rig):
    rig.connect()
    rig.firmware.settings.teaching = rig.firmware.settings.teaching._replace(stroke_limit_mm=0)
    rig.controller.settings.read([Parameter("stroke_limit_mm").batch])
    rig.run_until(lambda: not rig.controller.settings.busy)
    figures = gripper_figures(TWO, rig.controller.state)
    assert figures.travel.maximum == 100.0


def test_an_enable_that_is_done_keeps_what_a_run_has_sent_the_gripper_to(arm2):
    """Else the end of that run would not hold the gripper where it is (S23)."""
    accepted(arm2.gripper.enable(1.0))
    arm2.gripper.note_travel(60.0, 1.0)
    arm2.run(0.3)
    assert "gripper_act_done" in arm2.codes()

    arm2.heard()
    arm2.gripper.end_travel()
    arm2.run(0.1)

    assert [frame.arbitration_id for frame in arm2.heard()] == [0x159]
