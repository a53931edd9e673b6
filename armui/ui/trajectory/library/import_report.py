"""What became of each file of an import, for when a message has no room for it."""

from __future__ import annotations

from collections.abc import Sequence
from typing import Final, NamedTuple

from PySide6.QtCore import QSize, Qt
from PySide6.QtWidgets import QHeaderView, QPushButton, QTableWidgetItem, QWidget

from armui.control.arm_controller import ArmController
from armui.ui.dialogs.base import ArmDialog, CloseButton
from armui.ui.widgets.layouts import STRETCH, fill
from armui.ui.widgets.table_model import plain_table
from armui.ui.widgets.text_label import text_label
from armui.ui.widgets.translated import Translated

_SIZE: Final = QSize(860, 520)
_FILE_PX: Final = 260


class Result(NamedTuple):
    """What became of a file.

    Attributes:
        file: Its name.
        name: Under which its content is in the library now; "" if it is not.
        requested: The name its content brought along; another one than `name` if that was taken.
        problem: Why it is not in the library; "" if it is.
    """

    file: str
    name: str = ""
    requested: str = ""
    problem: str = ""


class ImportReport(ArmDialog):
    """A line for each file, those that were not imported first.

    Args:
        controller: Whom the emergency stop tells.
        results: Of all files, as they were imported.
        parent: The window it belongs to.
    """

    def __init__(
        self, controller: ArmController, results: Sequence[Result], parent: QWidget | None = None
    ) -> None:
        super().__init__(controller, parent)
        self._results = sorted(results, key=lambda result: not result.problem)
        self._summary = text_label("report_summary")
        self._table = plain_table("report_table", 2, wide=1)
        self._table.setRowCount(len(results))
        self._table.verticalHeader().setSectionResizeMode(QHeaderView.ResizeMode.ResizeToContents)
        self._table.setColumnWidth(0, _FILE_PX)
        fill(self.body, self._summary, (self._table, 1))
        fill(self.footer, STRETCH, CloseButton(self, on_enter=True))
        self.retranslate_ui()
        self.resize(_SIZE)

    def retranslate_ui(self) -> None:
        """Put every word into the operator's language."""
        self.set_title(self.tr("What became of the files"))
        taken = sum(not result.problem for result in self._results)
        text = self.tr("{taken} imported, {left} not imported.")
        self._summary.setText(text.format(taken=taken, left=len(self._results) - taken))
        self._table.setHorizontalHeaderLabels([self.tr("File"), self.tr("Result")])
        self._table.setAccessibleName(self.tr("What became of the files"))
        for row, result in enumerate(self._results):
            for column, cell in enumerate((result.file, self._tell(result))):
                item = QTableWidgetItem(cell)
                item.setToolTip(cell)
                self._table.setItem(row, column, item)

    def _tell(self, result: Result) -> str:
        """A sign and a sentence."""
        if result.problem:
            return f"✕ {result.problem}"
        if result.name != result.requested:
            text = self.tr("✓ As “{name}”: the name “{requested}” was taken")
            return text.format(name=result.name, requested=result.requested)
        return self.tr("✓ As “{name}”").format(name=result.name)


class ReportButton(Translated, QPushButton):
    """Opens the report of the last import; there while its message is.

    Args:
        controller: Whom the emergency stop in the report tells.
        window: The report belongs to it.
    """

    def __init__(self, controller: ArmController, window: QWidget) -> None:
        super().__init__(window)
        self._controller = controller
        self._results: Sequence[Result] = ()
        self.setObjectName("library_report")
        self.setAutoDefault(False)
        self.clicked.connect(lambda _checked=False: self._open())
        self.hide()
        self.retranslate_ui()

    def show_for(self, results: Sequence[Result]) -> None:
        """Offer the report of these, or none."""
        self._results = results
        self.setVisible(bool(results))

    def _open(self) -> None:
        report = ImportReport(self._controller, self._results, self.window())
        report.setAttribute(Qt.WidgetAttribute.WA_DeleteOnClose)
        report.open()

    def retranslate_ui(self) -> None:
        """Put every word into the operator's language."""
        self.setText(self.tr("Results…"))
