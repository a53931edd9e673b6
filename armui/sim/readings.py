"""The true state of a simulated arm, read from outside its feedback."""

from __future__ import annotations

from armui.protocol.codes import ArmStatusCode, ControlMode, MotionState, MoveMode, TeachingState
from armui.sim.condition import Condition
from armui.sim.mechanics.mechanics import Mechanics
from armui.sim.mechanics.powered_joints import SixValues


class Readings:
    """Read-only access to what an arm's parts hold.

    Attributes:
        mechanics: Joints and motors.
        condition: Modes, flags and faults.
    """

    mechanics: Mechanics
    condition: Condition

    @property
    def joints_deg(self) -> SixValues:
        """Where the joints are."""
        return self.mechanics.positions_deg

    @property
    def true_joints_deg(self) -> SixValues:
        """Where the joints truly are, counted from the factory's zeros; nothing on the bus says."""
        return tuple(self.mechanics.weight.true_deg(self.mechanics.positions_deg))

    @property
    def enabled(self) -> tuple[bool, ...]:
        """Which motors have power."""
        return self.mechanics.powered

    @property
    def status(self) -> ArmStatusCode:
        """As 0x2A1 byte 1 tells it."""
        return self.condition.status

    @property
    def stopped(self) -> bool:
        """Whether an emergency stop is in force."""
        return self.condition.stopped

    @property
    def control_mode(self) -> ControlMode:
        """Who commands the arm."""
        return self.condition.control_mode

    @property
    def move_mode(self) -> MoveMode:
        """Which kind of motion targets ask for."""
        return self.condition.move_mode

    @property
    def speed_percent(self) -> int:
        """Share of the joints' highest speeds."""
        return self.condition.speed_percent

    @property
    def motion_state(self) -> MotionState:
        """Whether the last target is reached."""
        return self.condition.motion_state

    @property
    def teaching_state(self) -> TeachingState:
        """What drag teaching does."""
        return self.condition.teaching_state
