"""The answers to clients about the program and the arm, except for the measured state."""

from __future__ import annotations

from collections.abc import Sequence
from typing import TYPE_CHECKING

from armui import __version__
from armui.arm.limits import JOINTS, check_joints
from armui.control.motion.target_stream import REST_S, SETTLING_S, STREAM_DEG_S
from armui.interface.lease import SILENT_S
from armui.interface.messages import PROTOCOL, Json, plain
from armui.interface.methods import MOST_POINTS, MOST_RATE_HZ
from armui.interface.plain_forms import asks, offered

if TYPE_CHECKING:
    from armui.control.arm_controller import ArmController


def hello(controller: ArmController, client: int) -> Json:
    """Return the answer to a client's first call: program, arm, limits, rates and its number."""
    now = controller.operating_state
    return {
        "program": "armui",
        "version": __version__,
        "protocol": PROTOCOL,
        "client": client,
        "arm": {
            "link": now.link.name.lower(),
            "device": None if now.device is None else now.device.label or now.device.channel,
            "simulated": now.device is not None and now.device.simulated,
            "model": now.model.value,
            "generation": None if now.generation is None else int(now.generation),
            "firmware": controller.state.firmware,
        },
        "limits": [
            {
                "min_deg": each.min_deg,
                "max_deg": each.max_deg,
                "max_speed_deg_s": each.max_speed_deg_s,
            }
            for each in now.limits
        ],
        "rates": {
            "state_hz": MOST_RATE_HZ,
            "stream_hz": [10.0, 100.0],
            "stream_max_deg_s": STREAM_DEG_S,
            "stream_smoothing_s": SETTLING_S,
            "stream_rests_after_s": REST_S,
            "silent_after_s": SILENT_S,
            "check_points": MOST_POINTS,
        },
    }


def operations(controller: ArmController) -> list[Json]:
    """Return the operations that clients can call, each with the reason against it now."""
    now = controller.operating_state
    listed = []
    for bound in offered(controller.operations):
        operation = bound.operation
        refusal = operation.why_not_now(now)
        listed.append(
            {
                "id": operation.id,
                "title": operation.title,
                "moves": operation.moves,
                "asks_the_operator": asks(operation),
                "why_not": None if refusal is None else plain(refusal),
            }
        )
    return listed


def forward(controller: ArmController, joints_deg: Sequence[float]) -> Json:
    """Return the pose of the flange at six angles."""
    pose = controller.cartesian.kinematics().forward(joints_deg)
    return {"flange_pose_mm_deg": plain(tuple(pose))}


def inverse(
    controller: ArmController, flange_pose_mm_deg: Sequence[float], near_deg: Sequence[float] | None
) -> Json:
    """Return the angles for a pose within the limits, nearest to given or measured ones first."""
    from armui.kinematics.poses import Pose  # noqa: PLC0415 - numpy

    near = near_deg or controller.state.angles_deg() or (0.0,) * len(JOINTS)
    found = controller.cartesian.kinematics().inverse(Pose(*flange_pose_mm_deg), near)
    limits = controller.operating_state.limits
    within = [each for each in found if check_joints(each, limits) is None]
    return {"joints_deg": plain([tuple(each) for each in within])}
