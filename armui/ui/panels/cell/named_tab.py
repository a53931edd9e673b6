"""The base of the tabs of tools, frames, areas and held objects: a list of poses with names."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass, replace
from itertools import count
from typing import Any, ClassVar, Final

from PySide6.QtWidgets import QComboBox, QLabel, QLineEdit, QWidget

from armui.arm.refusal import Refusal
from armui.arm.state import ArmState
from armui.cell.cell import Cell, with_part, without_part
from armui.cell.checks import CELL_NAME_TAKEN, LONGEST_NAME
from armui.cell.held_objects import HeldObject
from armui.cell.parts import part_named
from armui.cell.tools import Tool
from armui.cell.user_frames import UserFrame
from armui.cell.work_area import Zone
from armui.control.arm_controller import ArmController
from armui.control.cell.cell_control import CellControl
from armui.kinematics.axes import AXES
from armui.ui import format as fmt
from armui.ui.actions.act import Act, ActFamily
from armui.ui.panels.cell.cell_tab import (
    NARROW_PX,
    UNITS,
    Answered,
    CellTab,
    CurrentStack,
    hint_label,
    pose_grid,
)
from armui.ui.panels.cell.point_search import PointSearch
from armui.ui.widgets.buttons import caption, choice_group, named
from armui.ui.widgets.figure_field import FigureField
from armui.ui.widgets.layouts import STRETCH, Item, empty_grid, in_column, in_row
from armui.ui.words.text import Text

CellItem = Tool | UserFrame | HeldObject | Zone
EDGES: Final = "XYZ"
_LABELS: Final = {
    "apply": Text("NamedTab", "Apply"),
    "add": Text("NamedTab", "Add"),
    "plane": Text("AreaTab", "Add plane"),
    "box": Text("AreaTab", "Add box"),
    "delete": Text("NamedTab", "Delete"),
    "restore": Text("NamedTab", "Undo delete"),
}
ADDED: Final = Text(
    "ForceTab",
    "“{name}” is added, and nothing else has changed. Choose it under “Type it” to put it "
    "in force.",
)
"""The message after a tool or frame was added that is not in force."""


@dataclass(frozen=True, slots=True)
class TabTexts:
    """The words of a tab in the present language.

    Attributes:
        kind: The name of one item in its list.
        choice: The label of the list.
        name: The label of the field for the name.
        none: The entry of the list for none.
        missing: The sentence that none is chosen.
        apply: The tooltip of Apply.
        add: The tooltip of each button that adds.
        delete: The tooltip of Delete.
    """

    kind: str
    choice: str
    name: str
    none: str
    missing: str
    apply: str
    add: Sequence[str]
    delete: str


class NamedTab(CellTab):
    """A list of things, fields for the name and figures of the chosen one, and perhaps a search.

    Args:
        controller: The controller of the arm; changes go through its `cell`.
        answered: Shows an answer in the panel.
        search: The widget of the search.
    """

    part: ClassVar[str]
    """The part of the widgets' and commands' names: ``tool``, ``frame``, ``area`` or ``held``."""
    listed: ClassVar[str] = ""
    """The name of the list's widget, if it differs from `part`."""
    kind: ClassVar[type[Any]]
    """The class of the items in the list."""
    adds: ClassVar[Sequence[str]] = ("add",)
    """The keys of the buttons that add a thing."""
    changes: ClassVar[ActFamily[str]]
    """The buttons Apply, those that add a thing, and Delete."""

    @classmethod
    def changes_of(cls, part: str, **titles: Text) -> ActFamily[str]:
        """Return the buttons that change the items of a tab.

        Args:
            part: The `part` of the tab.
            titles: Their titles in the palette.
        """
        acts = {
            act: Act(
                _LABELS[act],
                named=f"cell_{part}_{act}",
                does=CellControl.change,
                whose=_LABELS[act].context == "NamedTab",
                key=f"cell.{part}_{act}",
                title=title,
                leads=True,
                risky=act == "delete",
            )
            for act, title in titles.items()
        }
        acts["restore"] = Act(
            _LABELS["restore"], named=f"cell_{part}_restore", does=CellControl.change
        )
        changes = ActFamily(acts)
        changes.pressed(cls._on_change)
        changes.why_not(cls._why_no_change)
        changes.tip(cls._use_of)
        changes.lit(cls._is_wanted)
        changes.there(cls._is_there)
        return changes

    def __init__(
        self, controller: ArmController, answered: Answered, search: PointSearch | None = None
    ) -> None:
        super().__init__(controller, answered)
        name = f"cell_{self.part}"
        self._why_not = ""
        self._local = ""
        self._deleted: tuple[Cell, Cell, str] | None = None
        self._shown: tuple[CellItem | None, ...] = ()
        self._next = hint_label(f"{name}_next")
        self._choice_label, self._name_label, self._size_label = QLabel(), QLabel(), QLabel()
        self._choice = named(self.listed or name, QComboBox())
        self._name = named(f"{name}_name", QLineEdit(maxLength=LONGEST_NAME))
        self._figures: list[FigureField] = []
        self._fields = [self._figure(axis, fmt.DECIMALS, unit) for axis, unit in UNITS.items()]
        self._sizes: list[FigureField] = []
        self._search = search
        self._ways = CurrentStack()
        self._choice.activated.connect(
            lambda place: self._choose(self._choice.itemData(place) or "")
        )
        self._name.textEdited.connect(lambda _text: self._show_news())

    def _figure(self, name: str, decimals: int, unit: str = "") -> FigureField:
        """Return a field for a figure of the item, named after it."""
        field = named(f"cell_{self.part}_{name}", FigureField(decimals, unit))
        field.textEdited.connect(lambda _text: self._show_news())
        self._figures.append(field)
        return field

    def _lay_out(
        self,
        *rows: tuple[QLabel, Sequence[QWidget]],
        beside: tuple[Sequence[QWidget], Sequence[QWidget]] = ((), ()),
        below: Sequence[Item] = (),
        last: Sequence[Item] = (),
    ) -> None:
        """Lay out the tab.

        Args:
            rows: Further labels with their fields and the widgets beside these.
            beside: The widgets beside the list, and beside the name.
            below: The widgets below the figures.
            last: The widgets below the buttons.
        """
        grid = empty_grid(gaps=(8, 6), margins=0)
        first = (
            (self._choice_label, (self._choice, *beside[0])),
            (self._name_label, (self._name, *beside[1])),
        )
        for row, (label, (field, *more)) in enumerate((*first, *rows)):
            label.setBuddy(field)
            field.setMinimumWidth(NARROW_PX)
            grid.addWidget(label, row, 0)
            grid.addWidget(field, row, 1, 1, 2 - len(more))
            for each in more:
                grid.addWidget(each, row, 2)
        if self._sizes:
            sizes = in_row(*((each, 1) for each in self._sizes), spacing=6)
            grid.addWidget(self._size_label, row + 1, 0)
            grid.addLayout(sizes, row + 1, 1, 1, 2)
        grid.setColumnStretch(1, 1)
        for widget in (*self.changes.values(), *self._sizes):
            widget.setMinimumWidth(NARROW_PX)
        apply, delete = self.changes["apply"], (self.changes["delete"], self.changes["restore"])
        adds = [self.changes[each] for each in self.adds]
        rows_of_buttons = [adds, [apply, *delete]] if len(adds) > 1 else [[apply, *adds, *delete]]
        ends = [in_row(*((each, 1) for each in row), spacing=6) for row in rows_of_buttons]
        parts = (self._next, grid, pose_grid(self._fields), *below, *ends, *last, STRETCH)
        if self._search is None:
            in_column(*parts, on=self, spacing=8, margins=0)
            return
        typed = QWidget()
        in_column(*parts, on=typed, spacing=8, margins=0)
        for widget in (typed, self._search):
            self._ways.addWidget(widget)
        names = (f"cell_{self.part}_typed", f"cell_{self.part}_by_points")
        self._way = choice_group(self, names)
        self._way.idClicked.connect(self._on_way_chosen)
        self._search.applied.connect(self._take_found)
        ways = in_row(*((button, 1) for button in self._way.buttons()), spacing=6)
        in_column(ways, self._ways, on=self, spacing=8, margins=0)

    # What a subclass defines -----------------------------------------------------------------

    def _texts(self) -> TabTexts:
        """Return the words of the tab."""
        raise NotImplementedError

    def typed(self) -> Any:
        """Return the thing as typed; an empty field counts as 0, an invalid one as its text."""
        raise NotImplementedError

    def _next_step(self, *, new: bool, changed: bool) -> str:
        raise NotImplementedError

    @property
    def _items(self) -> Sequence[CellItem]:
        raise NotImplementedError

    @property
    def _chosen(self) -> str:
        """The name of the chosen thing; "" for none."""
        return self._local

    def _choose(self, name: str) -> None:
        """Choose another thing to be shown; "" for none."""
        self._local = name
        self.show_cell(self._why_not)

    def _put(self, item: Any, instead_of: str = "") -> Cell:
        """Return the cell with a thing added, or put in the place of another one."""
        return with_part(self._cell, item, instead_of=instead_of)

    def _without(self, name: str) -> Cell:
        """Return the cell without the thing of a name."""
        return without_part(self._cell, self.kind, name)

    def _entry(self, item: CellItem) -> str:
        """Return the entry of a thing in the list."""
        return item.name

    def _proposed(self) -> CellItem | None:
        """Return what the fields show while no thing is chosen; ``None`` empties them."""
        return None

    def _fixed(self) -> str:
        """Return why the chosen thing can be neither changed nor deleted; empty if it can."""
        return ""

    def _is_changed(self, typed: CellItem) -> bool:
        """Return whether the typed thing differs from the chosen one, so that Apply is useful."""
        return self._item is not None and typed != self._item

    # Actions ---------------------------------------------------------------------------------

    @property
    def _item(self) -> Any:
        return part_named(self._items, self._chosen)

    def _change(self, cell: Cell, chosen: str) -> None:
        before, self._local = self._local, chosen
        if not self._answered(self._controller.cell.change(cell)):
            self._local = before
            self.show_cell(self._why_not)

    def _on_change(self, act: str) -> None:
        if act == "apply":
            self._on_apply()
        elif act == "delete":
            before, name = self._cell, self._chosen
            self._deleted = before, self._without(name), name
            self._change(self._deleted[1], "")
        elif act == "restore" and self._deleted is not None:
            self._change(self._deleted[0], self._deleted[2])
        else:
            self._on_add(act)

    def _on_apply(self) -> None:
        typed = self.typed()
        self._change(self._put(typed, self._chosen), typed.name)

    def _on_add(self, _act: str) -> None:
        typed = self.typed()
        self._change(self._put(typed), typed.name)

    def _on_way_chosen(self, place: int) -> None:
        self._ways.setCurrentIndex(place)
        self.show_state(self._controller.state)

    def take_tool_pose(self) -> None:
        """Fill in the tool's pose; for a plane, the allowed side is then behind the tool."""
        pose = self._controller.cartesian.tool_pose(self._controller.state)
        if pose is not None:
            self.take_pose(pose)

    def why_no_tool_pose(self) -> str:
        """Return why the tool's pose cannot be filled in; empty if it can."""
        known = self._controller.cartesian.tool_pose(self._controller.state) is not None
        return "" if known else self.tr("The arm has not reported its pose yet.")

    def take_pose(self, pose: Sequence[float]) -> None:
        """Fill in a pose; it takes effect when the operator applies it."""
        for field, value in zip(self._fields, pose, strict=True):
            field.show_value(value)
        self._show_news()

    def _take_found(self, pose: tuple[float, ...], anew: bool) -> None:
        """Put a pose that was found into the chosen one, or into a new one.

        Args:
            pose: Six figures.
            anew: True to add a new one, even if one is chosen.
        """
        rounded = tuple(round(each, fmt.DECIMALS) for each in pose)
        chosen = self._item
        if chosen is not None and not anew:
            self._change(self._put(replace(chosen, pose=rounded), chosen.name), chosen.name)
            return
        names = {item.name.casefold() for item in self._items}
        numbered = (f"{self._texts().kind} {number}" for number in count(1))
        name = next(each for each in numbered if each.casefold() not in names)
        self._change(self._put(self.kind(name, rounded)), name)

    # Appearance ------------------------------------------------------------------------------

    def show_cell(self, why_not: str) -> None:
        """Show the chosen cell; typed figures stay while the same thing is chosen."""
        self._why_not = why_not
        self._choice.clear()
        self._choice.addItem(self._texts().none, "")
        for each in self._items:
            self._choice.addItem(self._entry(each), each.name)
        item = self._item
        if item is None:
            self._local = ""
        self._choice.setCurrentIndex(max(0, self._choice.findData(self._chosen)))
        self._choice.setEnabled(self._controller.cell.cell is not None)
        if (item,) != self._shown:
            self._shown = (item,)
            self._fill(item or self._proposed())
        if self._search is not None:
            self._search.show_chosen(item, why_not)
        self.show_state(self._controller.state)
        self._show_news()

    def _fill(self, item: Any) -> None:
        """Fill the fields with an item, or empty them for ``None``."""
        self._name.setText("" if item is None else item.name)
        figures = () if item is None else (*item.pose, *getattr(item, "size_mm", ()))
        fields = (*self._fields, *self._sizes)
        for field, value in zip(fields, figures or (None,) * len(fields), strict=False):
            field.show_value(value)

    def show_state(self, _state: ArmState) -> None:
        """Show in the search what the arm's present pose would result in."""
        if self._search is not None and self._search.isVisible():
            self._search.drop_others()
            self._search.show_live()

    def _show_news(self) -> None:
        """Show what is to be done next, highlight its button, and explain disabled ones."""
        for field in self._figures:
            field.show_attention(wanted=field.is_nonsense())
        self.show_acts()
        typed = self.typed()
        new, changed = self._is_new(typed), self._is_changed(typed)
        self._next.setText(self._no_step() or self._guidance(new=new, changed=changed))

    def _guidance(self, *, new: bool, changed: bool) -> str:
        """Return the sentence about the next step, when the cell is in force."""
        return self._next_step(new=new, changed=changed)

    def _is_new(self, typed: CellItem) -> bool:
        """Return whether the typed name is not used yet."""
        names = {item.name.casefold() for item in self._items}
        return bool(typed.name) and typed.name.casefold() not in names

    def _why_no_change(self, act: str) -> Refusal | str | None:
        typed = self.typed()
        if act in self.adds:
            unnamed = "" if typed.name else self.tr("Type a name first.")
            taken = None if self._is_new(typed) else CELL_NAME_TAKEN(value=typed.name)
            return self._why_not or unnamed or taken
        missing = "" if self._item is not None else self._texts().missing
        if act == "restore":
            return self._why_not
        if act == "apply":
            same = missing or self.tr("Nothing is changed.")
            missing = "" if self._is_changed(typed) else same
        return self._why_not or self._fixed() or missing

    def _use_of(self, act: str) -> str:
        texts = self._texts()
        if act == "restore":
            name = "" if self._deleted is None else self._deleted[2]
            return self.tr("Restores “{name}”.").format(name=name)
        adds = dict(zip(self.adds, texts.add, strict=True))
        return adds.get(act) or (texts.apply if act == "apply" else texts.delete)

    def _is_wanted(self, act: str) -> bool:
        """Return whether to highlight a button: the only one that adds, or else Apply."""
        if act in {"delete", "restore"} or not self.changes[act].isEnabled():
            return False
        return not self._is_new(self.typed()) if act == "apply" else len(self.adds) == 1

    def _is_there(self, act: str) -> bool:
        """Return whether to show a button: Restore replaces Delete right after a deletion."""
        deleted = self._deleted
        undoable = self._item is None and deleted is not None and self._cell == deleted[1]
        return undoable if act == "restore" else not undoable or act != "delete"

    def heading(self) -> str:
        """Return the name of one of the items, for a screen reader."""
        return self._texts().kind

    def retranslate_ui(self) -> None:
        """Set all texts in the operator's language."""
        texts = self._texts()
        for label, field, text in (
            (self._choice_label, self._choice, texts.choice),
            (self._name_label, self._name, texts.name),
        ):
            label.setText(text)
            field.setAccessibleName(text)
        for axis, figure in zip(AXES, self._fields, strict=True):
            figure.setAccessibleName(f"{texts.kind} {axis}")
        for edge, figure in zip(EDGES, self._sizes, strict=False):
            text = self.tr("{kind}: edge along {axis}")
            figure.setAccessibleName(text.format(kind=texts.kind, axis=edge))
        self.show_cell(self._why_not)


class ForceTab(NamedTab):
    """A list whose chosen thing is in force: tools or user frames.

    A new one is not chosen by itself: displayed figures and moves would jump. A message says how
    to choose it.
    """

    _added = ""
    """The name of the thing that was added last, if it is not in force."""

    @property
    def _items(self) -> Sequence[CellItem]:
        return getattr(self._cell, f"{self.part}s")  # type: ignore[no-any-return]

    @property
    def _chosen(self) -> str:
        return getattr(self._cell, self.part)  # type: ignore[no-any-return]

    def _choose(self, name: str) -> None:
        self._change(self._with_force(self._cell, name), "")

    def _with_force(self, cell: Cell, name: str) -> Cell:
        changed: dict[str, Any] = {self.part: name}
        return replace(cell, **changed)

    def _put(self, item: Any, instead_of: str = "") -> Cell:
        cell = super()._put(item, instead_of)
        return cell if instead_of else self._with_force(cell, self._chosen)

    def _change(self, cell: Cell, chosen: str) -> None:
        before, self._added = {item.name for item in self._items}, ""
        super()._change(cell, chosen)
        added = [item.name for item in self._items if item.name not in before]
        self._added = next((name for name in added if name != self._chosen), "")
        if self._added:
            self._fill(self._item)
            self._show_news()

    def _guidance(self, *, new: bool, changed: bool) -> str:
        if self._added and not new and not changed:
            return ADDED.text().format(name=self._added)
        if new and self._item is None:
            return self.tr("Press Add. It is in force once it is chosen in the list.")
        return super()._guidance(new=new, changed=changed)

    def show_cell(self, why_not: str) -> None:
        """Show the chosen cell; another one is chosen only while it may be changed."""
        super().show_cell(why_not)
        self._choice.setEnabled(self._choice.isEnabled() and not why_not)

    def _name_ways(self, typed: str, by_points: str) -> None:
        """Set the texts of the two ways to enter a pose."""
        for button, text in zip(self._way.buttons(), (typed, by_points), strict=True):
            caption(button, text)
