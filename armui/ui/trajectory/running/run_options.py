"""What the operator has chosen beside 发送."""

from __future__ import annotations

from dataclasses import dataclass


@dataclass(frozen=True, slots=True)
class RunOptions:
    """How the operator wants it run.

    Attributes:
        cycles: How often; 0 until it is ended.
        speed_factor: On the speed of each point, or on the recorded one.
        first: The index of the point to begin with.
        step_by_step: Whether to wait after each point.
    """

    cycles: int = 1
    speed_factor: float = 1.0
    first: int = 0
    step_by_step: bool = False
