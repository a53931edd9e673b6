"""Feedback that arrives late: held up on its way, or not sent in time by a starving arm."""

from collections import deque
from collections.abc import Sequence

import can

from tests.arm_rig import STEP_S, ArmRig


class LateBus:
    """Stands between a rig's arm and its bus.

    Args:
        rig: The rig; what its arm says passes at once until something is held up.
    """

    def __init__(self, rig: ArmRig) -> None:
        self._rig = rig
        self._pass_on = rig._arm_bus._hand_over
        self._held: deque[Sequence[can.Message]] | None = None
        rig._arm_bus._hand_over = self._take

    def _take(self, messages: Sequence[can.Message]) -> None:
        if self._held is None:
            self._pass_on(messages)
        else:
            self._held.append(messages)

    def hold_up(self, seconds: float) -> None:
        """Let time pass while what the arm says is held up; commands reach it."""
        if self._held is None:
            self._held = deque()
        self._rig.run(seconds)

    def hand_over(self, steps: int | None = None) -> None:
        """Hand over what was held up, all of it or the oldest steps; then look."""
        held = self._held or deque()
        for _ in range(len(held) if steps is None else steps):
            self._pass_on(held.popleft())
        if not held:
            self._held = None
        self._rig._settle()
        self._rig.controller.tick()

    def starve(self, seconds: float) -> None:
        """Let time pass while the arm neither hears nor says anything; then it catches up."""
        rig = self._rig
        rig.powered = False
        rig.run(round(seconds / STEP_S) * STEP_S)
        rig.powered = True
        with rig._arm_bus.together():
            rig.node.poll(seconds)
        self.hand_over()
