"""The tab of the gripper table: commanded openings, and those measured with callipers."""

from __future__ import annotations

from dataclasses import replace
from typing import Final

from PySide6.QtWidgets import QCheckBox, QLabel

from armui.arm.refusal import Refusal
from armui.arm.state import ArmState
from armui.cell.gripper_table import MOST_PAIRS, Pairs
from armui.control.arm_controller import ArmController
from armui.control.cell.cell_control import CellControl
from armui.control.devices.gripper import GripperControl, why_not_move_gripper
from armui.ui import format as fmt
from armui.ui.actions.act import Act
from armui.ui.panels.cell.cell_tab import Answered, CellTab, change_command, hint_label
from armui.ui.widgets.buttons import caption, enable_or_explain, named
from armui.ui.widgets.figure_field import FigureField
from armui.ui.widgets.layouts import STRETCH, empty_grid, in_column, in_row
from armui.ui.words.text import Text

_SHARES: Final = (0.1, 0.3, 0.5, 0.7, 0.9)
"""The proposed openings as shares of the stroke, away from its ends, where the fingers press."""
_GENTLE_NM: Final = 1.0
"""The torque while openings are measured: low, as hands and callipers are between the fingers."""


class GripperTab(CellTab):
    """The gripper table of the chosen cell; see :class:`CellTab`."""

    key = "gripper"
    title = Text("CellPanel", "Gripper")
    commands = (
        change_command(
            "cell.gripper_on", Text("GripperTab", "Show and command calibrated openings")
        ),
    )
    widths = Act(
        "Propose widths",
        named="cell_gripper_widths",
        tip="Fills in widths over the gripper's stroke.",
        whose=title,
        key="cell.gripper_widths",
        title=Text("GripperTab", "Propose widths for the gripper table"),
    )
    open_next = Act(
        "Open to {width} mm",
        named="cell_gripper_open",
        does=GripperControl.move,
        tip="Moves the gripper, uncalibrated.",
        key="cell.gripper_open",
        title=Text("GripperTab", "Open the gripper to the next width of its table"),
        primary=True,
        leads=True,
    )
    apply = Act(
        "Apply",
        named="cell_gripper_apply",
        does=CellControl.change,
        tip="Puts the table in force; one of fewer than two pairs switches it off.",
        whose=title,
        key="cell.gripper_apply",
        title=Text("GripperTab", "Apply the gripper table"),
        leads=True,
    )

    def __init__(self, controller: ArmController, answered: Answered) -> None:
        super().__init__(controller, answered)
        self._why_not = ""
        self._shown: tuple[str, Pairs] | None = None
        self._next = hint_label("cell_gripper_next", lines=3)
        self._on = named("cell_gripper_on", QCheckBox())
        self._heads = (QLabel(), QLabel())
        self._asked = [named(f"cell_gripper_asked_{n}", self._field()) for n in range(MOST_PAIRS)]
        self._measured = [
            named(f"cell_gripper_measured_{n}", self._field()) for n in range(MOST_PAIRS)
        ]
        grid = empty_grid(gaps=(8, 4), margins=0)
        for column, (head, fields) in enumerate(
            zip(self._heads, (self._asked, self._measured), strict=True)
        ):
            grid.addWidget(head, 0, column)
            for row, field in enumerate(fields, start=1):
                grid.addWidget(field, row, column)
        buttons = in_row((self.widths, 1), (self.open_next, 1), (self.apply, 1), spacing=6)
        parts = (self._next, buttons, in_row(self._on, STRETCH), grid, STRETCH)
        in_column(*parts, on=self, spacing=8, margins=0)
        self._on.clicked.connect(self._on_switched)
        self.retranslate_ui()

    def _field(self) -> FigureField:
        field = FigureField(1, "mm")
        field.textEdited.connect(lambda _text: self._show_news())
        return field

    # -- actions ------------------------------------------------------------------------------

    def typed(self) -> Pairs:
        """Return the complete pairs of a commanded and a measured opening, in mm, in order."""
        pairs = [(a.value, b.value) for a, b in zip(self._asked, self._measured, strict=True)]
        return tuple(sorted((a, b) for a, b in pairs if a is not None and b is not None))

    @property
    def _row(self) -> int | None:
        """The first row whose commanded opening has no measured one yet."""
        rows = enumerate(zip(self._asked, self._measured, strict=True))
        return next((n for n, (a, b) in rows if a.value is not None and b.value is None), None)

    def _on_switched(self, on: bool) -> None:
        self._answered(self._controller.cell.change(replace(self._cell, gripper_calibrated=on)))
        self._show_switch()

    @widths.pressed
    def _on_widths(self) -> None:
        """Propose openings over the stroke; only measured pairs that are applied are kept."""
        widest = self._controller.gripper.own_figures.travel.maximum
        widths = [round(share * widest) for share in _SHARES]
        for place, (asked, measured) in enumerate(zip(self._asked, self._measured, strict=True)):
            asked.show_value(widths[place] if place < len(widths) else None)
            measured.show_value(None)
        self._show_news()

    @open_next.pressed
    def _on_open(self) -> None:
        row = self._row
        width = None if row is None else self._asked[row].value
        if row is not None and width is not None:
            gripper = self._controller.gripper
            if self._answered(gripper.move(width, _GENTLE_NM, uncalibrated=True)):
                self._measured[row].setFocus()

    @apply.pressed
    def _on_apply(self) -> None:
        pairs = self.typed()
        on = len(pairs) > 1
        self._answered(
            self._controller.cell.change(
                replace(self._cell, gripper_table=pairs, gripper_calibrated=on)
            )
        )

    # -- appearance ---------------------------------------------------------------------------

    def show_cell(self, why_not: str) -> None:
        """Show the table of the chosen cell; typed figures stay while that is the same."""
        self._why_not = why_not
        self._controller.gripper.learn_stroke()
        shown = self._cell.name, self._cell.gripper_table
        before, self._shown = self._shown or ("", ()), shown
        renamed = bool(before[0]) and before[0] not in self._controller.cell.cells
        if shown[1] != before[1] or (shown != before and not renamed):
            for place in range(MOST_PAIRS):
                known = place < len(shown[1])
                self._asked[place].show_value(shown[1][place][0] if known else None)
                self._measured[place].show_value(shown[1][place][1] if known else None)
        self._show_switch()
        self._show_news()

    def show_state(self, _state: ArmState) -> None:
        """Update whether opening is possible, when the gripper is first heard."""
        GripperTab.open_next.show(self)

    def _show_switch(self) -> None:
        self._on.setChecked(self._cell.gripper_calibrated)
        short = self.tr("Apply a table of two pairs at least first.")
        none = short if len(self._cell.gripper_table) < 2 else ""
        use = self.tr("Off, everything is as the arm tells it; the table is kept.")
        enable_or_explain(self._on, self._why_not or none, use)

    @open_next.text
    def _open_text(self) -> str:
        row = self._row
        width = fmt.NOTHING if row is None else fmt.number(self._asked[row].value or 0.0, 1)
        return self.tr("Open to {width} mm").format(width=width)

    @open_next.why_not
    def _why_not_open(self) -> Refusal | str | None:
        done = self.tr("Every width is measured. Type another one, or apply the table.")
        no_move = why_not_move_gripper(self._controller.operating_state)
        return no_move or (done if self._row is None else "")

    @widths.why_not
    def _why_no_widths(self) -> str:
        return self._why_not

    @apply.why_not
    def _why_not_apply(self) -> str:
        off = len(self.typed()) > 1 and not self._cell.gripper_calibrated
        same = "" if self._is_changed() or off else self.tr("Nothing is changed.")
        return self._why_not or same

    @apply.lit
    def _is_to_apply(self) -> bool:
        whole = len(self.typed()) > 1 and self._row is None
        return self._is_changed() and whole

    def _is_changed(self) -> bool:
        return self.typed() != self._cell.gripper_table

    def _show_news(self) -> None:
        """Show what is to be done next, and highlight its button."""
        for field in (*self._asked, *self._measured):
            field.show_attention(wanted=field.is_nonsense())
        self.show_acts()
        self._next.setText(self._next_step(changed=self._is_changed()))

    def _next_step(self, *, changed: bool) -> str:
        if none := self._no_step():
            return none
        if self._row is not None:
            return self.tr(
                "Row {row}: press Open, wait until the gripper stands, measure between the fingers "
                "with callipers and type what they show."
            ).format(row=self._row + 1)
        if len(self.typed()) < 2 and (changed or self.typed()):
            return self.tr(
                "Two pairs at least are needed: type another width, and what is measured. Apply "
                "with fewer switches the calibration off."
            )
        if changed:
            return self.tr("Press Apply: openings are calibrated from then on.")
        if self._cell.gripper_calibrated:
            return self.tr(
                "Calibrated: targets, points, the opening shown and the picture go by this table. "
                "Recordings keep what the arm told."
            )
        return self.tr("Press Propose widths, or type openings to be measured.")

    def retranslate_ui(self) -> None:
        """Set all texts in the operator's language."""
        caption(self._on, self.tr("Calibrated"), whose=self.title.text())
        texts = (self.tr("Asked for"), self.tr("Measured"))
        for head, text, fields in zip(
            self._heads, texts, (self._asked, self._measured), strict=True
        ):
            head.setText(text)
            for number, field in enumerate(fields, start=1):
                field.setAccessibleName(f"{text} {number}")
        self.show_cell(self._why_not)
