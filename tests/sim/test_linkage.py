"""0x470: a teaching input leads, a motion output follows, each under its own identifiers."""

from __future__ import annotations

import itertools

import can
import pytest

from armui.protocol.codes import ControlMode, LinkageRole, MotionState
from armui.protocol.generation import Generation
from armui.sim.firmware import Firmware
from armui.sim.node import Node
from tests.moments import now
from tests.sim.talk import BOTH, RESUME, STANDBY, STOP, heard, mode, ready, target, tell, text

ONE, TWO = Generation.ONE, Generation.TWO
HOME = (0.0,) * 6
THERE = (20.0, 60.0, -45.0, 10.0, -20.0, 30.0)
ANSWER = ["476#7000000000000000"]


def leader(
    generation: Generation = TWO, *, target_offset: int = 0, joints_deg: tuple[float, ...] = HOME
) -> Firmware:
    arm = Firmware(generation, joints_deg=joints_deg)
    assert tell(arm, f"470#FA0000{target_offset:02X}00000000") == ANSWER
    return arm


def test_a_teaching_input_sends_commands_and_no_feedback() -> None:
    arm = leader(joints_deg=(1.0, 2.0, -3.0, 4.0, -5.0, 6.0))
    assert [text(each) for each in arm.step(0.005)] == [
        "151#0101640000000000",  # CAN control, MOVE J, 100 %
        "155#000003E8000007D0",  # 1.000°, 2.000°
        "156#FFFFF44800000FA0",  # −3.000°, 4.000°
        "157#FFFFEC7800001770",  # −5.000°, 6.000°
        "159#0000000003E80100",  # 0 mm, 1 N·m, enabled
    ]
    assert arm.condition.control_mode is ControlMode.LINKED_TEACHING_INPUT
    # 200 times a second, and nothing else
    assert len(arm.step(1.0)) == 5 * 200
    assert {each.arbitration_id for each in arm.step(0.5)} == {*range(0x155, 0x158), 0x151, 0x159}


def test_generation_1_leads_with_an_angle_and_a_speed_and_sets_it_with_four_bytes() -> None:
    arm = Firmware(ONE)
    assert tell(arm, "470#FA000000") == ANSWER
    # pi rad/s = 3142 = 0x0C46
    assert heard(arm.step(0.02), 0x159) == ["000000000C460100"]


@pytest.mark.each_value(full="each offset in both generations")
@pytest.mark.parametrize("offset", [0x00, 0x10, 0x20])
@pytest.mark.parametrize("generation", BOTH)
def test_leader_and_follower_move_together(generation: Generation, offset: int) -> None:
    ahead, behind = leader(generation, target_offset=offset), ready(generation)
    tell(behind, f"470#FC00{offset:02X}0000000000")
    ahead.hand_guiding.lead_to(THERE, speed_deg_s=40.0)
    strays = []
    for _ in range(600):
        for each in ahead.step(0.005):
            assert behind.on_frame(each) == []
        for each in behind.step(0.005):
            assert ahead.on_frame(each) == []
        strays.append(
            max(abs(a - b) for a, b in zip(ahead.joints_deg, behind.joints_deg, strict=True))
        )
    assert ahead.joints_deg == THERE
    assert behind.joints_deg == pytest.approx(THERE, abs=0.001)
    # v²/2a of 40 °/s, and a frame's time
    assert 0.0 < max(strays) < 40.0**2 / (2 * 286.0) + 2.0
    assert behind.condition.control_mode is ControlMode.CAN_CONTROL
    assert not ahead.ignored


def test_a_follower_elsewhere_hears_nothing() -> None:
    ahead, behind = leader(target_offset=0x10), ready()
    ahead.hand_guiding.lead_to(THERE)
    for _ in range(100):
        for each in ahead.step(0.005):
            behind.on_frame(each)
        behind.step(0.005)
    assert behind.joints_deg == HOME


@pytest.mark.parametrize(
    ("feedback", "control"), list(itertools.product((0x00, 0x10, 0x20), (0x00, 0x10, 0x20)))
)
@pytest.mark.parametrize("generation", BOTH)
def test_every_pair_of_offsets(generation: Generation, feedback: int, control: int) -> None:
    arm = ready(generation)
    assert tell(arm, f"470#FC{feedback:02X}{control:02X}0000000000") == ANSWER
    frames = arm.step(0.2)
    said = {each.arbitration_id for each in frames if 0x2A0 < each.arbitration_id < 0x2D0}
    assert said == {base + feedback for base in range(0x2A1, 0x2A9)}
    for other in {0x00, 0x10, 0x20} - {control}:
        tell(arm, f"{0x150 + other:03X}#0100000000000000")
        assert not arm.condition.stopped
    tell(arm, f"{0x150 + control:03X}#0100000000000000")
    assert arm.condition.stopped


@pytest.mark.parametrize(
    "line",
    [
        *(STOP, RESUME, STANDBY, mode(50), "471#0701000000000000", "159#00009C4003E80100"),
        *("150#0000010000000000", "152#0000000000000000", "15A#0000000000000000"),
    ],
)
def test_a_teaching_input_obeys_no_command(line: str) -> None:
    arm, other = leader(), leader()
    assert tell(arm, line) == []
    assert arm.step(0.3) == other.step(0.3)
    assert arm.condition.control_mode is ControlMode.LINKED_TEACHING_INPUT
    assert not arm.condition.stopped


def test_a_teaching_input_still_answers_questions() -> None:
    # joint 1: 150.0°, −150.0°, 3.00 rad/s
    assert tell(leader(), "472#0101000000000000") == ["473#0105DCFA24012C00"]


@pytest.mark.parametrize("generation", BOTH)
def test_0xfc_makes_it_a_motion_output_in_standby_again(generation: Generation) -> None:
    arm = leader(generation)
    arm.hand_guiding.lead_to(THERE)
    arm.step(2.0)
    assert tell(arm, "470#FC00000000000000") == ANSWER
    assert arm.condition.control_mode is ControlMode.STANDBY
    frames = arm.step(0.1)
    assert heard(frames, 0x2A1)
    assert not heard(frames, 0x155)
    # the hand is not felt any more
    arm.hand_guiding.lead_to(HOME)
    arm.step(1.0)
    assert arm.joints_deg == THERE
    tell(arm, mode(100), *target(*HOME))
    while arm.condition.motion_state is MotionState.NOT_REACHED:
        arm.step(0.005)
    assert arm.joints_deg == HOME


def test_the_role_waits_for_standby() -> None:
    arm = ready()
    tell(arm, mode(50), "470#FA00000000000000")
    assert heard(arm.step(0.05), 0x2A1)
    tell(arm, STANDBY)
    assert heard(arm.step(0.05), 0x155)


def test_the_role_waits_for_the_end_of_a_stop() -> None:
    arm = ready()
    tell(arm, STOP, "470#FA00000000000000")
    assert arm.condition.stopped
    assert heard(arm.step(0.05), 0x2A1)
    tell(arm, RESUME)
    assert heard(arm.step(0.05), 0x155)


def test_the_role_outlives_a_power_cycle_and_takes_effect_after_one() -> None:
    arm = ready()
    tell(arm, mode(50), "470#FA00001000000000")
    arm.power_cycle()
    assert arm.settings.linkage.role is LinkageRole.TEACHING_INPUT
    assert heard(arm.step(0.05), 0x165)
    arm.power_cycle()
    assert heard(arm.step(0.05), 0x165)


def test_role_0_changes_the_offsets_only() -> None:
    arm = leader()
    tell(arm, "470#0000001000000000")
    assert heard(arm.step(0.05), 0x165)


def test_a_hand_moves_no_arm_that_holds_its_joints_and_none_beyond_its_stops() -> None:
    arm = ready()
    arm.hand_guiding.push((10.0, 0, 0, 0, 0, 0))
    arm.step(1.0)
    assert now(arm.joints_deg) == HOME
    arm = leader()
    arm.hand_guiding.push((0.0, -10.0, 0, 0, 0, 100.0))
    arm.step(2.0)
    assert now(arm.joints_deg) == (0, 0, 0, 0, 0, 120.0)
    arm.hand_guiding.release()
    arm.step(1.0)
    assert arm.joints_deg == (0, 0, 0, 0, 0, 120.0)


def test_a_node_hears_again_what_it_said_as_a_leader() -> None:
    """Some buses return what is sent, so a node is deaf to its own identifiers."""
    with (
        can.Bus(interface="virtual", channel="linkage") as bus,
        can.Bus(interface="virtual", channel="linkage") as host,
    ):
        node = Node(leader(), bus)
        node.poll(0.05)

        def say(line: str) -> None:
            identifier, _, data = line.partition("#")
            host.send(
                can.Message(
                    arbitration_id=int(identifier, 16),
                    data=bytes.fromhex(data),
                    is_extended_id=False,
                )
            )

        say("470#FC00000000000000")
        node.poll(0.05)
        say(mode(50))
        node.poll(0.05)
        assert node.firmware.condition.control_mode is ControlMode.CAN_CONTROL
