"""Checks of changes to parameters, before and after saving: pure, by the values read."""

from __future__ import annotations

from collections.abc import Iterable, Mapping
from typing import TYPE_CHECKING, Final

from armui.arm.parameters import Batch, Group, Parameter, check_value, is_corrupt, reading_of
from armui.arm.refusal import Reason, Refusal
from armui.arm.state import ArmState
from armui.control.parameters.setting_frames import as_carried, can_leave_unchanged, step_of

if TYPE_CHECKING:
    from armui.protocol.codec import Codec

SETTING_NOT_TAKEN = Reason(
    "setting_not_taken",
    "{parameter}: {value} was sent and answered, but the arm holds {held}. It did not take "
    "this value; try another one.",
)
SETTING_CORRUPT = Reason(
    "setting_corrupt",
    "{parameter} would have to be sent along, and what the arm holds there is corrupt. Enter "
    "a value for it as well.",
)
LIMITS_CROSSED = Reason(
    "limits_crossed",
    "Joint {joint}: the min. angle {minimum}° must be below the max. angle {maximum}°. Change "
    "one of them.",
)
SETTING_UNKNOWN = Reason(
    "setting_unknown",
    "{parameter} would have to be sent along unchanged and has not been read from the arm. "
    "Read it first.",
)


_SAME_STEPS: Final = 0.51
"""A value read back within this many steps of the frame is the one asked for."""

Changes = Mapping[Parameter, float]
"""New values by parameter, in the operator's units."""


def batches_of(parameters: Iterable[Parameter]) -> list[Batch]:
    """Return the batches that contain the parameters, each once, in their order."""
    return list(dict.fromkeys(parameter.batch for parameter in parameters))


def why_not(codec: Codec, state: ArmState, changes: Changes) -> Refusal | None:
    """Return the first reason against sending changes, or ``None``."""
    for parameter, value in changes.items():
        refusal = check_value(parameter, value)
        if refusal is not None:
            return refusal
    for batch in batches_of(changes):
        refusal = _unknown_neighbour(codec, state, batch, changes) or crossed(state, batch, changes)
        if refusal is not None:
            return refusal
    return None


def frame_values(
    codec: Codec, state: ArmState, batch: Batch, changes: Changes
) -> dict[Parameter, float | None]:
    """Return the values in the frame of a batch: the changes, and the rest unchanged."""
    leaves = can_leave_unchanged(codec, batch)
    values: dict[Parameter, float | None] = {}
    for parameter in batch.parameters():
        known = reading_of(state, parameter)
        as_read = None if leaves or known is None else known.value
        values[parameter] = changes.get(parameter, as_read)
    return values


def not_taken(codec: Codec, state: ArmState, wanted: Changes) -> dict[Parameter, Refusal]:
    """Return the parameters that the arm has not taken, by the values read back."""
    return {
        parameter: SETTING_NOT_TAKEN(
            parameter=parameter.name, joint=parameter.joint, value=value, held=known.value
        )
        for parameter, value in wanted.items()
        if (known := reading_of(state, parameter)) is not None
        and abs(known.value - as_carried(codec, parameter, value))
        > _SAME_STEPS * step_of(codec, parameter)
    }


def crossed(state: ArmState, batch: Batch, changes: Changes) -> Refusal | None:
    """Return a joint whose smallest angle would not be below its greatest, or ``None``."""
    if batch.group is not Group.JOINT_LIMITS:
        return None
    ends = [Parameter(name, batch.joint) for name in ("min_angle_deg", "max_angle_deg")]
    if not any(end in changes for end in ends):
        return None
    for end in ends:
        if end not in changes and is_corrupt(state, end):
            return SETTING_CORRUPT(parameter=end.name, joint=end.joint)
    low, high = (
        changes[end]
        if end in changes
        else known.value
        if (known := reading_of(state, end))
        else None
        for end in ends
    )
    if low is None or high is None or low < high:
        return None
    return LIMITS_CROSSED(joint=batch.joint, minimum=low, maximum=high)


def _unknown_neighbour(
    codec: Codec, state: ArmState, batch: Batch, changes: Changes
) -> Refusal | None:
    """Return a value that is to stay as it is, and is not known.

    Generation 2 can be told to leave it. Even so it must have been read from this very arm: to one
    of generation 1 the mark for «leave it» is a value (0x7FFF, 32.767).
    """
    leaves = can_leave_unchanged(codec, batch)
    for parameter in batch.parameters():
        if parameter in changes:
            continue
        figures: dict[str, int | str] = {"parameter": parameter.name, "joint": parameter.joint}
        if reading_of(state, parameter) is None:
            return SETTING_UNKNOWN(**figures)
        if is_corrupt(state, parameter) and not leaves:
            return SETTING_CORRUPT(**figures)
    return None
