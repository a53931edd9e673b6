"""What must hold of a client that has, or had, the arm (S29, S30).

Where the arm may go by a client's word is judged as what an operator asked for: see `oracle`.
"""

from __future__ import annotations

from collections.abc import Iterator
from typing import TYPE_CHECKING, Final

from armui.control.operating_state import StopState
from armui.interface.lease import SILENT_S
from armui.protocol.frame import Frame
from tests.safety.fuzz.asked import Asked, Violation
from tests.safety.fuzz.traffic import base_id

if TYPE_CHECKING:
    from tests.safety.fuzz.world import World

_LOOK_S: Final = 0.06
_POWER_S: Final = 0.5
_FASTER: Final = 1.05
"""A joint of the simulated arm may overshoot its speed by so much."""
_SLOW_DEG_S: Final = 1.0
_SLOWS_S: Final = 0.4
"""What was faster before comes down to what is allowed within this time."""


class LeaseOracle:
    """Watches whether a lease ends in time, and what a client's motion does.

    Args:
        world: What it watches.

    Attributes:
        cut_s: When the operator, or the client by its own word, last took the arm's power.
        sped_s: When the operator last set a speed himself.
        moved: What the operator has begun although the lease stays.
        led: The lease by which the arm was last set in motion.
    """

    def __init__(self, world: World) -> None:
        self._world = world
        self.cut_s = -1e9
        self.sped_s = -1e9
        self.moved = ""
        self.led: int | None = None
        self._percent = 0
        self._held_s: float | None = None
        self._ended_s = -1e9
        self._unheld_s: float | None = None
        self._before_deg = world.firmware.joints_deg

    def began(self, what: str) -> None:
        """The operator has begun a motion."""
        if self._world.interface.view.lease is not None:
            self.moved = what

    def look(self, asked: Asked, *, fails: bool, apart: bool) -> Iterator[Violation]:
        """Yield what is not as it must be.

        Args:
            asked: What was asked for last.
            fails: Whether the program got no turn, or failed at it.
            apart: Whether others have had a part in how the arm moves.
        """
        world, now_s = self._world, self._world.time_s
        lease = world.interface.view.lease
        here_deg, before_deg = world.firmware.joints_deg, self._before_deg
        self._before_deg = here_deg
        if lease is None:
            if self._held_s is not None:
                self._ended_s = now_s
            self._held_s = None
        else:
            self._held_s = now_s if self._held_s is None else self._held_s
            self._percent = lease.max_speed_percent
        if self.moved:
            yield Violation("S29", "the operator moves and the lease stays", self.moved)
            self.moved = ""
        if fails:
            self._unheld_s = None
        else:
            yield from self._outlives(now_s)
        its_own = lease is not None and asked.lease == self.led == lease.number
        if its_own and not apart and asked.cancelled is None:
            yield from self._too_fast(asked, here_deg, before_deg)

    def _outlives(self, now_s: float) -> Iterator[Violation]:
        """A lease that outlives its client's connection or word, or a stream that outlives it."""
        world = self._world
        held = world.interface.view.lease is not None
        why = ""
        if held and not world.client.connected:
            why = "a client that is gone"
        elif held and now_s - world.client.heard_s > SILENT_S:
            why = "a client that is silent"
        elif not held and world.controller.jogging.streamed is not None:
            why = "no lease, by a stream"
        self._unheld_s = (self._unheld_s or now_s) if why else None
        if self._unheld_s is not None and now_s - self._unheld_s > _LOOK_S:
            self._unheld_s = None
            yield Violation("S29", f"the arm is held by {why}", why)

    def _too_fast(
        self, asked: Asked, here_deg: tuple[float, ...], before_deg: tuple[float, ...]
    ) -> Iterator[Violation]:
        world, now_s = self._world, self._world.time_s
        firmware = world.firmware
        allowed_s = max(asked.at_s, self.sped_s) + _SLOWS_S
        if now_s < allowed_s or not all(firmware.enabled) or firmware.condition.stopped:
            return
        limits = world.controller.operating_state.limits
        for joint, (here, before) in enumerate(zip(here_deg, before_deg, strict=True)):
            speed = abs(here - before) / world.step_s
            most = self._percent / 100.0 * limits[joint].max_speed_deg_s
            if speed > _FASTER * most + _SLOW_DEG_S:
                text = f"J{joint + 1} at {speed:.1f}°/s, {most:.1f} granted"
                yield Violation("S29", f"{asked.kind.value} of a client is too fast", text)
                return

    def on_said(self, frame: Frame, at_s: float) -> Iterator[Violation]:
        """Yield what is wrong with a frame of ours: the end of a lease leaves the power on."""
        identifier, data = base_id(frame.arbitration_id), frame.data
        off = identifier == 0x471 and data[1:2] == b"\x01"
        off = off or (identifier == 0x150 and data[:1] in (b"\x01", b"\x02"))
        world = self._world
        lease_ended = self._held_s is not None and world.interface.view.lease is None
        ended_s = at_s if lease_ended else self._ended_s
        stops = world.controller.operating_state.stop is not StopState.RUNNING
        if off and not stops and at_s - ended_s < _POWER_S and at_s - self.cut_s > _POWER_S:
            text = f"{identifier:03X}#{data.hex()} {at_s - ended_s:.2f} s after the lease"
            yield Violation("S29", "the end of a lease takes the power", text)
