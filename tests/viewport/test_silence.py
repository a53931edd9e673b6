"""A process of the picture that says nothing: it hangs, or the processors are taken by others."""

from __future__ import annotations

import itertools
import sys
from typing import Any

import pytest

from armui.viewport.messages import PICTURE_PROCESS_HUNG, Drawn, PicturePhase, Ready
from armui.viewport.process_link import (
    ChildProcess,
    Mailbox,
    ProcessLostError,
    RenderRequest,
    RenderSession,
)
from armui.viewport.view_state import BUILT_IN_ROBOT, ViewState
from armui.viewport.watch import ThreadTurns
from tests.posix import of_system, stand_still

DRAWING, HEARTBEAT = 1, 2


class SilentChild:
    """Draws after so many silent looks; between them, a thread of it has had such turns."""

    def __init__(
        self, silent_looks: int, queued_s: float, ran_s: float = 0.0, thread: int = DRAWING
    ) -> None:
        silence = [None] * silent_looks
        drawn = Drawn(1, None, 1.0, False, 0.0, 0.0)
        self._answers = itertools.chain([Ready(HEARTBEAT)], silence, [drawn])
        self._thread = thread
        self._number = itertools.count()
        self._queued_s = queued_s
        self._ran_s = ran_s

    def send(self, _message: Any) -> None:
        pass

    def receive(self, limit_s: float) -> Any:
        assert limit_s > 0.0
        return next(self._answers)

    def turns(self) -> dict[int, ThreadTurns]:
        number = next(self._number)
        return {self._thread: ThreadTurns(number * self._ran_s, number * self._queued_s, False)}


def draw(child: SilentChild) -> None:
    mailbox: Mailbox[RenderRequest] = Mailbox()
    session = RenderSession(child, mailbox, print, 0, {})  # type: ignore[arg-type]
    session.begin()
    session.phase = PicturePhase.DRAWING
    try:
        session.render(RenderRequest(1, ViewState(BUILT_IN_ROBOT, width_px=2, height_px=2)))
    finally:
        session.close()


def test_one_that_stands_in_line_is_waited_for():
    draw(SilentChild(silent_looks=20, queued_s=0.15))


@pytest.mark.parametrize(
    "child",
    [
        SilentChild(silent_looks=3, queued_s=0.0),
        SilentChild(silent_looks=10_000, queued_s=0.15, ran_s=0.05),
        SilentChild(silent_looks=3, queued_s=0.15, thread=HEARTBEAT),
    ],
    ids=["sleeps", "spins among others", "holds Python's lock"],
)
def test_one_that_hangs_is_not(child):
    with pytest.raises(ProcessLostError) as lost:
        draw(child)
    assert lost.value.refusal.reason == PICTURE_PROCESS_HUNG


@pytest.mark.skipif(sys.platform != "linux", reason="/proc")
def test_the_system_tells_the_turns_of_a_process():
    child = ChildProcess("tests.viewport.processes:sleeping", print)
    try:
        while not child.turns():
            pass
        assert all(each.ran_s >= 0.0 for each in child.turns().values())
        assert child.pid is not None
        stand_still(child.pid)
        of_system("waitid")(
            of_system("P_PID"), child.pid, of_system("WSTOPPED") | of_system("WNOWAIT")
        )
        standing = child.turns()
        assert standing == child.turns()
        assert not any(each.wants_to_run for each in standing.values())
    finally:
        child.kill()
        child.end()
    assert child.turns() == {}
