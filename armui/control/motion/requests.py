"""The requests that motions of the joints and of the tool make of the gate."""

from __future__ import annotations

from collections.abc import Callable, Mapping, Sequence
from typing import TYPE_CHECKING

from armui.arm.refusal import Refusal
from armui.control.motion.motion_command import CommandKind
from armui.control.safety.gate import MotionRequest
from armui.protocol import commands
from armui.protocol.codes import MoveMode

if TYPE_CHECKING:
    from armui.control.context import Context
    from armui.control.events import Notice
    from armui.control.operating_state import OperatingState
    from armui.control.operations.started import Started
    from armui.ways.way import Way


def joint_request(
    context: Context,
    started: Started,
    target_deg: Sequence[float],
    speed_percent: Callable[[], int],
    *,
    most_percent: int = 100,
    why_not: Callable[[OperatingState], Refusal | None],
    sent_event: tuple[Notice, Mapping[str, object]] | None = None,
    kind: CommandKind = CommandKind.JOINTS,
) -> MotionRequest:
    """Return the request of a motion of the joints to six angles (MOVE J, 0x155–0x157, 0x151).

    Args:
        context: The context that the controller's parts share.
        started: The record of its operation.
        target_deg: The six angles.
        speed_percent: Returns the speed in the mode word.
        most_percent: The highest one that it may be given.
        why_not: Returns a reason against it other than its way, or ``None``.
        sent_event: The notice, with its figures, that reports the sending.
        kind: The kind of the command.
    """

    def plan(begin_deg: Sequence[float]) -> Way:
        from armui.ways.way import joint_way  # noqa: PLC0415 - numpy

        return joint_way(begin_deg, target_deg)

    return MotionRequest(
        started=started,
        kind=kind,
        move_mode=MoveMode.MOVE_J,
        speed_percent=speed_percent,
        most_percent=most_percent,
        plan=plan,
        frames=lambda percent: commands.move_joints(
            context.connection.codec, target_deg, speed_percent=percent
        ),
        why_not=why_not,
        joints_deg=tuple(target_deg),
        sent_event=sent_event,
    )
