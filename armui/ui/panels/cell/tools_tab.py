"""The tab of the tools: added, named, typed, chosen and deleted."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import replace
from itertools import count
from typing import Final

from PySide6.QtWidgets import QButtonGroup, QComboBox, QLabel, QLineEdit, QWidget

from armui.arm.state import ArmState
from armui.cell.cell import Cell, with_tool, without_tool
from armui.cell.checks import LONGEST_NAME
from armui.cell.tools import NO_TOOL, Tool
from armui.control.arm_controller import ArmController
from armui.control.cell.cell_control import CellControl
from armui.control.operations.operation import operation_of
from armui.kinematics.axes import AXES
from armui.ui import format as fmt
from armui.ui.actions.command import Command, Target
from armui.ui.panels.cell.cell_tab import Answered, CellTab, CurrentStack, figures, pose_grid
from armui.ui.panels.cell.tip_by_points import TipByPoints
from armui.ui.widgets.buttons import (
    caption,
    choice_button,
    enable_or_explain,
    named,
    push_button,
    show_primary,
)
from armui.ui.widgets.figure_field import FigureField
from armui.ui.widgets.layouts import STRETCH, empty_grid, in_column, in_row
from armui.ui.widgets.text_label import text_label
from armui.ui.words.text import Text

_CHANGE: Final = operation_of(CellControl.change)
_NARROW_PX: Final = 60


class ToolsTab(CellTab):
    """The tools of the chosen cell; see :class:`CellTab`."""

    key = "tools"
    title = Text("CellPanel", "Tools")
    commands = (
        Command("cell.tool", Text("ToolsTab", "Tool on the flange")),
        Command("cell.tool_by_points", Text("ToolsTab", "Find the tip by points")),
        Command(
            "cell.tool_apply",
            Text("ToolsTab", "Apply the figures of the tool"),
            _CHANGE,
            leads=True,
        ),
        Command("cell.tool_add", Text("ToolsTab", "Add as a new tool"), _CHANGE, leads=True),
        Command(
            "cell.tool_delete", Text("ToolsTab", "Delete the tool"), _CHANGE, leads=True, risky=True
        ),
    )

    def __init__(self, controller: ArmController, answered: Answered) -> None:
        super().__init__(controller, answered)
        self._shown: Tool | None = None
        self._next = text_label("cell_tool_next", wraps=True)
        self._choice_label = QLabel()
        self._choice = named("cell_tool_box", QComboBox())
        self._choice_label.setBuddy(self._choice)
        self._name_label = QLabel()
        self._name = named("cell_tool_name", QLineEdit())
        self._name.setMaxLength(LONGEST_NAME)
        self._name_label.setBuddy(self._name)
        self._fields = [named(f"cell_tool_{axis}", FigureField(fmt.DECIMALS)) for axis in AXES]
        self._radius_label = QLabel()
        self._radius = named("cell_tool_radius", FigureField(1, "mm"))
        self._radius_label.setBuddy(self._radius)
        self._capsule = text_label("cell_tool_capsule", rank="muted", wraps=True)
        self._apply = push_button("cell_tool_apply")
        self._add = push_button("cell_tool_add")
        self._delete = push_button("cell_tool_delete")
        self._by_points = TipByPoints(controller, answered)
        self._by_points.applied.connect(self._on_tip_applied)
        self._ways = CurrentStack()
        self._way = QButtonGroup(self)
        for place, name in enumerate(("cell_tool_typed", "cell_tool_by_points")):
            self._way.addButton(choice_button(name), place)
        self._way.button(0).setChecked(True)
        self._way.idClicked.connect(self._on_way_chosen)
        self._lay_out()
        self._choice.activated.connect(self._on_chosen)
        for field in (self._name, self._radius, *self._fields):
            field.textEdited.connect(lambda _text: self._show_news())
        self._apply.clicked.connect(self._on_apply)
        self._add.clicked.connect(self._on_add)
        self._delete.clicked.connect(self._on_delete)
        self.retranslate_ui()

    def _lay_out(self) -> None:
        grid = empty_grid(gaps=(8, 6), margins=0)
        grid.addWidget(self._choice_label, 0, 0)
        grid.addWidget(self._choice, 0, 1)
        grid.addWidget(self._name_label, 1, 0)
        grid.addWidget(self._name, 1, 1)
        grid.addWidget(self._radius_label, 2, 0)
        grid.addWidget(self._radius, 2, 1)
        grid.setColumnStretch(1, 1)
        for button in (self._apply, self._add, self._delete):
            button.setMinimumWidth(_NARROW_PX)
        self._choice.setMinimumWidth(_NARROW_PX)
        buttons = in_row((self._apply, 1), (self._add, 1), (self._delete, 1), spacing=6)
        typed = QWidget()
        parts = (self._next, grid, pose_grid(self._fields), self._capsule, buttons, STRETCH)
        in_column(*parts, on=typed, spacing=8, margins=0)
        self._ways.addWidget(typed)
        self._ways.addWidget(self._by_points)
        ways = in_row(*((button, 1) for button in self._way.buttons()), spacing=6)
        in_column(ways, self._ways, on=self, spacing=8, margins=0)

    def command_targets(self) -> Mapping[str, Target]:
        """Return the target of each command, by the command's name."""
        return {
            "cell.tool": self._choice,
            "cell.tool_apply": self._apply,
            "cell.tool_add": self._add,
            "cell.tool_delete": self._delete,
            "cell.tool_by_points": self._way.button(1),
        }

    # -- actions ------------------------------------------------------------------------------

    @property
    def _cell(self) -> Cell:
        return self._controller.cell.cell or Cell("")

    def _change(self, cell: Cell) -> None:
        if not self._answered(self._controller.cell.change(cell)):
            self._show_tool(force=False)

    def _on_chosen(self, place: int) -> None:
        self._change(replace(self._cell, tool=self._choice.itemData(place) or ""))

    def _on_apply(self) -> None:
        if self._shown is not None:
            self._change(with_tool(self._cell, self.typed(), instead_of=self._shown.name))

    def _on_add(self) -> None:
        self._change(with_tool(self._cell, self.typed()))

    def _on_delete(self) -> None:
        if self._shown is not None:
            self._change(without_tool(self._cell, self._shown.name))

    def _on_way_chosen(self, place: int) -> None:
        self._ways.setCurrentIndex(place)
        self._by_points.show_live()

    def _on_tip_applied(self, pose: tuple[float, ...]) -> None:
        """Put the tip in the chosen tool; without one it becomes a new tool."""
        rounded = tuple(round(each, fmt.DECIMALS) for each in pose)
        chosen = self._cell.chosen_tool
        if chosen is None:
            names = {tool.name.casefold() for tool in self._cell.tools}
            numbered = (self.tr("Tool {number}").format(number=number) for number in count(1))
            name = next(each for each in numbered if each.casefold() not in names)
            self._change(with_tool(self._cell, Tool(name, rounded)))
        else:
            tool = replace(chosen, pose=rounded)
            self._change(with_tool(self._cell, tool, instead_of=chosen.name))

    def show_state(self, _state: ArmState) -> None:
        """Show how far the arm has turned since the last pose of the search."""
        if self._by_points.isVisible():
            self._by_points.show_live()

    def typed(self) -> Tool:
        """Return the tool as typed; an empty field counts as 0, a text as itself."""
        pose, radius = figures(self._fields), figures([self._radius])
        return Tool(self._name.text().strip(), pose, *radius)

    # -- appearance ---------------------------------------------------------------------------

    def show_cell(self, why_not: str) -> None:
        """Show the tools of the chosen cell."""
        cell = self._controller.cell.cell
        self._choice.clear()
        self._choice.addItem(self.tr("— (bare flange)"), "")
        for tool in self._cell.tools:
            self._choice.addItem(tool.name, tool.name)
        self._choice.setCurrentIndex(max(0, self._choice.findData(self._cell.tool)))
        self._show_tool(force=self._shown != self._cell.chosen_tool)
        use = self.tr("Puts these figures in the place of those of the chosen tool.")
        none = self.tr("No tool is chosen. Add one, or choose one above.")
        no_tool = none if self._shown is None else ""
        enable_or_explain(self._apply, why_not or no_tool, use)
        enable_or_explain(self._add, why_not, self.tr("Adds a tool of this name and chooses it."))
        use = self.tr("Deletes the chosen tool; the bare flange is chosen then.")
        enable_or_explain(self._delete, why_not or no_tool, use)
        self._choice.setEnabled(cell is not None and not why_not)
        chosen = self._cell.chosen_tool
        self._by_points.show_tool(NO_TOOL if chosen is None else chosen.pose, why_not)
        self._show_news()

    def _show_tool(self, *, force: bool) -> None:
        """Fill the fields with the chosen tool; what is typed stays while it is the same one."""
        self._choice.setCurrentIndex(max(0, self._choice.findData(self._cell.tool)))
        if not force:
            return
        tool = self._shown = self._cell.chosen_tool
        self._name.setText("" if tool is None else tool.name)
        for field, value in zip(self._fields, NO_TOOL if tool is None else tool.pose, strict=True):
            field.show_value(None if tool is None else value)
        self._radius.show_value(None if tool is None else tool.radius_mm)

    def _show_news(self) -> None:
        """Say what is to be done next, and light its button."""
        typed, shown = self.typed(), self._shown
        known = self._cell.tool_named(typed.name)
        for field in (*self._fields, self._radius):
            field.show_attention(wanted=field.is_nonsense())
        new = bool(typed.name) and known is None
        show_primary(self._add, wanted=self._add.isEnabled() and new)
        changed = shown is not None and typed != shown
        show_primary(self._apply, wanted=self._apply.isEnabled() and changed and not new)
        length = 0.0 if any(field.is_nonsense() for field in self._fields) else typed.length_mm
        text = self.tr("Checks see a capsule from the flange to the tip, {length} mm long.")
        self._capsule.setText(text.format(length=fmt.number(length, 1)))
        self._next.setText(self._next_step(new=new, changed=changed))

    def _next_step(self, *, new: bool, changed: bool) -> str:
        if self._controller.cell.cell is None:
            return self.tr("There is no cell yet: type its name above and press New.")
        if self._shown is None and not new:
            return self.tr("Type a name for the tool and what is known of it, then press Add.")
        if new and self._shown is None:
            return self.tr("Press Add: the tool is chosen, and its tip is what moves from then on.")
        if new:
            return self.tr("Press Add for a further tool, or Apply to rename the chosen one.")
        if changed:
            return self.tr("Press Apply to put the new figures in force.")
        return self.tr("This tool is in force. Choose another one, or change its figures.")

    def retranslate_ui(self) -> None:
        """Set all texts in the operator's language."""
        self._choice_label.setText(self.tr("Tool on the flange"))
        self._choice.setAccessibleName(self.tr("Tool on the flange"))
        self._name_label.setText(self.tr("Tool's name"))
        self._name.setAccessibleName(self.tr("Tool's name"))
        for axis, field in zip(AXES, self._fields, strict=True):
            field.setAccessibleName(self.tr("Tool {axis}").format(axis=axis))
        self._radius_label.setText(self.tr("Radius"))
        self._radius.setAccessibleName(self.tr("Radius of the tool's capsule"))
        ways = (self.tr("Type it"), self.tr("Find the tip by points"))
        for button, text in zip(self._way.buttons(), ways, strict=True):
            caption(button, text)
        caption(self._apply, self.tr("Apply"))
        caption(self._add, self.tr("Add"))
        caption(self._delete, self.tr("Delete"), whose=self.tr("Tool"))
        self.show_cell("")
