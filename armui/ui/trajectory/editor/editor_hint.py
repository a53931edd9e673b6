"""What stands in the table of a trajectory that has no points yet."""

from __future__ import annotations

from typing import TYPE_CHECKING, Final

from PySide6.QtWidgets import QTableView

from armui.ui.widgets.buttons import push_button
from armui.ui.widgets.table_model import TableHint

if TYPE_CHECKING:
    from armui.ui.trajectory.editor.editor_actions import EditorActions

_NAMES: Final = ("insert_measured", "insert_after")


class EditorHint(TableHint):
    """How the first point is made: from where the arm is, or by figures.

    Args:
        table: Over which.
        actions: Make a point of where the arm is, and one to be filled with figures.
    """

    def __init__(self, table: QTableView, actions: EditorActions) -> None:
        self._actions = actions
        self._buttons = (
            push_button("hint_insert_measured", on_enter=False),
            push_button("hint_insert_after", on_enter=False),
        )
        self._table = table
        super().__init__(table, "editor_hint", *self._buttons)
        for button, name in zip(self._buttons, _NAMES, strict=True):
            button.clicked.connect(lambda _checked=False, name=name: actions[name].trigger())
        table.model().rowsInserted.connect(self._show_if_empty)
        table.model().rowsRemoved.connect(self._show_if_empty)
        table.model().modelReset.connect(self._show_if_empty)
        # the jog buttons have one of their own beside them
        actions["jog"].toggled.connect(self._buttons[0].setHidden)
        self.retranslate_ui()
        self._show_if_empty()

    def _show_if_empty(self) -> None:
        self.setVisible(self._table.model().rowCount() == 0)

    def retranslate_ui(self) -> None:
        """Put every word into the operator's language."""
        texts = (self.tr("Insert current pose"), self.tr("Enter a point"))
        for button, name, text in zip(self._buttons, _NAMES, texts, strict=True):
            keys = self._actions.keys(name)
            button.setText(f"{text}  ({keys.toString(keys.SequenceFormat.NativeText)})")
            button.setAccessibleName(text)
        self.say(
            self.tr("No points yet"),
            self.tr(
                "Bring the arm to the first point, by the jog buttons or by hand, and insert where "
                "it is. Or enter a point as figures. Then the next one."
            ),
        )
