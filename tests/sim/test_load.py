"""What hangs at the flange: currents, heat, and how the arm gives way."""

from __future__ import annotations

import math

import pytest

from armui.kinematics.arm_kinematics import Kinematics
from armui.protocol.codec import Codec, Message
from armui.protocol.generation import Generation
from armui.sim.firmware import Firmware
from armui.sim.mechanics.gravity import Weight
from tests.family import PIPER
from tests.sim.talk import DISABLE, STOP, ready, tell

TWO = Generation.TWO
LEANING = (10.0, 110.0, -60.0, 0.0, 10.0, 15.0)
LOADS = ["477#000000AE00000000", "477#000000AE01000000", "477#000000AE02000000"]
SILENCE = "422#0100000000000000"
NO_DETECTION = "47A#0000000000000000"


def current_a(arm: Firmware, joint: int) -> float:
    """As the frames 0x251–0x256 tell it."""
    frame = [each for each in arm.step(0.1) if each.arbitration_id == 0x250 + joint][-1]
    message = Codec(TWO).decode(frame)
    assert isinstance(message, Message)
    return message.signals["Current"]


@pytest.mark.parametrize("joint", [2, 3, 5])
@pytest.mark.parametrize("pose", [LEANING, (0, 150, -60, 0, 0, 0), (0, 60, -120, 0, -50, 0)])
def test_a_payload_weighs_as_its_height_changes(joint: int, pose: tuple[float, ...]) -> None:
    """Virtual work: a weight's torque on a joint is the weight times the height it loses."""
    kinematics, nudge_deg = Kinematics(PIPER), 0.01
    heights_m = []
    for sign in (-1, 1):
        nudged = list(pose)
        nudged[joint - 1] += sign * nudge_deg
        heights_m.append(kinematics.forward(nudged).z_mm / 1000)
    gradient_m = (heights_m[1] - heights_m[0]) / math.radians(2 * nudge_deg)
    torques_nm = [Weight(payload_kg=mass_kg).torques_nm(pose)[joint - 1] for mass_kg in (0.0, 1.5)]
    assert torques_nm[1] - torques_nm[0] == pytest.approx(-1.5 * 9.81 * gradient_m, abs=0.05)


def test_a_load_the_host_tells_of_takes_more_current() -> None:
    arm = ready(joints_deg=LEANING)
    currents = []
    for line in LOADS:
        tell(arm, line)
        currents.append(current_a(arm, 2))
    # leaning forward, joint 2 is pulled to larger angles and pushes back
    assert 0.0 > currents[0] > currents[1] + 0.2 > currents[2] + 0.4


def test_a_real_load_counts_whatever_the_host_says() -> None:
    arm = ready(joints_deg=LEANING)
    tell(arm, NO_DETECTION)
    empty = current_a(arm, 2)
    arm.settings_applier.hang(1.5)
    loaded = current_a(arm, 2)
    assert loaded < empty - 0.4
    tell(arm, *LOADS)
    assert current_a(arm, 2) == loaded
    arm.settings_applier.hang(None)
    tell(arm, LOADS[0])
    assert current_a(arm, 2) == empty


def test_a_motor_that_holds_more_gets_warmer() -> None:
    def after_minutes(load: str) -> float:
        arm = ready(joints_deg=LEANING)
        tell(arm, load, SILENCE)
        arm.step(120.0)
        return arm.drivers.motor_temperatures_c[1]

    empty, full = after_minutes(LOADS[0]), after_minutes(LOADS[2])
    assert empty + 2.5 < full < 45.0


def test_a_motor_without_power_cools() -> None:
    arm = ready(joints_deg=LEANING)
    tell(arm, LOADS[2], SILENCE)
    arm.step(120.0)
    warm_c = arm.drivers.motor_temperatures_c[1]
    tell(arm, DISABLE)
    arm.step(120.0)
    assert arm.drivers.motor_temperatures_c[1] < warm_c - 2.5


def test_a_loaded_arm_sinks_faster() -> None:
    def sunk_deg(load: str) -> float:
        arm = ready(joints_deg=LEANING)
        tell(arm, load, STOP)
        arm.step(1.0)
        return arm.joints_deg[2] - LEANING[2]

    assert sunk_deg(LOADS[2]) > 1.5 * sunk_deg(LOADS[0]) > 0.5


def test_a_motor_pushes_back() -> None:
    arm = ready(joints_deg=LEANING)
    assert current_a(arm, 1) == 0.0
    arm.protection.push(0, 1.2)
    # k·b·c = 1.18125·4·1 = 4.725 N·m an ampere
    assert current_a(arm, 1) == -0.254
    assert arm.joints_deg == LEANING
