"""An arm's half hour in no time: decoded messages as the bus thread hands them on."""

import math

from armui.arm.limits import JOINTS
from armui.protocol.codec import Codec, Message
from armui.protocol.frame import Frame
from armui.protocol.generation import Generation
from armui.telemetry.store import Telemetry

EIGHT_BYTES = Frame(0x2A1, bytes(8))
"""What a frame was, where only its length matters."""
DRIVER_FLAGS = (
    *("Undervoltage", "MotorOvertemperature", "Overcurrent", "DriverOvertemperature"),
    *("CollisionProtection", "DriverFault", "StallProtection"),
)


class Clock:
    """A clock that is set by hand."""

    def __init__(self, time_s=1000.0):
        self.time_s = time_s

    def __call__(self):
        return self.time_s


def telemetry_at(clock, generation=Generation.TWO, **how):
    """A store that knows its arm's generation."""
    telemetry = Telemetry(clock, **how)
    telemetry.on_codec(Codec(generation))
    telemetry.know_generation(generation)
    return telemetry


def angle(joint, t_s):
    """Where a joint is, in degrees."""
    return 40.0 * math.sin(2 * math.pi * t_s / (4.0 + joint)) + joint


def controller_frames(t_s):
    """What the controller sends 200 times a second."""
    for first in (1, 3, 5):
        yield Message(
            f"JointFeedback{first}{first + 1}",
            {f"J{joint}": angle(joint, t_s) for joint in (first, first + 1)},
        )
    for place, axes in enumerate((("X", "Y"), ("Z", "RX"), ("RY", "RZ")), 1):
        signals = {axis: 100.0 * math.sin(t_s / (place + 2)) for axis in axes}
        yield Message(f"EndPose{place}", signals)
    status: dict[str, float] = {
        "ControlMode": 1,
        "Status": 0,
        "MoveMode": 1,
        "TeachingState": 0,
        "MotionState": 1,
    }
    status["TrajectoryPoint"] = 0
    for joint in JOINTS:
        status[f"J{joint}LimitExceeded"] = status[f"J{joint}CommunicationFault"] = 0
    yield Message("ArmStatus", status)
    for joint in JOINTS:
        signals = {
            "Speed": 0.3 * math.cos(t_s / joint),
            "Current": 1.0 + 0.8 * math.sin(3 * t_s + joint),
            "Position": math.radians(angle(joint, t_s)),
        }
        yield Message(f"DriverFast{joint}", signals)


def driver_frames(t_s):
    """What the drivers send 40 times a second."""
    for joint in JOINTS:
        signals = {
            "Voltage": 24.0,
            "DriverTemperature": 35 + joint,
            "MotorTemperature": 30 + joint + int(t_s / 300),
            "BusCurrent": 0.5,
            "Enabled": 1,
        }
        yield Message(f"DriverSlow{joint}", signals | dict.fromkeys(DRIVER_FLAGS, 0))


def feed(telemetry, clock, seconds, rate_hz=200.0, silent=()):
    """Let an arm move for a time; the clock goes on.

    Args:
        silent: Pairs of seconds from the beginning between which nothing is heard.
    """
    begin_s = clock.time_s
    for step in range(round(seconds * rate_hz)):
        t_s = step / rate_hz
        clock.time_s = at_s = begin_s + t_s
        if any(first <= t_s < last for first, last in silent):
            continue
        batch = [(message, at_s, EIGHT_BYTES, 0) for message in controller_frames(t_s)]
        if step % 5 == 0:
            batch += [(message, at_s, EIGHT_BYTES, 0) for message in driver_frames(t_s)]
        telemetry.on_heard(batch)
        telemetry.on_look(at_s)
    clock.time_s = begin_s + seconds
