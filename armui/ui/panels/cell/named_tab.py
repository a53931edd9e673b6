"""The base of the tabs of tools and user frames: a list of poses with names, one of them chosen."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import replace
from itertools import count
from typing import ClassVar, Final

from PySide6.QtWidgets import QButtonGroup, QComboBox, QLabel, QLineEdit, QWidget

from armui.arm.state import ArmState
from armui.cell.cell import Cell
from armui.cell.checks import LONGEST_NAME
from armui.cell.tools import NO_TOOL, Tool
from armui.cell.user_frames import UserFrame
from armui.control.arm_controller import ArmController
from armui.kinematics.axes import AXES
from armui.ui import format as fmt
from armui.ui.actions.command import Target
from armui.ui.panels.cell.cell_tab import Answered, CellTab, CurrentStack, pose_grid
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

NARROW_PX: Final = 60
Thing = Tool | UserFrame


class NamedTab(CellTab):
    """A list, one chosen, its name and figures, and a guided search by points.

    Args:
        controller: The controller of the arm; changes go through its `cell`.
        answered: Shows an answer in the panel.
        by_points: The widget of the search.
    """

    part: ClassVar[str]
    """The part of the widgets' and commands' names: ``tool`` or ``frame``."""

    def __init__(self, controller: ArmController, answered: Answered, by_points: QWidget) -> None:
        super().__init__(controller, answered)
        name = f"cell_{self.part}"
        self._shown: Thing | None = None
        self._next = text_label(f"{name}_next", wraps=True)
        self._choice_label = QLabel()
        self._choice = named(f"{name}_box", QComboBox())
        self._choice_label.setBuddy(self._choice)
        self._name_label = QLabel()
        self._name = named(f"{name}_name", QLineEdit())
        self._name.setMaxLength(LONGEST_NAME)
        self._name_label.setBuddy(self._name)
        self._fields = [named(f"{name}_{axis}", FigureField(fmt.DECIMALS)) for axis in AXES]
        self._apply = push_button(f"{name}_apply")
        self._add = push_button(f"{name}_add")
        self._delete = push_button(f"{name}_delete")
        self._points = by_points
        self._ways = CurrentStack()
        self._way = QButtonGroup(self)
        for place, way in enumerate((f"{name}_typed", f"{name}_by_points")):
            self._way.addButton(choice_button(way), place)
        self._way.button(0).setChecked(True)
        self._way.idClicked.connect(self._on_way_chosen)
        self._choice.activated.connect(self._on_chosen)
        for field in (self._name, *self._fields):
            field.textEdited.connect(lambda _text: self._show_news())
        self._apply.clicked.connect(self._on_apply)
        self._add.clicked.connect(lambda: self._change(self._put(self.typed())))
        self._delete.clicked.connect(self._on_delete)

    def _lay_out(
        self, rows: Sequence[tuple[QLabel, QWidget]] = (), below: Sequence[QWidget] = ()
    ) -> None:
        """Lay out the tab.

        Args:
            rows: What else has a label, below the name.
            below: What stands below the figures.
        """
        grid = empty_grid(gaps=(8, 6), margins=0)
        first = ((self._choice_label, self._choice), (self._name_label, self._name))
        for row, pair in enumerate((*first, *rows)):
            for column, widget in enumerate(pair):
                grid.addWidget(widget, row, column)
        grid.setColumnStretch(1, 1)
        for widget in (self._choice, self._apply, self._add, self._delete):
            widget.setMinimumWidth(NARROW_PX)
        buttons = in_row((self._apply, 1), (self._add, 1), (self._delete, 1), spacing=6)
        typed = QWidget()
        parts = (self._next, grid, pose_grid(self._fields), *below, buttons, STRETCH)
        in_column(*parts, on=typed, spacing=8, margins=0)
        self._ways.addWidget(typed)
        self._ways.addWidget(self._points)
        ways = in_row(*((button, 1) for button in self._way.buttons()), spacing=6)
        in_column(ways, self._ways, on=self, spacing=8, margins=0)

    def command_targets(self) -> Mapping[str, Target]:
        """Return the target of each command, by the command's name."""
        return {
            f"cell.{self.part}": self._choice,
            f"cell.{self.part}_apply": self._apply,
            f"cell.{self.part}_add": self._add,
            f"cell.{self.part}_delete": self._delete,
            f"cell.{self.part}_by_points": self._way.button(1),
        }

    # What is of one kind alone ---------------------------------------------------------------

    @property
    def _things(self) -> Sequence[Thing]:
        raise NotImplementedError

    @property
    def _chosen(self) -> Thing | None:
        raise NotImplementedError

    def _choosing(self, name: str) -> Cell:
        """Return the cell with another one chosen; "" for none."""
        raise NotImplementedError

    def _put(self, thing: Thing, instead_of: str = "") -> Cell:
        """Return the cell with a further one, or with one in the place of another."""
        raise NotImplementedError

    def _without(self, name: str) -> Cell:
        """Return the cell without one."""
        raise NotImplementedError

    def typed(self) -> Thing:
        """Return what is typed; an empty field counts as 0, a text as itself."""
        raise NotImplementedError

    def _next_step(self, *, new: bool, changed: bool) -> str:
        raise NotImplementedError

    # Actions ---------------------------------------------------------------------------------

    @property
    def _cell(self) -> Cell:
        return self._controller.cell.cell or Cell("")

    def _change(self, cell: Cell) -> None:
        if not self._answered(self._controller.cell.change(cell)):
            self._show_thing(force=False)

    def _on_chosen(self, place: int) -> None:
        self._change(self._choosing(self._choice.itemData(place) or ""))

    def _on_apply(self) -> None:
        if self._shown is not None:
            self._change(self._put(self.typed(), self._shown.name))

    def _on_delete(self) -> None:
        if self._shown is not None:
            self._change(self._without(self._shown.name))

    def _on_way_chosen(self, place: int) -> None:
        self._ways.setCurrentIndex(place)
        self._live()

    def _live(self) -> None:
        raise NotImplementedError

    def _take_found(self, pose: tuple[float, ...], pattern: str, *, anew: bool) -> None:
        """Put a pose that was found into the chosen one, or into a new one.

        Args:
            pose: Six figures.
            pattern: The name of a new one, with {number}.
            anew: True for a new one though one is chosen.
        """
        rounded = tuple(round(each, fmt.DECIMALS) for each in pose)
        chosen = self._chosen
        if chosen is not None and not anew:
            self._change(self._put(replace(chosen, pose=rounded), chosen.name))
            return
        names = {thing.name.casefold() for thing in self._things}
        numbered = (pattern.format(number=number) for number in count(1))
        name = next(each for each in numbered if each.casefold() not in names)
        self._change(self._put(type(self.typed())(name, rounded)))

    def show_state(self, _state: ArmState) -> None:
        """Show what the present pose would tell in the search."""
        if self._points.isVisible():
            self._live()

    # Appearance ------------------------------------------------------------------------------

    def _list_things(self, none: str, why_not: str) -> None:
        """List all, with the words for none of them."""
        self._choice.clear()
        self._choice.addItem(none, "")
        for thing in self._things:
            self._choice.addItem(thing.name, thing.name)
        self._show_thing(force=self._shown != self._chosen)
        self._choice.setEnabled(self._controller.cell.cell is not None and not why_not)

    def _show_thing(self, *, force: bool) -> None:
        """Fill the fields with the chosen one; what is typed stays while it is the same one."""
        chosen = self._chosen
        name = "" if chosen is None else chosen.name
        self._choice.setCurrentIndex(max(0, self._choice.findData(name)))
        if force:
            self._shown = chosen
            self._name.setText(name)
            for field, value in zip(
                self._fields, NO_TOOL if chosen is None else chosen.pose, strict=True
            ):
                field.show_value(None if chosen is None else value)

    def _allow(self, why_not: str, none: str, uses: tuple[str, str, str]) -> None:
        """Enable the buttons or say why not.

        Args:
            why_not: Why nothing can be changed now; empty if it can.
            none: That none is chosen.
            uses: What each of Apply, Add and Delete does.
        """
        missing = none if self._shown is None else ""
        enable_or_explain(self._apply, why_not or missing, uses[0])
        enable_or_explain(self._add, why_not, uses[1])
        enable_or_explain(self._delete, why_not or missing, uses[2])

    def _show_news(self) -> None:
        """Say what is to be done next, and light its button."""
        typed, shown = self.typed(), self._shown
        for field in self._fields:
            field.show_attention(wanted=field.is_nonsense())
        new = bool(typed.name) and typed.name not in {thing.name for thing in self._things}
        show_primary(self._add, wanted=self._add.isEnabled() and new)
        changed = shown is not None and typed != shown
        show_primary(self._apply, wanted=self._apply.isEnabled() and changed and not new)
        self._next.setText(self._next_step(new=new, changed=changed))

    def _caption(self, texts: tuple[str, str], ways: tuple[str, str], thing: str) -> None:
        """Name the parts for the eye and for a screen reader.

        Args:
            texts: The list's, and the name's.
            ways: The two ways.
            thing: The kind, before the axes and buttons.
        """
        for label, field, text in zip(
            (self._choice_label, self._name_label), (self._choice, self._name), texts, strict=True
        ):
            label.setText(text)
            field.setAccessibleName(text)
        for axis, figure in zip(AXES, self._fields, strict=True):
            figure.setAccessibleName(f"{thing} {axis}")
        for button, text in zip(self._way.buttons(), ways, strict=True):
            caption(button, text)
        caption(self._apply, self.tr("Apply"), whose=thing)
        caption(self._add, self.tr("Add"), whose=thing)
        caption(self._delete, self.tr("Delete"), whose=thing)
