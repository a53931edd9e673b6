"""The common part of 关节设置, 配速设置 and 碰撞等级: read, edit, save, and check the result."""

from __future__ import annotations

from collections.abc import Callable, Sequence
from dataclasses import dataclass
from itertools import pairwise
from typing import ClassVar, Final

from PySide6.QtCore import Qt, QTimer
from PySide6.QtGui import QHideEvent, QKeyEvent, QShowEvent
from PySide6.QtWidgets import QFrame

from armui.arm.device import Device
from armui.arm.models import model_data
from armui.arm.parameters import Parameter, factory_bound, reading_of
from armui.arm.refusal import Refusal
from armui.arm.state import Reading
from armui.control.arm_controller import ArmController
from armui.control.events import Level
from armui.control.operating_state import BUSY, OperatingState
from armui.control.operations.started import SETTING_NOT_READ_BACK, SETTING_UNANSWERED
from armui.control.parameters.arm_settings import ArmSettings
from armui.control.parameters.setting_cell import CellState
from armui.control.parameters.setting_checks import SETTING_NOT_TAKEN, batches_of
from armui.control.parameters.setting_draft import CellStatus, SettingDraft, shown_as
from armui.control.parameters.setting_saving import SettingSaving
from armui.ui import format as fmt
from armui.ui import words
from armui.ui.actions.act import Act, ActFamily
from armui.ui.actions.command import no_reason, while_editing
from armui.ui.actions.keys import key_text
from armui.ui.dialogs.confirm_dialog import confirm
from armui.ui.panels.panel import Panel, level_of
from armui.ui.panels.parameters.setting_cell import SettingCell
from armui.ui.widgets.layouts import in_row, scrolled
from armui.ui.words.parameters import (
    beyond_danger,
    beyond_factory,
    beyond_word,
    full_name,
    span_text,
    status_explained,
    status_word,
    value_text,
)
from armui.ui.words.text import Text, Texts, listed

_LABELS: Final = Texts("ParameterButtons") | {
    "read": "Read",
    "reset": "Initialise",
    "edit": "Edit",
    "cancel": "Cancel",
    "save": "Save",
}
_HEIGHT_PX: Final = 38
_GAP_PX: Final = 10
_LEVELS: Final = {
    SETTING_NOT_TAKEN: Level.FAULT,
    SETTING_UNANSWERED: Level.FAULT,
    SETTING_NOT_READ_BACK: Level.FAULT,
}


@dataclass(frozen=True, slots=True)
class _Message:
    """A text and how much it matters."""

    text: str
    level: Level = Level.INFO


class ParameterPanel(Panel):
    """Shows the arm's parameters, and lets the operator enter others and save them.

    They are read whenever the panel is shown, and when the arm comes online meanwhile. Fields are
    locked until 【编辑】; entries stay until the arm holds them, or they are discarded.

    Args:
        controller: The controller of the arm.
        name: The first part of the buttons' names: ``<name>_save_button``.
        cells: A cell for each parameter, in the order of the Tab key.
        open_backup: Opens 参数备份.

    Attributes:
        buttons: By their acts; 【编辑】 and 【取消】 share a place, as only one makes sense.
    """

    buttons: ClassVar[ActFamily[str]]

    @classmethod
    def buttons_of(cls, place: str, reset: Callable[..., object] | None = None) -> ActFamily[str]:
        """Return the buttons of a panel of parameters.

        Args:
            place: The key of the panel, and the first part of the buttons' names.
            reset: The operation that restores the factory values; ``None`` without 【初始化】.
        """
        read, save = ArmSettings.read, ArmSettings.save
        does: dict[str, Callable[..., object]] = {"read": read, "edit": read, "save": save}
        if reset is not None:
            does["reset"] = reset
        acts = {
            act: Act(
                _LABELS.entry(act),
                named=f"{place}_{act}_button",
                does=does.get(act),
                key=f"{place}.{act}",
                shortcut="parameters.save" if act == "save" else "",
                title=_LABELS.entry(act),
                needs=while_editing if act in ("cancel", "save") else no_reason,
                least_height_px=_HEIGHT_PX,
            )
            for act in _LABELS
            if act != "reset" or reset is not None
        }
        backup = Text("ParameterPanel", "Backup…")
        acts["backup"] = Act(backup, named=f"{place}_backup_button", flat=True)
        buttons = ActFamily(acts)
        buttons.pressed(cls._on_pressed)
        buttons.why_not(cls._why_not_press)
        buttons.tip(cls._use_of)
        buttons.lit(cls._is_recommended)
        return buttons

    def __init__(
        self,
        controller: ArmController,
        name: str,
        cells: Sequence[SettingCell],
        open_backup: Callable[[], object],
    ) -> None:
        super().__init__(controller, f"{name}_message")
        self._settings = controller.settings
        self._cells = {cell.parameter: cell for cell in cells}
        self._draft = SettingDraft(list(self._cells))
        self._saving = SettingSaving(self._settings, self._draft)
        self._then: Callable[[], object] | None = None
        self._batches = batches_of(self._cells)
        self._ready = False
        self._device: Device | None = None
        self._open_backup = open_backup

    def finish(self, card: QFrame) -> None:
        """Lay the panel out around its card; the last step of the constructor.

        Args:
            card: Holds the cells.
        """
        head = in_row((self._title, 1), self.buttons["backup"])
        row = ((button, 1) for act, button in self.buttons.items() if act != "backup")
        self._stack(scrolled(card), in_row(*row, spacing=_GAP_PX), head=head)
        for before, after in pairwise(cell.focus_widget for cell in self._cells.values()):
            self.setTabOrder(before, after)
        self._connect()
        self._on_operating_state_changed(self._controller.operating_state)
        self.retranslate_ui()

    def _connect(self) -> None:
        for cell in self._cells.values():
            cell.edited.connect(lambda cell=cell: self._on_edited(cell))
        self._settings.changed.connect(self._on_settings_changed)
        self._controller.operating_state_changed.connect(self._on_operating_state_changed)
        self._controller.step_changed.connect(self._on_step_changed)

    # -- what a panel of its own adds ---------------------------------------------------------

    def title(self) -> str:
        """Return the title of the panel."""
        raise NotImplementedError

    def reset_question(self) -> tuple[str, str]:
        """Return title and text of the question before 【初始化】."""
        return "", ""

    def why_no_reset(self) -> str:
        """Return why 【初始化】 is missing for this arm; empty if it is not."""
        return ""

    def reset_to_factory(self) -> Refusal | None:
        """Have the arm restore its factory values."""
        return None

    def danger(self) -> str:
        """Return a warning about the present or entered values; empty if none is needed."""
        return self._beyond()

    def danger_of_saving(self) -> str:
        """Return a warning to be confirmed before saving; empty if none is needed."""
        beyond = self._beyond()
        return f"{beyond}\n{beyond_danger()}" if beyond else ""

    def _bound(self, parameter: Parameter, value: float) -> float | None:
        """Return the factory value of this model that a value exceeds, or ``None``."""
        return factory_bound(parameter, value, model_data(self._operating_state.model))

    def _beyond(self) -> str:
        """Return a line for each entry that exceeds the factory's value."""
        return "\n".join(
            beyond_factory(parameter, value, bound)
            for parameter, value in self._draft.changes().items()
            if (bound := self._bound(parameter, value)) is not None
        )

    # -- leaving ------------------------------------------------------------------------------

    def has_unsaved_changes(self) -> bool:
        """Return whether there are entries that the arm does not hold."""
        return self._draft.changed

    def discard_changes(self) -> None:
        """Discard the entries."""
        self._draft.end_editing()
        self._saving.forget_outcome()
        self._then = None
        self._refusal = None
        self._settings.settle(self._cells)
        self._show_all()

    def why_no_saving(self) -> str:
        """Return why the entries cannot be saved now; empty if they can."""
        wrong = self._draft.first_wrong(self._controller.state)
        return self._no_way() or words.why_not(self._controller.operating_state.occupied or wrong)

    def save_changes(self, then: Callable[[], object]) -> None:
        """Save the entries as 【保存】 does, and go on once all of them have been read back.

        If the arm does not accept an entry, it stays with the reason below it, and ``then`` is not
        called.
        """
        self._save(then)

    def focus_joint(self, joint: int) -> None:
        """Focus the first value of a joint."""
        for parameter, cell in self._cells.items():
            if parameter.joint == joint:
                cell.focus_widget.setFocus(Qt.FocusReason.OtherFocusReason)
                return

    # -- actions ------------------------------------------------------------------------------

    def _on_pressed(self, act: str) -> None:
        does: dict[str, Callable[[], object]] = {
            "read": self._on_read,
            "reset": self._on_reset,
            "edit": self._on_edit,
            "cancel": self._on_cancel,
            "save": self._save,
            "backup": self._open_backup,
        }
        does[act]()

    def _on_read(self) -> None:
        self._saving.forget_outcome()
        self._settings.settle(self._cells)
        self._refusal = self._settings.read(self._batches)
        self._show_all()

    def _on_edit(self) -> None:
        self._saving.forget_outcome()
        self._refusal = None
        self._settings.settle(self._cells)
        self._draft.begin_editing()
        self._show_all()
        next(iter(self._cells.values())).focus_widget.setFocus(Qt.FocusReason.TabFocusReason)

    def _on_cancel(self) -> None:
        self.discard_changes()
        self.buttons["edit"].setFocus()

    def _on_edited(self, cell: SettingCell) -> None:
        self._refusal = None
        self._draft.enter(self._controller.state, cell.parameter, cell.text, cell.value)
        self._settings.settle([cell.parameter])
        self._show_all()

    def _save(self, then: Callable[[], object] | None = None) -> None:
        """Save, after a question if a value is dangerous; then call ``then``."""
        danger, changes = self.danger_of_saving(), self._draft.changes()
        if danger:
            confirm(
                self,
                self._controller,
                title=self.title(),
                text=danger,
                action_label=self.buttons["save"].text(),
                on_confirmed=lambda: self._save_now(then),
                hold=True,
                still=lambda: self._draft.changes() == changes,
            )
        else:
            self._save_now(then)

    def _save_now(self, then: Callable[[], object] | None) -> None:
        self._then = then
        self._refusal = self._saving.begin(self._controller.state)
        if self._refusal is not None:
            self._stay()
        self._show_all()

    def _go_on(self) -> None:
        """Continue the operator's way out of the panel if the arm now holds all entries."""
        then = self._then
        if self._draft.changed:
            self._stay()
        elif then is not None:
            self._then = None
            # from the event loop: it may delete the object whose signal is being handled
            QTimer.singleShot(0, self, then)

    def _stay(self) -> None:
        """Do not leave the panel, and bring its window to the front with the reason."""
        if self._then is not None:
            self._then = None
            self.window().raise_()
            self.window().activateWindow()

    def _on_reset(self) -> None:
        title, text = self.reset_question()
        confirm(
            self,
            self._controller,
            title=title,
            text=text,
            action_label=self.buttons["reset"].text(),
            on_confirmed=self._reset_now,
        )

    def _reset_now(self) -> None:
        self._saving.forget_outcome()
        self._refusal = self.reset_to_factory()
        self._show_all()

    def keyPressEvent(self, event: QKeyEvent) -> None:
        """Discard the entries at Escape."""
        if event.key() == Qt.Key.Key_Escape and self._draft.editing:
            self.buttons["cancel"].click()
        else:
            super().keyPressEvent(event)

    # -- what the arm says --------------------------------------------------------------------

    def _on_settings_changed(self) -> None:
        if self._saving.ended():
            self._go_on()
        if self.isVisible():
            self._show_all()

    def _on_operating_state_changed(self, operating_state: OperatingState) -> None:
        self._operating_state = operating_state
        if operating_state.device is not None and operating_state.device != self._device:
            # another arm: entries for the last one must not be saved in it
            self._device = operating_state.device
            self.discard_changes()
        ready = operating_state.unreachable is None and operating_state.generation is not None
        came_online, self._ready = ready and not self._ready, ready
        if self.isVisible():
            if came_online:
                self._read_anew()
            self._show_all()

    def _read_anew(self) -> None:
        if self._ready and not self._draft.changed:
            self._settings.read(self._batches)

    def _why_not_here(self) -> Refusal | None:
        """Return why nothing can be read or saved: no arm, or one without such parameters."""
        return self._operating_state.unreachable or self._settings.why_not_kept(self._batches)

    def _no_way(self) -> str:
        """Return why nothing can be read or saved, or that a request is under way; else ""."""
        refusal = self._why_not_here()
        if refusal is None and self._settings.busy:
            refusal = BUSY(what="settings")
        return words.why_not(refusal)

    # -- appearance ---------------------------------------------------------------------------

    def _show_all(self) -> None:
        for cell in self._cells.values():
            self._show_cell(cell)
        self._show_possible()
        self._show_message()

    def _show_cell(self, cell: SettingCell) -> None:
        parameter, state = cell.parameter, self._controller.state
        stands = self._settings.cell(parameter)
        known = reading_of(state, parameter)
        if self._draft.entry(parameter) is None:
            cell.show_value(None if known is None else known.value)
        cell.set_locked(locked=not self._draft.editing or self._saving.running)
        cell.setEnabled(self._operating_state.unreachable is None or self._draft.editing)
        status = self._draft.status(state, parameter, stands)
        held = fmt.NOTHING if known is None else value_text(parameter.name, known.value)
        bound = None if cell.value is None else self._bound(parameter, cell.value)
        word = self._word(cell, status, known)
        if bound is not None and status in (CellStatus.READ, CellStatus.CHANGED):
            word = beyond_word(parameter.name, bound)
        cell.show_status(status, word, beyond=bound is not None)
        reason = self._draft.why_wrong(state, parameter) or stands.refusal
        message = status_explained(status, held) if reason is None else words.refusal(reason)
        too_far = "" if bound is None else beyond_factory(parameter, cell.value or 0.0, bound)
        lines = (full_name(parameter), span_text(parameter.name), too_far, message)
        cell.describe(full_name(parameter), "\n".join(line for line in lines if line))

    def _word(self, cell: SettingCell, status: CellStatus, known: Reading[float] | None) -> str:
        """Return the text below a value."""
        if status is not CellStatus.CHANGED:
            return status_word(status) or self.remark(cell)
        held = None if known is None else known.value
        decimals = cell.parameter.kind.decimals
        return self.tr("was {held}").format(held=fmt.number(held, decimals))

    def remark(self, _cell: SettingCell) -> str:
        """Return the text below a value that has no other state."""
        return ""

    def _show_possible(self) -> None:
        """Show the button that ends editing, or the one that begins it; and what can be used."""
        # hide first: a row with both buttons would widen the panel for a moment
        going, coming = ("edit", "cancel") if self._draft.editing else ("cancel", "edit")
        self.buttons[going].hide()
        self.buttons[coming].show()
        self.show_acts()

    def _why_not_press(self, act: str) -> str:
        if act == "backup":
            return ""
        if act == "cancel":
            answer = self.tr("The arm is being asked; wait for its answer.")
            return answer if self._saving.running else ""
        no_way = self._no_way()
        if act == "save":
            unwanted = "" if self._draft.changed else self.tr("Nothing has been changed.")
            return no_way or unwanted or self.why_no_saving()
        if act == "reset":
            not_now = words.why_not(self._controller.operating_state.occupied)
            first = self.tr("Save or cancel your changes first.") if self._draft.editing else ""
            return no_way or not_now or self.why_no_reset() or first
        return no_way

    def _is_recommended(self, act: str) -> bool:
        """Return whether to highlight a button: Save, or Edit if a value is corrupt."""
        return act == "save" or (act == "edit" and bool(self._corrupt()))

    def _corrupt(self) -> list[Parameter]:
        state, draft = self._controller.state, self._draft
        return [
            parameter
            for parameter in draft.parameters
            if draft.status(state, parameter, self._settings.cell(parameter)) is CellStatus.CORRUPT
        ]

    def _use_of(self, act: str) -> str:
        give_up = self.tr("Shows what the arm holds again.")
        uses = {
            "read": self.tr("Reads the values from the arm."),
            "reset": self.reset_question()[0],
            "edit": self.tr("Lets you change the values; nothing is sent."),
            "cancel": f"{give_up} ({key_text('parameters.cancel')})",
            "save": self.tr("Sends what was changed, reads it back and compares."),
            "backup": self.tr("All parameters of the arm: save them to a file, compare, restore."),
        }
        return uses[act]

    def _show_message(self) -> None:
        occupied = self._controller.operating_state.occupied if self._draft.editing else None
        message = self._current_message(
            self._refusal or self._unless_told(self._why_not_here()) or occupied
        )
        self._message.show_message(message.text, message.level)
        self._share_room()

    def _current_message(self, refusal: Refusal | None) -> _Message:
        """Return the one message: a refusal, an invalid entry, a danger, or that all is saved."""
        state, cell, draft = self._controller.state, self._settings.cell, self._draft
        reasons = (cell(parameter).refusal for parameter in draft.parameters)
        first = (
            refusal
            or draft.first_wrong(state)
            or next((reason for reason in reasons if reason is not None), None)
        )
        if first is not None:
            return _Message(words.refusal(first), _LEVELS.get(first.reason, level_of(first)))
        if corrupt := self._corrupt():
            names = listed(full_name(parameter) for parameter in corrupt)
            reason = status_explained(CellStatus.CORRUPT, "")
            text = self.tr("{names}: {reason}").format(names=names, reason=reason)
            return _Message(text, Level.FAULT)
        danger, asked = self.danger(), self._saving.asked
        if danger:
            return _Message(danger, Level.WARNING)
        if asked and all(cell(parameter).state is CellState.SAVED for parameter in asked):
            return self._saved()
        return _Message("")

    def _saved(self) -> _Message:
        """Return the message after saving, with the values that the arm has rounded."""
        nearest = [
            f"{full_name(parameter)} {value_text(parameter.name, known.value)}"
            for parameter, value in self._saving.asked.items()
            if (known := reading_of(self._controller.state, parameter)) is not None
            and shown_as(parameter, known.value) != shown_as(parameter, value)
        ]
        if not nearest:
            return _Message(self.tr("Saved; reading back gave the same values."), Level.DONE)
        text = self.tr("Saved. The arm stores coarser steps; it holds the nearest: {values}.")
        return _Message(text.format(values=listed(nearest)), Level.DONE)

    def retranslate_ui(self) -> None:
        """Set all texts in the operator's language."""
        self._title.setText(self.title())
        self._show_all()

    def showEvent(self, event: QShowEvent) -> None:
        """Read the arm's values."""
        self._read_anew()
        super().showEvent(event)

    def hideEvent(self, event: QHideEvent) -> None:
        """Clear the result of the last saving."""
        super().hideEvent(event)
        if not self._draft.changed:
            self.discard_changes()
