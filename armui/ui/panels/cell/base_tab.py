"""The tab of the base: its place in the room, and whether the mounting was sent to the arm."""

from __future__ import annotations

from typing import Final

from PySide6.QtWidgets import QLabel

from armui.cell.cell import placed
from armui.cell.placement import WORLD, Placement
from armui.control.arm_controller import ArmController
from armui.control.cell.cell_control import CellControl
from armui.kinematics.axes import AXES
from armui.protocol.codes import Mounting
from armui.ui import format as fmt
from armui.ui import words
from armui.ui.actions.act import Act
from armui.ui.actions.command import Command
from armui.ui.panels.cell.cell_tab import UNITS, Answered, CellTab, figures, hint_label, pose_grid
from armui.ui.widgets.buttons import named
from armui.ui.widgets.figure_field import FigureField
from armui.ui.widgets.layouts import STRETCH, in_column
from armui.ui.widgets.text_label import text_label
from armui.ui.words.text import Text

_NONE: Final = Placement()


class BaseTab(CellTab):
    """The place of the base in the room in the chosen cell; see :class:`CellTab`."""

    key = "base"
    title = Text("CellPanel", "Base")
    commands = (
        Command("cell.base_X", Text("BaseTab", "Place of the base in the room"), presses=False),
    )
    apply = Act(
        "Apply",
        named="cell_base_apply",
        does=CellControl.change,
        tip="Stands the arm in the room: for the picture, the floor and the frame WORLD.",
        whose=title,
        key="cell.base_apply",
        title=Text("BaseTab", "Apply the place of the base"),
        primary=True,
        leads=True,
    )

    def __init__(self, controller: ArmController, answered: Answered) -> None:
        super().__init__(controller, answered)
        self._why_not = ""
        self._shown: tuple[Placement, ...] = ()
        self._next = hint_label("cell_base_next")
        self._heading = QLabel()
        self._fields = [
            named(f"cell_base_{axis}", FigureField(fmt.DECIMALS, unit))
            for axis, unit in UNITS.items()
        ]
        self._mounting = text_label("cell_base_mounting", rank="warning", wraps=True)
        self._note = text_label(rank="muted", wraps=True)
        grid = pose_grid(self._fields)
        parts = (self._next, self._heading, grid, self.apply, self._mounting, self._note, STRETCH)
        in_column(*parts, on=self, spacing=8, margins=0)
        for field in self._fields:
            field.textEdited.connect(lambda _text: self._show_news())
        self.retranslate_ui()

    @apply.why_not
    def _why_not_apply(self) -> str:
        same = Placement(figures(self._fields)) == self._cell.placement
        return self._why_not or (self.tr("Nothing is changed.") if same else "")

    @apply.pressed
    def _on_apply(self) -> None:
        cell = placed(self._cell, Placement(figures(self._fields)))
        self._answered(self._controller.cell.change(cell))

    def _mounting_of_arm(self) -> Mounting | None:
        """Return the mounting that this program has sent last to this arm, or ``None``."""
        now, identity = self._controller.operating_state, self._controller.state.identity
        if now.device is None or self.preferences is None:
            return None
        key = now.device.arm_key("" if identity is None else identity.node_number)
        name = self.preferences.settings.mountings.get(key)
        return None if name is None else Mounting[name.upper()]

    def show_cell(self, why_not: str) -> None:
        """Show the place of the base; typed figures stay while the stored ones are the same."""
        self._why_not = why_not
        shown = (self._cell.placement,)
        if shown != self._shown:
            self._shown = shown
            for field, value in zip(self._fields, shown[0].pose, strict=True):
                field.show_value(value)
        self._show_news()

    def _show_news(self) -> None:
        """Show what is to be done next, and highlight its button."""
        nonsense = [field.is_nonsense() for field in self._fields]
        for field, wrong in zip(self._fields, nonsense, strict=True):
            field.show_attention(wanted=wrong)
        typed, placement = Placement(figures(self._fields)), self._cell.placement
        changed = typed != placement
        self.show_acts()
        told = (
            words.mounting_check(typed.mounting, self._mounting_of_arm())
            if not any(nonsense)
            else ""
        )
        self._mounting.setText(told if typed.is_set else "")
        if none := self._no_step():
            self._next.setText(none)
        elif changed:
            self._next.setText(self.tr("Press Apply: the floor is then where the room has it."))
        elif placement == _NONE:
            self._next.setText(
                self.tr("All 0: the arm stands upright on the floor. Type where its base stands.")
            )
        else:
            text = self.tr("The arm stands so. The frame “{name}” shows poses in the room.")
            self._next.setText(text.format(name=WORLD))

    def retranslate_ui(self) -> None:
        """Set all texts in the operator's language."""
        self._heading.setText(self.tr("The base in the room (mm, °)"))
        for axis, field in zip(AXES, self._fields, strict=True):
            field.setAccessibleName(f"{self.title.text()} {axis}")
        self._note.setText(
            self.tr(
                "The room's Z points up, its floor is at Z 0. Areas, frames and targets stay given "
                "in the base. A table that the arm stands on belongs in the area: the floor check "
                "asks only for the floor."
            )
        )
        self.show_cell(self._why_not)
