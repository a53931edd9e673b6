"""The tab of objects that the hand may hold: boxes and rods, and which one it holds now."""

from __future__ import annotations

from collections.abc import Sequence
from typing import Any

from PySide6.QtWidgets import QLabel, QMenu

from armui.arm.models import model_data
from armui.arm.refusal import Refusal
from armui.cell.held_objects import PAYLOAD_KG, HeldObject
from armui.control.arm_controller import ArmController
from armui.control.cell.cell_control import CellControl, why_not_change
from armui.control.devices.end_reports import EndReports
from armui.protocol.codes import EndLoad
from armui.ui import format as fmt
from armui.ui.actions.act import Act
from armui.ui.actions.command import Command
from armui.ui.panels.cell.cell_tab import NARROW_PX, Answered, figures
from armui.ui.panels.cell.named_tab import EDGES, CellItem, NamedTab, TabTexts
from armui.ui.widgets.buttons import drop_down, give_menu, named
from armui.ui.widgets.layouts import in_row
from armui.ui.widgets.text_label import text_label
from armui.ui.words.arm import END_LOADS
from armui.ui.words.text import Text


class HeldTab(NamedTab):
    """The objects that the hand may hold in the chosen cell; see :class:`NamedTab`."""

    key = "held"
    part = "held"
    listed = "cell_held_object"
    kind = HeldObject
    title = Text("CellPanel", "Held")
    commands = (Command("cell.held_object", Text("HeldTab", "Held object")),)
    changes = NamedTab.changes_of(
        "held",
        add=Text("HeldTab", "Add an object to hold"),
        apply=Text("HeldTab", "Apply the figures of the object"),
        delete=Text("HeldTab", "Delete the object"),
    )
    hold = Act(
        "It is held",
        named="cell_hold",
        does=CellControl.hold,
        whose=True,
        key="cell.hold",
        leads=True,
    )
    touch = Act(
        "May touch…",
        named="cell_held_touch",
        key="cell.held_touch",
        title=Text("HeldTab", "What the held object may touch"),
    )
    load = Act(
        "Tell: {load}",
        named="cell_held_load",
        does=EndReports.set_load,
        tip="Tells the arm its end load; the program never does so by itself.",
        key="cell.held_load",
        title=Text("HeldTab", "Tell the arm the object's load"),
        leads=True,
    )

    def __init__(self, controller: ArmController, answered: Answered) -> None:
        super().__init__(controller, answered)
        self._touched: frozenset[str] = frozenset()
        self._form = drop_down("cell_held_kind")
        self._sizes = [self._figure(f"size_{edge}", 1, "mm") for edge in EDGES]
        self._mass_label = QLabel()
        self._mass = self._figure("mass", 2, "kg")
        self._menu = named("cell_held_touch_menu", QMenu(self.touch))
        give_menu(self.touch, self._menu)
        self._payload = text_label("cell_held_payload", rank="muted", wraps=True)
        for button in (self.hold, self.touch, self.load):
            button.setMinimumWidth(NARROW_PX)
        self._lay_out(
            (self._mass_label, [self._mass, self.touch]),
            beside=([self.hold], [self._form]),
            last=[in_row((self._payload, 1), self.load, spacing=6)],
        )
        self._form.activated.connect(lambda _place: self._show_news())
        self._menu.triggered.connect(self._on_touch)
        self.retranslate_ui()

    @property
    def _items(self) -> Sequence[HeldObject]:
        return self._cell.held_objects

    @property
    def _load_of(self) -> EndLoad:
        """The load of the held object, which the arm should be sent."""
        held = self._cell.held_object
        return EndLoad.EMPTY if held is None else held.load

    @load.pressed
    def _on_load(self) -> None:
        self._answered(self._controller.end_reports.set_load(self._load_of))

    @load.text
    def _load_text(self) -> str:
        return self.tr("Tell: {load}").format(load=END_LOADS.text(self._load_of))

    @hold.pressed
    def _on_hold(self) -> None:
        self._answered(self._controller.cell.hold("" if self._cell.held else self._chosen))

    def _on_touch(self) -> None:
        self._touched = frozenset(
            action.data() for action in self._menu.actions() if action.isChecked()
        )
        self._show_news()

    def typed(self) -> HeldObject:
        """Return the object as typed; an empty field counts as 0, a text as itself."""
        return HeldObject(
            self._name.text().strip(),
            figures(self._fields),
            figures(self._sizes),
            bool(self._form.currentIndex()),
            figures([self._mass])[0],
            tuple(sorted(self._touched)),
        )

    # -- appearance ---------------------------------------------------------------------------

    def show_cell(self, why_not: str) -> None:
        """Show the objects of the chosen cell; at first the held one is chosen."""
        if self._item is None and not self._name.text():
            self._local = self._cell.held
        super().show_cell(why_not)

    def _entry(self, item: CellItem) -> str:
        now = self.tr(" (held)") if item.name == self._cell.held else ""
        return f"{item.name}{now}"

    def _proposed(self) -> HeldObject:
        """Return the proposal for a new object, placed between the fingertips."""
        model = self._controller.operating_state.model
        reach_mm = model_data(model).gripper.reach_mm
        return HeldObject("", (0.0, 0.0, reach_mm, 0.0, 0.0, 0.0))

    def _fill(self, item: Any) -> None:
        super()._fill(item)
        self._mass.show_value(item.mass_kg)
        self._form.setCurrentIndex(int(item.is_rod))
        self._touched = frozenset(item.may_touch)

    def _show_touched(self) -> None:
        zones = [zone.name for zone in self._cell.area.zones]
        self._menu.clear()
        for name in zones:
            action = self._menu.addAction(name)
            action.setData(name)
            action.setCheckable(True)
            action.setChecked(name in self._touched)
        self._touched &= frozenset(zones)

    @touch.text
    def _touch_text(self) -> str:
        count = len(self._touched)
        return self.tr("May touch: {count}").format(count=count) if count else self.tr("May touch…")

    @touch.tip
    def _touch_use(self) -> str:
        named = fmt.listed(sorted(self._touched))
        return named or self.tr("What it may touch: the table, a tray.")

    @touch.why_not
    def _why_no_touch(self) -> str:
        none = self.tr("The work area has no plane or box yet.")
        return "" if self._cell.area.zones else none

    @hold.text
    def _hold_text(self) -> str:
        return self.tr("Put down") if self._cell.held else self.tr("It is held")

    @hold.tip
    def _hold_use(self) -> str:
        if not self._cell.held:
            return self.tr("It counts in every check from now on. The gripper does not move.")
        text = self.tr("“{name}” no longer counts in any check. The gripper does not move.")
        return text.format(name=self._cell.held)

    @hold.why_not
    def _why_not_hold(self) -> Refusal | str | None:
        chosen, why_not = self._item, why_not_change(self._controller.operating_state)
        if self._cell.held:
            return why_not
        if chosen is None:
            return why_not or self._texts().missing
        typing = self.tr("Press Apply first: the figures typed are not in force.")
        return why_not or (typing if self.typed() != chosen else "")

    @hold.lit
    def _is_to_hold(self) -> bool:
        return not self._cell.held

    def _show_news(self) -> None:
        """Show what is to be done next, and highlight its button."""
        self._show_touched()
        super()._show_news()
        is_rod = bool(self._form.currentIndex())
        self._size_label.setText(self.tr("Ø X, Y; length Z") if is_rod else self.tr("Edges"))
        held = self._cell.held_object
        mass = fmt.number(0.0 if held is None else held.mass_kg, 2)
        text = self.tr("In the gripper: {mass} kg. The arm carries {most} kg at most.")
        self._payload.setText(text.format(mass=mass, most=fmt.number(PAYLOAD_KG, 1)))

    def _next_step(self, *, new: bool, changed: bool) -> str:
        held = self._cell.held
        if changed and not new:
            return self.tr("Press Apply to put the new figures in force.")
        if held:
            return self.tr(
                "The gripper holds “{name}”: it counts in every check until Put down."
            ).format(name=held)
        if new:
            return self.tr("Press Add. It counts as soon as it is marked as held.")
        if self._item is not None:
            return self.tr("Press It is held once the gripper has closed on it.")
        return self.tr("Type a name, the middle of the object in the flange, and its edges.")

    def _texts(self) -> TabTexts:
        return TabTexts(
            kind=self.title.text(),
            choice=self.tr("Held object"),
            name=self.tr("Name"),
            none=self.tr("— (a new one)"),
            missing=self.tr("Choose an object above first."),
            apply=self.tr("Puts these figures in the place of those of the chosen object."),
            add=[self.tr("Adds an object of this name.")],
            delete=self.tr("Deletes the chosen object."),
        )

    def retranslate_ui(self) -> None:
        """Set all texts in the operator's language."""
        self._mass_label.setText(self.tr("Mass"))
        self._mass.setAccessibleName(self.tr("Mass"))
        form = self._form.currentIndex()
        self._form.clear()
        self._form.addItems([self.tr("Box"), self.tr("Rod")])
        self._form.setCurrentIndex(max(0, form))
        self._form.setAccessibleName(self.tr("Shape of the held object"))
        super().retranslate_ui()
        self._name.setAccessibleName(self.tr("Name of the held object"))
