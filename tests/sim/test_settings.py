"""Zeros, errors, the end's motion, the silence: settings that do more than keep a value."""

from __future__ import annotations

import math
from itertools import pairwise

import pytest

from armui.kinematics.arm_kinematics import Kinematics
from armui.kinematics.geometry import Geometry
from armui.protocol.codec import Codec, Message
from armui.protocol.codes import ArmStatusCode, EndLoad
from armui.protocol.frame import Frame
from armui.protocol.generation import Generation
from armui.sim.firmware import Firmware
from armui.sim.parameters.settings import Light
from tests.family import PIPER, PIPER_BEFORE_V1_6_3
from tests.moments import now
from tests.sim.talk import (
    BOTH,
    DISABLE,
    FRAMES_A_SECOND,
    RESUME,
    STOP,
    heard,
    mode,
    ready,
    status_bytes,
    target,
    tell,
)

ONE, TWO = Generation.ONE, Generation.TWO
ZERO_ALL = "475#07AE000000000000"
LEANING = (10.0, 110.0, -60.0, 5.0, 10.0, 15.0)
END_MOTION = list(range(0x481, 0x487))
END_MOTION_ON = {ONE: "477#0000010000000000", TWO: "477#0000010000000000"}
END_MOTION_OFF = {ONE: "477#0000000000000000", TWO: "477#0000020000000000"}


@pytest.mark.parametrize("generation", BOTH)
def test_zero_of_one_joint_is_where_it_stands(generation: Generation) -> None:
    arm = ready(generation, LEANING)
    assert tell(arm, "475#02AE000000000000") == ["476#7501000000000000"]
    assert arm.joints_deg == (10.0, 0.0, -60.0, 5.0, 10.0, 15.0)
    # J1 10.000° = 0x2710, J2 0
    assert heard(arm.step(0.02), 0x2A5)[-1] == "0000271000000000"


def test_zero_of_all_joints() -> None:
    arm = ready(joints_deg=LEANING)
    assert tell(arm, ZERO_ALL) == ["476#7501000000000000"]
    assert arm.joints_deg == (0.0,) * 6
    arm.step(1.0)
    assert arm.joints_deg == (0.0,) * 6


def test_a_new_zero_moves_nothing_and_changes_no_weight() -> None:
    arm, same = ready(joints_deg=LEANING), ready(joints_deg=LEANING)
    tell(arm, ZERO_ALL)
    for each in (arm, same):
        each.step(0.1)
    assert arm.drivers.currents_a == pytest.approx(same.drivers.currents_a)
    for each in (arm, same):
        tell(each, STOP)
        each.step(1.0)
    sunk = [a - b for a, b in zip(same.joints_deg, LEANING, strict=True)]
    assert sunk[1] > 1.0
    assert arm.joints_deg == pytest.approx(sunk, abs=1e-9)


def test_angles_after_a_new_zero_count_from_it() -> None:
    arm = ready(joints_deg=(20.0, 0, 0, 0, 0, 0))
    tell(arm, "475#01AE000000000000", mode(100), *target(-5.0, 0, 0, 0, 0, 0))
    arm.step(2.0)
    assert arm.joints_deg[0] == -5.0
    assert arm.settings.zeros_deg[0] == 20.0


def test_a_target_from_before_is_not_pursued_in_the_new_angles() -> None:
    arm = ready(joints_deg=(20.0, 0, 0, 0, 0, 0))
    tell(arm, *target(15.0, 0, 0, 0, 0, 0), "475#01AE000000000000", mode(100))
    arm.step(2.0)
    assert arm.joints_deg[0] == 0.0


def test_zero_cannot_be_set_while_moving() -> None:
    arm = ready()
    tell(arm, mode(50), *target(90.0, 0, 0, 0, 0, 0))
    arm.step(0.3)
    before = arm.joints_deg
    assert tell(arm, "475#06AE000000000000") == ["476#7500000000000000"]
    assert arm.joints_deg == before
    arm.step(5.0)
    assert arm.joints_deg[0] == 90.0


def test_zero_of_a_falling_joint_cannot_be_set_of_a_resting_one_it_can() -> None:
    arm = ready(joints_deg=LEANING)
    tell(arm, DISABLE)
    arm.step(0.2)
    assert tell(arm, ZERO_ALL) == ["476#7500000000000000"]
    assert tell(arm, "475#01AE000000000000") == ["476#7501000000000000"]
    arm.step(20.0)
    assert tell(arm, ZERO_ALL) == ["476#7501000000000000"]
    assert arm.joints_deg == (0.0,) * 6


def test_zero_of_a_joint_nobody_can_talk_to_cannot_be_set() -> None:
    arm = Firmware(TWO, joints_deg=LEANING)
    arm.set_communication_fault(3, present=True)
    assert tell(arm, "475#03AE000000000000", ZERO_ALL) == ["476#7500000000000000"] * 2
    assert arm.joints_deg == LEANING
    assert tell(arm, "475#02AE000000000000") == ["476#7501000000000000"]


def test_without_the_mark_no_zero_is_set() -> None:
    arm = Firmware(TWO, joints_deg=LEANING)
    assert tell(arm, "475#0200000000000000") == ["476#7500000000000000"]
    assert tell(arm, "475#0201000000000000") == []
    assert arm.joints_deg == LEANING


def test_clearing_errors_clears_the_joint_that_was_sent_too_far() -> None:
    arm = ready()
    tell(arm, mode(50), *target(151.0, 0, 0, 0, 0, 0))
    assert now(arm.condition.status) is ArmStatusCode.TARGET_BEYOND_LIMIT
    # byte 6 means nothing; joint 2 is not the one
    assert tell(arm, "475#010000000000AE00") == ["476#7500000000000000"]
    assert tell(arm, "475#0200000000AE0000") == ["476#7500000000000000"]
    assert now(arm.condition.status) is ArmStatusCode.TARGET_BEYOND_LIMIT
    assert tell(arm, "475#0100000000AE0000") == ["476#7500000000000000"]
    assert now(arm.condition.status) is ArmStatusCode.NORMAL
    assert arm.enabled == (True,) * 6


@pytest.mark.parametrize(("generation", "per_second"), [(ONE, 50), (TWO, 200)])
def test_end_motion_is_told_only_when_on(generation: Generation, per_second: int) -> None:
    arm = ready(generation)
    assert not [each for each in arm.step(1.0) if each.arbitration_id in END_MOTION]
    assert tell(arm, END_MOTION_ON[generation]) == ["476#7700000000000000"]
    said = arm.step(1.0)
    assert [len(heard(said, identifier)) for identifier in END_MOTION] == [per_second] * 6
    assert tell(arm, END_MOTION_OFF[generation]) == ["476#7700000000000000"]
    assert not [each for each in arm.step(1.0) if each.arbitration_id in END_MOTION]


def test_generation_2_leaves_the_end_motion_alone_unless_told() -> None:
    arm = ready(TWO)
    tell(arm, END_MOTION_ON[TWO], "477#0100000000000000", "477#0000000000000000")
    assert heard(arm.step(0.1), 0x481)


def test_end_motion_of_a_standing_arm_is_nothing() -> None:
    arm = ready(joints_deg=LEANING)
    tell(arm, END_MOTION_ON[TWO])
    said = arm.step(0.1)
    assert {payload for i in END_MOTION for payload in heard(said, i)} == {"0000000000000000"}


@pytest.mark.parametrize("joint", range(1, 7))
def test_end_motion_is_that_of_the_flange(joint: int) -> None:
    """One joint turns alone: the flange's own track tells the same speed."""
    arm, kinematics, codec = ready(joints_deg=LEANING), Kinematics(PIPER), Codec(TWO)
    goal = list(LEANING)
    goal[joint - 1] += 40.0
    tell(arm, END_MOTION_ON[TWO], mode(40), *target(*goal))
    track, told = [], []
    for _ in range(120):
        frame = [f for f in arm.step(0.005) if f.arbitration_id == 0x480 + joint][-1]
        message = codec.decode(frame)
        assert isinstance(message, Message)
        told.append(message.signals)
        track.append(kinematics.forward(arm.joints_deg)[:3])
    for (before, after), (first, second) in zip(pairwise(track), pairwise(told), strict=True):
        speed_m_s = math.dist(before, after) / 1000 / 0.005
        mean = (first["LinearSpeed"] + second["LinearSpeed"]) / 2
        assert mean == pytest.approx(speed_m_s, abs=0.004)
    # 40 % of 3 rad/s, and 5 rad/s² on the way there
    assert max(signals["AngularSpeed"] for signals in told) == pytest.approx(1.2, abs=0.001)
    assert max(signals["AngularAcceleration"] for signals in told) == pytest.approx(5.0, abs=0.001)


def test_a_load_that_is_not_given_changes_nothing_and_is_no_invalid_frame() -> None:
    """The maker's SDK fills byte 4 with 3 whenever the frame is about something else."""
    arm = Firmware(TWO)
    assert tell(arm, "477#000000AE02000000") == ["476#7700000000000000"]
    assert tell(arm, "477#0200000003000000") == ["47B#0101010101010000"]
    assert tell(arm, "477#000000AE03000000") == ["476#7700000000000000"]
    assert arm.settings.load is EndLoad.FULL
    assert not arm.ignored


def test_the_trajectory_index_is_told_with_0x476() -> None:
    assert tell(Firmware(TWO), "477#0300000000000000") == ["476#7700000000000000"]
    assert tell(Firmware(ONE), "477#0300000000000000") == []


def test_lights_keep_the_count_of_the_host() -> None:
    arm = Firmware(TWO)
    tell(arm, "121#0106051122330009", "121#010605112233000A")
    assert arm.settings.lights == {6: Light(5, 0x11, 0x22, 0x33, counter=10)}
    assert tell(arm, "121#0107051122330001", "121#0201051122330001") == []
    assert list(arm.settings.lights) == [6]


@pytest.mark.parametrize("generation", BOTH)
@pytest.mark.parametrize("silence", ["01", "02"])
def test_both_silences_end_feedback_and_answers(generation: Generation, silence: str) -> None:
    arm = Firmware(generation)
    assert tell(arm, f"422#{silence}00000000000000", "472#0101000000000000") == []
    assert arm.silent
    assert arm.step(0.5) == []
    assert tell(arm, "422#03", "422#00") == []
    assert tell(arm, "472#0102000000000000") != []
    assert status_bytes(arm)


def test_joints_are_enabled_one_by_one() -> None:
    arm = Firmware(TWO)
    for joint in range(1, 7):
        assert tell(arm, f"471#{joint:02X}02000000000000") == ["476#7100000000000000"]
        assert arm.enabled == tuple(i < joint for i in range(6))
    assert tell(arm, "471#0001000000000000", "471#0703000000000000", "471#0700") == []
    assert arm.enabled == (True,) * 6


def test_limits_that_read_ffff_refuse_every_target_until_reset_to_factory() -> None:
    arm = ready(TWO)
    arm.corrupt_limits(2)
    assert tell(arm, "472#0201000000000000", "472#0202000000000000") == [
        "473#02FFFFFFFFFFFF00",
        "47C#02FFFF0000000000",
    ]
    tell(arm, mode(50), *target(0, 10.0, 0, 0, 0, 0))
    assert arm.condition.status is ArmStatusCode.TARGET_BEYOND_LIMIT
    tell(arm, "477#0002000000000000", RESUME)
    assert tell(arm, "472#0201000000000000") == ["473#0207080000012C00"]


def test_limits_that_read_ffff_in_generation_1() -> None:
    arm = Firmware(ONE)
    arm.corrupt_limits(6)
    assert tell(arm, "472#0601000000000000", "472#0602000000000000") == [
        "473#06FFFFFFFFFFFF00",
        "47C#06FFFF0000000000",
    ]


def test_the_same_frames_with_end_motion_on() -> None:
    def life() -> list[Frame]:
        arm = Firmware(TWO, seed=3, joints_deg=LEANING)
        tell(
            arm, "471#0702000000000000", END_MOTION_ON[TWO], mode(60), *target(0, 90, -90, 0, 0, 0)
        )
        return arm.step(1.0)

    first = life()
    assert first == life()
    assert len(first) == FRAMES_A_SECOND + 1200


def test_end_motion_in_bytes() -> None:
    arm = ready(TWO)
    tell(arm, END_MOTION_ON[TWO], mode(40), *target(90.0, 0, 0, 0, 0, 0))
    # 0.1 s at 5 rad/s²: 0.5 rad/s = 500 = 0x01F4; the flange is 56.128 mm from the axis:
    # 0.028 m/s = 28 = 0x001C, 0.281 m/s² = 281 = 0x0119; 5 rad/s² = 5000 = 0x1388
    assert heard(arm.step(0.1), 0x481)[-1] == "001C01F401191388"
    # at 40 % of 3 rad/s: 1.2 rad/s = 1200 = 0x04B0, 0.067 m/s = 67 = 0x0043
    assert heard(arm.step(0.4), 0x481)[-1] == "004304B000000000"
    assert heard(arm.step(0.1), 0x482)[-1] == "0000000000000000"


@pytest.mark.parametrize(
    ("version", "geometry"),
    [
        ("S-V1.5-2", PIPER_BEFORE_V1_6_3),
        ("S-V1.6-2", PIPER_BEFORE_V1_6_3),
        ("S-V1.6-3", PIPER),
        ("S-V1.10-0", PIPER),
        ("S-V2.0-0", PIPER),
        ("unreadable", PIPER),
    ],
)
def test_the_end_pose_is_that_of_the_version_s_geometry(version: str, geometry: Geometry) -> None:
    arm = Firmware(TWO, version=version)
    pose = Kinematics(geometry).forward((0.0,) * 6)
    x, y, z = (round(1000 * value) for value in pose[:3])
    words = [value.to_bytes(4, "big", signed=True).hex().upper() for value in (x, y, z)]
    frames = arm.step(0.01)
    assert heard(frames, 0x2A2)[-1] == words[0] + words[1]
    assert heard(frames, 0x2A3)[-1][:8] == words[2]


def test_the_two_geometries_differ() -> None:
    new, old = (Kinematics(each).forward((0.0,) * 6) for each in (PIPER, PIPER_BEFORE_V1_6_3))
    assert math.dist(new[:3], old[:3]) > 5.0
