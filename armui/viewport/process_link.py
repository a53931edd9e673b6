"""Has pictures drawn in another process, and starts that process again when it is lost.

A thread of the program sends one request after another and waits for each answer. It shares
nothing with the one that draws: a process that crashes, hangs or is killed costs pictures, and
nothing else. No Qt here. What starts processes is imported by that thread, so that no window waits.
"""

from __future__ import annotations

import logging
import threading
import time
from typing import TYPE_CHECKING, Final

from armui.arm.refusal import Refusal
from armui.arm.refusal_codes import RefusalCode
from armui.viewport.mailbox import Mailbox
from armui.viewport.messages import LoadFailed, PicturePhase
from armui.viewport.news import Lost, Wanted
from armui.viewport.view_state import BUILT_IN_ROBOT, RobotChoice
from armui.viewport.watch import Restarts

if TYPE_CHECKING:
    from collections.abc import Callable

    from armui.viewport.child_process import ChildProcess
    from armui.viewport.conversation import Conversation
    from armui.viewport.view_state import ViewState

ENTRY: Final = "armui.viewport.process.main:run"
"""Module and function that the process runs; by name, so that the program does not load it."""

_LOG = logging.getLogger(__name__)
_REST_S: Final = 0.15
"""The picture has come to rest when nothing has changed for so long."""

_JOIN_LIMIT_S: Final = 3.0
_WITH_A_NEW_ROBOT: Final = frozenset({PicturePhase.LOADING, PicturePhase.FIRST_DRAWING})


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
        self._robot_read: dict[RobotChoice, bytes] = {}
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
            try:
                reason = self._draw_in_one_process()
            except Exception as error:  # noqa: BLE001 - the view must learn of it, and try again
                _LOG.exception("The link to the 3D view's process failed")
                reason = Refusal(
                    RefusalCode.DRAWING_STOPPED, {"text": f"{type(error).__name__}: {error}"}
                )
            if self._mailbox.is_closed:
                return
            _LOG.warning("The 3D view's process is lost: %s", reason or "a robot was put aside")
            comes_back = reason is None or (
                reason.code != RefusalCode.NO_OPENGL and self._restarts.lost(time.monotonic())
            )
            if reason is not None:
                self._tell(Lost(reason, comes_back))
            if not comes_back:
                return

    def _draw_in_one_process(self) -> Refusal | None:
        """Draw until the process is lost; why. None: a robot was to blame, and is put aside."""
        from armui.viewport.child_process import ChildProcess  # noqa: PLC0415 - see above
        from armui.viewport.conversation import Conversation, ProcessLostError  # noqa: PLC0415

        self._mailbox.resume()
        self._mailbox.forget_results()
        try:
            child = ChildProcess(self._entry, self._mailbox.interrupt)
        except OSError as error:
            return Refusal(RefusalCode.PICTURE_PROCESS_ENDED, {"text": str(error)})
        with self._lock:
            self._child = child
            if self._mailbox.is_closed:  # while the process was started
                child.kill()
        conversation = Conversation(
            child, self._mailbox, self._tell, self._asked_serial, self._robot_read
        )
        reason: Refusal | None = None
        try:
            conversation.begin()
            while not self._mailbox.is_closed:
                self._draw_one(conversation)
        except ProcessLostError as error:
            reason = error.reason
            child.kill()
        except (OSError, EOFError):
            reason = None
        finally:
            with self._lock:
                self._child = None
            how = child.end()
            conversation.close()
        self._asked_serial = conversation.asked_serial
        # the next process has none that could stay in the picture
        self._put_aside = conversation.failed_robot or self._put_aside
        reason = reason or Refusal(RefusalCode.PICTURE_PROCESS_ENDED, {"text": how})
        return None if self._blames_robot(conversation, reason) else reason

    def _draw_one(self, conversation: Conversation) -> None:
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
        return state._replace(robot=self._proven) if bad else state

    def _blames_robot(self, conversation: Conversation, reason: Refusal) -> bool:
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
        hung = reason.code == RefusalCode.PICTURE_PROCESS_HUNG
        params: dict[str, float | int | str] = {"path": str(suspect.path)}
        if not hung:
            params["text"] = str(reason.params.get("text", ""))
        self._tell(
            LoadFailed(
                Refusal(RefusalCode.URDF_HANGS_VIEW if hung else RefusalCode.URDF_ENDS_VIEW, params)
            )
        )
        return True
