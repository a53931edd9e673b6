"""A program that has ended leaves nothing in memory, however many follow it."""

import gc
import weakref

from PySide6.QtCore import QCoreApplication, QEvent

from armui.protocol.generation import Generation
from tests.desk import Desk


def test_nothing_of_it_is_left(qapp, request, tmp_path):
    desk = Desk(qapp, request.node.nodeid, tmp_path / "settings.json", Generation.TWO)
    desk.click("library_button")
    left = [weakref.ref(part) for part in (desk.program, desk.controller, desk.window)]
    desk.close()
    del desk
    QCoreApplication.sendPostedEvents(None, QEvent.Type.DeferredDelete.value)
    gc.collect()
    assert [part() for part in left] == [None] * 3
