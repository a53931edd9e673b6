"""Small windows open over the panel or the page: picture and stops stay free."""

import pytest
from PySide6.QtCore import QPoint, QRect
from PySide6.QtWidgets import QWidget

from armui.ui.dialogs.base import ArmDialog
from armui.ui.dialogs.confirm_dialog import LeaveQuestion
from armui.ui.shell.workspace import PageWindow

pytestmark = pytest.mark.styled


def on_desktop(widget: QWidget) -> QRect:
    return QRect(widget.mapToGlobal(QPoint(0, 0)), widget.size())


def free(pages):
    """What no small window may lie over."""
    names = ("stop_button", "halt_button")
    return [on_desktop(pages.view), *(on_desktop(pages.driver.find(name)) for name in names)]


@pytest.mark.parametrize("language", ["en", "zh"])
def test_the_question_before_an_editor_is_left(pages, language):
    pages.driver.store.change(language=language)
    pages.change(pages.open_editor())
    pages.driver.click("page_back")
    question = pages.driver.dialog(LeaveQuestion)
    assert not [each for each in free(pages) if each.intersects(question.frameGeometry())]


def test_the_question_before_motors_are_switched_off(pages):
    pages.driver.ready()
    pages.driver.click("enable_button")
    question = pages.driver.dialog(ArmDialog)
    assert not [each for each in free(pages) if each.intersects(question.frameGeometry())]


def test_over_a_page_that_was_taken_out_its_own_stops_stay_free(pages):
    pages.change(pages.open_editor())
    window = pages.take_out()
    assert isinstance(window, PageWindow)
    window.close()
    question = pages.driver.dialog(LeaveQuestion)
    stops = (window.stop_button, window.halt_button)
    assert not [each for each in stops if on_desktop(each).intersects(question.frameGeometry())]
