"""Whoever else is on the bus: a second host, written without the program's own codec."""

from collections.abc import Iterable

import can

from tests.bench import Bench
from tests.sim.talk import frame, mode, pose_target, target


class OtherHost:
    """Another program on the bench's bus; it writes frames as candump does (`tests.sim.talk`).

    Args:
        bench: Where it is plugged in; it is unplugged with :meth:`close`.
    """

    def __init__(self, bench: Bench) -> None:
        self._bus = can.Bus(interface="virtual", channel=bench.channel)

    def say(self, *lines: str) -> None:
        """Put frames on the bus, ID#DATA each."""
        for line in lines:
            said = frame(line)
            self._bus.send(
                can.Message(
                    arbitration_id=said.arbitration_id, data=said.data, is_extended_id=False
                )
            )

    def move_to(self, joints_deg: Iterable[float], speed_percent: int = 100) -> None:
        """Six joint angles in degrees, by MOVE J."""
        self.say(*target(*joints_deg), mode(speed_percent))

    def move_tool(self, pose: Iterable[float], speed_percent: int = 100, *, move: int = 0) -> None:
        """A pose of the flange in mm and degrees, by MOVE P (0) or MOVE L (2)."""
        self.say(*pose_target(*pose), mode(speed_percent, move=move))

    def close(self) -> None:
        """Leave the bus."""
        self._bus.shutdown()
