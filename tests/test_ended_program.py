"""A program that has ended leaves nothing in memory, however many follow it."""

import gc
import weakref

from PySide6.QtCore import QCoreApplication, QEvent, QEventLoop, QTimer

from armui.protocol.generation import Generation
from tests.desk import Desk

LONGEST_MS = 60_000


def test_nothing_of_it_is_left(qapp, request, tmp_path):
    settings = tmp_path / "settings.json"
    desk = Desk(qapp, request.node.nodeid, settings, Generation.TWO, draws=True)
    drawn = []
    desk.program.view.first_frame_shown.connect(lambda: drawn.append(True))
    desk.click("library_button")
    loop = QEventLoop()
    desk.program.view.first_frame_shown.connect(loop.quit)
    QTimer.singleShot(LONGEST_MS, loop.quit)
    if not drawn:
        loop.exec()
    assert drawn
    left = [weakref.ref(part) for part in (desk.program, desk.controller, desk.window)]
    desk.close()
    del desk
    QCoreApplication.sendPostedEvents(None, QEvent.Type.DeferredDelete.value)
    gc.collect()
    assert [part() for part in left] == [None] * 3
