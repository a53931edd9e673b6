"""Ends motions of this program: a cancelled one, or all when a part fails (safety S23)."""

from __future__ import annotations

import logging
import math
from collections.abc import Callable
from typing import TYPE_CHECKING, Final

from armui.arm.refusal import Reason, Refusal
from armui.control.authority import PART_FAILED
from armui.control.link.link_state import LinkState
from armui.control.motion.abort import RUN_STOPPED, abort_motion, ending_frames
from armui.control.safety.standstill import why_not_still
from armui.protocol.addressing import OFFSETS
from armui.protocol.frame import Frame

if TYPE_CHECKING:
    from armui.control.context import Context
    from armui.control.controller_parts import ControllerParts
    from armui.control.run.execution import Execution

_LOG: Final = logging.getLogger(__name__)

_ABORTS: Final = (bytes([0, 6, 0, 0, 0, 0, 0, 0]), bytes([0, 0, 6, 0, 0, 0, 0, 0]))
"""0x150 byte 1 = 6 and byte 2 = 6, 终止; written out because the codec may be the part that fails.
"""
_MOTION_COMMAND: Final = 0x150
"""The identifier of stop, resume and trajectory commands, without an offset."""
_OPEN: Final = frozenset({LinkState.ONLINE, LinkState.OFFLINE})
_REST_WITHIN_S: Final = 0.5
"""The longest time that the end of the program waits for the arm to rest."""
_AGAIN_S: Final = 0.1
"""The end is sent again this often until the arm rests; rest reported earlier may be outdated."""
_LOOK_S: Final = 0.02
_OWED_S: Final = 10.0
"""A lost device that comes back within this time is sent the end of the motion."""


class MotionEnd:
    """Ends a run, replay, jog, single motion or gripper motion, each in its own way.

    If that fails, the arm is told to end its motion by the shortest code path, once for each
    motion. The stop and the halt do not use this class.

    Args:
        controller: Has the parts.
        context: The context that the controller's parts share.
        stopping: Knows whether a stop is outstanding, which makes any other end needless.

    Attributes:
        stuck: True if a part could not end its motion: it is asked again at each tick.
    """

    def __init__(
        self, controller: ControllerParts, context: Context, stopping: Callable[[], bool]
    ) -> None:
        self._controller = controller
        self._context = context
        self._stopping = stopping
        self._ending = False
        self._code = PART_FAILED
        self._aborted: int | None = None
        self._ended_s: float | None = None
        self._was_lost = False
        self._moved_s = -math.inf
        self.stuck = False

    def end_motion(self, code: Reason = PART_FAILED, *, single: bool = True) -> None:
        """End every motion; send nothing if nothing moves.

        Args:
            code: The reason, for the operator.
            single: True to end single motions of arm and gripper, too.
        """
        if self._ending or self._context.connection.device is None:
            return
        self._ending, self._code = True, code
        if self._context.connection.link is LinkState.LOST:
            self._owe_end()
        try:
            ways = (
                self._controller.gate.halt,
                self._end_gamepad,
                self._end_jog,
                lambda: self._end_run(self._controller.replayer),
                lambda: self._end_run(self._controller.player),
                *((self._end_single_motion, self._end_gripper) if single else ()),
                self._drop_own_replay,
            )
            ended = [_succeeds(way) for way in ways]
            self.stuck = not all(ended)
            if self.stuck:
                _succeeds(lambda: self._context.authority.cancelled(self._context.clock()))
                _succeeds(self._abort_once)
            else:
                self._aborted = None
        finally:
            self._ending = False

    def abort_from_any_thread(self) -> bool:
        """Tell the arm once more to end our motion, and stop streams and runs, from any thread.

        Returns:
            True if there is a motion that is not known to have ended.
        """
        authority = self._context.authority
        authority.failed = True
        moves = authority.command is not None or authority.may_be_ours or authority.is_ending
        told = moves and not self._stopping() and _succeeds(self._abort)
        # The gripper's part exists from the first device on; made here, it would belong to this
        # thread.
        if "gripper" in vars(self._controller):
            _succeeds(self._end_gripper)  # after the abort, which drops all that waits
        return told

    def await_rest(self, refresh: Callable[[], None], wait: Callable[[float], object]) -> None:
        """Tell the arm again to end its motion until it stands still, for half a second at most.

        A frame may be lost, and after the program's end nobody would see the arm move on.

        Args:
            refresh: Takes in the feedback.
            wait: Lets a time pass, in seconds.
        """
        authority, clock = self._context.authority, self._context.clock
        began_s = told_s = clock()
        for _ in range(round(_REST_WITHIN_S / _LOOK_S)):
            now_s = clock()
            still = now_s - began_s >= _AGAIN_S and why_not_still(self._context.state()) is None
            if still or not authority.is_ending or now_s - began_s >= _REST_WITHIN_S:
                return
            if now_s - told_s >= _AGAIN_S:
                told_s = now_s
                self._abort()
            wait(_LOOK_S)
            refresh()

    @property
    def busy(self) -> bool:
        """True while motion is being ended, now or at the next tick.

        A failure meanwhile is logged, and the reader of the log asks for an end once more.
        """
        return self._ending or self.stuck

    def retry_end(self, now_s: float) -> None:
        """Try again to end motions that could not be ended; called at each tick."""
        if self.stuck:
            self.end_motion(self._code)
        connection, authority = self._context.connection, self._context.authority
        if connection.link in _OPEN and authority.may_be_ours:
            self._moved_s = now_s
        if authority.cancel_is_due(now_s) and not self._stopping():
            self._abort()
        if self._ended_s is None:
            return
        self._was_lost = self._was_lost or connection.link is LinkState.LOST
        if now_s - self._ended_s > _OWED_S or connection.device is None:
            self._ended_s, self._was_lost = None, False
        elif self._was_lost and connection.link in _OPEN:
            # The abort was lost with the device, or could not be sent without it: send it.
            self._ended_s, self._was_lost = None, False
            if not authority.other.commands:
                self._abort()

    def _end_gamepad(self) -> None:
        if "gamepad" in vars(self._controller):
            self._controller.gamepad.lose(self._reason())

    def _end_jog(self) -> None:
        jogging = self._controller.jogging
        if jogging.active:
            self._note()
            jogging.end_jog(self._reason())

    def _end_run(self, run: Execution) -> None:
        if run.running:
            self._note()
            run.end_run(self._reason())

    def _end_single_motion(self) -> None:
        authority = self._context.authority
        if authority.may_be_ours and not self._stopping():
            self._note()
            abort_motion(self._context)

    def _drop_own_replay(self) -> None:
        """Drop the request for the arm's own replay, which was ended as a single motion."""
        self._controller.teaching.drop_replay()

    def _end_gripper(self) -> None:
        self._controller.gripper.end_travel()

    def _reason(self) -> Refusal:
        """Return the reason for the end; during a stop the one after which nothing is sent."""
        stopped = self._stopping()
        return Refusal(RUN_STOPPED if stopped else self._code)

    def _owe_end(self) -> None:
        """Note that a motion of ours must be ended when the lost adapter comes back."""
        now_s = self._context.clock()
        if now_s - self._moved_s <= _OWED_S:
            self._ended_s, self._was_lost = now_s, True

    def _note(self) -> None:
        self._ended_s, self._was_lost = self._context.clock(), False

    def _abort_once(self) -> None:
        try:
            number = self._context.authority.number
        except Exception:  # noqa: BLE001 - this part may be the one that fails
            number = 0
        if number != self._aborted and not self._stopping():
            self._aborted = number
            self._abort()

    def _abort(self) -> None:
        connection = self._context.connection
        device = connection.device
        if device is None or device.listen_only:
            return
        try:
            frames = ending_frames(connection)
        except Exception:  # noqa: BLE001 - this part may be the one that fails
            frames = [Frame(_MOTION_COMMAND + each, data) for data in _ABORTS for each in OFFSETS]
        connection.send_urgent(frames)


def _succeeds(act: Callable[[], object]) -> bool:
    try:
        act()
    except Exception:  # noqa: BLE001 - whatever has failed before may fail again
        _LOG.exception("A motion could not be ended by the part that drives it")
        return False
    return True
