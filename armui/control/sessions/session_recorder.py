"""Records the bus: the last minutes always in memory, files when the operator asks."""

from __future__ import annotations

import time
from collections import deque
from collections.abc import Callable
from concurrent.futures import Future, ThreadPoolExecutor, wait
from datetime import datetime
from functools import partial
from pathlib import Path
from typing import TYPE_CHECKING, Final

from PySide6.QtCore import QObject, QTimer, Signal

from armui.arm.refusal import Reason, Refusal
from armui.cell.cell_in_force import CellInForce
from armui.control.events import Notice
from armui.control.link.connection import CONNECTED, RECONNECTED
from armui.control.operations.started import Ending, Started
from armui.control.sessions.choices import SessionChoices
from armui.control.sessions.progress import SESSION_FRAMES_LOST, RecordingProgress, RingContent
from armui.control.sessions.ring_saving import SaveAtFaults
from armui.control.sessions.sidecar_lines import EventFeed, SidecarLines
from armui.session.recording.collector import Collector, FrameRing
from armui.session.recording.kinds import is_name, name_for, why_not_written
from armui.session.recording.lane import FrameLane
from armui.session.recording.sidecar import event_line
from armui.session.session import MarkKind
from armui.system import paths
from armui.telemetry.events import Asker, EventKind, Level

if TYPE_CHECKING:
    from armui.bus.link import BusReport
    from armui.control.context import Context
    from armui.control.sessions.episodes import Episodes
    from armui.control.sessions.sidecar_lines import FedEvent
    from armui.session.recording.session_recording import SessionRecording
    from armui.session.recording.sidecar import Line
    from armui.session.recording.writer import RecordingPlan
    from armui.telemetry.events import EventLog

SESSION_RECORDED = Reason("session_recorded", "A log is being written already. Stop it first.")
SESSION_NAME_BAD = Reason(
    "session_name_bad",
    '“{name}” cannot be the name of a log. Leave out / \\ : * ? " < > | and a dot at '
    "the beginning or the end; 120 characters at most.",
)
SESSION_NONE = Reason("session_none", "No log is being written: there is nothing to stop.")
SESSION_SAVING = Reason(
    "session_saving", "The last minutes are being saved already. Wait a moment."
)
SESSION_RING_EMPTY = Reason(
    "session_ring_empty", "Nothing has been heard on the bus yet: there is nothing to save."
)
SESSION_STARTED = Notice("session_started", "Log begun: {name}", Level.INFO, EventKind.COMMAND)
SESSION_ENDED = Notice(
    "session_ended",
    "Log written: {name}, {frames} frames, {size} MB",
    Level.DONE,
    EventKind.RESULT,
    Asker.PROGRAM,
)
SESSION_FAILED_NOTICE = Notice(
    "session_failed", "The log has ended: {reason}", Level.WARNING, EventKind.RESULT, Asker.PROGRAM
)
RING_SAVED = Notice(
    "ring_saved", "What just happened is saved: {name}", Level.DONE, EventKind.PROGRAM
)
RING_NOT_SAVED = Notice(
    "ring_not_saved",
    "What just happened could not be saved: {reason}",
    Level.WARNING,
    EventKind.PROGRAM,
)


_LOOK_MS: Final = 250
KEPT_S: Final = 300.0
"""The time that the ring reaches back."""
_MOST_RECENT: Final = 10_000
_END_S: Final = 1.0
_OPENED: Final = frozenset({CONNECTED, RECONNECTED})

_WORDS: Final = {"operator": "saved"}
"""The ending of a saved ring's name, by the origin of the request."""


class SessionRecorder(QObject):
    """Carries out all that the operator can do about recordings of sessions.

    It takes frames where the bus thread leaves them, and never holds that thread up. It goes on
    when the arm is lost or another one is connected. Files are only touched by threads of its own.

    Args:
        context: The context that the controller's parts share.
        events: The event log.
        parent: The parent object.
        cell: Returns what of a cell holds, which is recorded.
        episodes: Marks episodes in the recording under way.

    Attributes:
        choices: The operator's choices.

    Signals:
        changed: A recording has begun or ended, or the ring was saved.
    """

    changed = Signal()

    def __init__(
        self,
        context: Context,
        events: EventLog,
        parent: QObject | None = None,
        cell: Callable[[], CellInForce] = CellInForce,
        episodes: Episodes | None = None,
    ) -> None:
        super().__init__(parent)
        self._context = context
        self._episodes = episodes
        self._feed = EventFeed(events)
        self._facts = SidecarLines(context, cell)
        self._recent: deque[FedEvent] = deque(maxlen=_MOST_RECENT)
        self._lane = FrameLane()
        self._ring: FrameRing | None = None
        self._collector: Collector | None = None
        self._recording: SessionRecording | None = None
        self._started: dict[SessionRecording, Started] = {}
        self._ending: list[SessionRecording] = []
        self._saver: ThreadPoolExecutor | None = None
        self._saving: Future[Path] | None = None
        self._saving_plan: RecordingPlan | None = None
        self._at_faults = SaveAtFaults(KEPT_S)
        self._lost_told = self._dropped_before = 0
        self._device: object = None
        self.choices = SessionChoices(paths.sessions())
        self._timer = QTimer(self, interval=_LOOK_MS)
        self._timer.timeout.connect(self.poll)
        context.connection.add_listener(self._lane)
        context.connection.changed.connect(self._on_connection)

    # State ------------------------------------------------------------------------------------

    @property
    def recording(self) -> bool:
        """True if something is being recorded to the disk."""
        return self._recording is not None

    @property
    def saving(self) -> bool:
        """True if the ring is being saved."""
        return self._saving is not None

    def busy_names(self) -> frozenset[str]:
        """Return the recordings whose files are being written: they must not be moved."""
        writing = [*self._ending] + ([self._recording] if self._recording is not None else [])
        names = {each.name for each in writing if each.name is not None}
        if self._saving_plan is not None:
            names.add(self._saving_plan.name)
        return frozenset(names)

    def progress(self) -> RecordingProgress | None:
        """Return the progress of the recording under way, or ``None``."""
        recording = self._recording
        if recording is None:
            return None
        return RecordingProgress(
            recording.name or "",
            recording.plan.folder,
            self._context.clock() - recording.begun_s,
            recording.frames,
            recording.total_bytes,
            self._lost(recording),
        )

    def ring(self) -> RingContent:
        """The frames, seconds and bytes in the ring buffer; all 0 without one."""
        if self._ring is None:
            return RingContent()
        frames, span_s = self._ring.span()
        return RingContent(frames, span_s, self._ring.bytes_kept, self._ring.most_bytes)

    def ring_as_text(self) -> Callable[[], bytes] | None:
        """Return a function that writes the ring as a candump log; ``None`` if the ring is empty.

        The function takes seconds: call it in another thread.
        """
        if self._ring is None or self._collector is None or not self._ring.span()[0]:
            return None
        plan = self._plan("report", "report")
        return partial(_text_of, self._ring, self._collector, plan)

    def _lost(self, recording: SessionRecording) -> int:
        return recording.lost + self._lane.dropped - self._dropped_before

    # What the operator wants ------------------------------------------------------------------

    def choose(self, choices: SessionChoices) -> None:
        """Take over the operator's choices; a recording under way goes on as it was begun."""
        self.choices = choices
        if not choices.save_at_faults:
            self._at_faults.reset()

    def start(self, name: str | None = None) -> Refusal | None:
        """Record to the disk; return ``None`` if it is under way, or why not.

        Args:
            name: The name of the recording; by default the time.
        """
        if self._recording is not None:
            return self._context.refuse(SESSION_RECORDED(), sends=False)
        if name is not None and not is_name(name):
            return self._context.refuse(SESSION_NAME_BAD(name=name), sends=False)
        from armui.session.recording.session_recording import SessionRecording  # noqa: PLC0415 - python-can

        collector = self._begin_collecting()
        self._facts.reset()
        self._dropped_before, self._lost_told = self._lane.dropped, 0
        plan = self._plan(name or name_for(datetime.now().astimezone()), "operator")
        self._recording = SessionRecording(plan, self._context.clock)
        collector.add(self._recording.put)
        self._note_facts()
        self._timer.start()
        started = self._started[self._recording] = Started("session.record")
        self._context.emit_event(SESSION_STARTED, started, name=plan.name)
        if self._episodes is not None:
            self._episodes.begin_log(self._recording.note, plan.base.shift_s)
        self.changed.emit()
        return None

    def stop(self) -> Refusal | None:
        """End the recording; return ``None``, or that there is none.

        The last frames follow later.
        """
        recording = self._recording
        if recording is None:
            return self._context.refuse(SESSION_NONE(), sends=False)
        self.poll()
        if self._recording is not None:
            self._end(recording, "operator")
        return None

    def save_ring(self, reason: str = "operator") -> Refusal | None:
        """Save the ring; return ``None`` if it is being written, or why not.

        Args:
            reason: The origin of the request: ``operator``, ``fault``, ``stop``.
        """
        if self._saving is not None:
            return self._context.refuse(SESSION_SAVING(), sends=False)
        if self._ring is None or self._collector is None or not self._ring.span()[0]:
            return self._context.refuse(SESSION_RING_EMPTY(), sends=False)
        self.poll()
        self._facts.reset()
        lines = self._facts.new_lines()
        name = f"{name_for(datetime.now().astimezone())}-{_WORDS.get(reason, reason)}"
        plan = self._plan(name, "ring" if reason == "operator" else reason)
        oldest_s = self._context.clock() - KEPT_S
        lines += [_line(each, plan.base.shift_s) for each in self._recent if each.at_s >= oldest_s]
        self._saving_plan = plan
        if self._saver is None:
            self._saver = ThreadPoolExecutor(1, "armui-ring-save")
        ring, collector = self._ring, self._collector
        self._saving = self._saver.submit(_save, plan, ring, collector, lines, self._context.clock)
        self._timer.start()
        self.changed.emit()
        return None

    def end(self) -> bool:
        """End everything being written, and every thread, at the end of the program.

        Returns:
            True if all have ended within a second; a disk may hang.
        """
        self._context.connection.remove_listener(self._lane)
        if self._recording is not None:
            self._end(self._recording, "program ended")
        self._timer.stop()
        if self._collector is not None:
            self._collector.end()
        until_s = time.monotonic() + _END_S
        ended = True
        for recording in self._ending:
            ended = recording.wait(max(0.0, until_s - time.monotonic())) and ended
        if self._saver is not None:
            if self._saving is not None:
                rest_s = max(0.0, until_s - time.monotonic())
                ended = bool(wait([self._saving], rest_s).done) and ended
            self._saver.shutdown(wait=ended)
        if self._ring is not None:
            self._ring.clear()
        return ended

    # Events and the collecting thread ---------------------------------------------------------

    def poll(self) -> None:
        """Take in the events; called by its own timer, four times a second."""
        for each in self._feed.take_events():
            self._recent.append(each)
            if self.choices.save_at_faults and each.is_new:
                self._at_faults.happened(each.mark, each.at_s)
            if self._recording is not None:
                self._recording.note(_line(each, self._recording.plan.base.shift_s))
        self._note_facts()
        self._follow_recording()
        self._follow_saving()
        wanted = self._at_faults.take_due(self._context.clock())
        if wanted is not None and self._saving is None:
            self.save_ring("stop" if wanted is MarkKind.STOP else "fault")

    def _on_connection(self, report: BusReport, notice: Notice) -> None:
        if notice not in _OPENED:
            return
        self._begin_collecting()
        if self._device is not None and self._device != report.device and self._ring is not None:
            self._ring.clear()  # another bus: its frames must not be mixed in
        self._device = report.device
        self._timer.start()

    def _begin_collecting(self) -> Collector:
        """Collect frames, from the first device or the first request for recordings on."""
        # numpy comes with the first device: the window starts without it

        if self._collector is None or self._ring is None:
            self._ring = FrameRing(KEPT_S)
            self._collector = Collector(self._lane, self._ring)
            self._collector.start()
        return self._collector

    def _note_facts(self) -> None:
        if self._recording is not None:
            for line in self._facts.new_lines():
                self._recording.note(line)

    def _follow_recording(self) -> None:
        recording = self._recording
        if recording is not None and not recording.running:
            error = recording.failure
            reason = why_not_written(error or OSError("unknown"), recording.plan.folder)
            self._end(recording, "failure")
            self._close(recording, Ending.FAILED, SESSION_FAILED_NOTICE, reason=reason)
            self.changed.emit()
        elif recording is not None and (lost := self._lost(recording)) > self._lost_told:
            count, self._lost_told = lost - self._lost_told, lost
            self._context.emit_event(SESSION_FRAMES_LOST, count=count)
        for each in [one for one in self._ending if not one.running]:
            self._ending.remove(each)
            if each.failure is None:
                size = f"{each.total_bytes / 1e6:.2f}"
                figures = {"name": each.name or "", "frames": each.frames, "size": size}
                self._close(each, Ending.DONE, SESSION_ENDED, **figures)
            else:
                reason = why_not_written(each.failure, each.plan.folder)
                self._close(each, Ending.FAILED, SESSION_FAILED_NOTICE, reason=reason)
            self.changed.emit()

    def _close(
        self, recording: SessionRecording, ending: Ending, notice: Notice, **params: object
    ) -> None:
        self._context.close(self._started.pop(recording, None), ending, notice, **params)

    def _follow_saving(self) -> None:
        saving = self._saving
        if saving is None or not saving.done():
            return
        self._saving = self._saving_plan = None
        error = saving.exception()
        if error is None:
            self._context.emit_event(RING_SAVED, name=saving.result().stem)
        else:
            reason = why_not_written(error, self.choices.folder)
            self._context.emit_event(RING_NOT_SAVED, reason=reason)
        self.changed.emit()

    def _end(self, recording: SessionRecording, reason: str) -> None:
        """End the recording once its last frames are written; a failed one has ended already."""
        if self._episodes is not None:
            self._episodes.end_log()
        self._recording = None
        facts = {"reason": reason, "dropped": self._lane.dropped - self._dropped_before}
        if recording.running and reason != "failure":
            self._ending.append(recording)
        if self._collector is not None:
            self._collector.remove(recording.put, lambda: recording.end(facts))
        self.changed.emit()

    def _plan(self, name: str, reason: str) -> RecordingPlan:
        from armui.session.recording.writer import RecordingPlan, TimeBase  # noqa: PLC0415 - as above

        device = self._context.connection.device
        channel = "can" if device is None else str(device.channel)
        return RecordingPlan(
            folder=self.choices.folder,
            name=name,
            kind=self.choices.kind,
            base=TimeBase(self._context.clock(), time.time()),
            rotate_bytes=self.choices.rotate_bytes,
            channel=channel,
            facts={"reason": reason, "device": None if device is None else device.name},
        )


def _line(each: FedEvent, shift_s: float) -> Line:
    return event_line(each.at_s + shift_s, each.mark, each.entry)


def _save(
    plan: RecordingPlan,
    ring: FrameRing,
    collector: Collector,
    lines: list[Line],
    clock: Callable[[], float],
) -> Path:
    """Write the ring; in a thread of its own.

    Raises:
        OSError: It could not be written.
    """
    from armui.session.recording.session_recording import write_at_once  # noqa: PLC0415 - as above

    collector.collect(everything=True)
    return write_at_once(plan, ring.snapshot(), lines, {"reason": plan.name}, clock)


def _text_of(ring: FrameRing, collector: Collector, plan: RecordingPlan) -> bytes:
    from armui.session.recording.candump_text import candump_text  # noqa: PLC0415 - as above

    collector.collect(everything=True)
    return candump_text(ring.snapshot(), plan.base, plan.channel)
