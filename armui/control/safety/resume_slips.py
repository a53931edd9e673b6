"""Compares the feedback just before and after each resume (0x150): what slipped shows there."""

from __future__ import annotations

from collections import deque
from collections.abc import Callable, Sequence
from datetime import datetime
from typing import TYPE_CHECKING, Final

from armui.arm.inspection_record import ResumeEntry
from armui.arm.limits import JOINTS
from armui.control.context import Context, ControllerPart
from armui.control.events import Notice
from armui.protocol.codec import Message
from armui.protocol.codes import StopCommand
from armui.telemetry.events import Asker, EventKind, Level
from armui.telemetry.listener import Listener, ReceivedFrame

if TYPE_CHECKING:
    from armui.control.safety.reference_control import ReferenceControl

RESUME_SLIPPED = Notice(
    "resume_slipped",
    "At the resume the feedback jumped: {joints}. By so much the joint stood elsewhere than it "
    "reported. What was set as zero, saved or taught before may be off by it: check the "
    "reference, and set zeros only now.",
    Level.WARNING,
    EventKind.STATUS,
    Asker.ARM,
)

BEFORE_S: Final = 0.15
AFTER_S: Final = 0.5
"""The feedback from `BEFORE_S` before to this long after a resume is compared."""
_COMES_S: Final = 0.1
"""The last feedback of that time has arrived after this further time."""


class ResumeListener(Listener):
    """Notes every resume on the bus, this program's and any other host's."""

    def __init__(self) -> None:
        self.times_s: deque[float] = deque(maxlen=64)

    def on_heard(self, batch: Sequence[ReceivedFrame]) -> None:
        """Note the resumes of others; called by the bus thread."""
        for heard, at_s, _frame, _flags in batch:
            message = heard if isinstance(heard, Message) else heard.message
            if message is None or message.name != "MotionCommand":
                continue
            if message.signals.get("EmergencyStop") == StopCommand.RESUME:
                self.times_s.append(at_s)

    def on_sent(self, batch: Sequence[ReceivedFrame]) -> None:
        """Note those of this program; called by the bus thread."""
        self.on_heard(batch)


class ResumeSlips(ControllerPart):
    """Has each resume's comparison kept with its date, and says a slip from 1° on.

    Args:
        context: The context that the controller's parts share.
        reference: Keeps it with the arm.
        wall: Returns the local time of a monotonic time.
    """

    def __init__(
        self, context: Context, reference: ReferenceControl, wall: Callable[[float], datetime]
    ) -> None:
        self._context = context
        self._reference = reference
        self._wall = wall
        self._listener = ResumeListener()
        context.connection.add_listener(self._listener)

    def follow_arm(self) -> None:
        """Compare at each resume whose feedback has come; those sent in a row are one."""
        times_s, device = self._listener.times_s, self._context.connection.device
        if device is None or device.recorded is not None:
            times_s.clear()
        if not times_s or self._context.clock() < times_s[-1] + AFTER_S + _COMES_S:
            return
        first_s, last_s = times_s[0], times_s[-1]
        times_s.clear()
        self._compare(first_s, last_s)

    def forget_arm(self) -> None:
        """Forget what is to be compared: its feedback goes with the arm."""
        self._listener.times_s.clear()

    def _compare(self, first_s: float, last_s: float) -> None:
        from armui.telemetry.jumps import jump_deg  # noqa: PLC0415 - numpy

        telemetry, slips_deg = self._context.connection.telemetry, []
        for joint in JOINTS:
            quantity, series = telemetry.find(f"arm.joint_angle.{joint}")
            samples = series.samples(first_s - BEFORE_S, last_s + AFTER_S)
            slips_deg.append(jump_deg(samples["time_s"], samples[quantity.field], first_s))
        at = self._wall(first_s).isoformat(timespec="seconds")
        entry = ResumeEntry(at, tuple(slips_deg))
        self._reference.keep_resume(entry)
        if joints := entry.text:
            self._context.emit_event(RESUME_SLIPPED, joints=joints)
            self._context.refresh()
