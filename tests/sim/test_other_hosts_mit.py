"""Hosts written by others, unchanged, drive the simulated arm of several versions, in MIT too.

piper_control is MIT-licensed and not the maker's; it stands on the maker's SDK, which is driven by
itself as well. Both send the code 0x04 and layout A only: from S-V1.8-8 on their MIT does nothing,
as users reported of real arms, and MOVE J still works.
"""

from __future__ import annotations

import json
import math
import subprocess
from collections.abc import Iterator
from typing import Any

import can
import pytest

from armui.protocol.generation import Generation
from armui.sim.firmware import Firmware
from armui.sim.node import Node
from tests.sim.test_sdk_host import WITHIN_S, Meeting, Sdk, meeting, sdk, until

__all__ = ["meeting", "sdk"]

START = (0.0, 60.0, -60.0, 0.0, 10.0, 0.0)
GOAL = (15.0, 75.0, -70.0, -10.0, 20.0, 12.0)
KP, KD = 60.0, 3.0
NEAR_DEG = math.degrees(0.4 / KP) + 1.5
"""Dry friction, and what is left of the weight after the torque fed forward in 8-bit steps."""


@pytest.fixture(params=["S-V1.5-2", "S-V1.7-3", "S-V1.8-5", "S-V1.8-9"])
def arm(request: pytest.FixtureRequest, meeting: Meeting) -> Iterator[Node]:
    """A simulated arm of each version in real time."""
    bus = can.Bus(interface="udp_multicast", channel=meeting.group, port=meeting.port)
    firmware = Firmware(Generation.TWO, joints_deg=START, version=request.param)
    with bus, Node(firmware, bus) as node:
        yield node


class ControlHost:
    """piper_control in its process."""

    def __init__(self, process: subprocess.Popen[str]) -> None:
        assert process.stdin is not None
        assert process.stdout is not None
        self._asks, self._answers = process.stdin, process.stdout

    def __call__(self, what: str, **arguments: Any) -> Any:
        self._asks.write(json.dumps([what, arguments]) + "\n")
        self._asks.flush()
        return json.loads(self._answers.readline())


@pytest.fixture
def host(meeting: Meeting) -> Iterator[ControlHost]:
    with meeting.host("control_host") as process:
        yield ControlHost(process)
        assert process.stdin is not None
        process.stdin.close()
        process.wait(WITHIN_S)


def holding_nm(firmware: Firmware) -> list[float]:
    """What holds the goal's weight, as the version wants it on the wire, in ±8 N·m."""
    weight_nm = firmware.mechanics.weight.torques_nm(GOAL)
    return [
        -nm / scale for nm, scale in zip(weight_nm, firmware.type.mit_torque_scale, strict=True)
    ]


def off_deg(firmware: Firmware) -> float:
    return max(abs(a - b) for a, b in zip(firmware.joints_deg, GOAL, strict=True))


def read_off_deg(host: ControlHost, goal_deg: tuple[float, ...]) -> float:
    read = [math.degrees(each) for each in host("positions")]
    return max(abs(a - b) for a, b in zip(read, goal_deg, strict=True))


def radians(angles_deg: tuple[float, ...]) -> list[float]:
    return [math.radians(angle) for angle in angles_deg]


def test_piper_control(arm: Node, host: ControlHost) -> None:
    firmware = arm.firmware
    # S-V1.8-9 is 1.8.post9 to it
    version = firmware.type.version.removeprefix("S-V").replace("-", ".post")
    until(lambda: host("version") == version, "the version is known")
    host("enable", mit=True)
    assert firmware.enabled == (True,) * 6
    torques_nm = holding_nm(firmware)

    def off_after_commanding_deg() -> float:
        host("mit", target_rad=radians(GOAL), kp=KP, kd=KD, torques_nm=torques_nm, for_s=0.5)
        return off_deg(firmware)

    follows = firmware.type.quirks.mit_code == 0x04
    if follows:
        until(lambda: off_after_commanding_deg() < NEAR_DEG, "the arm is near the goal")
        until(lambda: read_off_deg(host, GOAL) < NEAR_DEG + 0.1, "piper_control reads it there")
        assert firmware.mechanics.driver_torques_nm
    else:
        off_after_commanding_deg()
        assert firmware.joints_deg == pytest.approx(START, abs=0.01)
    if follows and not firmware.type.quirks.exits_by_mode_word:
        assert host("move", target_rad=radians(START), timeout_s=0.5) is False
        host("reset")
    until(lambda: host("move", target_rad=radians(START), timeout_s=2.0), "MOVE J moves it back")
    assert firmware.joints_deg == pytest.approx(START, abs=0.3)


def test_the_maker_s_kit(arm: Node, sdk: Sdk) -> None:
    firmware = arm.firmware
    quirks = firmware.type.quirks

    def knows_version() -> bool:
        sdk("SearchPiperFirmwareVersion")
        return sdk("GetPiperFirmwareVersion") == firmware.type.version

    until(knows_version, "the version is known")
    until(lambda: sdk("EnablePiper"), "EnablePiper")

    def in_mit() -> bool:
        sdk("MotionCtrl_2", 0x01, 0x04, 100, 0xAD)
        return firmware.condition.move_mode == 0x04

    until(in_mit, "the mode is taken")
    goal = [sign * angle for sign, angle in zip(quirks.mit_signs, radians(GOAL), strict=True)]
    torques = [sign * nm for sign, nm in zip(quirks.mit_signs, holding_nm(firmware), strict=True)]

    def off_after_sending_deg() -> float:
        for joint, (angle_rad, torque_nm) in enumerate(zip(goal, torques, strict=True), 1):
            sdk("JointMitCtrl", joint, angle_rad, 0.0, KP, KD, torque_nm)
        return off_deg(firmware)

    if quirks.mit_code == 0x04:
        until(lambda: off_after_sending_deg() < NEAR_DEG, "the arm is near the goal")
        sdk.until_reads("GetArmStatus", "arm_status", {"ctrl_mode": 1, "mode_feed": 4})
    else:
        for _ in range(20):
            off_after_sending_deg()
        assert firmware.joints_deg == pytest.approx(START, abs=0.01)

        def off_by_move_j_deg() -> float:
            sdk("MotionCtrl_2", 0x01, 0x01, 100, 0)
            sdk("JointCtrl", *(round(1000 * angle) for angle in GOAL))
            return off_deg(firmware)

        until(lambda: off_by_move_j_deg() < 0.01, "MOVE J has moved it")
