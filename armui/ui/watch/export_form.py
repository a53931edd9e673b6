"""What is to be exported, how and where to, as the operator enters it."""

from __future__ import annotations

import math
from collections.abc import Sequence
from pathlib import Path
from typing import TYPE_CHECKING, Final

from PySide6.QtCore import QT_TRANSLATE_NOOP, Signal
from PySide6.QtWidgets import (
    QButtonGroup,
    QComboBox,
    QLabel,
    QLineEdit,
    QPushButton,
    QSizePolicy,
    QToolButton,
    QWidget,
)

from armui.arm.models import all_models
from armui.protocol.generation import Generation
from armui.session.exports.request import (
    ArmWishes,
    ExportFormat,
    ExportRequest,
    default_target,
)
from armui.ui.dialogs.files import choose_file, choose_folder
from armui.ui.watch import export_text
from armui.ui.widgets.buttons import named
from armui.ui.widgets.elided_label import ElidedLabel
from armui.ui.widgets.figure_field import FigureField
from armui.ui.widgets.layouts import empty_grid, in_row
from armui.ui.widgets.text_label import text_label
from armui.ui.widgets.translated import Translated

if TYPE_CHECKING:
    from armui.control.arm_controller import ArmController

_FIELD_PX: Final = 130
_FORMATS: Final = {
    ExportFormat.MCAP: "MCAP",
    ExportFormat.CSV: "CSV",
    ExportFormat.PARQUET: "Parquet",
    ExportFormat.CSV_MESSAGES: QT_TRANSLATE_NOOP("ExportForm", "CSV per message"),
}
_LOGS: Final = "*.blf *.log *.asc *.trc *.csv *.db *.mf4 *.txt *.gz"
_GENERATIONS: Final = (None, Generation.ONE, Generation.TWO)
_BELOW_FORMATS: Final = 2
"""The row in which stands what the chosen format is."""


class ExportForm(Translated, QWidget):
    """The fields.

    Args:
        controller: For the emergency stop in the file choosers.

    Signals:
        changed: Something was entered or chosen.
    """

    changed = Signal()

    def __init__(self, controller: ArmController) -> None:
        super().__init__()
        self._controller = controller
        self._log: Path | None = None
        self._target: Path | None = None
        self._target_chosen = False
        self._build()
        self.log_button.clicked.connect(self._on_choose_log)
        self.target_button.clicked.connect(self._on_choose_target)
        self.formats.idClicked.connect(self._on_format)
        self.begin_field.value_edited.connect(self.changed)
        self.end_field.value_edited.connect(self.changed)
        self.retranslate_ui()

    def _build(self) -> None:
        self._labels = [QLabel() for _row in range(7)]
        self._log_label, self._target_label = ElidedLabel(), ElidedLabel()
        self._log_label.setObjectName("export_log")
        self._target_label.setObjectName("export_target")
        self.log_button, self.target_button = QPushButton(), QPushButton()
        self.formats, formats = _choice([f"format_{each}" for each in ExportFormat])
        self.generations, generations = _choice(["generation_auto", "generation_1", "generation_2"])
        self.model_box = QComboBox()
        self.model_box.addItem("", None)
        for model, data in all_models().items():
            self.model_box.addItem(data.name, model)
        self._about = text_label("export_about", rank="muted", wraps=True, plain=True)
        self.begin_field, self.end_field = FigureField(3, "s"), FigureField(3, "s")
        self._until = QLabel()
        stretch = QWidget()
        times = in_row(on=stretch, margins=0)
        for widget in (self.begin_field, self._until, self.end_field):
            times.addWidget(widget)
        for field in (self.begin_field, self.end_field):
            field.setFixedWidth(_FIELD_PX)
        self._counted_from = text_label(rank="muted")
        times.addWidget(self._counted_from)
        times.addStretch(1)
        self.channel_field = QLineEdit()
        self.channel_field.setFixedHeight(32)
        grid = empty_grid(self, gaps=(14, 10), margins=0)
        grid.setColumnStretch(1, 1)
        rows = (
            *(self._log_label, formats, stretch, generations),
            *(self.model_box, self.channel_field, self._target_label),
        )
        for row, (label, content) in enumerate(zip(self._labels, rows, strict=True)):
            place = row if row < _BELOW_FORMATS else row + 1
            grid.addWidget(label, place, 0)
            # the buttons stand beside the two files; all else has the whole width
            width = 1 if content in {self._log_label, self._target_label} else 2
            grid.addWidget(content, place, 1, 1, width)
        grid.addWidget(self.log_button, 0, 2)
        grid.addWidget(self._about, _BELOW_FORMATS, 1, 1, 2)
        grid.addWidget(self.target_button, len(rows), 2)
        for button in (self.log_button, self.target_button):
            button.setAutoDefault(False)

    def retranslate_ui(self) -> None:
        """Put every word into the operator's language."""
        texts = (
            self.tr("Recording"),
            self.tr("Format"),
            self.tr("Time"),
            self.tr("Protocol"),
            self.tr("Model"),
            self.tr("Channel"),
            self.tr("Target"),
        )
        for label, text in zip(self._labels, texts, strict=True):
            label.setText(text)
        for button in (self.log_button, self.target_button):
            button.setText(self.tr("Choose…"))
        self.log_button.setAccessibleName(self.tr("Choose the recording"))
        self.target_button.setAccessibleName(self.tr("Choose the target"))
        for place, each in enumerate(ExportFormat):
            self.formats.button(place).setText(self.tr(str(_FORMATS[each])))
        names = (self.tr("As the log tells"), self.tr("Generation 1"), self.tr("Generation 2"))
        for place, name in enumerate(names):
            self.generations.button(place).setText(name)
        self.model_box.setItemText(0, self.tr("As the recording tells"))
        self.model_box.setAccessibleName(self.tr("Model"))
        self.model_box.setToolTip(
            self.tr(
                "Where the links and the tool are depends on it. A recording of this program says "
                "it; of other logs it is the one that fits the end pose in them."
            )
        )
        self._until.setText(self.tr("to"))
        self._counted_from.setText(self.tr("counted from the first frame"))
        self.begin_field.setPlaceholderText(self.tr("beginning"))
        self.end_field.setPlaceholderText(self.tr("end"))
        self.begin_field.setAccessibleName(self.tr("From, in seconds from the first frame"))
        self.end_field.setAccessibleName(self.tr("Up to, in seconds from the first frame"))
        self.channel_field.setPlaceholderText(self.tr("the one on which an arm is heard"))
        self.channel_field.setAccessibleName(self.tr("Channel"))
        self._show_paths()

    # What is entered --------------------------------------------------------------------------

    @property
    def format(self) -> ExportFormat:
        """The chosen one."""
        return tuple(ExportFormat)[self.formats.checkedId()]

    def show_log(self, path: Path) -> None:
        """Take a log; the target is proposed beside it."""
        self._log = path
        self._target_chosen = False
        self._propose_target()

    def show_target(self, path: Path) -> None:
        """Write there."""
        self._target, self._target_chosen = path, True
        self._show_paths()
        self.changed.emit()

    def reason(self) -> str:
        """Why nothing can be exported with this; empty: it can."""
        if self._log is None:
            return self.tr("Choose the recording first.")
        begin_s, end_s = self.begin_field.value or 0.0, self.end_field.value
        wrong = self.begin_field.is_nonsense() or self.end_field.is_nonsense()
        if wrong or begin_s < 0 or (end_s is not None and end_s <= begin_s):
            return self.tr("The time must begin at 0 s or later, and end after that.")
        return ""

    def has_log(self) -> bool:
        """Whether a recording is chosen."""
        return self._log is not None

    def request(self) -> ExportRequest | None:
        """What to export; ``None`` while something is missing or wrong."""
        if self._log is None or self._target is None or self.reason():
            return None
        end_s = self.end_field.value
        wishes = ArmWishes(
            _GENERATIONS[self.generations.checkedId()],
            channel=self.channel_field.text().strip() or None,
            model=self.model_box.currentData(),
        )
        begin_s = self.begin_field.value or 0.0
        end_s = math.inf if end_s is None else end_s
        return ExportRequest(self._log, self._target, self.format, begin_s, end_s, wishes)

    # What the operator does -------------------------------------------------------------------

    def _on_choose_log(self) -> None:
        choose_file(
            self,
            self._controller,
            title=self.tr("Choose the recording"),
            name_filter=self.tr("CAN log") + f" ({_LOGS})",
            start=self._log or Path.home(),
            on_chosen=self.show_log,
        )

    def _on_choose_target(self) -> None:
        proposed = self._target or self.format.named(Path.home() / "recording")
        if self.format.is_folder:
            choose_folder(
                self._controller,
                self.window(),
                title=self.tr("Choose where the folder of the export shall be"),
                start=proposed.parent,
                on_chosen=lambda folder: self.show_target(folder / proposed.name),
            )
            return
        choose_file(
            self,
            self._controller,
            title=self.tr("Choose the target"),
            name_filter=f"{_FORMATS[self.format]} (*.{self.format})",
            start=proposed,
            new_file=proposed.name,
            on_chosen=self.show_target,
        )

    def _on_format(self) -> None:
        if self._target is not None and self._target_chosen:
            self._target = self.format.named(self._target)
            self._show_paths()
            self.changed.emit()
        else:
            self._propose_target()

    def _propose_target(self) -> None:
        if self._log is not None:
            self._target = default_target(self._log, self.format)
        self._show_paths()
        self.changed.emit()

    def _show_paths(self) -> None:
        self._log_label.show_text(str(self._log or self.tr("none chosen")))
        self._target_label.show_text(str(self._target or self.tr("beside the recording")))
        self._about.setText(export_text.about(self.format))


def _choice(names: Sequence[str]) -> tuple[QButtonGroup, QWidget]:
    """Buttons of which one is chosen, the first one at first."""
    group = QButtonGroup()
    row = QWidget()
    layout = in_row(on=row, spacing=6, margins=0)
    for place, name in enumerate(names):
        button = named(name, QToolButton())
        button.setCheckable(True)
        button.setProperty("choice", True)
        button.setSizePolicy(QSizePolicy.Policy.Expanding, QSizePolicy.Policy.Fixed)
        group.addButton(button, place)
        layout.addWidget(button, 1)
    group.button(0).setChecked(True)
    return group, row
