"""The window 回放 in use."""

from __future__ import annotations

import tempfile
import time
from collections.abc import Callable
from datetime import datetime
from pathlib import Path

from PySide6.QtCore import QDeadlineTimer
from PySide6.QtTest import QTest
from PySide6.QtWidgets import QDialog

from armui.protocol.generation import Generation
from armui.sim.faults.schedule import Fault
from armui.ui.watch.replay.replay_window import ReplayWindow
from tests.accepted import accepted
from tests.app_driver import AppDriver, AtOnce
from tests.gallery_scenes.events import act
from tests.session.recordings import START_S, frames, moving, write

SIZE_PX = (1440, 920)
SMALL_PX = (1000, 640)
_DRAWN_MS = 500
_HIT_S = 14.0
_PICTURE_MS = 60_000


def _log() -> Path:
    """Twenty seconds of an arm that moves, gets hot, is hit, and is stopped."""
    path = Path(tempfile.gettempdir()) / "armui-gallery" / "2026-09-21 cell 3.blf"
    if not path.exists():
        path.parent.mkdir(exist_ok=True)
        faults = (
            Fault("motor-overtemperature", 3, 6.0, 7.0),
            Fault("collision", 2, _HIT_S, _HIT_S + 0.5),
        )
        write(path, frames(20.0, faults=faults, asked=moving(Generation.TWO)))
    return path


def _patiently(condition: Callable[[], bool]) -> None:
    """A process that draws may begin slowly on a busy computer."""
    deadline = QDeadlineTimer(_PICTURE_MS)
    while not condition():
        assert not deadline.hasExpired(), "it never came"
        QTest.qWait(10)


def _window(app_driver: AppDriver, tab: int, since_s: float) -> ReplayWindow:
    app_driver.window.pages.show("replay")
    window = app_driver.dialog(ReplayWindow)
    window.resize(*SIZE_PX)
    if window.view is None:
        window._make_helper = AtOnce
        window.open_log(_log())
        _patiently(lambda: window.view is not None)
    view = window.view
    assert view is not None
    view.tabs.setCurrentIndex(tab)
    view.replay.go_to(START_S + since_s)
    app_driver.wait(lambda: not view.replay.is_travelling)
    if view.curves.isVisible():  # what nobody sees is not read
        series = view.curves.board.telemetry.series["JointFeedback12"]
        app_driver.wait(lambda: series.count > 1000)
        app_driver.wait(lambda: view.curves.board.built)
        view.curves.board.set_span(20.0)
        view.curves.board.draw(view.curves.board.now_s())
    _patiently(lambda: view.view.is_settled)
    return window


def joints(app_driver: AppDriver) -> QDialog:
    return _window(app_driver, 0, _HIT_S + 0.3)


def curves(app_driver: AppDriver) -> QDialog:
    return _window(app_driver, 1, _HIT_S + 2.0)


def jumped(app_driver: AppDriver) -> QDialog:
    """Paused, and gone to another place: its curves are there without 播放."""
    window = _window(app_driver, 1, _HIT_S + 2.0)
    view = window.view
    assert view is not None
    view.replay.go_to(START_S + 7.0)
    app_driver.wait(lambda: not view.replay.is_travelling)
    _patiently(lambda: view.view.is_settled)
    QTest.qWait(_DRAWN_MS)
    return window


def small(app_driver: AppDriver) -> QDialog:
    """As it opens on a small screen: time line and buttons in sight."""
    window = _window(app_driver, 0, _HIT_S + 0.3)
    window.resize(*SMALL_PX)
    view = window.view
    assert view is not None
    _patiently(lambda: view.view.is_settled)
    return window


def events(app_driver: AppDriver) -> QDialog:
    window = _window(app_driver, 2, _HIT_S + 0.01)
    view = window.view
    assert view is not None
    app_driver.wait(lambda: view.events.model.rowCount() > 0)
    return window


def whole(app_driver: AppDriver) -> QDialog:
    """The curves from beginning to end, with the cursor where the replay is."""
    window = _window(app_driver, 3, _HIT_S + 0.01)
    view = window.view
    assert view is not None
    curves = view.whole
    app_driver.wait(lambda: curves.area is not None and curves.area.board.built)
    app_driver.wait(lambda: not curves.is_loading)
    curves.show_position(view.replay.position_s)
    assert curves.area is not None
    curves.area.board.draw(curves.area.board.now_s())
    return window


def listed(app_driver: AppDriver) -> QDialog:
    """The frames around the moment that is shown."""
    window = _window(app_driver, 4, _HIT_S + 0.01)
    view = window.view
    assert view is not None
    frames = view.frames
    app_driver.wait(lambda: frames.table.currentIndex().row() > 0)
    return window


def _own_recording(app_driver: AppDriver) -> Path:
    """An arm that moves, has a fault, is recovered, and is stopped; recorded once for all looks."""
    controller, sessions = app_driver.controller, app_driver.controller.sessions
    made = sessions.choices.folder / "cell 3.blf"
    if "session_ended" in app_driver.codes():
        return made
    zero_s = time.time() - app_driver.time_s
    controller._wall = controller.event_collector._writer._wall = lambda at_s: (
        datetime.fromtimestamp(zero_s + at_s).astimezone()
    )
    folder = Path(tempfile.mkdtemp(prefix="armui-gallery-"))
    app_driver.store.change(session_folder=str(folder))
    assert sessions.start("cell 3") is None
    accepted(controller.motors.enable())
    app_driver.run_until(lambda: controller.operating_state.cannot_move is None)
    act(app_driver)
    assert sessions.stop() is None

    def is_ended() -> bool:
        sessions.poll()
        return "session_ended" in app_driver.codes()

    app_driver.wait(is_ended)
    return folder / "cell 3.blf"


def own_events(app_driver: AppDriver) -> QDialog:
    """A recording of this program: who asked for what, what was answered and read back."""
    app_driver.window.pages.show("replay")
    window = app_driver.dialog(ReplayWindow)
    window.resize(*SIZE_PX)
    if window.view is None:
        window.open_log(_own_recording(app_driver))
        _patiently(lambda: window.view is not None)
    view = window.view
    assert view is not None
    _patiently(lambda: view.events.model.rowCount() > 0)
    view.tabs.setCurrentIndex(2)
    fault = next(each for each in view.events.model.entries() if each.code == "joint_fault")
    view.replay.go_to(fault.at_s)
    app_driver.wait(lambda: not view.replay.is_travelling)
    _patiently(lambda: view.view.is_settled)
    return window


def beginning(app_driver: AppDriver) -> QDialog:
    app_driver.window.pages.show("replay")
    window = app_driver.dialog(ReplayWindow)
    window.resize(*SIZE_PX)
    window._on_cancel()
    return window
