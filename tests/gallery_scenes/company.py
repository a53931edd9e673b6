"""The window when somebody else moves the arm, or a motion is held back in it."""

from __future__ import annotations

from collections.abc import Iterator
from contextlib import contextmanager

from tests.company import OtherHost
from tests.desk import Desk
from tests.gallery_scenes.arm import reached_out

THERE_DEG = (-20.0, 60.0, -40.0, 0.0, 20.0, 0.0)


@contextmanager
def _host(desk: Desk) -> Iterator[OtherHost]:
    host = OtherHost(desk)
    try:
        yield host
    finally:
        host.close()


def held_back(desk: Desk) -> None:
    """A motion stands at 0 %, and waits for the operator's word."""
    reached_out(desk)
    desk.controller.motion.send_joints(THERE_DEG)
    desk.run(1.0)
    desk.controller.motion.set_speed_percent(0)
    desk.run(1.5)


def other_host(desk: Desk) -> None:
    """Another program has moved the arm and pauses: it may be taken over."""
    reached_out(desk)
    with _host(desk) as host:
        stream = host.stream_targets(lambda _t_s: THERE_DEG, rate_hz=200, speed_percent=30)
        desk.run(1.0)
        stream.end()
        desk.run(0.8)


def other_mode(desk: Desk) -> None:
    """Another program drives the arm in MIT mode."""
    reached_out(desk)
    with _host(desk) as host:
        host.say("151#010400AD00000000")
        desk.run(0.3)
