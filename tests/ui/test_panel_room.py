"""The room of a panel: what scrolls, and what is kept for a message."""

from PySide6.QtWidgets import QApplication, QScrollArea

from armui.ui.panels.teaching_panel import TeachingPanel
from armui.ui.widgets.message_line import MessageLine
from tests.ui.arm_states import operating_state


def test_no_room_is_kept_for_a_message_below_a_card_that_scrolls(qtbot, controller):
    panel = TeachingPanel(controller, lambda: None)
    qtbot.addWidget(panel)
    panel.resize(440, 700)
    panel.show()
    controller.be(operating_state())
    message = panel.findChild(MessageLine, "teaching_message")
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
