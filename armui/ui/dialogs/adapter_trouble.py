"""In 连接机械臂: why an adapter cannot be used yet, and the command that mends it, to be copied."""

from __future__ import annotations

from collections.abc import Callable, Sequence
from typing import Final

from PySide6.QtCore import Signal
from PySide6.QtWidgets import QWidget

from armui.arm.refusal import Refusal
from armui.doctor.facts import Diagnosis
from armui.doctor.report import Words, adapter_trouble
from armui.ui.background import Background, Job
from armui.ui.dialogs.finding_row import FindingRow
from armui.ui.widgets.layouts import in_column
from armui.ui.widgets.translated import Translated

_MOST: Final = 1
"""The gravest alone: 诊断 tells all of them."""


class AdapterTrouble(Translated, QWidget):
    """There while something is wrong with an adapter.

    Args:
        background: Where it is looked for.
        look: Finds it out.

    Signals:
        told: Other findings are shown, or the same in other words: it needs other room.
    """

    told = Signal()

    def __init__(
        self, background: Background, look: Callable[[], list[Diagnosis]] = adapter_trouble
    ) -> None:
        super().__init__()
        self.setObjectName("adapter_trouble")
        self._background = background
        self._look = look
        self._findings: Sequence[Diagnosis] = ()
        self._rows: list[FindingRow] = []
        self._column = in_column(on=self, spacing=6, margins=(12, 0, 0, 0))
        self.hide()

    def examine(self) -> None:
        """Look anew."""
        self._background.begin_here(Job(self._take), self._look)

    def _take(self, findings: list[Diagnosis] | Refusal) -> None:
        self._findings = () if isinstance(findings, Refusal) else findings[:_MOST]
        self.retranslate_ui()

    def retranslate_ui(self) -> None:
        """Say it in the operator's language."""
        # Translators: the code of the language that is shown, "zh" for Chinese
        words = Words("zh" if self.tr("en") == "zh" else "en")
        for row in self._rows:
            self._column.removeWidget(row)
            row.deleteLater()
        self._rows = [
            FindingRow(each, words.text(each), words.mark(each.severity)) for each in self._findings
        ]
        for row in self._rows:
            self._column.addWidget(row)
        self.setVisible(bool(self._rows))
        self.told.emit()
