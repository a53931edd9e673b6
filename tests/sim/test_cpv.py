"""CPV: 0x181–0x187 written, read and answered; the first position does nothing; the wrong signs."""

from __future__ import annotations

import itertools
import math

import pytest

from armui.protocol.generation import Generation, PiperModel
from armui.sim.firmware import Firmware
from tests.sim.talk import DISABLE, ENABLE, RESUME, STOP, mode, ready, target, tell

CPV = "151#0105320000000000"
MIT = "151#010600AD00000000"
HERE = (0.0, 60.0, -60.0, 0.0, 0.0, 0.0)


def write(joint: int, kind: str, value: int) -> str:
    """`77`, two letters, int32."""
    return f"{0x180 + joint:03X}#77{kind.encode().hex().upper()}{value & 0xFFFFFFFF:08X}"


def read(joint: int, kind: str) -> str:
    return f"{0x180 + joint:03X}#72{kind.encode().hex().upper()}00000000"


def in_cpv(**options) -> Firmware:
    arm = Firmware(Generation.TWO, joints_deg=HERE, **options)
    tell(arm, ENABLE, CPV)
    return arm


def test_the_literal_bytes_of_the_text() -> None:
    # po 0.5 rad = 28.648°, sp 0.5 rad/s
    assert write(1, "po", 28648) == "181#77706F00006FE8"
    assert write(1, "sp", 500) == "181#777370000001F4"
    assert read(1, "kp") == "181#726B7000000000"


def test_a_position_takes_effect_when_it_is_sent_twice() -> None:
    arm = in_cpv()
    line = "181#77706F00006FE8"
    assert tell(arm, line) == []
    arm.step(2.0)
    assert arm.joints_deg == HERE
    tell(arm, line)
    arm.step(3.0)
    assert arm.joints_deg == pytest.approx((28.648, *HERE[1:]), abs=1e-6)
    tell(arm, write(1, "po", -10_000), write(6, "po", 5_000))  # joint 6 for the first time
    arm.step(3.0)
    assert arm.joints_deg == pytest.approx((-10.0, *HERE[1:]), abs=1e-6)


@pytest.mark.parametrize("between", [mode(50), MIT, "151#0005000000000000"])
def test_after_another_mode_the_first_position_does_nothing_again(between: str) -> None:
    arm = in_cpv()
    tell(arm, write(1, "po", 1000), write(1, "po", 1000))
    arm.step(2.0)
    tell(arm, between, *target(*arm.joints_deg), CPV, write(1, "po", 9000))
    arm.step(3.0)
    assert arm.joints_deg[0] == pytest.approx(1.0, abs=0.2)
    tell(arm, CPV, write(1, "po", 9000))  # the mode again changes nothing
    arm.step(3.0)
    assert arm.joints_deg[0] == pytest.approx(9.0, abs=1e-6)


def test_the_profile_keeps_its_speed_and_its_accelerations() -> None:
    arm = in_cpv()
    tell(arm, write(1, "vv", 500), write(1, "ac", 100), write(1, "dc", 50))  # 0.5, 1.0, 0.5
    tell(arm, *[write(1, "po", 90_000)] * 2)
    speeds = [0.0]
    for _ in range(1200):
        arm.step(0.005)
        speeds.append(math.radians(arm.mechanics.speeds_deg_s[0]))
    changes = [(b - a) / 0.005 for a, b in itertools.pairwise(speeds)]
    assert max(speeds) == pytest.approx(0.5, abs=1e-6)
    assert max(changes) == pytest.approx(1.0, abs=1e-6)
    # but for the last step into the goal
    assert sorted(changes)[1] >= -0.5 - 1e-6
    assert arm.joints_deg[0] == pytest.approx(90.0, abs=1e-6)
    # 0.5 s up, 1 s down: 1.5 s for the ends' 0.375 rad, the rest of 1.571 rad at 0.5 rad/s
    taken_s = next(i for i, speed in enumerate(speeds) if i > 10 and speed == 0.0) * 0.005
    assert taken_s == pytest.approx(1.5 + (math.pi / 2 - 0.375) / 0.5, abs=0.05)


@pytest.mark.parametrize(
    ("model", "position_signs", "speed_signs"),
    [
        (PiperModel.PIPER, (1, 1, 1, 1, 1, 1), (1, -1, -1, -1, -1, 1)),
        (PiperModel.PIPER_H, (1, 1, 1, 1, 1, 1), (1, -1, -1, -1, -1, 1)),
        (PiperModel.PIPER_X, (1, 1, 1, -1, -1, 1), (1, -1, -1, 1, 1, 1)),
    ],
)
def test_the_signs_are_wrong_where_the_table_says_so(model, position_signs, speed_signs) -> None:
    for joint, (position, speed) in enumerate(zip(position_signs, speed_signs, strict=True), 1):
        arm = in_cpv(model=model)
        start = arm.joints_deg[joint - 1]
        tell(arm, write(joint, "sp", 200))
        arm.step(0.5)
        turned = arm.joints_deg[joint - 1] - start
        assert math.copysign(1, turned) == speed
        assert arm.mechanics.speeds_deg_s[joint - 1] == pytest.approx(speed * math.degrees(0.2))
        goal = start + 10.0
        tell(arm, *[write(joint, "po", round(position * goal * 1000))] * 2)
        arm.step(3.0)
        assert arm.joints_deg[joint - 1] == pytest.approx(goal, abs=0.001)


def test_a_speed_lasts_until_another_and_ends_at_the_limit() -> None:
    arm = in_cpv()
    tell(arm, write(1, "sp", 1000))
    arm.step(1.0)
    assert arm.joints_deg[0] > 40.0
    tell(arm, write(1, "sp", 0))
    arm.step(1.0)
    halted = arm.joints_deg[0]
    arm.step(1.0)
    assert arm.joints_deg[0] == halted < 90.0
    tell(arm, write(1, "sp", 3000))
    arm.step(5.0)
    assert arm.joints_deg[0] == pytest.approx(150.0, abs=0.5)
    assert arm.mechanics.speeds_deg_s[0] == 0.0


def test_what_is_written_can_be_read() -> None:
    arm = in_cpv()
    for kind, value in (("ac", 321), ("dc", 222), ("vv", 1500), ("pp", 77), ("kp", 88), ("ki", 9)):
        assert tell(arm, write(3, kind, value)) == []
        assert tell(arm, read(3, kind)) == [f"183#61{kind.encode().hex().upper()}{value:08X}"]
    # po 0.5 rad is read as written, though it has not moved the joint
    tell(arm, write(3, "po", -28648))
    assert tell(arm, read(3, "po")) == ["183#61706FFFFF9018"]
    assert tell(arm, "183#61706FFFFF9018") == []  # its own answer, heard again on some buses
    assert arm.joints_deg == HERE


def test_a_speed_of_nothing_as_a_profile_is_not_kept() -> None:
    arm = in_cpv()
    tell(arm, write(1, "vv", 0), write(1, "ac", -5))
    assert tell(arm, read(1, "vv"), read(1, "ac")) == ["181#61767600000BB8", "181#616163000001F4"]


@pytest.mark.parametrize("version", ["S-V1.5-2", "S-V1.7-4"])
def test_there_is_none_before_1_8_1(version: str) -> None:
    arm = in_cpv(version=version)
    assert tell(arm, read(1, "kp"), *[write(1, "po", 9000)] * 2) == []
    arm.step(1.0)
    assert arm.joints_deg == HERE


def test_outside_cpv_targets_move_nothing() -> None:
    arm = ready(joints_deg=HERE)
    tell(arm, mode(50), *[write(1, "po", 9000)] * 3, write(2, "sp", 500))
    arm.step(1.0)
    assert arm.joints_deg == HERE


def test_a_stop_ends_it_and_nothing_of_it_comes_back() -> None:
    arm = in_cpv()
    tell(arm, write(1, "sp", 1000))
    arm.step(0.5)
    tell(arm, STOP)
    arm.step(0.5)
    stopped = arm.joints_deg[0]
    tell(arm, write(1, "sp", 1000), RESUME, ENABLE)
    arm.step(0.5)
    assert arm.joints_deg[0] == stopped
    tell(arm, CPV)
    arm.step(1.0)
    assert arm.joints_deg[0] == stopped


def test_another_mode_brakes_it() -> None:
    arm = in_cpv()
    tell(arm, write(1, "sp", 1000))
    arm.step(0.5)
    tell(arm, mode(50))
    arm.step(2.0)
    braked = arm.joints_deg
    arm.step(2.0)
    assert arm.joints_deg == braked


def test_zero_learning_is_heard_and_moves_no_zero() -> None:
    arm = ready()
    tell(arm, DISABLE, "184#77656565000000", "187#77656565000000")
    arm.step(1.0)
    assert arm.settings.zeros_deg == [0.0] * 6
    assert arm.unsupported["zero learning"] == 2
    assert not arm.ignored
