"""The window when somebody else moves the arm, or a motion is held back in it."""

from __future__ import annotations

from collections.abc import Iterator
from contextlib import contextmanager

from tests.app_driver import AppDriver
from tests.company import OtherHost
from tests.gallery_scenes.arm import reached_out

THERE_DEG = (-20.0, 60.0, -40.0, 0.0, 20.0, 0.0)


@contextmanager
def _host(app_driver: AppDriver) -> Iterator[OtherHost]:
    host = OtherHost(app_driver)
    try:
        yield host
    finally:
        host.close()


def held_back(app_driver: AppDriver) -> None:
    """A motion stands at 0 %, and waits for the operator's word."""
    reached_out(app_driver)
    app_driver.controller.motion.send_joints(THERE_DEG)
    app_driver.run(1.0)
    app_driver.controller.motion.set_speed_percent(0)
    app_driver.run(1.5)


def other_host(app_driver: AppDriver) -> None:
    """Another program has moved the arm and pauses: it may be taken over."""
    reached_out(app_driver)
    with _host(app_driver) as host:
        stream = host.stream_targets(lambda _t_s: THERE_DEG, rate_hz=200, speed_percent=30)
        app_driver.run(1.0)
        stream.end()
        app_driver.run(0.8)


def other_mode(app_driver: AppDriver) -> None:
    """Another program drives the arm in MIT mode."""
    reached_out(app_driver)
    with _host(app_driver) as host:
        host.say("151#010600AD00000000")
        app_driver.run(0.3)
