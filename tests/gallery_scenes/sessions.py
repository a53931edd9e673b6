"""The page 会话记录 in use."""

from __future__ import annotations

from collections.abc import Sequence
from pathlib import Path

from PySide6.QtWidgets import QWidget

from armui.session.recording.kinds import RecordingFormat
from armui.session.recording.rows import ROW, FrameRows
from armui.session.recording.sidecar import event_line
from armui.session.recording.writer import RecordingPlan, RecordingWriter, TimeBase
from armui.session.session import MarkKind
from armui.ui.watch.recordings.sessions_page import SessionsPage
from tests.app_driver import AppDriver

SIZE_PX = (1080, 700)
_MORNING_S = 1_780_000_000.0


def _made(folder: Path, name: str, at_s: float, *, minutes: float, reason: str, marks: str) -> None:
    """A recording of another day; marks are f for a fault, s for a stop."""
    import numpy as np  # noqa: PLC0415 - only for these pictures

    base = TimeBase(at_s, at_s)
    plan = RecordingPlan(folder, name, RecordingFormat.BLF, base, 10**9, facts={"reason": reason})
    writer = RecordingWriter(plan, clock=lambda: at_s, time_of_day=lambda: at_s)
    table = np.zeros(1000, ROW)
    table["time_s"] = at_s + np.linspace(0.0, 60.0 * minutes, 1000)
    table["id"], table["length"] = 0x2A1 + np.arange(1000) % 30, 8
    table["data"][:, 3] = np.arange(1000) % 251
    kinds = {"f": MarkKind.FAULT, "s": MarkKind.STOP}
    lines = [event_line(at_s + 1, kinds[mark], {"place": at}) for at, mark in enumerate(marks)]
    writer.write(FrameRows(table), lines)
    writer.finish({"reason": reason})


def _recordings(app_driver: AppDriver) -> Sequence[str]:
    folder = app_driver.library_folder.parent / "sessions"
    if not folder.exists():
        _made(
            folder, "pick and place, shift 2", _MORNING_S, minutes=31.4, reason="operator", marks=""
        )
        _made(folder, "session-20260528-220105-fault", _MORNING_S + 4200, minutes=5,
              reason="fault", marks="ffs")  # fmt: skip
        _made(folder, "session-20260529-091512-stop", _MORNING_S + 44_000, minutes=5,
              reason="stop", marks="s")  # fmt: skip
        _made(folder, "gripper drifts", _MORNING_S + 51_000, minutes=2.2, reason="ring", marks="")
        _made(folder, "overnight", _MORNING_S + 90_000, minutes=611, reason="command", marks="f")
    return [str(folder)]


def _page(app_driver: AppDriver) -> SessionsPage:
    _recordings(app_driver)
    folder = app_driver.library_folder.parent / "sessions"
    app_driver.store.change(session_folder=str(folder))
    app_driver.find("sessions_button").click()
    page = app_driver.page(SessionsPage)
    app_driver.wait(lambda: page.table.model().rowCount() >= 5)
    return page


def listed(app_driver: AppDriver) -> SessionsPage:
    """What was recorded on other days; the last minutes are in memory."""
    page = _page(app_driver)
    page.table.selectRow(2)
    app_driver.wait(lambda: app_driver.controller.sessions.ring().frames > 100)
    page._refresh_cards()
    return page


def taken_out(app_driver: AppDriver) -> QWidget:
    """The same in a window of its own."""
    listed(app_driver)
    window = app_driver.taken_out(SessionsPage).window()
    window.resize(*SIZE_PX)
    return window


def recording(app_driver: AppDriver) -> SessionsPage:
    """While it is recorded."""
    page = _page(app_driver)
    sessions = app_driver.controller.sessions
    if not sessions.recording:
        sessions.start("test of the new tool")
        app_driver.run(2.0)

    def written() -> bool:
        progress = sessions.progress()
        return progress is not None and progress.frames > 1000

    app_driver.wait(written)
    page.refresh()
    page._refresh_cards()
    return page
