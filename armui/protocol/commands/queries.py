"""Questions to the arm: 0x472, 0x477 and 0x4AF."""

from __future__ import annotations

from typing import TYPE_CHECKING

from armui.protocol.codes import LimitQuery, ParameterQuery

if TYPE_CHECKING:
    from armui.protocol.codec import Codec
    from armui.protocol.frame import Frame


def query_limits(codec: Codec, joint: int) -> list[Frame]:
    """Asks for a joint's angle and speed limits; answered by LimitFeedback (0x472)."""
    return [codec.encode("LimitQuery", Joint=joint, Query=LimitQuery.ANGLE_AND_SPEED_LIMITS)]


def query_acceleration(codec: Codec, joint: int) -> list[Frame]:
    """Asks for a joint's acceleration limit; answered by AccelerationFeedback (0x472)."""
    return [codec.encode("LimitQuery", Joint=joint, Query=LimitQuery.ACCELERATION_LIMIT)]


def query_end_limits(codec: Codec) -> list[Frame]:
    """Asks for the end's speed and acceleration limits; answered by EndLimitFeedback (0x477)."""
    return [codec.encode("ParameterCommand", Query=ParameterQuery.END_LIMITS)]


def query_collision_levels(codec: Codec) -> list[Frame]:
    """Asks for the collision protection levels; answered by CollisionFeedback (0x477)."""
    return [codec.encode("ParameterCommand", Query=ParameterQuery.COLLISION_LEVELS)]


def query_trajectory_index(codec: Codec) -> list[Frame]:
    """Asks for the index of the trajectory (0x477, generation 2)."""
    return [codec.encode("ParameterCommand", Query=ParameterQuery.TRAJECTORY_INDEX)]


def query_teaching(codec: Codec) -> list[Frame]:
    """Asks for the teaching setting; answered by TeachingFeedback (0x477, generation 2)."""
    return [codec.encode("ParameterCommand", Query=ParameterQuery.TEACHING_SETTING)]


def query_drag_assistance(codec: Codec) -> list[Frame]:
    """Asks how much the joints help the hand; answered by DragAssistanceFeedback (0x477).

    Only firmware from S-V1.8-1 on answers.
    """
    return [codec.encode("ParameterCommand", Query=ParameterQuery.DRAG_ASSISTANCE)]


def query_firmware(codec: Codec) -> list[Frame]:
    """Asks for the firmware version (0x4AF, generation 2).

    Generation 1 stays silent, which is how a host tells the two apart: ask with a codec of
    generation 2.
    """
    return [codec.encode("FirmwareVersion", Byte0=1)]
