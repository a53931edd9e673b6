"""Below the figures of a pose: an arc by three poses, or the tool centre point, one at a time."""

from __future__ import annotations

from PySide6.QtWidgets import QButtonGroup, QSizePolicy, QStackedWidget, QWidget

from armui.ui.panels.jogging.arc_box import ArcBox
from armui.ui.panels.jogging.tool_box import ToolBox
from armui.ui.widgets.buttons import caption, choice_button
from armui.ui.widgets.layouts import in_column, in_row
from armui.ui.widgets.translated import Translated


class PoseExtras(Translated, QWidget):
    """Two buttons, and what the chosen one stands for: both fit on a low screen so.

    Args:
        arc, tool: What is shown.
    """

    def __init__(self, arc: ArcBox, tool: ToolBox) -> None:
        super().__init__()
        self._group = QButtonGroup(self)
        self._stack = QStackedWidget()
        row = in_row(spacing=6)
        for place, (name, widget) in enumerate((("extra_arc", arc), ("extra_tool", tool))):
            button = choice_button(name)
            button.setSizePolicy(QSizePolicy.Policy.Expanding, QSizePolicy.Policy.Fixed)
            self._group.addButton(button, place)
            self._stack.addWidget(widget)
            row.addWidget(button, 1)
        self._group.button(0).setChecked(True)
        self._group.idClicked.connect(self._stack.setCurrentIndex)
        in_column(row, self._stack, on=self, spacing=6, margins=0)
        self.retranslate_ui()

    def retranslate_ui(self) -> None:
        """Put every word into the operator's language."""
        for place, text in enumerate((self.tr("Arc by three poses"), self.tr("Tool centre point"))):
            caption(self._group.button(place), text)
