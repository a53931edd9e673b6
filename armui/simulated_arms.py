"""The simulated arms of this program: each a process on a bus of its own, with no adapter."""

from __future__ import annotations

from collections.abc import Iterator
from contextlib import contextmanager, suppress
from typing import TYPE_CHECKING, Final

from armui.arm.device import Device
from armui.protocol.generation import Generation

if TYPE_CHECKING:
    import can

    from armui.sim.arm_choice import ArmChoice
    from armui.sim.arm_process import ArmProcess, LineHand

SIMULATED: Final = tuple(
    Device("virtual", f"armui-simulated-{generation}", None, simulated=True, generation=generation)
    for generation in (2, 1)
)
"""The simulated arms, today's protocol first."""


class SimulatedArms:
    """The simulated arms of this program: each a process, for as long as it is connected.

    Args:
        firmware: The version of one of generation 2, ``None`` for today's.
        joints_deg: The angles at which it lies, joint 1 first; ``None`` for the rest pose.

    Attributes:
        hand: The hand that leads the connected one; set and cleared by the bus thread.
    """

    def __init__(
        self, firmware: str | None = None, joints_deg: tuple[float, ...] | None = None
    ) -> None:
        self._firmware = firmware
        self._joints_deg = joints_deg
        self._begun: tuple[ArmChoice, ArmProcess] | None = None
        self.hand: LineHand | None = None

    def begin(self, device: Device) -> None:
        """Start the process of an arm that is about to be connected: it takes a second to load.

        One that cannot be started is told of where it is connected.
        """
        from armui.sim.arm_process import ArmProcess  # noqa: PLC0415 - for those who drive it

        choice = self._choice(device)
        with suppress(OSError):
            self._begun = choice, ArmProcess(choice)

    @contextmanager
    def connected(self, device: Device) -> Iterator[can.BusABC]:
        """Connect to a simulated arm, which ends with the connection.

        Raises:
            OSError: Its process cannot be started, or has ended.
        """
        from armui.bus.line_bus import LineBus  # noqa: PLC0415 - python-can, as in `open_device`

        arm = self._process_of(self._choice(device))
        try:
            arm.wait_until_it_lives()
            with LineBus(str(device.channel), arm.line) as bus:
                self.hand = arm.hand
                yield bus
        finally:
            self.hand = None
            arm.end()

    def end(self) -> None:
        """End the process of an arm that was not connected."""
        begun, self._begun = self._begun, None
        if begun is not None:
            begun[1].end()

    def _choice(self, device: Device) -> ArmChoice:
        from armui.sim.arm_choice import ArmChoice  # noqa: PLC0415 - as above

        generation = Generation(device.generation or 2)
        version = self._firmware if generation is Generation.TWO else None
        return ArmChoice(generation, device.model, version, self._joints_deg)

    def _process_of(self, choice: ArmChoice) -> ArmProcess:
        from armui.sim.arm_process import ArmProcess  # noqa: PLC0415 - as above

        if self._begun is not None and self._begun[0] == choice:
            (_choice, begun), self._begun = self._begun, None
            return begun
        self.end()
        return ArmProcess(choice)
