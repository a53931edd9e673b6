"""Jogging within the editor: the jog box, and the button that makes a point of where the arm is."""

from __future__ import annotations

from typing import TYPE_CHECKING

from PySide6.QtCore import Signal
from PySide6.QtWidgets import QWidget

from armui.ui.widgets.buttons import push_button
from armui.ui.widgets.layouts import in_column
from armui.ui.widgets.translated import Translated

if TYPE_CHECKING:
    from armui.control.arm_controller import ArmController
    from armui.ui.panels.jogging.jog_box import JogBox


class EditorJog(Translated, QWidget):
    """Folded away at first, and made when it is first wanted.

    Args:
        controller: Whom the box asks for motion.
        keys: What the button's key is called.

    Signals:
        refused: A :class:`Refusal`, or ``None`` when something was done.
        insert_wanted: The button was pressed.
    """

    refused = Signal(object)
    insert_wanted = Signal()

    def __init__(self, controller: ArmController, keys: str) -> None:
        super().__init__()
        self._controller = controller
        self._keys = keys
        self._box: JogBox | None = None
        self._insert = push_button("box_insert", primary=True, on_enter=False)
        self._insert.clicked.connect(lambda _checked=False: self.insert_wanted.emit())
        self._column = in_column(on=self, margins=0)
        self.hide()
        self.retranslate_ui()

    def unfold(self, wanted: bool) -> None:
        """Show the box, or put it away; what is put away moves nothing."""
        if wanted and self._box is None:
            from armui.ui.panels.jogging.jog_box import JogBox  # noqa: PLC0415 - scipy, with the first

            self._box = JogBox(self._controller, self._insert)
            self._box.refused.connect(self.refused)
            self._column.addWidget(self._box)
        self.setVisible(wanted)

    def retranslate_ui(self) -> None:
        """Put every word into the operator's language."""
        text = self.tr("Insert current pose")
        self._insert.setText(f"{text}  ({self._keys})")
        self._insert.setAccessibleName(text)
        tip = self.tr("Makes a point of where the arm is now, after the chosen row.")
        self._insert.setToolTip(tip)
