"""The maker's own SDK, unchanged, as the host: what it reads is what the simulated arm holds.

The SDK runs in a process of its own and meets the arm on a multicast group and port of the test's
own. python-can takes the port from its environment, as any program's user may set it.
"""

from __future__ import annotations

import json
import os
import signal
import socket
import subprocess
import sys
import threading
import time
from collections.abc import Callable, Iterator, Sequence
from math import radians
from pathlib import Path
from typing import IO, Any, NamedTuple

import can
import pytest

from armui.kinematics.arm_kinematics import Kinematics
from armui.protocol.codes import ArmStatusCode, EndLoad, MotionState
from armui.protocol.generation import Generation
from armui.sim.faults.schedule import Fault, fault
from armui.sim.firmware import Firmware
from armui.sim.node import Node
from tests.arm_rig import thin_out
from tests.family import PIPER
from tests.moments import now

WITHIN_S = 50.0
"""More than a busy computer needs; nothing waits longer than it must."""

# some of these wait for several things one after another
pytestmark = pytest.mark.timeout(180)

ROOT = Path(__file__).parents[2]


def until(condition: Callable[[], bool], what: str) -> None:
    """Waits for a condition; fails when it does not come true."""
    deadline_s = time.monotonic() + WITHIN_S
    pause = threading.Event()
    while not condition():
        assert time.monotonic() < deadline_s, f"after {WITHIN_S} s still not: {what}"
        pause.wait(0.01)


class Meeting(NamedTuple):
    """Where host and arm meet."""

    group: str
    port: int

    def environment(self) -> dict[str, str]:
        """For a process that opens a bus with python-can."""
        return os.environ | {
            "CAN_CONFIG": json.dumps({"port": self.port}),
            "PYTHONPATH": str(ROOT),
            "PYTHONUNBUFFERED": "1",
        }

    def host(self, name: str) -> subprocess.Popen[str]:
        """A host of these tests in a process of its own, asked by its input and output."""
        return subprocess.Popen(
            [sys.executable, "-m", f"tests.sim.{name}", self.group],
            env=self.environment(),
            cwd=ROOT,
            text=True,
            stdin=subprocess.PIPE,
            stdout=subprocess.PIPE,
            stderr=subprocess.DEVNULL,
        )


@pytest.fixture
def meeting() -> Meeting:
    """A port nobody uses, and a group made of it."""
    with socket.socket(socket.AF_INET, socket.SOCK_DGRAM) as free:
        free.bind(("", 0))
        port = free.getsockname()[1]
    return Meeting(f"239.74.{port >> 8}.{port & 0xFF}", port)


class Sdk:
    """The SDK in its process."""

    def __init__(self, asks: IO[str], answers: IO[str]) -> None:
        self._asks = asks
        self._answers = answers

    def __call__(self, method: str, *arguments: Any) -> Any:
        """Calls a public method of C_PiperInterface_V2; returns what it returned, in plain."""
        self._asks.write(json.dumps([method, arguments]) + "\n")
        self._asks.flush()
        return json.loads(self._answers.readline())

    def until_reads(self, method: str, part: str, expected: dict[str, Any]) -> None:
        """Waits until a part of what a method returns holds the values expected."""
        read: dict[str, Any] = {}

        def equal() -> bool:
            read.update(self(method)[part])
            return expected.items() <= read.items()

        try:
            until(equal, f"{method} reads {expected}")
        except AssertionError as error:
            raise AssertionError(f"{error}, but {read}") from None


@pytest.fixture
def arm(meeting: Meeting) -> Iterator[Node]:
    """A simulated arm in real time, to be looked into.

    It tells everything 50 times a second: the group brings it its own frames back, and on a busy
    computer thousands of them would push a command, which is said once, out of its socket.
    """
    firmware = Firmware(Generation.TWO, joints_deg=(0, 20, -30, 0, 10, 0))
    thin_out(firmware)
    bus = can.Bus(interface="udp_multicast", channel=meeting.group, port=meeting.port)
    with bus, Node(firmware, bus) as node:
        yield node


@pytest.fixture
def sdk(meeting: Meeting) -> Iterator[Sdk]:
    with meeting.host("sdk_host") as process:
        assert process.stdin is not None
        assert process.stdout is not None
        yield Sdk(process.stdin, process.stdout)
        process.stdin.close()
        process.wait(WITHIN_S)


def enable(sdk: Sdk) -> None:
    until(lambda: sdk("EnablePiper"), "EnablePiper")


def break_it(arm: Node, broken: Fault) -> None:
    """Starts a fault while the arm holds its breath: its thread alone touches what it is."""
    arm.stop()
    arm.faults.start(broken)
    arm.start()


def joints(firmware: Firmware) -> dict[str, int]:
    """As the SDK counts them: 0.001°."""
    return {f"joint_{i}": round(1000 * q) for i, q in enumerate(firmware.joints_deg, 1)}


def test_enable_move_and_read_where_it_is(arm: Node, sdk: Sdk) -> None:
    firmware = arm.firmware
    enable(sdk)
    assert firmware.enabled == (True,) * 6
    assert sdk("GetArmEnableStatus") == [True] * 6
    sdk("MotionCtrl_2", 0x01, 0x01, 100)
    sdk("JointCtrl", 20_000, 30_000, -40_000, 5_000, 10_500, -15_000)
    goal = (20.0, 30.0, -40.0, 5.0, 10.5, -15.0)
    until(lambda: firmware.joints_deg == goal, "the arm is there")
    sdk.until_reads("GetArmJointMsgs", "joint_state", joints(firmware))
    pose = [round(1000 * value) for value in Kinematics(PIPER).forward(goal)]
    axes = ("X_axis", "Y_axis", "Z_axis", "RX_axis", "RY_axis", "RZ_axis")
    sdk.until_reads("GetArmEndPoseMsgs", "end_pose", dict(zip(axes, pose, strict=True)))
    sdk.until_reads(
        "GetArmStatus",
        "arm_status",
        {"ctrl_mode": 1, "mode_feed": 1, "motion_status": MotionState.REACHED, "arm_status": 0},
    )
    for joint, angle_deg in enumerate(goal, 1):
        position = {"pos": round(1000 * radians(angle_deg)), "motor_speed": 0}
        sdk.until_reads("GetArmHighSpdInfoMsgs", f"motor_{joint}", position)


AXES = ("X_axis", "Y_axis", "Z_axis", "RX_axis", "RY_axis", "RZ_axis")
READY_DEG = (0.0, 60.0, -60.0, 0.0, -20.0, 0.0)


def pose_at(joints_deg: Sequence[float]) -> list[int]:
    """As the SDK counts a pose: 0.001 mm and 0.001°."""
    return [round(1000 * value) for value in Kinematics(PIPER).forward(joints_deg)]


def until_at(sdk: Sdk, arm: Node, goal: list[int]) -> None:
    """Waits until the SDK reads a pose and no motion; it must be what the arm's joints say."""

    def there() -> bool:
        read = sdk("GetArmEndPoseMsgs")["end_pose"]
        status = sdk("GetArmStatus")["arm_status"]
        near = all(abs(read[axis] - value) <= 20 for axis, value in zip(AXES, goal, strict=True))
        return near and status["motion_status"] == MotionState.REACHED

    until(there, f"the tool is at {goal}")
    pose = pose_at(arm.firmware.joints_deg)
    sdk.until_reads("GetArmEndPoseMsgs", "end_pose", dict(zip(AXES, pose, strict=True)))
    sdk.until_reads("GetArmJointMsgs", "joint_state", joints(arm.firmware))


def test_end_pose_line_and_arc(arm: Node, sdk: Sdk) -> None:
    enable(sdk)
    start = pose_at(READY_DEG)
    sdk("MotionCtrl_2", 0x01, 0x00, 100)
    sdk("EndPoseCtrl", *start)
    until_at(sdk, arm, start)
    sdk.until_reads("GetArmStatus", "arm_status", {"mode_feed": 0, "arm_status": 0})

    beside = [start[0], start[1] + 60_000, *start[2:]]
    sdk("MotionCtrl_2", 0x01, 0x02, 100)
    sdk("EndPoseCtrl", *beside)
    until_at(sdk, arm, beside)
    sdk.until_reads("GetArmStatus", "arm_status", {"mode_feed": 2, "arm_status": 0})

    above = [start[0], start[1] + 30_000, start[2] + 30_000, *start[3:]]
    for number, pose in enumerate((beside, above, start), 1):
        sdk("EndPoseCtrl", *pose)
        sdk("MoveCAxisUpdateCtrl", number)
    sdk("MotionCtrl_2", 0x01, 0x03, 100)
    until_at(sdk, arm, start)
    sdk.until_reads("GetArmStatus", "arm_status", {"mode_feed": 3, "arm_status": 0})


def test_gripper(arm: Node, sdk: Sdk) -> None:
    enable(sdk)
    sdk("GripperCtrl", 40_000, 1_000, 0x01, 0)
    until(lambda: arm.firmware.gripper.travel == 40.0, "the gripper is open")
    sdk.until_reads("GetArmGripperMsgs", "gripper_state", {"grippers_angle": 40_000})
    state = sdk("GetArmGripperMsgs")["gripper_state"]
    assert state["foc_status"]["driver_enable_status"] is True


def test_drivers_are_read_as_they_are(arm: Node, sdk: Sdk) -> None:
    enable(sdk)
    drivers = arm.firmware.drivers
    for joint in range(1, 7):
        temperatures = {
            "foc_temp": round(drivers.driver_temperatures_c[joint - 1]),
            "motor_temp": round(drivers.motor_temperatures_c[joint - 1]),
            "foc_status_code": 0x40,
        }
        sdk.until_reads("GetArmLowSpdInfoMsgs", f"motor_{joint}", temperatures)
        current = {"current": round(1000 * drivers.currents_a[joint - 1])}
        sdk.until_reads("GetArmHighSpdInfoMsgs", f"motor_{joint}", current)
        assert sdk("GetArmLowSpdInfoMsgs")[f"motor_{joint}"]["vol"] == pytest.approx(240, abs=3)


def test_settings_are_set_and_read_back(arm: Node, sdk: Sdk) -> None:
    settings = arm.firmware.settings
    until(lambda: sdk("GetPiperFirmwareVersion") == "S-V1.8-9", "the version is known")

    sdk("MotorAngleLimitMaxSpdSet", 1, 900, -450, 150)
    answer = {"instruction_index": 0x74, "is_set_zero_successfully": 0}
    sdk.until_reads("GetRespInstruction", "instruction_response", answer)
    sdk("SearchMotorMaxAngleSpdAccLimit", 1, 0x01)
    sdk.until_reads(
        "GetCurrentMotorAngleLimitMaxVel",
        "current_motor_angle_limit_max_vel",
        {"motor_num": 1, "max_angle_limit": 900, "min_angle_limit": -450, "max_joint_spd": 150},
    )
    assert (settings.limits[0].min_deg, settings.limits[0].max_deg) == (-45.0, 90.0)

    sdk("JointMaxAccConfig", 2, 250)
    sdk.until_reads("GetRespInstruction", "instruction_response", {"instruction_index": 0x75})
    sdk("SearchMotorMaxAngleSpdAccLimit", 2, 0x02)
    acceleration = {"joint_motor_num": 2, "max_joint_acc": 250}
    sdk.until_reads("GetCurrentMotorMaxAccLimit", "current_motor_max_acc_limit", acceleration)

    sdk("CrashProtectionConfig", 0, 1, 2, 3, 4, 8)
    sdk("ArmParamEnquiryAndConfig", 0x02)
    levels = {f"joint_{j}_protection_level": n for j, n in enumerate((0, 1, 2, 3, 4, 8), 1)}
    sdk.until_reads("GetCrashProtectionLevelFeedback", "crash_protection_level_feedback", levels)
    assert settings.collision_levels == (0, 1, 2, 3, 4, 8)

    sdk("EndSpdAndAccParamSet", 100, 200, 300, 400)
    sdk("ArmParamEnquiryAndConfig", 0x01)
    end_limits = {
        "end_max_linear_vel": 100,
        "end_max_angular_vel": 200,
        "end_max_linear_acc": 300,
        "end_max_angular_acc": 400,
    }
    sdk.until_reads("GetCurrentEndVelAndAccParam", "current_end_vel_acc_param", end_limits)

    sdk("GripperTeachingPendantParamConfig", 150, 100, 10)
    sdk("ArmParamEnquiryAndConfig", 0x04)
    teaching = {"teaching_range_per": 150, "max_range_config": 100, "teaching_friction": 10}
    part = "arm_gripper_teaching_param_feedback"
    sdk.until_reads("GetGripperTeachingPendantParamFeedback", part, teaching)

    sdk("ArmParamEnquiryAndConfig", 0, 0, 0, 0xAE, 2)
    until(lambda: settings.load is EndLoad.FULL, "the load is told")
    sdk("ArmParamEnquiryAndConfig", 0, 2)
    sdk.until_reads("GetRespInstruction", "instruction_response", {"instruction_index": 0x77})
    until(lambda: settings.limits[0].max_deg == 150.0, "the joint limits are the factory's")
    assert not arm.firmware.ignored


def test_zero(arm: Node, sdk: Sdk) -> None:
    assert arm.firmware.joints_deg[1] == 20.0
    until(lambda: sdk("isOk"), "the SDK hears the arm")
    sdk("JointConfig", 2, 0xAE)
    answer = {"instruction_index": 0x75, "is_set_zero_successfully": 1}
    sdk.until_reads("GetRespInstruction", "instruction_response", answer)
    sdk.until_reads("GetArmJointMsgs", "joint_state", {"joint_2": 0, "joint_3": -30_000})
    assert arm.firmware.settings.zeros_deg[1] == 20.0


def test_stop_and_reset(arm: Node, sdk: Sdk) -> None:
    firmware = arm.firmware
    enable(sdk)
    sdk("MotionCtrl_2", 0x01, 0x01, 20)
    sdk("JointCtrl", 140_000, 30_000, -40_000, 0, 0, 0)
    sdk.until_reads("GetArmStatus", "arm_status", {"motion_status": MotionState.NOT_REACHED})
    sdk("EmergencyStop", 0x01)
    sdk.until_reads("GetArmStatus", "arm_status", {"arm_status": ArmStatusCode.EMERGENCY_STOP})
    assert now(firmware.condition.stopped)
    until(lambda: sdk("GetArmEnableStatus") == [False] * 6, "the motors are off")
    assert firmware.joints_deg[0] < 140.0
    sdk("ResetPiper")
    sdk.until_reads("GetArmStatus", "arm_status", {"arm_status": 0, "ctrl_mode": 0})
    assert not now(firmware.condition.stopped)
    enable(sdk)
    assert firmware.enabled == (True,) * 6


@pytest.mark.parametrize(
    ("name", "status", "bit"),
    [
        ("collision", 7, "collision_status"),
        ("driver-overtemperature", 9, "driver_overheating"),
        ("overcurrent", 9, "driver_overcurrent"),
    ],
)
def test_faults_are_read_as_what_they_are(
    arm: Node, sdk: Sdk, name: str, status: int, bit: str
) -> None:
    enable(sdk)
    break_it(arm, fault(name, 2))
    sdk.until_reads("GetArmStatus", "arm_status", {"arm_status": status})

    def shows() -> bool:
        return sdk("GetArmLowSpdInfoMsgs")["motor_2"]["foc_status"][bit] is True

    until(shows, bit)


def test_a_joint_that_is_lost_is_named(arm: Node, sdk: Sdk) -> None:
    break_it(arm, fault("joint-communication", 3))
    sdk.until_reads("GetArmStatus", "arm_status", {"arm_status": 5})
    flags = sdk("GetArmStatus")["arm_status"]["err_status"]
    assert [name for name, value in flags.items() if value] == ["communication_status_joint_3"]


def test_against_the_command_in_a_process_of_its_own(
    meeting: Meeting, sdk: Sdk, tmp_path: Path
) -> None:
    """`armui sim` by its name, its options, and its end by Ctrl-C."""
    command = [sys.executable, "-m", "armui", "sim", "--interface", "udp_multicast"]
    options = ["--channel", meeting.group, "--firmware", "S-V1.7-3"]
    flash = tmp_path / "arm.json"
    with subprocess.Popen(
        [*command, *options, "--flash", str(flash)],
        env=meeting.environment(),
        cwd=ROOT,
        text=True,
        stdout=subprocess.PIPE,
        # a shell that runs the tests in the background has them, and their children, ignore Ctrl-C
        preexec_fn=lambda: signal.signal(signal.SIGINT, signal.SIG_DFL),  # noqa: PLW1509 - no lock in it
    ) as process:
        assert process.stdout is not None
        first = process.stdout.readline()
        sdk("PiperInit")
        until(lambda: sdk("GetPiperFirmwareVersion") == "S-V1.7-3", "the version is known")
        enable(sdk)
        sdk("MotionCtrl_2", 0x01, 0x01, 100)
        sdk("JointCtrl", 10_000, 10_000, -10_000, 0, 0, 0)
        sdk.until_reads("GetArmJointMsgs", "joint_state", {"joint_1": 10_000, "joint_2": 10_000})
        sdk("CrashProtectionConfig", 0, 1, 2, 3, 4, 8)
        sdk.until_reads("GetRespInstruction", "instruction_response", {"instruction_index": 0x7A})
        status = process.stdout.readline()
        process.send_signal(signal.SIGINT)
        rest = process.stdout.read()
        assert process.wait(WITHIN_S) == 0
    assert first == (
        f"Simulated arm, generation 2, on udp_multicast {meeting.group}. Ctrl-C ends it.\n"
    )
    assert "  sent 3" in status
    assert rest.endswith("\n")
    assert json.loads(flash.read_text())["collision_levels"] == [0, 1, 2, 3, 4, 8]
