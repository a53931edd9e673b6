"""Sets up an adapter by a click, and shows progress and result, without blocking the window."""

from __future__ import annotations

from collections.abc import Callable, Sequence
from functools import partial
from typing import Final, Protocol

from PySide6.QtCore import Qt, QTimer, Signal
from PySide6.QtWidgets import QLabel, QLineEdit, QPlainTextEdit, QWidget

from armui.arm.device import Device
from armui.arm.refusal import Refusal
from armui.control.arm_controller import ArmController
from armui.control.events import Level
from armui.control.link.adapter_use import why_not_switch
from armui.doctor.adapter_change import (
    ADAPTER_NOT_AUTHORISED,
    BY_ANYBODY,
    BY_ROOT,
    AdapterChange,
    Answer,
    Done,
    Planned,
    helper_is_there,
)
from armui.doctor.facts import Diagnosis, Section
from armui.doctor.judge_heard import ARM
from armui.doctor.process import DoctorProcess
from armui.ui import words
from armui.ui.actions.act import Act
from armui.ui.dialogs.base import ArmDialog, CloseButton
from armui.ui.dialogs.finding_row import WORDS, Remedy
from armui.ui.widgets.buttons import named, push_button
from armui.ui.widgets.layouts import STRETCH, fill, in_row
from armui.ui.widgets.message_line import MessageLine, Words
from armui.ui.widgets.text_label import text_label
from armui.ui.widgets.translated import Translated

_LISTEN_MS: Final = 2000
"""The time in which frames are counted after a change of the adapter."""
_TYPED_MS: Final = 300
"""The delay after a key, so that a plan is not requested for each letter of the name."""
_SIZE_PX: Final = (720, 520)


class HelperRun(Protocol):
    """A change in progress that can be started and cancelled."""

    def go(self) -> None:
        """Carry out the plan that was made."""

    def end(self) -> None:
        """Cancel the change."""


Begin = Callable[[Sequence[str], Callable[[Answer], object], Sequence[str]], HelperRun]
"""Starts a change; see :class:`armui.doctor.adapter_change.AdapterChange`."""


class Examination(Protocol):
    """An examination in progress that can be cancelled."""

    def end(self) -> None:
        """Cancel the examination."""


Examine = Callable[[Sequence[str], Callable[[list[Diagnosis] | str], object]], Examination]
"""Starts an examination; see :class:`armui.doctor.process.DoctorProcess`."""


class AdapterLine(Translated, QWidget):
    """A line shown while the adapter's helper works, and until its result was read.

    Args:
        controller: Gives the state of the arm on that adapter.
        begin: Starts a change.
        examine: Examines the adapter afterwards to check the result.
        is_there: Returns whether the helper can be used; called after an examination, whose thread
            has read the disk.

    Attributes:
        listens_elsewhere: Returns whether the owner listens to an interface at `changed`, and calls
            `show_heard` then: two programs that read one adapter take each other's frames.

    Signals:
        changed: The helper has changed something: earlier findings are outdated.
    """

    changed = Signal()
    _answered = Signal(object, object)
    _heard = Signal(object, object)

    def __init__(
        self,
        controller: ArmController,
        begin: Begin = AdapterChange,
        examine: Examine = DoctorProcess,
        is_there: Callable[[], bool] = helper_is_there,
    ) -> None:
        super().__init__()
        self._controller = controller
        self._begin = begin
        self._examine = examine
        self._helper_is_there = is_there
        self._forbidden = False
        self._number = 0
        self._remedy: Remedy = ()
        self._shown: Planned | None = None
        self._change: HelperRun | None = None
        self._listening: Examination | None = None
        self._waits_for = ""
        self.listens_elsewhere: Callable[[str], bool] = lambda _interface: False
        self._frames = 0
        self._line = named("adapter_message", MessageLine())
        self.cancel_button = push_button("adapter_cancel", on_enter=False)
        in_row((self._line, 1), self.cancel_button, on=self, spacing=8, margins=0)
        self.cancel_button.clicked.connect(self.cancel)
        # queued: an answer comes in another thread
        self._answered.connect(self._on_answered, Qt.ConnectionType.QueuedConnection)
        self._heard.connect(self._on_heard, Qt.ConnectionType.QueuedConnection)
        self.retranslate_ui()
        self.hide()

    def retranslate_ui(self) -> None:
        """Set all texts in the operator's language."""
        self.cancel_button.setText(self.tr("Cancel"))

    def text(self) -> str:
        """Return the message as shown."""
        return self._line.text()

    def is_there(self) -> bool:
        """Return whether a button is useful; if the system forbids it, commands are shown."""
        return not self._forbidden and self._helper_is_there()

    # What the operator does -------------------------------------------------------------------

    def choose(self, remedy: Remedy) -> None:
        """Carry out a remedy, after showing the files that it would write or remove."""
        if remedy[0] in {"remember", "forget"}:
            KeepDialog(self._controller, self.window(), remedy, self.start, self._begin).open()
        else:
            self.start(remedy)

    def start(self, remedy: Remedy, shown: Planned | None = None) -> None:
        """Start a remedy; the system asks for the password.

        Args:
            remedy: The verb and its arguments.
            shown: The plan that the operator has seen; another plan is not carried out.
        """
        if self._change is not None:
            return
        self._end_listening()
        refusal = why_not_switch(remedy[0], remedy[1], self._controller.operating_state)
        if refusal is not None:
            self._show_message(partial(words.refusal, refusal), Level.WARNING)
            return
        self._number += 1
        number = self._number
        self._remedy, self._shown = remedy, shown
        self._show_message(self.tr("The system asks for the administrator's password…"), busy=True)
        self._change = self._begin(
            remedy, lambda answer: self._answered.emit(number, answer), BY_ROOT
        )

    def cancel(self) -> None:
        """Cancel; a change that has begun is completed."""
        if self._change is not None:
            self._change.end()
            self._change = None
            self._show_message(self.tr("Cancelled. The system finishes what had begun."))
        self._end_listening()
        self._number += 1
        self.cancel_button.hide()

    # Results of background work ---------------------------------------------------------------

    def _on_answered(self, number: int, answer: Answer) -> None:
        if number != self._number or self._change is None:
            return
        if isinstance(answer, Planned):
            self._on_planned(answer)
            return
        self._change = None
        if isinstance(answer, Refusal):
            self._forbidden = answer.reason == ADAPTER_NOT_AUTHORISED
            self._show_message(partial(words.refusal, answer), Level.FAULT)
            self.changed.emit()
            return
        self._on_done(answer)

    def _on_planned(self, planned: Planned) -> None:
        """Carry out the plan, unless arm or adapter have changed while the password was typed."""
        verb, subject = self._remedy[:2]
        refusal = why_not_switch(verb, subject, self._controller.operating_state)
        changed = self._shown is not None and self._shown != planned
        if refusal is None and not changed and self._change is not None:
            self._show_message(self.tr("Under way…"), busy=True)
            self._change.go()
            return
        self.cancel()
        if refusal is not None:
            self._show_message(partial(words.refusal, refusal), Level.WARNING)
        else:
            said = self.tr("The adapter is not the one that was shown: nothing was written.")
            self._show_message(said, Level.WARNING)

    def _on_done(self, done: Done) -> None:
        verb, subject = self._remedy[:2]
        if verb in {"up", "reset"}:
            self._listen(subject)
        elif verb == "down":
            said = self.tr("{channel} is switched off.").format(channel=subject)
            self._show_message(said, Level.DONE)
        elif done.result.get("not_told"):
            said = self.tr("Done; it takes effect at the next start of this computer.")
            self._show_message(said, Level.DONE)
        else:
            said = self.tr("Done; it takes effect when the adapter is plugged in again.")
            self._show_message(said, Level.DONE)
        self.changed.emit()

    def _listen(self, interface: str) -> None:
        """Listen to the interface: only received frames prove that it works."""
        said = self.tr("{channel} is switched on; listening whether anything is heard…")
        self._show_message(said.format(channel=interface), busy=True)
        number = self._number
        device = self._controller.operating_state.device
        if device is not None and str(device.channel) == interface:
            self._frames = self._controller.state.frames
            QTimer.singleShot(_LISTEN_MS, self, lambda: self._count(number, interface))
            return
        if self.listens_elsewhere(interface):
            self._waits_for = interface
            return
        self._listening = self._examine(
            ["--interface", "socketcan", "--channel", interface],
            lambda findings: self._heard.emit(number, findings),
        )

    def _count(self, number: int, interface: str) -> None:
        if number != self._number:
            return
        count = self._controller.state.frames - self._frames
        if count > 0:
            said = self.tr("{channel} is switched on, and {count} frames were heard.")
            self._show_message(said.format(channel=interface, count=count), Level.DONE)
            return
        said = self.tr(
            "{channel} is switched on, but nothing is heard: is the arm powered, the CAN cable "
            "plugged in, the bit rate the arm's?"
        )
        self._show_message(said.format(channel=interface), Level.WARNING)

    def show_heard(self, findings: list[Diagnosis] | str) -> None:
        """Show the findings of the owner's examination, if this line waits for them."""
        interface, self._waits_for = self._waits_for, ""
        if not interface:
            return
        if isinstance(findings, list):
            name = Device("socketcan", interface).name
            findings = [each for each in findings if each.params.get("device") == name]
        self._on_heard(self._number, findings)

    def _on_heard(self, number: int, findings: list[Diagnosis] | str) -> None:
        if number != self._number:
            return
        self._listening = None
        if isinstance(findings, str):
            self._show_message(findings, Level.FAULT)
            return
        of_arm = [each for each in findings if each.section is Section.ARM]
        good = any(each.kind == ARM for each in of_arm)
        if not of_arm:  # the adapter is gone again, or the arm was not examined
            said = self.tr("{channel}: nothing was found out. Run the diagnosis again.")
            self._show_message(said.format(channel=self._remedy[1]), Level.WARNING)
            return
        self._show_message(WORDS.text(of_arm[0]), Level.DONE if good else Level.WARNING)

    # Appearance -------------------------------------------------------------------------------

    def _show_message(self, text: Words, level: Level = Level.INFO, *, busy: bool = False) -> None:
        self._line.show_message(text, level)
        self.cancel_button.setVisible(busy)
        self.setVisible(bool(text))

    def _end_listening(self) -> None:
        self._waits_for = ""
        if self._listening is not None:
            self._listening.end()
            self._listening = None

    def end(self) -> None:
        """Cancel and clear the line, because the window closes."""
        self.cancel()
        self._forbidden = False
        self._show_message("")


class KeepDialog(ArmDialog):
    """Shows the files before they are written or removed; the adapter gets its name here.

    Args:
        controller: Receives the emergency stop.
        parent: The window that asks.
        remedy: ``remember`` an interface with its bit rate, or a port; or ``forget`` a name.
        agreed: Called with the helper's arguments and the plan that was shown.
        begin: Starts a change; here only for its plan, without root's rights.
    """

    _answered = Signal(object, object)

    agree_button = Act("Write these files", named="adapter_agree", primary=True)

    def __init__(
        self,
        controller: ArmController,
        parent: QWidget | None,
        remedy: Remedy,
        agreed: Callable[[Remedy, Planned], object],
        begin: Begin = AdapterChange,
    ) -> None:
        super().__init__(controller, parent)
        self.setAttribute(Qt.WidgetAttribute.WA_DeleteOnClose)
        self._remedy = remedy
        self._agreed = agreed
        self._begin = begin
        self._number = 0
        self._change: HelperRun | None = None
        self._planned: Planned | None = None
        self._name_label = QLabel()
        self.name_edit = named("adapter_name", QLineEdit())
        self._name_label.setBuddy(self.name_edit)
        self._line = MessageLine(keeps_room=False)
        self.files = named("adapter_files", QPlainTextEdit(readOnly=True))
        self._note = text_label(rank="muted", wraps=True, plain=True)
        self._build()
        self._answered.connect(self._on_answered, Qt.ConnectionType.QueuedConnection)
        self._timer = QTimer(self, singleShot=True, interval=_TYPED_MS)
        self._timer.timeout.connect(self._plan)
        self.name_edit.textChanged.connect(self._on_typed)
        self.retranslate_ui()
        self.resize(*_SIZE_PX)
        self._plan()

    def _build(self) -> None:
        if self._names_it():
            fill(self.body, in_row(self._name_label, (self.name_edit, 1), spacing=8))
            self.name_edit.setText(f"arm_{self._remedy[1]}"[:15].lower())
        fill(self.body, self._line, (self.files, 1), self._note)
        fill(self.footer, STRETCH, self.agree_button, CloseButton(self))

    def _names_it(self) -> bool:
        return self._remedy[0] == "remember" and len(self._remedy) > 2

    def retranslate_ui(self) -> None:
        """Set all texts in the operator's language."""
        keeps = self._remedy[0] == "remember"
        self.set_title(self.tr("Keep at every start") if keeps else self.tr("Forget"))
        self._name_label.setText(self.tr("Name of the adapter"))
        self.files.setAccessibleName(self.tr("Files of the system"))
        self._note.setText(
            self.tr(
                "The system asks for the administrator's password. The name holds for this adapter "
                "by its serial number, wherever it is plugged in."
            )
            if self._names_it()
            else self.tr("The system asks for the administrator's password.")
        )
        self.show_acts()

    def _words(self) -> Remedy:
        if not self._names_it():
            return self._remedy
        verb, interface, bitrate = self._remedy
        return (verb, interface, self.name_edit.text().strip(), bitrate)

    def _on_typed(self) -> None:
        self._forget_plan()
        self._timer.start()
        self.show_acts()

    def _plan(self) -> None:
        self._forget_plan()
        number = self._number
        self._change = self._begin(
            self._words(), lambda answer: self._answered.emit(number, answer), BY_ANYBODY
        )

    def _forget_plan(self) -> None:
        self._number += 1
        self._planned = None
        if self._change is not None:
            self._change.end()
            self._change = None

    def _on_answered(self, number: int, answer: Answer) -> None:
        if number != self._number:
            return
        if self._change is not None:
            self._change.end()
        if isinstance(answer, Planned):
            self._planned = answer
            self._line.show_message("")
            self.files.setPlainText(self._as_text(answer))
        elif isinstance(answer, Refusal):
            self.files.setPlainText("")
            self._line.show_message(partial(words.refusal, answer), Level.WARNING)
        self.show_acts()

    def _as_text(self, planned: Planned) -> str:
        parts = [f"{path}\n\n{text}" for path, text in planned.files.items()]
        taken = self.tr("Taken away: {path}")
        parts += [taken.format(path=each) for each in planned.removed]
        return "\n".join(parts)

    @agree_button.text
    def _agreement(self) -> str:
        keeps = self._remedy[0] == "remember"
        return self.tr("Write these files") if keeps else self.tr("Remove")

    @agree_button.why_not
    def _why_not_agree(self) -> str:
        return "" if self._planned else self.tr("The files are being read.")

    @agree_button.pressed
    def _on_agree(self) -> None:
        planned = self._planned
        if planned is not None:
            wanted = self._words()
            self.close()
            self._agreed(wanted, planned)

    def done(self, result: int) -> None:
        """Cancel the request for a plan, and close."""
        self._timer.stop()
        self._forget_plan()
        super().done(result)
