"""Commands past the arm's own planning: MIT 0x15A–0x15F, CPV 0x181–0x187, their mode words.

No operator is offered them: they are for hosts that close a loop of their own, such as those that
drive the simulated arm in the tests. The signs, the torque factor and the code of MOVE M depend on
the firmware: `armui.protocol.firmware_version.quirks_of`.
"""

from __future__ import annotations

import math
from functools import reduce
from operator import xor
from typing import TYPE_CHECKING, Final

from armui.protocol.codes import ControlMode, CpvAction, CpvKind, MitMode, MoveMode
from armui.protocol.commands.motion import set_mode
from armui.protocol.errors import EncodeError
from armui.protocol.frame import Frame

if TYPE_CHECKING:
    from armui.protocol.codec import Codec

GRIPPER: Final = 7
"""Stands for the gripper in zero learning (0x187)."""

_CHECK: Final = "Crc4"
_CPV_SIGNALS: Final = {
    CpvKind.ACCELERATION: "Acceleration",
    CpvKind.DECELERATION: "Deceleration",
    CpvKind.SPEED_KI: "SpeedKi",
    CpvKind.SPEED_KP: "SpeedKp",
    CpvKind.POSITION_TARGET: "PositionTarget",
    CpvKind.POSITION_KP: "PositionKp",
    CpvKind.SPEED_TARGET: "SpeedTarget",
    CpvKind.PROFILE_SPEED: "ProfileSpeed",
}
_LEARN: Final = 0x65
_LEARNERS: Final = (4, 5, 6, GRIPPER)
"""Which joints learn their zero so, by the maker's example."""


def set_mit_mode(codec: Codec, *, speed_percent: float = 0) -> list[Frame]:
    """Hands the joints to their drivers' own loop (0x151); limp until their first setpoint.

    MOVE M has the code of the codec's firmware.
    """
    return set_mode(
        codec,
        control_mode=ControlMode.CAN_CONTROL,
        move_mode=codec.quirks.mit_code,
        speed_percent=speed_percent,
        mit_mode=MitMode.MIT,
    )


def set_high_follow(codec: Codec, *, speed_percent: float = 0) -> list[Frame]:
    """Lets the joints follow joint targets without a plan (0x151); limp until the first ones."""
    return set_mode(
        codec,
        control_mode=ControlMode.CAN_CONTROL,
        move_mode=MoveMode.MOVE_J,
        speed_percent=speed_percent,
        mit_mode=MitMode.MIT,
    )


def set_cpv_mode(codec: Codec, *, speed_percent: float = 50) -> list[Frame]:
    """Lets joints be told position, speed and gains one by one (0x151); from S-V1.8-1."""
    return set_mode(
        codec,
        control_mode=ControlMode.CAN_CONTROL,
        move_mode=MoveMode.MOVE_CPV,
        speed_percent=speed_percent,
    )


def mit_setpoint(
    codec: Codec,
    joint: int,
    *,
    position_rad: float,
    speed_rad_s: float,
    kp: float,
    kd: float,
    torque_nm: float,
) -> list[Frame]:
    """What one joint's driver is to do in MIT (0x15A + joint - 1), in the firmware's layout.

    Values become the step below them, as the maker's kits have it: 0 is not exact (0 rad/s becomes
    -0.011). The torque is that on the wire: its signs and its factor are the caller's.

    Args:
        codec: The arm's codec.
        joint: 1–6.
        position_rad: ±12.5.
        speed_rad_s: ±45.
        kp: 0–500 N·m/rad.
        kd: ±5 N·m·s/rad.
        torque_nm: ±8 up to S-V1.8-7, ±16 from S-V1.8-8.

    Raises:
        EncodeError: A value is out of range: it would wrap to another one.
    """
    name = f"MitControl{_joint('MitControl', joint, range(1, 7))}"
    wanted = {
        "Position": position_rad,
        "Velocity": speed_rad_s,
        "Kp": kp,
        "Kd": kd,
        "Torque": torque_nm,
    }
    frame = codec.encode(name, **wanted)  # refuses what is out of range
    layout = codec.layout(frame.arbitration_id)
    if layout is None:
        raise EncodeError(f"There is no {name} in this generation", message=name)
    raw = dict.fromkeys(layout.signals, 0)
    for signal, value in wanted.items():
        low, high = layout.signals[signal].minimum, layout.signals[signal].maximum
        steps = (value - low) * ((1 << layout.signals[signal].bits) - 1) / (high - low)
        raw[signal] = max(math.trunc(steps), 0)
    data = layout.pack(raw)
    if _CHECK in raw:
        data = data[:-1] + bytes((data[-1] | reduce(xor, data[:-1]) & 0x0F,))
    return [Frame(frame.arbitration_id, data)]


def cpv_write(codec: Codec, joint: int, kind: CpvKind, value: float) -> list[Frame]:
    """Sets one value of a joint in CPV (0x180 + joint).

    Args:
        codec: The arm's codec.
        joint: 1–6.
        kind: Any but zero learning. A position counts only when sent twice where it is the first
            one after CPV was entered.
        value: Degrees, rad/s, rad/s² or a bare number, as the kind has it.
    """
    return [_cpv(codec, joint, CpvAction.WRITE, kind, value)]


def cpv_read(codec: Codec, joint: int, kind: CpvKind) -> list[Frame]:
    """Asks a joint for one value of CPV; answered with the same identifier (0x180 + joint)."""
    return [_cpv(codec, joint, CpvAction.READ, kind, 0)]


def cpv_learn_zero(codec: Codec, joint: int) -> list[Frame]:
    """Lets joint 4, 5 or 6, or the gripper with 7, find its zero at its stop (0x184–0x187).

    Its motor must be off first: it moves by itself, and the others may drop.
    """
    number = _joint("CpvControl", joint, _LEARNERS)
    name = "CpvGripper" if number == GRIPPER else f"CpvControl{number}"
    return [
        codec.encode(name, Action=CpvAction.WRITE, Kind=CpvKind.ZERO_LEARNING, ZeroLearning=_LEARN)
    ]


def _cpv(codec: Codec, joint: int, action: CpvAction, kind: CpvKind, value: float) -> Frame:
    name = f"CpvControl{_joint('CpvControl', joint, range(1, 7))}"
    signal = _CPV_SIGNALS.get(kind)
    if signal is None:
        raise EncodeError(
            f"{name}.Kind cannot be {kind.name} here; give one with a value, or use cpv_learn_zero",
            message=name,
            signal="Kind",
            value=int(kind),
        )
    return codec.encode(name, Action=action, Kind=kind, **{signal: value})


def _joint(message: str, joint: int, allowed: range | tuple[int, ...]) -> int:
    if joint not in allowed:
        raise EncodeError(
            f"{message} has no joint {joint}; it has {', '.join(map(str, allowed))}",
            message=message,
            value=joint,
            minimum=min(allowed),
            maximum=max(allowed),
        )
    return joint
