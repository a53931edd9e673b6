"""Known bugs of firmware versions, as `--bugs` has them."""

from __future__ import annotations

import pytest

from armui.protocol.firmware_version import FirmwareBug, FirmwareVersion, quirks_of
from armui.protocol.generation import Generation
from armui.sim.faults.bugs import NAMES, PURPOSES
from armui.sim.firmware import Firmware
from tests.moments import now
from tests.sim.talk import ENABLE, RESUME, heard, mode, target, tell

MIT = "151#010400AD00000000"
HERE = (0.0, 60.0, -60.0, 0.0, 0.0, 0.0)


def arm_with(bug: FirmwareBug, version: str, joints_deg=HERE) -> Firmware:
    arm = Firmware(Generation.TWO, version=version, joints_deg=joints_deg, bugs=frozenset({bug}))
    tell(arm, ENABLE)
    return arm


def test_every_bug_has_a_name_and_words() -> None:
    assert set(NAMES.values()) == set(PURPOSES) == set(FirmwareBug)
    assert "mit-moves-zero" in NAMES


def test_without_the_option_no_version_has_its_bugs() -> None:
    arm = Firmware(Generation.TWO, version="S-V1.8-2")
    assert quirks_of(FirmwareVersion(1, 8, 2)).bugs
    assert arm.bugs.present == frozenset()
    assert arm.settings.limits[0].min_deg == -150.0


def test_corrupted_limits_read_so_until_they_are_reset() -> None:
    arm = arm_with(FirmwareBug.CORRUPTED_LIMITS, "S-V1.8-2")
    # 0x473: joint 3, max −1 and min −1 in 0.1°; 0x47C: 0xFFFF
    assert tell(arm, "472#0301000000000000")[0].startswith("473#03FFFFFFFF")
    assert tell(arm, "472#0302000000000000") == ["47C#03FFFF0000000000"]
    tell(arm, "477#0002000000000000")
    # factory: −170.0° to 0°, 3 rad/s; 5 rad/s²
    assert tell(arm, "472#0301000000000000") == ["473#030000F95C012C00"]
    assert tell(arm, "472#0302000000000000") == ["47C#0301F40000000000"]


def test_feedback_parts_from_the_true_place_and_a_reset_mends_it() -> None:
    arm = arm_with(FirmwareBug.FEEDBACK_PARTS, "S-V1.8-6")
    arm.step(9.9)
    assert arm.true_joints_deg == pytest.approx(HERE)
    arm.step(10.1)
    assert arm.joints_deg == HERE  # what the arm tells
    assert arm.true_joints_deg[2] == pytest.approx(HERE[2] - 20.0, abs=0.1)
    assert arm.condition.status.name == "NORMAL"
    arm.step(60.0)
    assert arm.true_joints_deg[2] == pytest.approx(HERE[2] - 30.0, abs=0.1)
    true_deg = arm.true_joints_deg
    tell(arm, ENABLE)
    assert arm.joints_deg == HERE  # enabling again doesn't mend it
    tell(arm, RESUME)
    assert arm.joints_deg == pytest.approx(true_deg)
    assert arm.true_joints_deg == pytest.approx(true_deg)


def test_the_way_back_from_mit_fails_and_moves_the_zero_of_joint_1() -> None:
    arm = arm_with(FirmwareBug.MIT_MOVES_ZERO, "S-V1.8-2", (0.0,) * 6)
    tell(arm, mode(100), *target(10, 0, 0, 0, 0, 0))
    arm.step(2.0)
    tell(arm, MIT, mode(100), *target(20, 0, 0, 0, 0, 0))
    arm.step(2.0)
    assert arm.joints_deg[0] == pytest.approx(10.0 - 12.0)
    assert arm.true_joints_deg[0] == pytest.approx(10.0)
    assert arm.settings.zeros_deg[0] == 12.0
    tell(arm, RESUME, ENABLE, mode(100), *target(20, 0, 0, 0, 0, 0))
    arm.step(2.0)
    assert arm.joints_deg[0] == pytest.approx(20.0)
    assert arm.true_joints_deg[0] == pytest.approx(32.0)


def test_zero_feedback_until_the_handle_is_set() -> None:
    arm = arm_with(FirmwareBug.ZERO_FEEDBACK, "S-V1.5-8")
    for identifier in (0x2A6, 0x2A2, 0x252):
        assert set(heard(arm.step(0.02), identifier)) == {"0000000000000000"}
    tell(arm, "47D#6446010000000000")
    # J3 −60.000° = 0xFFFF15A0
    assert heard(arm.step(0.02), 0x2A6)[-1] == "FFFF15A000000000"


def test_a_leader_falls_silent_until_a_power_cycle() -> None:
    arm = arm_with(FirmwareBug.SILENT_LEADER, "S-V1.7-3")
    assert arm.step(0.02)
    assert tell(arm, "470#FA00000000000000") == []
    assert arm.step(1.0) == []
    assert tell(arm, "4AF#0100000000000000") == []
    arm.power_cycle()
    assert arm.step(0.02)
    assert now(arm.leads)


def test_the_arm_falls_back_into_the_leader_s_role() -> None:
    arm = arm_with(FirmwareBug.FALLS_BACK_TO_LEADER, "S-V1.8-2")
    arm.step(29.0)
    assert not now(arm.leads)
    arm.step(1.1)
    assert now(arm.leads)
    tell(arm, "470#FC00000000000000")
    assert not now(arm.leads)
    arm.step(20.0)
    assert not now(arm.leads)
