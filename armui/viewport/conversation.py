"""Requests to one process of the picture, and its answers. No Qt here."""

from __future__ import annotations

import logging
import time
from typing import TYPE_CHECKING, TypeVar

from armui.arm.refusal import Refusal
from armui.arm.refusal_codes import RefusalCode
from armui.viewport.frame_memory import SLOTS, FrameMemory
from armui.viewport.messages import (
    BYTES_PER_PIXEL,
    Draw,
    Drawn,
    Failed,
    LoadFailed,
    PictureBusy,
    PicturePhase,
    Ready,
    RobotRead,
)
from armui.viewport.news import PictureFrame, UpToDate, Wanted
from armui.viewport.view_state import BUILT_IN_ROBOT
from armui.viewport.watch import LIMITS, LOOK_S, is_starved, is_stuck, silent_too_long

if TYPE_CHECKING:
    from collections.abc import Callable

    from armui.viewport.child_process import ChildProcess
    from armui.viewport.mailbox import Mailbox
    from armui.viewport.messages import Answer
    from armui.viewport.path_picture import PathPicture
    from armui.viewport.view_state import PickRequest, RobotChoice, ViewState
    from armui.viewport.watch import ThreadTurns

_LOG = logging.getLogger(__name__)

A = TypeVar("A", Ready, Drawn)


class ProcessLostError(Exception):
    """The process is of no use any more."""

    def __init__(self, reason: Refusal) -> None:
        self.reason = reason
        super().__init__(str(reason))


class Conversation:
    """Requests and answers with one process.

    Attributes:
        is_new: Whether nothing was drawn in it yet.
        is_rough: Whether the last image wants smooth edges.
        phase: What the process was last known to do.
        robot: The one it was last asked to show.
        proven_robot: The one in the last picture.
        failed_robot: The last one that could not be shown; the one before stays in the picture.
        asked_serial: The newest question about a place that was sent; none is sent twice.
    """

    def __init__(
        self,
        child: ChildProcess,
        mailbox: Mailbox[Wanted],
        tell: Callable[[object], None],
        asked_serial: int,
        robots: dict[RobotChoice, bytes],
    ) -> None:
        self._robots = robots
        self._child = child
        self._mailbox = mailbox
        self._tell = tell
        self._memory: FrameMemory | None = None
        self._path: PathPicture | None = None
        self._slot = 0
        self._sequence = 0
        self._image_bytes = 0
        self._answered_serial = asked_serial
        self._heartbeat_thread: int | None = None
        self.asked_serial = asked_serial
        self.is_new = True
        self.is_rough = False
        self.phase = PicturePhase.STARTING
        self.robot: RobotChoice | None = None
        self.proven_robot: RobotChoice | None = None
        self.failed_robot: RobotChoice | None = None

    def begin(self) -> None:
        """Wait until the process takes requests; raises what `request` raises."""
        self._await(Ready)

    def request(self, wanted: Wanted | None) -> None:
        """Have a state drawn, or without one the last again with smooth edges.

        Raises:
            ProcessLostError: the process hangs, or says that it can't go on.
            OSError, EOFError: it has ended.
        """
        self._send(wanted)
        drawn = self._await(Drawn)
        self.phase = PicturePhase.DRAWING
        self.is_new = False
        self.is_rough = drawn.is_rough
        if self.robot != self.failed_robot:
            self.proven_robot = self.robot
        memory = self._memory
        if memory is None:
            return
        memory.forget_name()
        if drawn.size_px is None:
            self._tell(UpToDate(drawn.sequence, drawn.is_rough))
            return
        number = self._mailbox.result_sent()
        self._tell(
            PictureFrame(
                number,
                drawn.sequence,
                memory,
                self._slot,
                drawn.size_px,
                drawn.pixel_ratio,
                drawn.is_rough,
                drawn.began_s,
                drawn.ended_s,
            )
        )
        self._slot = (self._slot + 1) % SLOTS

    def check(self) -> None:
        """Whether a process that was asked nothing is still there.

        Raises:
            EOFError, OSError: it is not.
        """
        self._child.receive(0.0)

    def close(self) -> None:
        """Nothing with a name is left."""
        if self._memory is not None:
            self._memory.forget_name()

    def _send(self, wanted: Wanted | None) -> None:
        if wanted is None:
            self._child.send(Draw(self._sequence, None, self._slot))
            return
        self._sequence = wanted.sequence
        state = self._unasked(wanted.state)
        self.robot = state.robot
        self._image_bytes = state.width_px * state.height_px * BYTES_PER_PIXEL
        memory = self._memory
        if memory is None or not memory.suits(self._image_bytes):
            try:
                memory = FrameMemory.create(self._image_bytes)
            except OSError as error:
                raise ProcessLostError(
                    Refusal(RefusalCode.PICTURE_PROCESS_ENDED, {"text": str(error)})
                ) from error
        path = state.preview.path
        is_new_path = path is not None and path is not self._path
        message = Draw(
            wanted.sequence,
            state._replace(preview=state.preview._replace(path=None)),
            self._slot,
            memory=None if memory is self._memory else memory.name,
            path=path if is_new_path else None,
            keeps_path=path is not None and not is_new_path,
            robot=self._robots.get(state.robot) if self.is_new else None,
        )
        self._memory, self._path = memory, path
        self._child.send(message)

    def _keep(self, content: bytes) -> None:
        """Keep the robot that was read, and no other, for the next process."""
        self._robots.clear()
        if self.robot is not None:
            # in the place of one that fails at the start, the built-in one is read
            read = BUILT_IN_ROBOT if self.robot == self.failed_robot else self.robot
            self._robots[read] = content

    def _unasked(self, state: ViewState) -> ViewState:
        """The state without questions that an earlier process was asked."""

        def fresh(question: PickRequest | None) -> PickRequest | None:
            if question is None or question.serial <= self._answered_serial:
                return None
            self.asked_serial = max(self.asked_serial, question.serial)
            return question

        return state._replace(pick=fresh(state.pick), mark_pick=fresh(state.mark_pick))

    def _hear(self) -> Answer | None:
        """The next message; None: it hangs, for it is silent though it had its turns."""
        message = self._child.receive(LIMITS[self.phase].silent_s)
        if message is not None:
            return message
        since_s = time.monotonic() - LIMITS[self.phase].silent_s
        first = before = self._turns()
        while (message := self._child.receive(LOOK_S)) is None:
            now = self._turns()
            ran_s = sum(now[each].ran_s - first[each].ran_s for each in now.keys() & first.keys())
            silent_s = time.monotonic() - since_s
            if not is_starved(before, now, LOOK_S) or silent_too_long(self.phase, silent_s, ran_s):
                return None
            before = now
        return message

    def _turns(self) -> dict[int, ThreadTurns]:
        """Of the threads that do something: whoever waits for Python's lock stands in line, too."""
        turns = self._child.turns()
        return {each: had for each, had in turns.items() if each != self._heartbeat_thread}

    def _await(self, kind: type[A]) -> A:
        """The next answer of a kind; what comes before it is told, or noted."""
        since_s = looked_s = time.monotonic()
        turns: dict[int, ThreadTurns] = {}
        while True:
            message = self._hear()
            if message is None:
                raise ProcessLostError(Refusal(RefusalCode.PICTURE_PROCESS_HUNG))
            if isinstance(message, Ready):
                self._heartbeat_thread = message.heartbeat_thread
            if isinstance(message, kind):
                return message
            if isinstance(message, PictureBusy):
                if message.phase is not self.phase:
                    self.phase, since_s = message.phase, time.monotonic()
                before, before_s = turns, looked_s
                turns, looked_s = self._turns(), time.monotonic()
                starved = is_starved(before, turns, looked_s - before_s)
                if is_stuck(message, looked_s - since_s, starved=starved):
                    raise ProcessLostError(Refusal(RefusalCode.PICTURE_PROCESS_HUNG))
            elif isinstance(message, RobotRead):
                self._keep(message.content)
            elif isinstance(message, Failed):
                _LOG.error("The 3D view stopped\n%s", message.traceback)
                raise ProcessLostError(message.reason)
            else:
                self._pass_on(message)

    def _pass_on(self, message: Answer) -> None:
        if isinstance(message, LoadFailed):
            self.failed_robot = self.robot
        self._tell(message)
