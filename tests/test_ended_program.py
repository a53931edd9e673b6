"""A program that has ended leaves nothing in memory, however many follow it."""

import gc
import weakref

from PySide6.QtCore import QCoreApplication, QEvent, QEventLoop, QTimer

from armui.protocol.generation import Generation
from tests.app_driver import AppDriver

LONGEST_MS = 60_000


def test_nothing_of_it_is_left(qapp, request, tmp_path):
    settings = tmp_path / "settings.json"
    app_driver = AppDriver(qapp, request.node.nodeid, settings, Generation.TWO, draws=True)
    drawn = []
    app_driver.program.view.first_frame_shown.connect(lambda: drawn.append(True))
    app_driver.click("library_button")
    loop = QEventLoop()
    app_driver.program.view.first_frame_shown.connect(loop.quit)
    QTimer.singleShot(LONGEST_MS, loop.quit)
    if not drawn:
        loop.exec()
    assert drawn
    left = [
        weakref.ref(part) for part in (app_driver.program, app_driver.controller, app_driver.window)
    ]
    app_driver.close()
    del app_driver
    QCoreApplication.sendPostedEvents(None, QEvent.Type.DeferredDelete.value)
    gc.collect()
    assert [part() for part in left] == [None] * 3
