"""The panels 碰撞等级 and 拖动助力: a level for each joint, and one click for all of them."""

from __future__ import annotations

from collections.abc import Callable
from typing import Final

from PySide6.QtCore import QSignalBlocker, Signal
from PySide6.QtWidgets import QButtonGroup, QFrame, QLabel, QSizePolicy, QWidget

from armui.arm.parameters import Batch, Group, Parameter, reading_of
from armui.control.arm_controller import ArmController
from armui.ui import format as fmt
from armui.ui.dialogs.base import ArmDialog, CloseButton
from armui.ui.panels.parameters.parameter_panel import ParameterPanel
from armui.ui.panels.parameters.setting_cell import SettingCell, cell_name
from armui.ui.widgets.buttons import choice_button, named
from armui.ui.widgets.layouts import STRETCH, empty_grid, fill, in_row
from armui.ui.widgets.text_label import text_label

_LABEL_PX: Final = 30
_GAP_PX: Final = 3
_NOTE_PX: Final = 94
"""The width of the note. It is beside the levels: below, it would seem to concern the last row."""
_HEIGHT_PX: Final = 30
_NO_DETECTION: Final = 0
_DIALOG_PX: Final = (600, 520)


class LevelRow(QWidget):
    """Levels side by side, of which one or none is chosen.

    Args:
        levels: The levels from left to right.
        name: The first part of the buttons' names: ``<name>_level_<level>``.

    Signals:
        chosen: The operator chose a level.
    """

    chosen = Signal(int)

    def __init__(self, levels: range, name: str) -> None:
        super().__init__()
        self._group = QButtonGroup(self)
        layout = in_row(on=self, spacing=_GAP_PX, margins=0)
        for level in levels:
            button = choice_button(f"{name}_level_{level}", str(level))
            button.setProperty("narrow", True)
            button.setFixedHeight(_HEIGHT_PX)
            button.setSizePolicy(QSizePolicy.Policy.Ignored, QSizePolicy.Policy.Fixed)
            self._group.addButton(button, level)
            layout.addWidget(button, 1)
        self._group.idClicked.connect(self.chosen)

    @property
    def level(self) -> int | None:
        """The chosen level, or ``None``."""
        level = self._group.checkedId()
        return None if level < 0 else level

    def show_level(self, level: int | None) -> None:
        """Choose a level, or none, without emitting a signal."""
        with QSignalBlocker(self._group):
            self._group.setExclusive(False)
            for button in self._group.buttons():
                button.setChecked(self._group.id(button) == level)
            self._group.setExclusive(True)

    def set_locked(self, *, locked: bool) -> None:
        """Lock or unlock the choice."""
        for button in self._group.buttons():
            button.setEnabled(not locked)

    def first(self) -> QWidget:
        """Return the widget that the Tab key enters."""
        return self._group.checkedButton() or self._group.buttons()[0]

    def describe(self, name: str) -> None:
        """Set the accessible names of the buttons."""
        for button in self._group.buttons():
            button.setAccessibleName(f"{name} {self._group.id(button)}")


class LevelCell(SettingCell):
    """A parameter with few levels; the row is named as the parameter, ``collision_level_3``.

    Attributes:
        levels: The levels from left to right.
    """

    def __init__(self, parameter: Parameter) -> None:
        super().__init__(parameter)
        kind = parameter.kind
        self.levels = range(round(kind.minimum), round(kind.maximum) + 1)
        self._row = named(cell_name(parameter), LevelRow(self.levels, cell_name(parameter)))
        self.note.setFixedWidth(_NOTE_PX)
        self.note.setSizePolicy(QSizePolicy.Policy.Fixed, QSizePolicy.Policy.Fixed)
        in_row((self._row, 1), self.note, on=self, spacing=0, margins=0)
        self._row.chosen.connect(self.edited)

    @property
    def text(self) -> str:
        """The chosen level as text."""
        return "" if self._row.level is None else str(self._row.level)

    @property
    def value(self) -> float | None:
        """The chosen level as a figure."""
        return None if self._row.level is None else float(self._row.level)

    @property
    def focus_widget(self) -> QWidget:
        """The chosen button."""
        return self._row.first()

    def show_value(self, value: float | None) -> None:
        """Choose the arm's value; a level without a button chooses none."""
        self._row.show_level(None if value is None else round(value))

    def choose(self, level: int) -> None:
        """Choose a level as if its button had been pressed."""
        self._row.show_level(level)
        self.edited.emit()

    def set_locked(self, *, locked: bool) -> None:
        """Lock or unlock the choice."""
        self._row.set_locked(locked=locked)

    def describe(self, name: str, tip: str) -> None:
        """Set the names of the levels, and the full state as tooltip."""
        self._row.describe(name)
        self.setToolTip(tip)


class LevelsPanel(ParameterPanel):
    """The levels of a group of parameters, joint 1 at the top.

    Args:
        controller: Reads and saves them.
        group: The group; the widgets below are named ``<group>_all`` and ``<group>_note``.
        open_backup: Opens the window in which parameters are backed up.
    """

    def __init__(
        self, controller: ArmController, group: Group, open_backup: Callable[[], object]
    ) -> None:
        self._levels = [LevelCell(each) for each in Batch(group).parameters()]
        super().__init__(controller, group.value, self._levels, open_backup)
        self._all_label = QLabel()
        self._all = LevelRow(self._levels[0].levels, f"{group.value}_all")
        self._all.chosen.connect(self._on_all_chosen)
        self._note = text_label(f"{group.value}_note", rank="muted", wraps=True)
        card = QFrame()
        grid = empty_grid(card, gaps=(10, 4), margins=(12, 12, 12, 10))
        for row, cell in enumerate(self._levels):
            label = QLabel(f"J{cell.parameter.joint}")
            label.setMinimumHeight(_LABEL_PX)
            grid.addWidget(label, row, 0)
            grid.addWidget(cell, row, 1)
        last = len(self._levels)
        grid.addWidget(self._all_label, last, 0)
        grid.addLayout(in_row((self._all, 1), _NOTE_PX), last, 1)
        grid.addWidget(self._note, last + 1, 0, 1, 2)
        grid.setColumnStretch(1, 1)
        grid.setRowStretch(last + 2, 1)
        self.finish(card)

    def note(self) -> str:
        """Return the meaning of the levels, in the operator's language."""
        raise NotImplementedError

    def _on_all_chosen(self, level: int) -> None:
        self._all.show_level(None)
        for cell in self._levels:
            cell.choose(level)

    def _show_possible(self) -> None:
        super()._show_possible()
        self._all.set_locked(locked=not self._draft.editing or self._saving.running)

    def retranslate_ui(self) -> None:
        """Set all texts in the operator's language."""
        self._all_label.setText(self.tr("All"))
        self._all.describe(self.tr("All joints: level"))
        self._note.setText(self.note())
        super().retranslate_ui()


class CollisionPanel(LevelsPanel):
    """The collision levels; warns of joints without detection."""

    buttons = ParameterPanel.buttons_of("collision")

    def __init__(self, controller: ArmController, open_backup: Callable[[], object]) -> None:
        super().__init__(controller, Group.COLLISION, open_backup)

    def title(self) -> str:
        """Return 碰撞等级 in the operator's language."""
        return self.tr("Collision level")

    def note(self) -> str:
        """Return which levels detect collisions, and that the most sensitive is not known."""
        return self.tr(
            "Levels 1 to 8 watch for collisions; level 0 does not watch at all. The maker has not "
            "published whether 1 or 8 is the more sensitive one."
        )

    def danger(self) -> str:
        """Return the joints that do not detect collisions, or would not."""
        blind = [cell.parameter.joint for cell in self._levels if cell.value == _NO_DETECTION]
        if not blind:
            return ""
        return self.tr(
            "Level 0 – no collision detection: {joints} will not stop after hitting something or "
            "someone."
        ).format(joints=fmt.joints(blind))

    def danger_of_saving(self) -> str:
        """Return the joints whose detection would be switched off."""
        state = self._controller.state
        blind = [
            parameter.joint
            for parameter, level in self._draft.changes().items()
            if level == _NO_DETECTION
            and ((known := reading_of(state, parameter)) is None or known.value != _NO_DETECTION)
        ]
        if not blind:
            return ""
        return self.tr(
            "This switches the collision detection of {joints} off: the arm will not stop "
            "after hitting something or someone. Keep everyone out of its reach."
        ).format(joints=fmt.joints(blind))

    def remark(self, cell: SettingCell) -> str:
        """Return the remark beside a joint without detection."""
        return self.tr("no detection") if cell.value == _NO_DETECTION else ""


class DragAssistancePanel(LevelsPanel):
    """The levels of assistance, from none to the most."""

    buttons = ParameterPanel.buttons_of("drag_assistance")

    def __init__(self, controller: ArmController, open_backup: Callable[[], object]) -> None:
        super().__init__(controller, Group.DRAG_ASSISTANCE, open_backup)

    def title(self) -> str:
        """Return 拖动助力 in the operator's language."""
        return self.tr("Drag assistance")

    def stand_in_dialog(self) -> None:
        """Remove title and margins, which the dialog has."""
        layout = self.layout()
        if layout is not None:
            layout.setContentsMargins(0, 0, 0, 0)
        self._title.hide()

    def note(self) -> str:
        """Return the effect of the levels."""
        return self.tr(
            "0: the joint does not help the hand; 10: it helps most. Read and set with the arm "
            "at rest; keep a hand on it when you lead it for the first time afterwards."
        )


class DragAssistanceDialog(ArmDialog):
    """The panel in a window; unsaved entries are kept until it is opened again.

    Args:
        controller: The controller of the arm.
        open_backup: Opens 参数备份.
        parent: The window it belongs to.
    """

    def __init__(
        self,
        controller: ArmController,
        open_backup: Callable[[], object],
        parent: QWidget | None = None,
    ) -> None:
        super().__init__(controller, parent)
        self.setObjectName("drag_assistance_dialog")
        self.panel = DragAssistancePanel(controller, open_backup)
        self.panel.stand_in_dialog()
        self.body.addWidget(self.panel)
        read, *acts, backup = self.panel.buttons.values()
        fill(self.footer, read, backup, STRETCH, *acts, CloseButton(self))
        self.resize(*_DIALOG_PX)
        self.retranslate_ui()

    def retranslate_ui(self) -> None:
        """Set all texts in the operator's language."""
        self.set_title(self.panel.title())
