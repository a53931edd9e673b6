"""From frames on the bus, byte by byte, to what they say."""

from __future__ import annotations

import pytest

from armui.doctor.hearing import TimedFrame, heard_facts
from armui.protocol.frame import Frame

# CAN control, normal, MOVE J, no teaching, reached, no trajectory point, no limit, no fault
STATUS = "0100010000000000"
# J1 = 90° = 90000 = 0x15F90, J2 = 1.5° = 1500 = 0x5DC
JOINTS = "00015F90000005DC"
# 56.128 mm = 0xDB40, 0
POSE = "0000DB4000000000"


def heard(*frames: tuple[int, str], times: int = 5, period_s: float = 0.005, **more):
    stream = [
        TimedFrame(n * period_s, Frame(arbitration_id, bytes.fromhex(data)))
        for n in range(times)
        for arbitration_id, data in frames
    ]
    return heard_facts("socketcan", "can0", stream, seconds=times * period_s, **more)


def test_an_arm_that_gives_feedback():
    facts = heard((0x2A1, STATUS), (0x2A5, JOINTS), (0x2A2, POSE), times=40)
    arm = facts.arm
    assert (arm.generation, arm.feedback_offset) == (2, 0)
    assert (arm.status_code, arm.mode_word) == (0, "MOVE J")
    assert arm.joints_deg[:3] == (90.0, 1.5, None)
    assert arm.pose[0] == 56.128
    assert arm.frames_per_s == pytest.approx(600)
    assert facts.other_hosts == ()


def test_generation_1_by_its_period():
    assert heard((0x2A1, STATUS), (0x2A5, JOINTS), times=40, period_s=0.02).arm.generation == 1


def test_the_version_is_read_where_somebody_has_asked_for_it():
    # "S-V1.8-6" in ASCII
    facts = heard((0x2A1, STATUS), (0x4AF, "532D56312E382D36"))
    assert facts.arm.firmware == "S-V1.8-6"
    assert facts.answered
    assert not heard((0x2A1, STATUS), (0x4AF, "01")).answered


def test_a_shifted_arm_and_a_second_one():
    shifted = heard((0x2B1, STATUS), (0x2B5, JOINTS))
    assert shifted.arm.feedback_offset == 0x10
    assert shifted.arm.joints_deg[0] == 90.0
    both = heard((0x2A1, STATUS), (0x2C1, STATUS))
    assert (both.arm.feedback_offset, both.other_offsets) == (0, (0x20,))


def test_a_stray_frame_is_no_arm():
    assert heard((0x2A1, STATUS), times=1).arm is None


def test_a_teaching_input_arm_by_its_targets():
    # targets, mode and gripper in lockstep, no feedback
    frames = [(each, "0000000000000000") for each in (0x151, 0x155, 0x156, 0x157, 0x159)]
    facts = heard(*frames, times=50)
    assert facts.arm is None
    assert facts.leader
    assert {each.arbitration_id for each in facts.other_hosts} == {each for each, _ in frames}


def test_a_teaching_input_arm_by_its_shifted_feedback():
    facts = heard(*[(each, "0000000000000000") for each in range(0x3A1, 0x3A9)])
    assert facts.arm is None
    assert facts.shifted_feedback == tuple(range(0x3A1, 0x3A9))


def test_another_host_beside_an_arm_is_no_leader():
    facts = heard((0x2A1, STATUS), (0x151, "0101320000000000"), times=20)
    assert not facts.leader
    (frames,) = facts.other_hosts
    assert (frames.arbitration_id, frames.count) == (0x151, 20)
    assert frames.rate_hz == pytest.approx(200)


def test_what_an_arm_says_of_its_joints():
    facts = heard(
        # joint 3 and 5 do not answer: bits 2 and 4; joint 2 beyond its limit: bit 1
        (0x2A1, "0105010000000214"),
        # 23.9 V = 0xEF, 40 and 41 degrees, undervoltage and enabled: bits 0 and 6
        (0x262, "00EF002829410000"),
        # limits of joint 2: -0.1 deg = 0xFFFF twice, 3 rad/s
        (0x473, "02FFFFFFFF012C00"),
        # accelerations of joint 2: 0xFFFF
        (0x47C, "02FFFF0000000000"),
        # teaching range 100 %, stroke 70 mm, friction 255
        (0x47E, "6446FF0000000000"),
        times=40,
    )
    arm = facts.arm
    assert (arm.unreachable, arm.beyond_limit) == ((3, 5), (2,))
    assert arm.driver_faults == ((2, "undervoltage"),)
    assert arm.lowest_voltage == 23.9
    assert arm.teaching == (100, 70, 255)
    (limits,) = arm.limits
    assert (limits.joint, limits.min_deg, limits.max_deg) == (2, -0.1, -0.1)
    assert limits.max_acceleration_deg_s2 == pytest.approx(37_548, abs=1)


def test_frames_of_nobody():
    facts = heard((0x100, ""), (0x123, "00"))
    assert facts.arm is None
    assert facts.unknown_ids == (0x100, 0x123)
