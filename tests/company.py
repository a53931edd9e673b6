"""Whoever else is on the bus: a second host, another arm, a leader; they live by the rig's clock.

A host is written without the program's own codec: it says frames as candump does.
"""

from collections.abc import Callable, Iterable

import can

from armui.protocol.codes import LinkageRole
from armui.protocol.generation import Generation
from armui.sim.firmware import Firmware
from armui.sim.node import Node
from armui.sim.parameters.flash import MemoryFlash
from armui.sim.parameters.settings import ArmSettingsRecord, LinkageSettings
from tests.arm_rig import ArmRig
from tests.arm_rig_bus import ArmBus
from tests.sim.talk import ENABLE, RESUME, STOP, frame, mode, pose_target, target

_EPSILON_S = 1e-9

Said = Callable[[float], Iterable[str]]
"""What a stream says some seconds after its beginning, ID#DATA each."""


class Stream:
    """Frames said over and over; time passes with the rig's clock.

    Attributes:
        running: Whether it goes on.
        rounds: How often it was said.
    """

    def __init__(self, say: Callable[..., None], lines: Said, rate_hz: float) -> None:
        self._say = say
        self._lines = lines
        self._period_s = 1.0 / rate_hz
        self._elapsed_s = 0.0
        self.running = True
        self.rounds = 0

    def step(self, dt_s: float) -> None:
        """Say what is due: the first round at once, the others a period apart."""
        while self.running and self.rounds * self._period_s < self._elapsed_s + dt_s - _EPSILON_S:
            self._say(*self._lines(self.rounds * self._period_s))
            self.rounds += 1
        self._elapsed_s += dt_s

    def end(self) -> None:
        """Say no more."""
        self.running = False


class OtherHost:
    """Another program on the rig's bus; it writes frames as candump does (`tests.sim.talk`).

    Args:
        rig: Where it is plugged in; it is unplugged with :meth:`close`.

    Attributes:
        streams: What it says over and over.
    """

    def __init__(self, rig: ArmRig) -> None:
        self._rig = rig
        self.streams: list[Stream] = []
        self._channel = rig.channel
        rig.company.append(self)

    def say(self, *lines: str) -> None:
        """Put frames on the bus, ID#DATA each."""
        # it is on the bus only while it speaks: what nobody takes would be copied and kept
        with ArmBus(self._channel) as bus, bus.together():
            for line in lines:
                said = frame(line)
                bus.send(
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

    def stop(self) -> None:
        """0x150: emergency stop."""
        self.say(STOP)

    def resume(self) -> None:
        """0x150: resume; the arm drops."""
        self.say(RESUME)

    def enable(self) -> None:
        """0x471: all motors."""
        self.say(ENABLE)

    def speed(self, percent: int, *, move: int = 1, mit: bool = False) -> None:
        """0x151 alone: speed, MOVE mode, and 0xAD or not."""
        self.say(f"151#01{move:02X}{percent:02X}{0xAD if mit else 0:02X}00000000")

    def stream(self, lines: Said, rate_hz: float = 200.0) -> Stream:
        """Say frames over and over while the rig's time passes, until the stream is ended.

        Args:
            lines: What to say, by the time since the first round in seconds.
            rate_hz: Rounds a second.
        """
        stream = Stream(self.say, lines, rate_hz)
        self.streams.append(stream)
        return stream

    def stream_targets(
        self,
        path: Callable[[float], Iterable[float]],
        rate_hz: float = 200.0,
        speed_percent: int = 100,
    ) -> Stream:
        """Stream joint targets with their 0x151: six angles in degrees by the time in seconds."""
        return self.stream(lambda t_s: [mode(speed_percent), *target(*path(t_s))], rate_hz)

    def step(self, dt_s: float) -> None:
        """Let time pass."""
        self.streams = [each for each in self.streams if each.running]
        for each in self.streams:
            each.step(dt_s)

    def close(self) -> None:
        """Leave the bus."""
        if self in self._rig.company:
            self._rig.company.remove(self)


class OtherArm:
    """Another simulated arm on the rig's bus.

    Its drivers' frames 0x251–0x266 and its answers 0x473–0x47E have the same identifiers as the
    first arm's, and it obeys the same 0x471 and 0x475, as 0x470 moves none of them.

    Args:
        rig: Where it is plugged in; it is unplugged with :meth:`close`.
        offset: What 0x470 adds to its feedback and its motion commands: 0, 0x10 or 0x20.
        role: A teaching input leads: it sends 0x151, 0x155–0x157 and 0x159, 200 times a second,
            for the arm at `target_offset`, and no feedback.
        target_offset: See `role`.
        joints_deg: Where it lies.

    Attributes:
        firmware: The arm; `firmware.hand_guiding` leads a leader, `firmware.drivers_tell` lets its
            drivers go on sending.
        node: Its way to the bus.
    """

    def __init__(
        self,
        rig: ArmRig,
        offset: int = 0x10,
        *,
        role: LinkageRole = LinkageRole.MOTION_OUTPUT,
        target_offset: int = 0,
        joints_deg: Iterable[float] = (0.0,) * 6,
        generation: Generation | None = None,
    ) -> None:
        self._rig = rig
        flash = MemoryFlash()
        flash.save(ArmSettingsRecord(linkage=LinkageSettings(role, offset, offset, target_offset)))
        self.firmware = Firmware(
            generation or rig.firmware.generation, joints_deg=tuple(joints_deg), flash=flash
        )
        self._bus = ArmBus(rig.channel)
        self.node = Node(self.firmware, self._bus)
        rig.company.append(self)

    @classmethod
    def leader(cls, rig: ArmRig, **how) -> "OtherArm":
        """A teaching input that leads the rig's arm."""
        return cls(rig, 0, role=LinkageRole.TEACHING_INPUT, **how)

    def step(self, dt_s: float) -> None:
        """Let time pass."""
        with self._bus.together():
            self.node.poll(dt_s)

    def close(self) -> None:
        """Leave the bus."""
        if self in self._rig.company:
            self._rig.company.remove(self)
        self._bus.shutdown()
        del self.firmware, self.node
