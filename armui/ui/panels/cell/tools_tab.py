"""The tab of the tools: added, named, typed, chosen and deleted."""

from __future__ import annotations

from typing import Any

from PySide6.QtWidgets import QLabel

from armui.cell.tools import Tool
from armui.control.arm_controller import ArmController
from armui.ui import format as fmt
from armui.ui.actions.command import Command
from armui.ui.panels.cell.cell_tab import Answered, figures
from armui.ui.panels.cell.named_tab import ForceTab, NamedTab, TabTexts
from armui.ui.panels.cell.tip_by_points import TipByPoints
from armui.ui.widgets.text_label import text_label
from armui.ui.words.text import Text


class ToolsTab(ForceTab):
    """The tools of the chosen cell; see :class:`NamedTab`."""

    key = "tools"
    part = "tool"
    kind = Tool
    title = Text("CellPanel", "Tools")
    commands = (
        Command("cell.tool", Text("ToolsTab", "Tool on the flange")),
        Command("cell.tool_by_points", Text("ToolsTab", "Find the tip by points")),
    )
    changes = NamedTab.changes_of(
        "tool",
        apply=Text("ToolsTab", "Apply the figures of the tool"),
        add=Text("ToolsTab", "Add as a new tool"),
        delete=Text("ToolsTab", "Delete the tool"),
    )

    def __init__(self, controller: ArmController, answered: Answered) -> None:
        super().__init__(controller, answered, TipByPoints(controller, answered))
        self._radius_label = QLabel()
        self._radius = self._figure("radius", 1, "mm")
        self._capsule = text_label("cell_tool_capsule", rank="muted", wraps=True)
        self._lay_out((self._radius_label, [self._radius]), below=[self._capsule])
        self.retranslate_ui()

    def typed(self) -> Tool:
        """Return the tool as typed; an empty field counts as 0, a text as itself."""
        return Tool(self._name.text().strip(), figures(self._fields), *figures([self._radius]))

    def _take_found(self, pose: tuple[float, ...], anew: bool) -> None:
        """Put the tip found in force as well, as the button's text says."""
        super()._take_found(pose, anew)
        if self._added:
            self._choose(self._added)

    def _fill(self, item: Any) -> None:
        super()._fill(item)
        self._radius.show_value(None if item is None else item.radius_mm)

    def _show_news(self) -> None:
        super()._show_news()
        nonsense = any(field.is_nonsense() for field in self._fields)
        length = 0.0 if nonsense else self.typed().length_mm
        text = self.tr("Checks see a capsule from the flange to the tip, {length} mm long.")
        self._capsule.setText(text.format(length=fmt.number(length, 1)) if length else "")

    def _next_step(self, *, new: bool, changed: bool) -> str:
        if new:
            return self.tr("Press Add for a further tool, or Apply: the chosen one gets these.")
        if self._item is None:
            return self.tr("Type a name for the tool and what is known of it, then press Add.")
        if changed:
            return self.tr("Press Apply to put the new figures in force.")
        return self.tr("This tool is in force. Choose another one, or change its figures.")

    def _texts(self) -> TabTexts:
        return TabTexts(
            kind=self.tr("Tool"),
            choice=self.tr("Tool on the flange"),
            name=self.tr("Tool's name"),
            none=self.tr("— (bare flange)"),
            missing=self.tr("No tool is chosen. Add one, or choose one above."),
            apply=self.tr("Puts these figures in the place of those of the chosen tool."),
            add=[self.tr("Adds a tool of this name; it is in force once it is chosen.")],
            delete=self.tr("Deletes the chosen tool; the bare flange is chosen then."),
        )

    def retranslate_ui(self) -> None:
        """Set all texts in the operator's language."""
        self._name_ways(self.tr("Type it"), self.tr("Find the tip by points"))
        self._radius_label.setText(self.tr("Radius"))
        self._radius.setAccessibleName(self.tr("Radius of the tool's capsule"))
        super().retranslate_ui()
