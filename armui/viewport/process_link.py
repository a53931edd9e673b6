"""Has pictures drawn in another process, and starts that process again when it is lost.

A thread of the program sends one request after another and waits for each answer. It shares
nothing with the one that draws: a process that crashes, hangs or is killed costs pictures, and
nothing else. No Qt here.
"""

from __future__ import annotations

import logging
import threading
import time
from dataclasses import dataclass, replace
from typing import TYPE_CHECKING, Final

from armui.arm.refusal import Refusal
from armui.viewport.child_process import ENTRY, ChildProcess
from armui.viewport.errors import NO_OPENGL, PROCESS_ENDED, PROCESS_HUNG
from armui.viewport.frame_memory import BYTES_PER_PIXEL, SLOTS, FrameMemory
from armui.viewport.mailbox import Mailbox
from armui.viewport.messages import Busy, Draw, Drawn, Failed, LoadFailed, Phase
from armui.viewport.view_state import BUILT_IN_ROBOT, RobotChoice
from armui.viewport.watch import LIMITS, Restarts, is_stuck

if TYPE_CHECKING:
    from collections.abc import Callable

    from armui.viewport.path_picture import PathPicture
    from armui.viewport.view_state import PickRequest, ViewState

_LOG = logging.getLogger(__name__)
_REST_S: Final = 0.15
"""The picture has come to rest when nothing has changed for so long."""

_JOIN_LIMIT_S: Final = 3.0
_WITH_A_NEW_ROBOT: Final = frozenset({Phase.LOADING, Phase.FIRST_DRAWING})


@dataclass(frozen=True, slots=True)
class Wanted:
    """A state to draw, and its number."""

    sequence: int
    state: ViewState


@dataclass(frozen=True, slots=True)
class Frame:
    """A finished image.

    Attributes:
        number: Of the frame, for `ProcessLink.frame_used`.
        sequence: Number of the state that it shows.
        memory, slot, size_px: Where it is, and how large.
        pixel_ratio: Device pixels a logical pixel.
        is_rough: Whether one with smooth edges follows.
        began_s, ended_s: When it was drawn, by the system's monotonic clock.
    """

    number: int
    sequence: int
    memory: FrameMemory
    slot: int
    size_px: tuple[int, int]
    pixel_ratio: float
    is_rough: bool
    began_s: float
    ended_s: float


@dataclass(frozen=True, slots=True)
class UpToDate:
    """The last image shows this state, too."""

    sequence: int


@dataclass(frozen=True, slots=True)
class Lost:
    """The process is gone; unless it comes back by itself, no pictures follow."""

    reason: Refusal
    comes_back: bool


News = "Frame | UpToDate | Lost | JointPicked | MarkPicked | LoadFailed"


class _LostError(Exception):
    """The process is of no use any more."""

    def __init__(self, reason: Refusal) -> None:
        self.reason = reason
        super().__init__(str(reason))


class ProcessLink:
    """Draws states in a process of its own, the latest one first.

    Args:
        tell: Takes the news, in the link's thread.
        entry: What the process runs.
    """

    def __init__(self, tell: Callable[[object], None], entry: str = ENTRY) -> None:
        self._tell = tell
        self._entry = entry
        self._mailbox: Mailbox[Wanted] = Mailbox()
        self._lock = threading.Lock()
        self._child: ChildProcess | None = None
        self._restarts = Restarts()
        self._last: Wanted | None = None
        self._proven: RobotChoice = BUILT_IN_ROBOT
        self._put_aside: RobotChoice | None = None
        self._asked_serial = 0
        self._thread = threading.Thread(target=self._run, name="armui-viewport", daemon=True)

    @property
    def pid(self) -> int | None:
        """Number of the process, while there is one."""
        with self._lock:
            return None if self._child is None else self._child.pid

    def start(self) -> None:
        """Begin; call once."""
        self._thread.start()

    def show(self, wanted: Wanted) -> None:
        """Ask for a picture; replaces a state that was not drawn yet."""
        self._mailbox.put(wanted)

    def frame_used(self, number: int) -> None:
        """This frame is on the screen: there is room for another."""
        self._mailbox.acknowledge(number)

    def stop(self) -> None:
        """End the process and the thread; may be called twice."""
        self._mailbox.close()
        with self._lock:
            if self._child is not None:
                self._child.kill()
        if self._thread.is_alive():
            self._thread.join(_JOIN_LIMIT_S)

    # In the link's thread ---------------------------------------------------------------------

    def _run(self) -> None:
        while True:
            reason = self._draw_in_one_process()
            if self._mailbox.is_closed:
                return
            _LOG.warning("The 3D view's process is lost: %s", reason or "a robot was put aside")
            comes_back = reason is None or (
                reason.code != NO_OPENGL and self._restarts.lost(time.monotonic())
            )
            if reason is not None:
                self._tell(Lost(reason, comes_back))
            if not comes_back:
                return

    def _draw_in_one_process(self) -> Refusal | None:
        """Draw until the process is lost; why. None: a robot was to blame, and is put aside."""
        self._mailbox.resume()
        self._mailbox.forget_results()
        try:
            child = ChildProcess(self._entry, self._mailbox.interrupt)
        except OSError as error:
            return Refusal(PROCESS_ENDED, {"text": str(error)})
        with self._lock:
            self._child = child
        conversation = _Conversation(child, self._mailbox, self._tell, self._asked_serial)
        reason: Refusal | None = None
        try:
            while not self._mailbox.is_closed:
                self._draw_one(conversation)
        except _LostError as error:
            reason = error.reason
        except (OSError, EOFError):
            reason = None
        finally:
            with self._lock:
                self._child = None
            child.kill()
            how = child.end()
            conversation.close()
        self._asked_serial = conversation.asked_serial
        reason = reason or Refusal(PROCESS_ENDED, {"text": how})
        return None if self._blames_robot(conversation, reason) else reason

    def _draw_one(self, conversation: _Conversation) -> None:
        wanted = self._mailbox.take_at_once() if conversation.is_new else None
        if wanted is None and conversation.is_new:
            wanted = self._last
        if wanted is None:
            wanted = self._mailbox.take(_REST_S if conversation.is_rough else None)
            if wanted is None and (self._mailbox.is_closed or not conversation.is_rough):
                conversation.check()
                return
        if wanted is not None:
            self._last = wanted
            wanted = Wanted(wanted.sequence, self._without_bad_robot(wanted.state))
        conversation.request(wanted)
        if conversation.proven_robot is not None:
            self._proven = conversation.proven_robot

    def _without_bad_robot(self, state: ViewState) -> ViewState:
        bad = state.robot == self._put_aside
        return replace(state, robot=self._proven) if bad else state

    def _blames_robot(self, conversation: _Conversation, reason: Refusal) -> bool:
        """Put a robot aside whose loading or first picture was the end of the process."""
        suspect = conversation.robot
        if (
            suspect is None
            or suspect == self._proven
            or suspect.path == BUILT_IN_ROBOT.path
            or conversation.phase not in _WITH_A_NEW_ROBOT
        ):
            return False
        self._put_aside = suspect
        hung = reason.code == PROCESS_HUNG
        params: dict[str, float | int | str] = {"path": str(suspect.path)}
        if not hung:
            params["text"] = str(reason.params.get("text", ""))
        self._tell(LoadFailed(Refusal("urdf_hangs_view" if hung else "urdf_ends_view", params)))
        return True


class _Conversation:
    """Requests and answers with one process.

    Attributes:
        is_new: Whether nothing was drawn in it yet.
        is_rough: Whether the last image wants smooth edges.
        phase: What the process was last known to do.
        robot: The one it was last asked to show.
        proven_robot: The one in the last picture.
        asked_serial: The newest question about a place that was sent; none is sent twice.
    """

    def __init__(
        self,
        child: ChildProcess,
        mailbox: Mailbox[Wanted],
        tell: Callable[[object], None],
        asked_serial: int,
    ) -> None:
        self._child = child
        self._mailbox = mailbox
        self._tell = tell
        self._memory: FrameMemory | None = None
        self._path: PathPicture | None = None
        self._slot = 0
        self._sequence = 0
        self._image_bytes = 0
        self._answered_serial = asked_serial
        self.asked_serial = asked_serial
        self.is_new = True
        self.is_rough = False
        self.phase = Phase.STARTING
        self.robot: RobotChoice | None = None
        self.proven_robot: RobotChoice | None = None

    def request(self, wanted: Wanted | None) -> None:
        """Have a state drawn, or without one the last again with smooth edges.

        Raises:
            _LostError: the process hangs, or says that it can't go on.
            OSError, EOFError: it has ended.
        """
        self._send(wanted)
        drawn = self._answer()
        self.is_new = False
        self.is_rough = drawn.is_rough
        self.proven_robot = self.robot
        memory = self._memory
        if memory is None:
            return
        memory.forget_name()
        if drawn.size_px is None:
            self._tell(UpToDate(drawn.sequence))
            return
        number = self._mailbox.result_sent()
        self._tell(
            Frame(
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
                raise _LostError(Refusal(PROCESS_ENDED, {"text": str(error)})) from error
        path = state.preview.path
        is_new_path = path is not None and path is not self._path
        message = Draw(
            wanted.sequence,
            replace(state, preview=replace(state.preview, path=None)),
            self._slot,
            memory=None if memory is self._memory else memory.name,
            path=path if is_new_path else None,
            keeps_path=path is not None and not is_new_path,
        )
        self._memory, self._path = memory, path
        self._child.send(message)

    def _unasked(self, state: ViewState) -> ViewState:
        """The state without questions that an earlier process was asked."""

        def fresh(question: PickRequest | None) -> PickRequest | None:
            if question is None or question.serial <= self._answered_serial:
                return None
            self.asked_serial = max(self.asked_serial, question.serial)
            return question

        return replace(state, pick=fresh(state.pick), mark_pick=fresh(state.mark_pick))

    def _answer(self) -> Drawn:
        since_s = time.monotonic()
        while True:
            message = self._child.receive(LIMITS[self.phase].silent_s)
            if message is None:
                raise _LostError(Refusal(PROCESS_HUNG))
            if isinstance(message, Drawn):
                self.phase = Phase.DRAWING
                return message
            if isinstance(message, Busy):
                if message.phase is not self.phase:
                    self.phase, since_s = message.phase, time.monotonic()
                if is_stuck(message, time.monotonic() - since_s):
                    raise _LostError(Refusal(PROCESS_HUNG))
            elif isinstance(message, Failed):
                raise _LostError(message.reason)
            else:
                self._tell(message)
