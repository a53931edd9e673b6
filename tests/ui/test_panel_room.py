"""The room of a panel: what scrolls, and what is kept for a message."""

import pytest
from PySide6.QtWidgets import QApplication, QPushButton, QScrollArea

from armui.arm.refusal import Refusal
from armui.control.safety.interlocks import STOPPED
from armui.ui.panels.light_panel import LightPanel
from armui.ui.panels.teaching_panel import TeachingPanel
from armui.ui.widgets.message_line import MessageLine
from tests.ui.arm_states import operating_state

KINDS = {
    "the card is the last": lambda controller: TeachingPanel(controller, lambda: None),
    "buttons below the card": LightPanel,
}


@pytest.fixture(params=KINDS)
def panel(request, qtbot, controller):
    panel = KINDS[request.param](controller)
    qtbot.addWidget(panel)
    panel.resize(440, 700)
    panel.show()
    controller.be(operating_state())
    return panel


def test_no_room_is_kept_for_a_message_where_the_card_scrolls(panel):
    message = panel.findChild(MessageLine)
    assert message.text() == ""
    bar = panel.findChild(QScrollArea).verticalScrollBar()
    kept = []
    for height in range(700, 300, -5):
        panel.resize(440, height)
        QApplication.sendPostedEvents()
        kept.append(not message.isHidden())
        assert not kept[-1] or bar.maximum() == 0
    assert kept == sorted(kept, reverse=True)  # it goes once, and does not come and go
    assert kept[0]
    assert not kept[-1]


def buttons_below(panel):
    area = panel.findChild(QScrollArea)
    return [each for each in panel.findChildren(QPushButton) if not area.isAncestorOf(each)]


def test_no_button_below_the_card_moves_when_something_is_said(panel):
    message = panel.findChild(MessageLine)
    for height in range(700, 330, -5):
        panel._show_outcome(None)
        panel.resize(440, height)
        QApplication.sendPostedEvents()
        before = [each.geometry() for each in buttons_below(panel)]
        panel._show_outcome(Refusal(STOPPED))
        QApplication.sendPostedEvents()
        assert message.isVisible()
        assert [each.geometry() for each in buttons_below(panel)] == before, height
        assert message.geometry().bottom() <= panel.height()
        assert not any(each.intersects(message.geometry()) for each in before)


def test_a_card_that_grows_gets_the_room_that_is_kept_for_a_message(panel):
    message, area = panel.findChild(MessageLine), panel.findChild(QScrollArea)
    QApplication.sendPostedEvents()
    assert not message.isHidden()
    more = QPushButton()
    more.setMinimumHeight(panel.height())
    area.widget().layout().addWidget(more)
    more.show()
    for _ in range(5):
        QApplication.sendPostedEvents()
    assert message.isHidden()
    assert area.verticalScrollBar().maximum() > 0
