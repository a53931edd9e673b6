"""单元: choosing, confirming, changing and exchanging cells: the arm's tools and surroundings."""

from __future__ import annotations

from collections.abc import Callable, Iterable, Mapping
from typing import TYPE_CHECKING, Final

from PySide6.QtWidgets import QButtonGroup, QComboBox, QFrame, QLabel, QLineEdit, QMenu, QWidget

from armui.arm.refusal import Refusal
from armui.arm.state import ArmState
from armui.cell.cell import Cell
from armui.cell.cell_file import SUFFIX, differences
from armui.cell.checks import LONGEST_NAME
from armui.cell.tools import Tool
from armui.control.arm_controller import ArmController
from armui.control.cell.cell_control import CellControl, why_not_change
from armui.control.cell.cell_reasons import CELL_NONE
from armui.control.events import Event, Level
from armui.control.operations.operation import operation_of
from armui.ui import format as fmt
from armui.ui import words
from armui.ui.actions.act import Act, ActFamily, BoundAct, HasActs, toggle_button
from armui.ui.actions.command import Command, Target
from armui.ui.actions.operator_view import why_taken
from armui.ui.dialogs.confirm_dialog import confirm
from armui.ui.dialogs.files import choose_file
from armui.ui.panels.cell.area_tab import AreaTab
from armui.ui.panels.cell.base_tab import BaseTab
from armui.ui.panels.cell.cell_tab import CellTab, CurrentStack
from armui.ui.panels.cell.frames_tab import FramesTab
from armui.ui.panels.cell.gripper_tab import GripperTab
from armui.ui.panels.cell.held_tab import HeldTab
from armui.ui.panels.cell.tools_tab import ToolsTab
from armui.ui.panels.jogging.jog_box import JogBox
from armui.ui.panels.panel import Panel
from armui.ui.widgets.buttons import caption, choice_button, enable_or_explain, give_menu, named
from armui.ui.widgets.layouts import STRETCH, fill, in_column, in_row, scrolled
from armui.ui.words.text import Text, Texts

if TYPE_CHECKING:
    from armui.control.operating_state import OperatingState
    from armui.settings import SettingsStore

TABS: Final[tuple[type[CellTab], ...]] = (
    ToolsTab,
    FramesTab,
    AreaTab,
    HeldTab,
    GripperTab,
    BaseTab,
)
"""The tabs from left to right."""
_NARROW_PX: Final = 60
_MOST_SHOWN: Final = 14
"""The most differences named in a question."""

_LABELS: Final = {
    "confirm": Text("CellPanel", "Confirm cell"),
    "new": Text("CellPanel", "New"),
    "rename": Text("CellPanel", "Rename"),
    "import": Text("CellPanel", "Import…"),
    "export": Text("CellPanel", "Export…"),
    "delete": Text("CellPanel", "Delete"),
}
_DOES: Final[Mapping[str, Callable[..., object]]] = {
    "confirm": CellControl.confirm,
    "new": CellControl.take,
    "rename": CellControl.rename,
    "import": CellControl.take,
    "delete": CellControl.delete,
}
_TITLES: Final = {
    "new": Text("CellPanel", "New cell"),
    "import": Text("CellPanel", "Import a cell"),
    "export": Text("CellPanel", "Export the cell"),
}
_USES: Final = Texts("CellPanel") | {
    "confirm": "The cell shown is that of the arm in front of you; it takes effect.",
    "new": "Makes an empty cell; a tool typed before becomes its first.",
    "rename": "Gives the cell in force and its file the name that is typed.",
    "import": "Reads a cell from a file; says what is different before it takes effect.",
    "export": "Writes the cell to a file of its own.",
    "delete": "Asks first, then deletes the cell and its file.",
}


class CellPanel(Panel):
    """The cell: its choice and confirmation, a tab for each part of it, and the jog buttons.

    Rarely needed actions on cells are folded away, unless there is no cell.

    Args:
        controller: The controller of the arm; it holds the cells.
        preferences: The settings, whose tool becomes the first one of a new cell.
    """

    commands = (
        Command("cell.choose", operation=operation_of(CellControl.choose), presses=False),
        *(Command(f"cell.tab_{tab.key}", tab.title) for tab in TABS),
        *(command for tab in TABS for command in tab.commands),
    )

    buttons = ActFamily(
        {
            name: Act(
                label,
                named=f"cell_{name}_button",
                does=_DOES.get(name),
                tip=_USES.entry(name),
                whose=True,
                key=f"cell.{name}",
                title=_TITLES.get(name),
                leads=name in {"confirm", "new", "rename", "delete"},
                risky=name == "delete",
            )
            for name, label in _LABELS.items()
        }
    )
    compare = Act(
        "Compare",
        named="cell_compare_button",
        tip="Says how another cell of the list differs from the one in force.",
        whose=True,
        key="cell.compare",
        title=Text("CellPanel", "Compare the cell with another"),
    )
    manage = Act(
        "Manage",
        named="cell_manage_button",
        tip="Unfolds what is done with cells: new, rename, import, export, compare, delete.",
        whose=True,
        key="cell.manage",
        title=Text("CellPanel", "Manage the cells"),
        kind=toggle_button,
    )
    jog = Act(
        "Jog",
        named="cell_jog_button",
        tip="Unfolds the jog buttons: poses are taken without leaving the page.",
        whose=True,
        key="cell.jog",
        title=Text("CellPanel", "Jog beside the cell"),
        kind=toggle_button,
    )

    def __init__(self, controller: ArmController, preferences: SettingsStore) -> None:
        super().__init__(controller, "cell_message")
        self._preferences = preferences
        self._choice = named("cell_box", QComboBox())
        self._choice.setMinimumWidth(_NARROW_PX)
        self._name = named("cell_name", QLineEdit(maxLength=LONGEST_NAME))
        self._others = named("cell_compare_menu", QMenu(self.compare))
        give_menu(self.compare, self._others)
        self._name_label = QLabel()
        self._name_label.setBuddy(self._name)
        self._group = QButtonGroup(self)
        self._stack_of_tabs = CurrentStack()
        self._tabs: dict[int, CellTab] = {}
        self._managing = QWidget()
        self._jog_place = QWidget()
        self._jog_box: JogBox | None = None
        self._lay_out()
        self._choice.activated.connect(self._on_chosen)
        self._name.returnPressed.connect(self._on_new)
        self._name.textEdited.connect(lambda _text: self.show_acts())
        self._others.aboutToShow.connect(self._show_others)
        self._others.triggered.connect(lambda action: self._on_compare(action.data()))
        controller.cell_changed.connect(self._on_cell_changed)
        self._listen("cell_", "held_", "load_")
        self.retranslate_ui()

    def _lay_out(self) -> None:
        confirm, new, rename, *files, delete = self.buttons.values()
        for button in (confirm, new, rename):
            button.setMinimumWidth(_NARROW_PX)
        head = in_row(self._title, (self._choice, 1), confirm, self.manage, spacing=8)
        names = in_row(self._name_label, (self._name, 1), new, rename, spacing=6)
        kept = in_row(*((each, 1) for each in (*files, self.compare, delete)), spacing=6)
        in_column(names, kept, on=self._managing, spacing=8, margins=0)
        choice = in_row(spacing=6)
        for place, tab in enumerate(TABS):
            tab_button = choice_button(f"cell_tab_{tab.key}")
            self._group.addButton(tab_button, place)
            tab_button.setProperty("tight", True)
            choice.addWidget(tab_button, 1)
        fill(choice, STRETCH, self.jog)
        self._group.button(0).setChecked(True)
        self._group.idClicked.connect(self._show_tab)
        card = QFrame()
        in_column(self._stack_of_tabs, on=card, spacing=8, margins=(16, 12, 16, 12))
        self._card = scrolled(card)
        in_column(on=self._jog_place, margins=0)
        self._jog_place.hide()
        self._stack(self._managing, choice, self._jog_place, self._card, head=head, gap_px=8)

    def command_targets(self) -> Mapping[str, Target]:
        """Return the target of each command, by the command's name."""
        places = enumerate(TABS)
        tabs = {f"cell.tab_{kind.key}": self._group.button(place) for place, kind in places}
        acts = super().command_targets().items()
        shown = {name: self.manage if self._is_folded(each) else each for name, each in acts}
        return {**shown, "cell.choose": self._choice, **tabs}

    def act_parts(self) -> Iterable[HasActs]:
        """Return the tabs that were created."""
        return self._tabs.values()

    def act_of(self, command: str) -> BoundAct | None:
        """Return the act of a command; if its button is folded away, the act that unfolds it."""
        targets = super().command_targets()
        folded = command in targets and self._is_folded(targets[command])
        return BoundAct(CellPanel.manage, self) if folded else super().act_of(command)

    def _is_folded(self, target: Target) -> bool:
        inside = isinstance(target, QWidget) and self._managing.isAncestorOf(target)
        return inside and self._managing.isHidden()

    def _tab(self) -> CellTab:
        """Return the chosen tab, created at its first use: creating all six would take 0.1 s."""
        place = self._group.checkedId()
        if place not in self._tabs:
            tab = self._tabs[place] = TABS[place](self._controller, self._accepted)
            tab.preferences = self._preferences
            self._stack_of_tabs.addWidget(tab)
        return self._tabs[place]

    def zone_target(self) -> AreaTab | None:
        """Return the tab of the work area if it is chosen, for drags in the picture."""
        tab = self._tabs.get(self._group.checkedId())
        return tab if isinstance(tab, AreaTab) else None

    # -- actions ------------------------------------------------------------------------------

    @manage.pressed
    def _on_manage(self) -> None:
        self._show_managing()

    @jog.pressed
    def _on_jog(self) -> None:
        """Show or hide the jog buttons; hidden ones move nothing."""
        layout = self._jog_place.layout()
        if self._jog_box is None and layout is not None:
            self._jog_box = JogBox(self._controller)
            self._jog_box.refused.connect(self._accepted)
            layout.addWidget(self._jog_box)
        self._jog_place.setVisible(self.jog.isChecked())

    @buttons.pressed
    def _on_pressed(self, name: str) -> None:
        does: dict[str, Callable[[], object]] = {
            "confirm": lambda: self._accepted(self._controller.cell.confirm()),
            "new": self._on_new,
            "rename": self._on_rename,
            "import": self._on_import,
            "export": self._on_export,
            "delete": self._on_delete,
        }
        does[name]()

    def _on_chosen(self, place: int) -> None:
        self._accepted(self._controller.cell.choose(self._choice.itemData(place) or ""))
        self._show_cells()

    def _on_new(self) -> None:
        """Make a new cell, with the tool of the settings, if there is one, as its first tool."""
        pose, name = self._preferences.settings.tool, self._name.text().strip()
        tool = Tool(self.tr("Tool"), pose)
        cell = Cell(name, (tool,), tool.name) if any(pose) else Cell(name)
        if self._accepted(self._controller.cell.take(cell)):
            self._name.clear()
            self.show_acts()

    def _on_rename(self) -> None:
        if self._accepted(self._controller.cell.rename(self._name.text().strip())):
            self._name.clear()
            self.show_acts()

    def _show_others(self) -> None:
        cells = self._controller.cell
        self._others.clear()
        for name in sorted(cells.cells, key=str.casefold):
            if cells.cell is not None and name != cells.cell.name:
                self._others.addAction(name).setData(name)

    def _on_compare(self, name: str) -> None:
        """Show the differences between another cell of the list and the one in force."""
        cells = self._controller.cell
        now, other = cells.cell, cells.cells.get(name)
        if now is None or other is None:
            return
        head = self.tr("In what it differs from “{name}”:").format(name=now.name)
        confirm(
            self.window(),
            self._controller,
            title=self.tr("Compare with “{name}”").format(name=name),
            text="\n".join((head, *self._differing(now, other))),
            action_label=self.tr("Choose it"),
            on_confirmed=lambda: self._accepted(cells.choose(name)),
            still=lambda: (cells.cell, cells.cells.get(name)) == (now, other),
        )

    def _differing(self, one: Cell, other: Cell) -> list[str]:
        """Return the lines of the first differences between two cells."""
        differing = [
            f"{each.place}: {_shown(each.before)} → {_shown(each.after)}"
            for each in differences(one, other)
        ]
        lines = differing[:_MOST_SHOWN] or [self.tr("They are the same.")]
        if len(differing) > len(lines):
            more = self.tr("… and {count} more")
            lines.append(more.format(count=len(differing) - len(lines)))
        return lines

    def _on_delete(self) -> None:
        cell = self._controller.cell.cell
        if cell is None:
            self._accepted(self._controller.cell.delete())
            return
        confirm(
            self.window(),
            self._controller,
            title=self.tr("Delete the cell"),
            text=self.tr(
                "“{name}” with everything in it is deleted, and no cell is in force then. Export "
                "it first if it may be wanted again."
            ).format(name=cell.name),
            action_label=self.tr("Delete"),
            on_confirmed=lambda: self._accepted(self._controller.cell.delete()),
            still=lambda: self._controller.cell.cell == cell,
        )

    def _on_export(self) -> None:
        cell, store = self._controller.cell.cell, self._controller.cell.store
        if cell is None or store is None:
            self._accepted(CELL_NONE())
            return
        choose_file(
            self.window(),
            self._controller,
            title=self.tr("Export the cell"),
            name_filter=f"{self.tr('Cell')} (*{SUFFIX})",
            on_chosen=lambda path: store.write(path, cell, self._accepted),
            new_file=f"{cell.name}{SUFFIX}",
        )

    def _on_import(self) -> None:
        store = self._controller.cell.store
        if store is None:
            return
        choose_file(
            self.window(),
            self._controller,
            title=self.tr("Import a cell"),
            name_filter=f"{self.tr('Cell')} (*{SUFFIX})",
            on_chosen=lambda path: store.read(path, self._on_read),
        )

    def _on_read(self, cell: Cell | Refusal) -> None:
        """Ask before importing a cell; show how it differs from the replaced or chosen one."""
        if isinstance(cell, Refusal):
            self._accepted(cell)
            return
        cells = self._controller.cell
        same = cells.cells.get(cell.name)
        other = same or cells.cell or Cell("")
        lines = self._differing(other, cell)
        if cell.name in cells.broken:
            head = self.tr(
                "It takes the place of the file of this name that could not be read, which is put "
                "aside. What it holds:"
            )
            lines = self._differing(Cell(""), cell)
        elif same is not None:
            head = self.tr("It takes the place of the cell of this name. What changes:")
        elif other.name:
            head = self.tr("In what it differs from “{name}”:").format(name=other.name)
        else:
            head = self.tr("What it holds:")
        confirm(
            self.window(),
            self._controller,
            title=self.tr("Import the cell “{name}”").format(name=cell.name),
            text="\n".join((head, *lines)),
            action_label=self.tr("Import"),
            on_confirmed=lambda: self._take_over(cell),
            still=lambda: cells.cells.get(cell.name) == same,
        )

    def _take_over(self, cell: Cell) -> None:
        self._accepted(self._controller.cell.take(cell, replacing=True))

    # -- appearance ---------------------------------------------------------------------------

    def _on_cell_changed(self, _cell: object) -> None:
        if self.isVisible():
            self._show_all()

    def _show_tab(self, _place: int) -> None:
        self._card.verticalScrollBar().setValue(0)
        self._refusal = self._event = None
        self._show_all()

    def _show_state(self, state: ArmState) -> None:
        self._tab().show_state(state)

    def _forget_outdated(self, old: OperatingState) -> None:
        if old.device != self._operating_state.device:
            self._refusal = self._event = None

    def _show_all(self) -> None:
        self._show_cells()
        self.show_acts()
        self._show_managing()
        taken = why_taken("", operation_of(CellControl.change))
        why_not = taken or words.why_not(self._why_not_change())
        self._stack_of_tabs.setCurrentWidget(self._tab())
        self._tab().show_cell(why_not)
        self._show_message()

    def _why_not_change(self) -> Refusal | None:
        unconfirmed = self._controller.cell.unconfirmed
        return why_not_change(self._operating_state) or unconfirmed or self._why_no_cell()

    def _show_cells(self) -> None:
        cells = self._controller.cell
        names = ["", *sorted({*cells.cells, *cells.broken}, key=str.casefold)]
        shown = [self._choice.itemData(place) for place in range(self._choice.count())]
        if names != shown:
            self._choice.clear()
            for name in names:
                self._choice.addItem(name or self.tr("— (no cell)"), name)
        chosen = "" if cells.cell is None else cells.cell.name
        self._choice.setCurrentIndex(max(0, self._choice.findData(chosen)))
        taken = why_taken("", operation_of(CellControl.choose))
        why_not = taken or words.why_not(why_not_change(self._operating_state))
        use = self.tr("Puts another cell in force, or none; that confirms it, too.")
        enable_or_explain(self._choice, why_not, use)

    def _show_managing(self) -> None:
        """Show the rarely needed actions if they are unfolded, or if there is no cell."""
        self._managing.setVisible(self.manage.isChecked() or self._controller.cell.cell is None)

    @buttons.why_not
    def _why_not_press(self, name: str) -> Refusal | str | None:
        cells, none = self._controller.cell, self._why_no_cell()
        if name == "export":
            return none
        no_change = why_not_change(self._operating_state)
        done = self.tr("Nothing is to be confirmed: the cell is in force, or there is none.")
        unnamed = "" if self._is_named() else self.tr("Type a name first.")
        reasons: dict[str, Refusal | str | None] = {
            "confirm": "" if self._waits() else done,
            "new": unnamed,
            "rename": none or unnamed,
            "import": done if cells.store is None else "",
            "delete": none,
        }
        return no_change or reasons[name]

    @buttons.lit
    def _is_wanted(self, name: str) -> bool:
        return self._waits() if name == "confirm" else name == "new" and self._is_named()

    @compare.why_not
    def _why_no_comparing(self) -> Refusal | str | None:
        alone = self.tr("There is no other cell.")
        return self._why_no_cell() or ("" if len(self._controller.cell.cells) > 1 else alone)

    def _why_no_cell(self) -> Refusal | None:
        return CELL_NONE() if self._controller.cell.cell is None else None

    def _waits(self) -> bool:
        """Return whether the cell shown waits to be confirmed."""
        cells = self._controller.cell
        return cells.unconfirmed is not None and cells.cell is not None

    def _is_named(self) -> bool:
        return bool(self._name.text().strip())

    def _on_noticed(self, event: Event) -> None:
        """Do not repeat a success here: the status bar shows it, and the tab its result."""
        super()._on_noticed(event)
        if self._event is event and event.level is Level.INFO:
            self._event = None
            self._show_message()

    def _show_message(self) -> None:
        refusal = self._refusal
        if refusal is None and self._event is None:
            refusal = self._unless_told(self._operating_state.unconfirmed_cell)
        self._show_outcome(refusal, self._event)

    def retranslate_ui(self) -> None:
        """Set all texts in the operator's language."""
        self._title.setText(self.tr("Cell"))
        self._choice.setAccessibleName(self.tr("Chosen cell"))
        self._name_label.setText(self.tr("Cell's name"))
        self._name.setAccessibleName(self.tr("Cell's name"))
        for place, tab in enumerate(TABS):
            caption(self._group.button(place), tab.title.text())
        self._choice.clear()
        self._show_all()


def _shown(value: object) -> str:
    """Return a parameter's value as text for a list of differences; «—» for none."""
    if value is None or value == "":
        return fmt.NOTHING
    return f"{value:g}" if isinstance(value, float) else str(value)
