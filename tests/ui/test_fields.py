"""What the style sheet makes of fields and cards."""

import pytest
from PySide6.QtWidgets import QComboBox, QFrame, QLabel, QSpinBox

from armui.ui.dialogs.files import FileDialog
from armui.ui.theme import LIGHT, style_sheet
from armui.ui.widgets.halt_button import HaltButton
from armui.ui.widgets.layouts import in_column, scrolled

pytestmark = pytest.mark.styled


def test_a_spin_box_is_as_high_as_a_drop_down(qtbot):
    spin, box = QSpinBox(), QComboBox()
    box.addItem("1")
    for field in (spin, box):
        qtbot.addWidget(field)
        field.setStyleSheet(style_sheet(LIGHT))
        field.ensurePolished()
    assert abs(spin.sizeHint().height() - box.sizeHint().height()) <= 1


def test_a_card_that_scrolls_has_round_corners(qtbot):
    card = QFrame()
    in_column(QLabel("J1"), on=card)
    area = scrolled(card)
    qtbot.addWidget(area)
    area.show()
    assert not card.autoFillBackground()


def test_the_file_chooser_can_halt(qtbot, controller):
    dialog = FileDialog(controller, title="", name_filter="CSV (*.csv)")
    qtbot.addWidget(dialog)
    dialog.show()
    halt = dialog.findChild(HaltButton)
    assert halt.isVisible()
    assert halt.geometry().right() < dialog.stop_button.geometry().left()
