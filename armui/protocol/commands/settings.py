"""Commands that change what the arm remembers: 0x121, 0x422, 0x470, 0x474–0x47D."""

from __future__ import annotations

from typing import TYPE_CHECKING

from armui.protocol.codes import (
    ALL_JOINTS,
    ALL_LAMPS,
    VALID,
    EndLoad,
    FactoryReset,
    LeaderZero,
    LinkageRole,
    SilenceMode,
)
from armui.protocol.commands.checks import exactly

if TYPE_CHECKING:
    from collections.abc import Mapping, Sequence

    from armui.protocol.codec import Codec
    from armui.protocol.frame import Frame

_JOINTS = tuple(f"J{joint}" for joint in range(1, 7))


def set_parameters(
    codec: Codec, message: str, values: Mapping[str, float | None], joint: int = ALL_JOINTS
) -> list[Frame]:
    """Sets what one frame carries of the values an arm keeps (0x474, 0x475, 0x479, 0x47A, 0x47D).

    Args:
        codec: The arm's codec.
        message: ``LimitSetting``, ``JointSetting``, ``EndLimitSetting``, ``CollisionSetting``,
            ``TeachingSetting`` or ``DragAssistanceSetting``.
        values: By signal, in the unit that ``codec.unit(message, signal)`` says: generation 1 takes
            rpm where generation 2 takes rad/s. None leaves a value unchanged (generation 2).
        joint: 1–6, where the message is about one; 7 is all of them in ``JointSetting``.
    """
    signals = dict(values)
    if "Joint" in codec.signals(message):
        signals["Joint"] = joint
    if message == "JointSetting":
        signals["AccelerationValid"] = VALID
    return [codec.encode(message, **signals)]


def set_joint_zero(codec: Codec, joint: int) -> list[Frame]:
    """Makes the present position of a joint, or of all with 7, its zero (0x475)."""
    return [codec.encode("JointSetting", Joint=joint, SetZero=VALID)]


def clear_joint_error(codec: Codec, joint: int = ALL_JOINTS) -> list[Frame]:
    """Clears the error of a joint, or of all with 7 (0x475)."""
    return [codec.encode("JointSetting", Joint=joint, ClearError=VALID)]


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


def set_drag_assistance(codec: Codec, levels: Sequence[int | None]) -> list[Frame]:
    """Sets how much joints 1–6 help the hand in drag teaching (0x487, from S-V1.8-1).

    Args:
        codec: The arm's codec.
        levels: 0–10 a joint; None leaves a joint's level as it is.
    """
    six = exactly("DragAssistanceSetting", levels, len(_JOINTS), "levels", "")
    return [codec.encode("DragAssistanceSetting", **dict(zip(_JOINTS, six, strict=True)))]


def send_leader_to_zero(codec: Codec, command: LeaderZero) -> list[Frame]:
    """Sends a leader arm to its zero, or back to leading (0x191, from S-V1.7-4): arms MOVE."""
    return [codec.encode("LeaderZero", Command=command)]


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
