"""The tab of the tools: added, named, typed, chosen and deleted."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import replace
from typing import Any, Final

from PySide6.QtWidgets import QLabel

from armui.cell.cell import Cell, with_tool, without_tool
from armui.cell.tools import NO_TOOL, Tool
from armui.control.arm_controller import ArmController
from armui.control.cell.cell_control import CellControl
from armui.control.operations.operation import operation_of
from armui.ui import format as fmt
from armui.ui.actions.command import Command
from armui.ui.panels.cell.cell_tab import Answered, figures
from armui.ui.panels.cell.named_tab import NamedTab, Thing
from armui.ui.panels.cell.tip_by_points import TipByPoints
from armui.ui.widgets.buttons import named
from armui.ui.widgets.figure_field import FigureField
from armui.ui.widgets.text_label import text_label
from armui.ui.words.text import Text

_CHANGE: Final = operation_of(CellControl.change)


class ToolsTab(NamedTab):
    """The tools of the chosen cell; see :class:`NamedTab`."""

    key = "tools"
    part = "tool"
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
        by_points = TipByPoints(controller, answered)
        super().__init__(controller, answered, by_points)
        self._by_points = by_points
        self._radius_label = QLabel()
        self._radius = named("cell_tool_radius", FigureField(1, "mm"))
        self._radius_label.setBuddy(self._radius)
        self._radius.textEdited.connect(lambda _text: self._show_news())
        self._capsule = text_label("cell_tool_capsule", rank="muted", wraps=True)
        self._by_points.applied.connect(
            lambda pose: self._take_found(pose, self.tr("Tool {number}"), anew=False)
        )
        self._lay_out([(self._radius_label, self._radius)], [self._capsule])
        self.retranslate_ui()

    @property
    def _things(self) -> Sequence[Thing]:
        return self._cell.tools

    @property
    def _chosen(self) -> Tool | None:
        return self._cell.chosen_tool

    def _choosing(self, name: str) -> Cell:
        return replace(self._cell, tool=name)

    def _put(self, thing: Any, instead_of: str = "") -> Cell:
        return with_tool(self._cell, thing, instead_of=instead_of)

    def _without(self, name: str) -> Cell:
        return without_tool(self._cell, name)

    def _live(self) -> None:
        self._by_points.show_live()

    def typed(self) -> Tool:
        """Return the tool as typed; an empty field counts as 0, a text as itself."""
        pose, radius = figures(self._fields), figures([self._radius])
        return Tool(self._name.text().strip(), pose, *radius)

    # -- appearance ---------------------------------------------------------------------------

    def show_cell(self, why_not: str) -> None:
        """Show the tools of the chosen cell."""
        self._list_things(self.tr("— (bare flange)"), why_not)
        uses = (
            self.tr("Puts these figures in the place of those of the chosen tool."),
            self.tr("Adds a tool of this name and chooses it."),
            self.tr("Deletes the chosen tool; the bare flange is chosen then."),
        )
        self._allow(why_not, self.tr("No tool is chosen. Add one, or choose one above."), uses)
        chosen = self._chosen
        self._by_points.show_tool(NO_TOOL if chosen is None else chosen.pose, why_not)
        self._show_news()

    def _show_thing(self, *, force: bool) -> None:
        super()._show_thing(force=force)
        if force:
            chosen = self._chosen
            self._radius.show_value(None if chosen is None else chosen.radius_mm)

    def _show_news(self) -> None:
        super()._show_news()
        self._radius.show_attention(wanted=self._radius.is_nonsense())
        length = 0.0
        if not any(field.is_nonsense() for field in self._fields):
            length = self.typed().length_mm
        text = self.tr("Checks see a capsule from the flange to the tip, {length} mm long.")
        self._capsule.setText(text.format(length=fmt.number(length, 1)))

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
        texts = (self.tr("Tool on the flange"), self.tr("Tool's name"))
        ways = (self.tr("Type it"), self.tr("Find the tip by points"))
        self._caption(texts, ways, self.tr("Tool"))
        self._radius_label.setText(self.tr("Radius"))
        self._radius.setAccessibleName(self.tr("Radius of the tool's capsule"))
        self.show_cell("")
