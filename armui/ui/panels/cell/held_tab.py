"""The tab of what the hand may hold: boxes and rods, and which of them it holds now."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import replace
from typing import Final

from PySide6.QtWidgets import QComboBox, QLabel, QLineEdit, QMenu

from armui.arm.models import model_data
from armui.cell.cell import Cell, with_held_object
from armui.cell.checks import LONGEST_NAME
from armui.cell.held_objects import PAYLOAD_KG, HeldObject
from armui.control.arm_controller import ArmController
from armui.control.cell.cell_control import CellControl, why_not_change
from armui.control.devices.end_reports import EndReports, why_no_load
from armui.control.operations.operation import operation_of
from armui.kinematics.axes import AXES
from armui.protocol.codes import EndLoad
from armui.ui import format as fmt
from armui.ui import words
from armui.ui.actions.command import Command, Target
from armui.ui.panels.cell.cell_tab import Answered, CellTab, figures, pose_grid
from armui.ui.widgets.buttons import (
    caption,
    drop_down,
    enable_or_explain,
    give_menu,
    named,
    push_button,
    show_primary,
)
from armui.ui.widgets.figure_field import FigureField
from armui.ui.widgets.layouts import STRETCH, empty_grid, in_column, in_row
from armui.ui.widgets.text_label import text_label
from armui.ui.words.text import Text

_CHANGE: Final = operation_of(CellControl.change)
_EDGES: Final = "XYZ"
_NARROW_PX: Final = 56


class HeldTab(CellTab):
    """What the hand may hold in the chosen cell; see :class:`CellTab`."""

    key = "held"
    title = Text("CellPanel", "Held")
    commands = (
        Command("cell.held_object", Text("HeldTab", "Held object")),
        Command("cell.hold", operation=operation_of(CellControl.hold), leads=True),
        Command("cell.held_add", Text("HeldTab", "Add an object to hold"), _CHANGE, leads=True),
        Command(
            "cell.held_apply",
            Text("HeldTab", "Apply the figures of the object"),
            _CHANGE,
            leads=True,
        ),
        Command(
            "cell.held_delete",
            Text("HeldTab", "Delete the object"),
            _CHANGE,
            leads=True,
            risky=True,
        ),
        Command("cell.held_touch", Text("HeldTab", "What the held object may touch")),
        Command(
            "cell.held_load",
            Text("HeldTab", "Tell the arm the object's load"),
            operation_of(EndReports.set_load),
            leads=True,
        ),
    )

    def __init__(self, controller: ArmController, answered: Answered) -> None:
        super().__init__(controller, answered)
        self._why_not = ""
        self._shown: tuple[str, HeldObject | None] | None = None
        self._chosen = ""
        self._touched: frozenset[str] = frozenset()
        self._hold_tip = ("", "")
        self._next = text_label("cell_held_next", wraps=True)
        self._choice = named("cell_held_box", QComboBox())
        self._hold = push_button("cell_held_hold")
        self._name = named("cell_held_name", QLineEdit())
        self._name.setMaxLength(LONGEST_NAME)
        self._kind = drop_down("cell_held_kind")
        self._fields = [named(f"cell_held_{axis}", FigureField(fmt.DECIMALS)) for axis in AXES]
        self._sizes = [named(f"cell_held_size_{edge}", FigureField(1, "mm")) for edge in _EDGES]
        self._mass = named("cell_held_mass", FigureField(2, "kg"))
        self._touch = push_button("cell_held_touch")
        self._menu = named("cell_held_touch_menu", QMenu(self._touch))
        give_menu(self._touch, self._menu)
        self._labels = [QLabel() for _ in range(3)]
        self._size_label = QLabel()
        self._add = push_button("cell_held_add")
        self._apply = push_button("cell_held_apply")
        self._delete = push_button("cell_held_delete")
        self._payload = text_label("cell_held_payload", rank="muted", wraps=True)
        self._load = push_button("cell_held_load")
        self._lay_out()
        self._choice.activated.connect(self._on_chosen)
        self._kind.activated.connect(lambda _place: self._show_news())
        for field in (self._name, self._mass, *self._fields, *self._sizes):
            field.textEdited.connect(lambda _text: self._show_news())
        self._hold.clicked.connect(self._on_hold)
        self._menu.triggered.connect(self._on_touch)
        self._add.clicked.connect(self._on_add)
        self._apply.clicked.connect(self._on_apply)
        self._delete.clicked.connect(self._on_delete)
        self._load.clicked.connect(lambda: answered(controller.end_reports.set_load(self._load_of)))
        self.retranslate_ui()

    def _lay_out(self) -> None:
        grid = empty_grid(gaps=(8, 6), margins=0)
        fields = (self._choice, self._name, self._mass)
        besides = (self._hold, self._kind, self._touch)
        for row, (label, field, beside) in enumerate(
            zip(self._labels, fields, besides, strict=True)
        ):
            label.setBuddy(field)
            grid.addWidget(label, row, 0)
            grid.addLayout(in_row((field, 1), beside, spacing=6), row, 1)
        grid.setColumnStretch(1, 1)
        sizes = in_row(*((field, 1) for field in self._sizes), spacing=6)
        changes = in_row((self._add, 1), (self._apply, 1), (self._delete, 1), spacing=6)
        load = in_row((self._payload, 1), self._load, spacing=6)
        buttons = (self._hold, self._touch, self._add, self._apply, self._delete, self._load)
        for each in (self._choice, self._name, self._mass, *self._sizes, *buttons):
            each.setMinimumWidth(_NARROW_PX)
        parts = (
            self._next,
            grid,
            pose_grid(self._fields),
            self._size_label,
            sizes,
            changes,
            load,
            STRETCH,
        )
        in_column(*parts, on=self, spacing=8, margins=0)

    def command_targets(self) -> Mapping[str, Target]:
        """Return the target of each command, by the command's name."""
        return {
            "cell.held_object": self._choice,
            "cell.hold": self._hold,
            "cell.held_add": self._add,
            "cell.held_apply": self._apply,
            "cell.held_delete": self._delete,
            "cell.held_touch": self._touch,
            "cell.held_load": self._load,
        }

    # -- actions ------------------------------------------------------------------------------

    @property
    def _cell(self) -> Cell:
        return self._controller.cell.cell or Cell("")

    @property
    def _object(self) -> HeldObject | None:
        return self._cell.object_named(self._chosen)

    @property
    def _load_of(self) -> EndLoad:
        """The load that the arm is proposed to be told."""
        held = self._cell.held_object
        return EndLoad.EMPTY if held is None else held.load

    def _on_chosen(self, place: int) -> None:
        self._chosen = self._choice.itemData(place) or ""
        self.show_cell(self._why_not)

    def _on_hold(self) -> None:
        self._answered(self._controller.cell.hold("" if self._cell.held else self._chosen))

    def _on_touch(self) -> None:
        self._touched = frozenset(
            action.data() for action in self._menu.actions() if action.isChecked()
        )
        self._show_news()

    def _change(self, cell: Cell, chosen: str) -> None:
        before, self._chosen = self._chosen, chosen
        if not self._answered(self._controller.cell.change(cell)):
            self._chosen = before
            self.show_cell(self._why_not)

    def _on_add(self) -> None:
        typed = self._typed()
        self._change(with_held_object(self._cell, typed), typed.name)

    def _on_apply(self) -> None:
        typed = self._typed()
        self._change(with_held_object(self._cell, typed, instead_of=self._chosen), typed.name)

    def _on_delete(self) -> None:
        left = tuple(each for each in self._cell.held_objects if each.name != self._chosen)
        held = "" if self._cell.held == self._chosen else self._cell.held
        self._change(replace(self._cell, held_objects=left, held=held), "")

    def _typed(self) -> HeldObject:
        return HeldObject(
            self._name.text().strip(),
            figures(self._fields),
            figures(self._sizes),
            bool(self._kind.currentIndex()),
            figures([self._mass])[0],
            tuple(sorted(self._touched)),
        )

    # -- appearance ---------------------------------------------------------------------------

    def show_cell(self, why_not: str) -> None:
        """Show what the hand may hold in the chosen cell, and what it holds."""
        self._why_not = why_not
        cell = self._cell
        self._choice.clear()
        self._choice.addItem(self.tr("— (a new one)"), "")
        for each in cell.held_objects:
            now = self.tr(" (held)") if each.name == cell.held else ""
            self._choice.addItem(f"{each.name}{now}", each.name)
        chosen = self._object
        if chosen is None and not self._name.text():
            chosen = cell.held_object
        self._chosen = "" if chosen is None else chosen.name
        self._choice.setCurrentIndex(max(0, self._choice.findData(self._chosen)))
        if (self._chosen, chosen) != self._shown:
            self._shown = (self._chosen, chosen)
            self._show_object(chosen or self._new())
        self._choice.setEnabled(self._controller.cell.cell is not None)
        enable_or_explain(self._add, why_not, self.tr("Adds an object of this name."))
        none = "" if chosen else self.tr("Choose an object above first.")
        use = self.tr("Puts these figures in the place of those of the chosen object.")
        enable_or_explain(self._apply, why_not or none, use)
        enable_or_explain(self._delete, why_not or none, self.tr("Deletes the chosen object."))
        held = cell.held
        caption(
            self._hold,
            self.tr("Let go") if held else self.tr("It is held"),
            whose=self.title.text(),
        )
        moving = words.why_not(why_not_change(self._controller.operating_state))
        use = (
            self.tr("“{name}” no longer counts in any check. The gripper does not move.")
            if held
            else self.tr("It counts in every check from now on. The gripper does not move.")
        )
        self._hold_tip = moving or ("" if held else none), use.format(name=held)
        self._show_news()

    def _new(self) -> HeldObject:
        """Return what is proposed for a new object: it is between the fingertips."""
        model = self._controller.operating_state.model
        reach_mm = model_data(model).gripper.reach_mm
        return HeldObject("", (0.0, 0.0, reach_mm, 0.0, 0.0, 0.0))

    def _show_object(self, held: HeldObject) -> None:
        if held.name:
            self._name.setText(held.name)
        for field, value in zip(self._fields, held.pose, strict=True):
            field.show_value(value)
        for field, value in zip(self._sizes, held.size_mm, strict=True):
            field.show_value(value)
        self._mass.show_value(held.mass_kg)
        self._kind.setCurrentIndex(int(held.is_rod))
        self._touched = frozenset(held.may_touch)

    def _show_touched(self) -> None:
        zones = [zone.name for zone in self._cell.area.zones]
        self._menu.clear()
        for name in zones:
            action = self._menu.addAction(name)
            action.setData(name)
            action.setCheckable(True)
            action.setChecked(name in self._touched)
        self._touched &= frozenset(zones)
        count = len(self._touched)
        text = self.tr("May touch: {count}").format(count=count) if count else self.tr("May touch…")
        caption(self._touch, text)
        none = "" if zones else self.tr("The work area has no plane or box yet.")
        use = ", ".join(sorted(self._touched))
        enable_or_explain(
            self._touch, none, use or self.tr("What it may touch: the table, a tray.")
        )

    def _show_news(self) -> None:
        """Say what is to be done next, and light its button."""
        for field in (*self._fields, *self._sizes, self._mass):
            field.show_attention(wanted=field.is_nonsense())
        self._show_touched()
        typed, chosen = self._typed(), self._object
        new = bool(typed.name) and self._cell.object_named(typed.name) is None
        changed = chosen is not None and typed != chosen and not new
        is_rod = typed.is_rod
        self._size_label.setText(
            self.tr("Diameter (X, Y), length (Z)") if is_rod else self.tr("Edges")
        )
        typing = self.tr("Press Apply first: the figures typed are not in force.")
        why_not, use = self._hold_tip
        enable_or_explain(
            self._hold, why_not or (typing if changed and not self._cell.held else ""), use
        )
        free = self._hold.isEnabled() and chosen is not None and not self._cell.held
        show_primary(self._add, wanted=self._add.isEnabled() and new and chosen is None)
        show_primary(self._apply, wanted=self._apply.isEnabled() and changed)
        show_primary(self._hold, wanted=free and not changed and not new)
        self._next.setText(self._next_step(new=new, changed=changed))
        load = self._load_of
        held = self._cell.held_object
        mass = fmt.number(0.0 if held is None else held.mass_kg, 2)
        text = self.tr("In the hand: {mass} kg. The arm carries {most} kg at most.")
        self._payload.setText(text.format(mass=mass, most=fmt.number(PAYLOAD_KG, 1)))
        caption(self._load, self.tr("Tell: {load}").format(load=words.end_load(load)))
        use = self.tr("Tells the arm its end load; the program never does so by itself.")
        why_not = words.why_not(why_no_load(self._controller.operating_state))
        enable_or_explain(self._load, why_not, use)

    def _next_step(self, *, new: bool, changed: bool) -> str:
        held = self._cell.held
        if self._controller.cell.cell is None:
            return self.tr("There is no cell yet: type its name above and press New.")
        if changed:
            return self.tr("Press Apply to put the new figures in force.")
        if held:
            return self.tr(
                "The hand holds “{name}”: it counts in every check until Let go."
            ).format(name=held)
        if new:
            return self.tr("Press Add. It counts as soon as it is marked as held.")
        if self._object is not None:
            return self.tr("Press It is held once the gripper has closed on it.")
        return self.tr("Type a name, the middle of the object in the flange, and its edges.")

    def retranslate_ui(self) -> None:
        """Set all texts in the operator's language."""
        names = (self.tr("Held object"), self.tr("Name"), self.tr("Mass"))
        for label, field, text in zip(
            self._labels, (self._choice, self._name, self._mass), names, strict=True
        ):
            label.setText(text)
            field.setAccessibleName(text)
        self._name.setAccessibleName(self.tr("Name of the held object"))
        kind = self._kind.currentIndex()
        self._kind.clear()
        self._kind.addItems([self.tr("Box"), self.tr("Rod")])
        self._kind.setCurrentIndex(max(0, kind))
        self._kind.setAccessibleName(self.tr("Shape of the held object"))
        for axis, field in zip(AXES, self._fields, strict=True):
            field.setAccessibleName(self.tr("Held object {axis}").format(axis=axis))
        for edge, field in zip(_EDGES, self._sizes, strict=True):
            field.setAccessibleName(
                self.tr("Edge of the held object along {axis}").format(axis=edge)
            )
        whose = self.title.text()
        caption(self._add, self.tr("Add"), whose=whose)
        caption(self._apply, self.tr("Apply"), whose=whose)
        caption(self._delete, self.tr("Delete"), whose=whose)
        self.show_cell(self._why_not)
