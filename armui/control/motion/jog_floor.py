"""Computes how low the arm reaches, and limits how low a jog may take it.

Heights are over the plane the arm stands on, or over the room's floor where the cell says how the
base stands in the room. The lowest of flange, fingertip and held object counts, as in the check
before a run.
"""

from __future__ import annotations

from collections.abc import Callable, Sequence
from typing import TYPE_CHECKING, Final

from armui.arm.models import Rising, model_data
from armui.arm.refusal import Reason, Refusal
from armui.kinematics.forward import flange_rows

if TYPE_CHECKING:
    from armui.arm.held_shape import HeldShape
    from armui.arm.state import ArmState
    from armui.arm.tool_capsule import ToolCapsule
    from armui.control.context import Context
    from armui.kinematics.poses import Matrix

JOG_TOO_LOW = Reason(
    "jog_too_low",
    "The hand or what it holds would come to {value} mm; jogs end at {minimum} mm, as chosen under "
    "Settings. Jog upwards.",
)


_PLACES: Final = 16
"""The number of places at which a step is checked: a circle may be lowest on its way."""
_SAME_MM: Final = 1e-6


class JogFloor:
    """Ends jogs and steps that lead below the operator's limit.

    Args:
        context: Knows the arm's geometry.
        tool: Returns the shape of the tool on the flange; ``None`` if only the gripper's tip
            counts.
        held: Returns the shape of what the hand holds, or ``None``.
        rising: Returns how the base stands in the room.

    Attributes:
        lowest_mm: The least height of the fingertip for jogs, or ``None`` for no limit.
    """

    def __init__(
        self,
        context: Context,
        tool: Callable[[], ToolCapsule | None],
        held: Callable[[], HeldShape | None],
        rising: Callable[[], Rising],
    ) -> None:
        self._context = context
        self._tool = tool
        self._held = held
        self._rising = rising
        self.lowest_mm: int | None = None
        self._measured: tuple[object, ...] = ()
        self._below_mm: int | None = None

    def height_mm(self, joints_deg: Sequence[float]) -> float:
        """Return the height of flange or fingertip at six angles, whichever is lower."""
        fit = self._context.operating_state().model_fit
        rows = flange_rows(fit.geometry, joints_deg)
        return self._lowest(rows[:4], rows[4:8], rows[8:12])

    def _lowest(self, *rows: Sequence[float]) -> float:
        """Return the lowest height, from the three rows of the flange's transform in the base."""
        *up, base_mm = self._rising()
        *ups, flange_mm = (
            sum(part * row[column] for part, row in zip(up, rows, strict=True))
            for column in range(4)
        )
        flange_mm += base_mm
        tool, held = self._tool(), self._held()
        if tool is not None:
            rises = sum(part * up for part, up in zip(tool.tip_mm, ups, strict=True))
            lowest = float(tool.lowest(flange_mm, flange_mm + rises))
        else:
            reach_mm = model_data(self._context.operating_state().model).gripper.reach_mm
            lowest = flange_mm + min(0.0, reach_mm * ups[2])
        return lowest if held is None else min(lowest, float(held.lowest(flange_mm, ups)))

    def below_base_mm(self, state: ArmState) -> int | None:
        """Return by how much the measured arm reaches below its base plane, or ``None``."""
        joints_deg = state.angles_deg()
        if joints_deg is None:
            return None
        fit = self._context.operating_state().model_fit
        measured = (joints_deg, fit, self._tool(), self._held(), self._rising())
        if measured != self._measured:  # it is asked twice a tick, mostly of an arm that stands
            below = round(-self.height_mm(joints_deg))
            self._measured, self._below_mm = measured, below if below > 0 else None
        return self._below_mm

    def why_lower(self, ahead_deg: Sequence[float], now_deg: Sequence[float]) -> Refusal | None:
        """Return why a jog may not go on to six angles; an arm below its limit may come up."""
        if self.lowest_mm is None:
            return None
        return self._why(self.height_mm(ahead_deg), lambda: self.height_mm(now_deg))

    def why_step_lower(self, end_deg: Sequence[float], now_deg: Sequence[float]) -> Refusal | None:
        """Return why a step to six angles is refused: it is too low somewhere on its way."""
        if self.lowest_mm is None:
            return None
        parts = [part / _PLACES for part in range(1, _PLACES + 1)]
        lowest = min(
            self.height_mm([a + part * (b - a) for a, b in zip(now_deg, end_deg, strict=True)])
            for part in parts
        )
        return self._why(lowest, lambda: self.height_mm(now_deg))

    def why_pose_lower(self, flange: Matrix, now: Matrix) -> Refusal | None:
        """Return why a straight step of the flange is refused, or ``None``."""
        if self.lowest_mm is None:
            return None
        ahead, here = (self._lowest(*each[:3].tolist()) for each in (flange, now))
        return self._why(ahead, lambda: here)

    def _why(self, ahead_mm: float, here_mm: Callable[[], float]) -> Refusal | None:
        lowest = self.lowest_mm
        if lowest is None or ahead_mm >= lowest or ahead_mm > here_mm() + _SAME_MM:
            return None
        return JOG_TOO_LOW(value=round(ahead_mm, 1), minimum=lowest)
