"""运动控制: the joints are sent to angles, together or one step at a time (manual 1.0.7.1)."""

from __future__ import annotations

from collections.abc import Sequence
from typing import Final

from armui.arm.limits import check_joints
from armui.arm.refusal import Refusal
from armui.control import gate, reports
from armui.control.context import Context
from armui.control.setpoint import Setpoint
from armui.control.speed import speed_frames
from armui.protocol import commands

_HOME_DEG: Final = (0.0,) * 6
_FIRST_SPEED_PERCENT: Final = 30


class Motion:
    """Joint motions, and the speed of every motion.

    Attributes:
        setpoint: The angles last asked for, as long as they stand for what the arm is doing.
        speed_percent: What motions are sent with, of the arm's maximum.
    """

    def __init__(self, context: Context) -> None:
        self._context = context
        self.setpoint = Setpoint()
        self.speed_percent = _FIRST_SPEED_PERCENT

    @property
    def setpoint_deg(self) -> tuple[float, ...] | None:
        """The angles last sent, as long as they stand for what the arm is doing."""
        return self.setpoint.angles_deg

    def set_speed_percent(self, percent: float) -> Refusal | None:
        """Set the speed of motions, 0–100 % of the arm's maximum (0x151 byte 2).

        The arm is told at once, in the mode it is in; it keeps that mode. While a jog goes on, and
        while it is not known where the arm listens, the next motion brings it to the arm.
        """
        context = self._context
        if not 0 <= percent <= 100:
            return context.refuse(Refusal("speed_out_of_range", {"value": percent}))
        if context.situation().running:
            return context.refuse(Refusal("run_under_way"))
        self.speed_percent = round(percent)
        situation = context.situation()
        tellable = situation.control_certain and not situation.jogging
        if tellable and gate.why_no_command(situation.link, situation.stop, None) is None:
            frames = speed_frames(context.connection.codec, context.state(), self.speed_percent)
            if frames and context.connection.send(frames):
                context.tell("sent_speed", percent=self.speed_percent)
        return None

    def jog(self, joint: int, delta_deg: float) -> Refusal | None:
        """Move one joint by a step at once; the other five stay where they are or were going."""
        context = self._context
        situation = context.situation()
        base_deg = self.setpoint.jog_base_deg(
            context.state(), context.clock(), moving=situation.moving
        )
        if base_deg is None:
            return context.refuse(situation.cannot_move or Refusal("joints_unknown"))
        target_deg = list(base_deg)
        target_deg[joint - 1] = round(target_deg[joint - 1] + delta_deg, 3)
        return self._move(target_deg, "jogged", joint=joint, target=target_deg[joint - 1])

    def jog_lagging(self, joint: int, step_deg: float) -> bool:
        """Whether the arm is so far behind that a held button should not step on."""
        return self.setpoint.lagging(self._context.state(), joint, step_deg)

    def send_joints(self, angles_deg: Sequence[float]) -> Refusal | None:
        """Move to six angles in degrees (MOVE J, 0x155–0x157 and 0x151)."""
        return self._move(angles_deg, "sent_joints", **reports.numbered(angles_deg))

    def go_home(self) -> Refusal | None:
        """Move to the factory zero angles."""
        return self._move(_HOME_DEG, "went_home")

    def _move(self, angles_deg: Sequence[float], code: str, **figures: object) -> Refusal | None:
        """Send six angles if that may be, and tell so with a notice."""
        context = self._context
        situation = context.situation()
        refusal = situation.cannot_move or check_joints(angles_deg, situation.limits)
        if refusal is not None:
            return context.refuse(refusal)
        frames = commands.move_joints(
            context.connection.codec, angles_deg, speed_percent=self.speed_percent
        )
        if not context.connection.send(frames):
            return context.refuse(Refusal("link_lost"))
        self.setpoint.set(angles_deg, context.clock())
        context.tell(code, **figures)
        return None

    def advance(self) -> None:
        """A motion goes on by itself."""

    def halt(self) -> None:
        """The arm is no longer where it was sent."""
        self.setpoint.clear()

    def forget(self) -> None:
        """Nothing is known of an arm that is gone."""
        self.setpoint.clear()
