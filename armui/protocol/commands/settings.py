"""Commands that change what the arm remembers: 0x121, 0x422, 0x470, 0x474–0x47D."""

from __future__ import annotations

from typing import TYPE_CHECKING

from armui.protocol.codes import (
    ALL_JOINTS,
    ALL_LAMPS,
    VALID,
    EndLoad,
    FactoryReset,
    LinkageRole,
    SilenceMode,
)
from armui.protocol.commands.checks import exactly

if TYPE_CHECKING:
    from collections.abc import Sequence

    from armui.protocol.codec import Codec
    from armui.protocol.frame import Frame


def set_limits(
    codec: Codec,
    joint: int,
    *,
    max_angle_deg: float | None,
    min_angle_deg: float | None,
    max_speed: float | None,
) -> list[Frame]:
    """Sets a joint's angle and speed limits (0x474).

    Args:
        codec: The arm's codec.
        joint: 1–6.
        max_angle_deg: None leaves it unchanged (generation 2).
        min_angle_deg: None leaves it unchanged (generation 2).
        max_speed: In rad/s (generation 2) or rpm (generation 1), as
            `codec.unit("LimitSetting", "MaxSpeed")` says. None leaves it unchanged (generation 2).
    """
    return [
        codec.encode(
            "LimitSetting",
            Joint=joint,
            MaxAngle=max_angle_deg,
            MinAngle=min_angle_deg,
            MaxSpeed=max_speed,
        )
    ]


def set_joint_acceleration(codec: Codec, joint: int, max_acceleration: float | None) -> list[Frame]:
    """Sets the acceleration limit of a joint, or of all with 7 (0x475).

    Args:
        codec: The arm's codec.
        joint: 1–7.
        max_acceleration: In rad/s² (generation 2) or rpm/s (generation 1), as
            `codec.unit("JointSetting", "MaxAcceleration")` says. None leaves it unchanged
            (generation 2).
    """
    return [
        codec.encode(
            "JointSetting", Joint=joint, AccelerationValid=VALID, MaxAcceleration=max_acceleration
        )
    ]


def set_joint_zero(codec: Codec, joint: int) -> list[Frame]:
    """Makes the present position of a joint, or of all with 7, its zero (0x475)."""
    return [codec.encode("JointSetting", Joint=joint, SetZero=VALID)]


def clear_joint_error(codec: Codec, joint: int = ALL_JOINTS) -> list[Frame]:
    """Clears the error of a joint, or of all with 7 (0x475)."""
    return [codec.encode("JointSetting", Joint=joint, ClearError=VALID)]


def set_end_limits(
    codec: Codec,
    *,
    max_linear_speed_m_s: float | None,
    max_angular_speed_rad_s: float | None,
    max_linear_acceleration_m_s2: float | None,
    max_angular_acceleration_rad_s2: float | None,
) -> list[Frame]:
    """Sets the end's limits (0x479); None leaves one unchanged, in generation 2."""
    return [
        codec.encode(
            "EndLimitSetting",
            MaxLinearSpeed=max_linear_speed_m_s,
            MaxAngularSpeed=max_angular_speed_rad_s,
            MaxLinearAcceleration=max_linear_acceleration_m_s2,
            MaxAngularAcceleration=max_angular_acceleration_rad_s2,
        )
    ]


def reset_end_limits(codec: Codec) -> list[Frame]:
    """Restores the factory values of the end's limits (0x477)."""
    return [codec.encode("ParameterCommand", Reset=FactoryReset.END_LIMITS_TO_FACTORY)]


def reset_joint_limits(codec: Codec) -> list[Frame]:
    """Restores the factory limits, speeds and accelerations of the joints (0x477, generation 2)."""
    return [codec.encode("ParameterCommand", Reset=FactoryReset.JOINT_LIMITS_TO_FACTORY)]


def set_end_feedback(codec: Codec, *, on: bool) -> list[Frame]:
    """Switches the feedback 0x481–0x486 (0x477); the code differs between the generations."""
    word = "On" if on else "Off"
    code = codec.code("ParameterCommand", "EndFeedback", word)
    return [codec.encode("ParameterCommand", EndFeedback=code)]


def set_load(codec: Codec, load: EndLoad) -> list[Frame]:
    """Tells the arm what it carries: nothing, half or the full payload (0x477)."""
    return [codec.encode("ParameterCommand", LoadValid=VALID, Load=load)]


def set_collision_levels(codec: Codec, levels: Sequence[int]) -> list[Frame]:
    """Sets the collision protection level of each joint, 0 (none) to 8 (0x47A)."""
    values = exactly("CollisionSetting", levels, 6, "levels", "")
    return [codec.encode("CollisionSetting", **{f"J{j}": v for j, v in enumerate(values, 1)})]


def set_teaching(
    codec: Codec, *, teaching_range_percent: float, stroke_limit_mm: int, friction: int
) -> list[Frame]:
    """Sets the teaching handle (0x47D, generation 2).

    Args:
        codec: The arm's codec.
        teaching_range_percent: 100–200.
        stroke_limit_mm: 0, 70 or 100.
        friction: 1–10.
    """
    return [
        codec.encode(
            "TeachingSetting",
            TeachingRange=teaching_range_percent,
            StrokeLimit=stroke_limit_mm,
            Friction=friction,
        )
    ]


def set_linkage(
    codec: Codec,
    role: LinkageRole,
    *,
    feedback_offset: int = 0,
    control_offset: int = 0,
    target_offset: int = 0,
) -> list[Frame]:
    """Makes the arm a teaching input or a motion output (0x470); offsets are 0, 0x10 or 0x20."""
    return [
        codec.encode(
            "LinkageSetting",
            Role=role,
            FeedbackOffset=feedback_offset,
            ControlOffset=control_offset,
            TargetOffset=target_offset,
        )
    ]


def set_bus_silence(codec: Codec, mode: SilenceMode) -> list[Frame]:
    """Silences the bus for a firmware upgrade, or ends the silence (0x422)."""
    return [codec.encode("BusSilence", Mode=mode)]


def set_light(
    codec: Codec,
    joint: int,
    rgb: Sequence[int],
    *,
    lamp: int = ALL_LAMPS,
    counter: int = 0,
    enable: bool = True,
) -> list[Frame]:
    """Colours the lamps of a joint (0x121).

    Args:
        codec: The arm's codec.
        joint: 1–6.
        rgb: Red, green, blue, 0–255 each.
        lamp: 0–254, or 255 for all.
        counter: Counts the frames, 0–255.
        enable: False sends a frame that the arm ignores.
    """
    red, green, blue = exactly("LightControl", rgb, 3, "colour values", "")
    return [
        codec.encode(
            "LightControl",
            Enable=int(enable),
            Joint=joint,
            Lamp=lamp,
            Red=red,
            Green=green,
            Blue=blue,
            Counter=counter,
        )
    ]
