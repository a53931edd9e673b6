"""What a gripper can be asked for: pure, by its generation and what was read of its stroke."""

from __future__ import annotations

import math
from dataclasses import dataclass
from typing import Final

from armui.arm.refusal import Reason, Refusal
from armui.arm.state import ArmState
from armui.protocol.generation import Generation
from armui.trajectory.points.program import RANGES

GRIPPER_NOT_A_NUMBER = Reason(
    "gripper_not_a_number",
    "{gripper}: “{value}” is not a number. Enter a value from {minimum} to {maximum} {unit}.",
)
GRIPPER_OUT_OF_RANGE = Reason(
    "gripper_out_of_range",
    "{gripper}: {value} {unit} is out of range. Enter a value from {minimum} to {maximum} {unit}.",
)


WIDEST_MM: Final = 100.0
"""The stroke of the large gripper: nothing of this arm opens wider."""

_SLIDER_DEG: Final = 100.0
_LEAST_SPEED_RAD_S: Final = 0.001


@dataclass(frozen=True, slots=True)
class Figure:
    """A figure of the gripper's command.

    Attributes:
        name: ``opening``, ``torque``, ``angle`` or ``speed``.
        unit: The operator's.
        minimum, maximum: What may be asked for.
        usual: How far its slider reaches.
        step: Of − and + and of the arrow keys.
        first: What it begins with.
        resolution: Of its slider.
    """

    name: str
    unit: str
    minimum: float
    maximum: float
    usual: float
    step: float
    first: float
    resolution: float


@dataclass(frozen=True, slots=True)
class Figures:
    """How far it is to open, and how hard or how fast.

    Attributes:
        travel: Opening in mm (generation 2) or angle in degrees (generation 1).
        effort: Torque in N·m (generation 2) or speed in rad/s (generation 1).
        stroke_read: Whether the end of the travel was read from the arm (0x47E).
    """

    travel: Figure
    effort: Figure
    stroke_read: bool


def figures_of(
    generation: Generation | None, state: ArmState, *, by_angle: bool = False
) -> Figures:
    """Return what can be asked of the gripper of an arm; generation 2 while that is not known.

    The stroke is that of the arm (0x47E) where it was read and is not 0, «no limit». How far the
    grippers turn is not published: the arm's own feedback shows where it ends.

    Args:
        generation: The arm's.
        state: What was read of it.
        by_angle: Generation 2 is told an angle in the place of the opening (from S-V1.8-8).
    """
    if generation is Generation.ONE:
        angle, speed = RANGES["gripper angle"], RANGES["gripper speed"]
        return Figures(
            Figure("angle", "°", angle.minimum, angle.maximum, _SLIDER_DEG, 1.0, 0.0, 0.1),
            Figure("speed", "rad/s", _LEAST_SPEED_RAD_S, speed.maximum, 6.0, 0.1, 1.0, 0.01),
            stroke_read=False,
        )
    torque = Figure("torque", "N·m", 0.0, RANGES["torque"].maximum, 5.0, 0.1, 1.0, 0.01)
    if by_angle:
        span = RANGES["gripper angle"]
        return Figures(
            Figure("angle", "°", span.minimum, span.maximum, _SLIDER_DEG, 1.0, 0.0, 0.1),
            torque,
            stroke_read=False,
        )
    handle = state.teaching_handle
    stroke_mm = 0.0 if handle is None else handle.value.stroke_limit_mm
    read = 0.0 < stroke_mm <= WIDEST_MM
    widest = float(stroke_mm) if read else WIDEST_MM
    return Figures(
        Figure("opening", "mm", 0.0, widest, widest, 1.0, 0.0, 0.1),
        torque,
        stroke_read=read,
    )


def check(figure: Figure, value: float) -> Refusal | None:
    """Tell why a figure may not be sent; ``None``: it may."""
    params: dict[str, float | int | str] = {
        "gripper": figure.name,
        "value": value,
        "minimum": figure.minimum,
        "maximum": figure.maximum,
        "unit": figure.unit,
    }
    if not math.isfinite(value):
        return GRIPPER_NOT_A_NUMBER(**params)
    if figure.minimum <= value <= figure.maximum:
        return None
    return GRIPPER_OUT_OF_RANGE(**params)
