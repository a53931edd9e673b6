"""The ranges of the gripper's command: pure, by its generation and the stroke read."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass, replace
from typing import Final

from armui.arm.figures import Range, check_figure
from armui.arm.refusal import Refusal
from armui.arm.state import ArmState
from armui.protocol.generation import Generation
from armui.trajectory.points.program import RANGES

WIDEST_MM: Final = 100.0
"""The stroke of the large gripper: no gripper of this arm opens wider."""

_SLIDER_DEG: Final = 100.0
_LEAST_SPEED_RAD_S: Final = 0.001


@dataclass(frozen=True, slots=True)
class GripperFigure:
    """A figure of the gripper's command with its range.

    Attributes:
        name: ``opening``, ``torque``, ``angle`` or ``speed``.
        unit: The unit that the operator sees.
        minimum, maximum: The limits of its value.
        usual: The upper end of its slider.
        step: The step of − and + and of the arrow keys.
        first: The value it begins with.
        resolution: The step of its slider.
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
    """The two figures of the gripper's command.

    Attributes:
        travel: Opening in mm (generation 2) or angle in degrees (generation 1).
        effort: Torque in N·m (generation 2) or speed in rad/s (generation 1).
        stroke_read: True if the end of the travel was read from the arm (0x47E).
    """

    travel: GripperFigure
    effort: GripperFigure
    stroke_read: bool


def gripper_figures(
    generation: Generation | None, state: ArmState, *, by_angle: bool = False
) -> Figures:
    """Return the ranges of an arm's gripper; those of generation 2 while that is unknown.

    The stroke is that of the arm (0x47E) where it was read and is not 0, «no limit». How far the
    grippers turn is not published: the arm's own feedback shows where it ends.

    Args:
        generation: The arm's generation.
        state: The arm as heard.
        by_angle: True if generation 2 is commanded by angles instead of openings (from S-V1.8-8).
    """
    if generation is Generation.ONE:
        angle, speed = RANGES["gripper angle"], RANGES["gripper speed"]
        return Figures(
            GripperFigure("angle", "°", angle.minimum, angle.maximum, _SLIDER_DEG, 1.0, 0.0, 0.1),
            GripperFigure("speed", "rad/s", _LEAST_SPEED_RAD_S, speed.maximum, 6.0, 0.1, 1.0, 0.01),
            stroke_read=False,
        )
    torque = GripperFigure("torque", "N·m", 0.0, RANGES["torque"].maximum, 5.0, 0.1, 1.0, 0.01)
    if by_angle:
        span = RANGES["gripper angle"]
        return Figures(
            GripperFigure("angle", "°", span.minimum, span.maximum, _SLIDER_DEG, 1.0, 0.0, 0.1),
            torque,
            stroke_read=False,
        )
    handle = state.teaching_handle
    stroke_mm = 0.0 if handle is None else handle.value.stroke_limit_mm
    read = 0.0 < stroke_mm <= WIDEST_MM
    widest = float(stroke_mm) if read else WIDEST_MM
    return Figures(
        GripperFigure("opening", "mm", 0.0, widest, widest, 1.0, 0.0, 0.1),
        torque,
        stroke_read=read,
    )


def calibrated(figures: Figures, measured_mm: Callable[[float], float]) -> Figures:
    """Return the ranges with an opening as it is measured with callipers."""
    own = figures.travel
    least, most, usual = (
        round(max(0.0, measured_mm(end)), 3) for end in (own.minimum, own.maximum, own.usual)
    )
    return replace(
        figures, travel=replace(own, minimum=least, maximum=most, usual=usual, first=least)
    )


def check(figure: GripperFigure, value: float) -> Refusal | None:
    """Return why a figure may not be sent; ``None``: it may."""
    return check_figure(figure.name, value, Range(figure.minimum, figure.maximum, figure.unit))
