"""Computes how low the arm reaches, and keeps how low the operator lets it be moved.

Heights are over the plane the arm stands on, or over the room's floor where the cell says how the
base stands in the room. The lowest of flange, fingertip and held object counts, as in the check
before a run.
"""

from __future__ import annotations

from collections.abc import Callable, Sequence
from dataclasses import dataclass, field
from typing import TYPE_CHECKING

from armui.arm.models import Rising, model_data
from armui.kinematics.forward import flange_rows

if TYPE_CHECKING:
    from armui.arm.held_shape import HeldShape
    from armui.arm.state import ArmState
    from armui.arm.tool_capsule import ToolCapsule
    from armui.control.context import Context


@dataclass(eq=False, repr=False)
class JogFloor:
    """Knows how low the arm reaches, and the operator's least height.

    Args:
        context: Knows the arm's geometry.
        tool: Returns the shape of the tool on the flange; ``None`` if only the gripper's tip
            counts.
        held: Returns the shape of what the hand holds, or ``None``.
        rising: Returns how the base stands in the room.
    """

    _context: Context
    _tool: Callable[[], ToolCapsule | None]
    _held: Callable[[], HeldShape | None]
    _rising: Callable[[], Rising]
    _lowest_mm: int | None = field(default=None, init=False)
    _chosen_mm: int | None = field(default=None, init=False)
    _measured: tuple[object, ...] = field(default=(), init=False)
    _height_mm: float = field(default=0.0, init=False)

    @property
    def lowest_mm(self) -> int | None:
        """The least height of motions, or ``None``; another one that is chosen counts at rest."""
        if self._context.rests:
            self._lowest_mm = self._chosen_mm
        return self._lowest_mm

    @lowest_mm.setter
    def lowest_mm(self, chosen_mm: int | None) -> None:
        self._chosen_mm = chosen_mm
        if self._context.rests:
            self._lowest_mm = chosen_mm

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
        return self._below_mm(state, 0)

    def below_lowest_mm(self, state: ArmState) -> int | None:
        """Return by how much it is below the least height for motions, or ``None``."""
        return None if self.lowest_mm is None else self._below_mm(state, self.lowest_mm)

    def _below_mm(self, state: ArmState, floor_mm: int) -> int | None:
        joints_deg = state.angles_deg()
        if joints_deg is None:
            return None
        fit = self._context.operating_state().model_fit
        measured = (joints_deg, fit, self._tool(), self._held(), self._rising())
        # asked twice a tick: computed only when something has changed
        if measured != self._measured:
            self._measured, self._height_mm = measured, self.height_mm(joints_deg)
        below = round(floor_mm - self._height_mm)
        return below if below > 0 else None
