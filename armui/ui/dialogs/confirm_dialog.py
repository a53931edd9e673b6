"""The questions of the program, none of which blocks a window."""

from __future__ import annotations

from collections.abc import Callable
from typing import Final

from PySide6.QtCore import QCoreApplication, Qt, Signal
from PySide6.QtWidgets import QLabel, QPushButton, QWidget

from armui.arm.refusal import Reason, Refusal
from armui.control.arm_controller import ArmController
from armui.control.operating_state import OperatingState
from armui.control.operations.started import ARM_CHANGED, Started
from armui.control.safety.gate import LEADS_BELOW
from armui.ui import words
from armui.ui.dialogs.base import ArmDialog
from armui.ui.theme import colors_of
from armui.ui.widgets import icons
from armui.ui.widgets.buttons import enable_or_explain, push_button
from armui.ui.widgets.hold_button import HoldButton
from armui.ui.widgets.layouts import STRETCH, fill, in_row
from armui.ui.widgets.text_label import text_label

ASKED_OTHERWISE = Reason(
    "asked_otherwise", "What the question was about has changed: nothing was done. Try again."
)


_SIGN_PX: Final = 36
_TEXT_WIDTH_PX: Final = 520


def below(controller: ArmController) -> str:
    """Return a line on the parts of the work area below a sinking arm; "" if there are none."""
    names = controller.area_guard.below()
    said = QCoreApplication.translate(
        "ConfirmDialog", "The work area does not hold it then: below the arm is {names}."
    )
    return f"\n{said.format(names=names)}" if names else ""


def confirm(
    parent: QWidget,
    controller: ArmController,
    *,
    title: str,
    text: str,
    action_label: str,
    on_confirmed: Callable[[], object],
    hold: bool = False,
    concerns_arm: bool = True,
    still: Callable[[], bool] = lambda: True,
    sinks: bool = False,
    on_withdrawn: Callable[[Refusal], object] = lambda _reason: None,
) -> ConfirmDialog:
    """Ask a question without blocking; an older question of the same title is withdrawn.

    Args:
        parent: The window that asks.
        controller: Receives the emergency stop.
        title: The question in a few words.
        text: The physical effect, and what to do before.
        action_label: The button's action in a word.
        on_confirmed: Called when the operator agrees.
        hold: The button must be held for a second.
        concerns_arm: True to withdraw it when another arm or none is connected; see
            `ConfirmDialog`.
        still: Returns whether its text still holds; otherwise it is withdrawn.
        sinks: True if the action lets the arm sink: the text then names what is below it, too.
        on_withdrawn: Called with the reason if the question is withdrawn; for a window that hides
            the line in which that is told.

    Returns:
        The open question; it deletes itself once answered.
    """
    if sinks:
        text += below(controller)
    for older in parent.findChildren(ConfirmDialog):
        if older.windowTitle() == title:
            older.reject()
    dialog = ConfirmDialog(
        controller,
        parent,
        title=title,
        text=text,
        action_label=action_label,
        hold=hold,
        concerns_arm=concerns_arm,
        still=still,
    )
    dialog.setAttribute(Qt.WidgetAttribute.WA_DeleteOnClose)
    dialog.accepted.connect(on_confirmed)
    dialog.withdrawn.connect(on_withdrawn)
    dialog.open()
    return dialog


def drive(
    parent: QWidget,
    controller: ArmController,
    move: Callable[[float], Started | Refusal],
    answered: Callable[[Started | Refusal], object],
    about: Callable[[], object],
) -> None:
    """Send a single motion; ask first, with a button to hold, if it leads below the floor.

    Args:
        parent: The part of a window that asks.
        controller: Receives the emergency stop.
        move: Sends the motion, given the height down to which the operator agrees to go.
        answered: Called with the answer to the motion; not at all if the operator says no.
        about: Returns what the motion was made from, such as the figures in the fields; a change
            of it withdraws the question.
    """
    answer = move(0.0)
    if not isinstance(answer, Refusal) or answer.reason is not LEADS_BELOW:
        answered(answer)
        return
    agreed_mm = -float(str(answer.params["value"]))
    rules, given = controller.gate.rules(), about()
    confirm(
        parent.window(),
        controller,
        title=QCoreApplication.translate("ConfirmDialog", "Below the floor"),
        text=words.refusal(answer),
        action_label=QCoreApplication.translate("ConfirmDialog", "Go there"),
        on_confirmed=lambda: answered(move(agreed_mm)),
        hold=True,
        still=lambda: controller.gate.rules() is rules and about() == given,
    )


class ConfirmDialog(ArmDialog):
    """Describes an action, which only happens if the button with its name is pressed.

    Enter and Escape both mean no. Its emergency stop stops, and never asks a question itself.

    It is about the arm that is connected when it is created, and withdraws itself with a line on
    the reason as soon as that is another one, or its text no longer holds. This is checked again at
    the press, by the newest state of the arm.

    Args:
        controller: Receives the emergency stop.
        parent: The window that asks.
        title: The question in a few words.
        text: The physical effect, and what to do before.
        action_label: The button's action in a word.
        hold: True if the button must be held for a second: for actions that a double click must not
            cause.
        concerns_arm: True if it is about the connected arm, as opposed to files.
        still: Returns whether its text still holds.

    Signals:
        withdrawn: Why it has withdrawn itself, a `Refusal`.
    """

    withdrawn = Signal(object)

    def __init__(
        self,
        controller: ArmController,
        parent: QWidget | None = None,
        *,
        title: str,
        text: str,
        action_label: str,
        hold: bool = False,
        concerns_arm: bool = True,
        still: Callable[[], bool] = lambda: True,
    ) -> None:
        super().__init__(controller, parent)
        self._controller = controller
        self._asked_for = controller.mark if concerns_arm else None
        self._still = still
        # what the question is about may change while it is open: then it is withdrawn
        controller.state_changed.connect(self._check)
        controller.operating_state_changed.connect(self._check)
        self.set_title(title)
        self._sign = QLabel()
        self._text = text_label(text=text, wraps=True, plain=True)
        self._text.setMinimumWidth(_TEXT_WIDTH_PX)
        content = in_row(spacing=16)
        content.addWidget(self._sign, 0, Qt.AlignmentFlag.AlignTop)
        content.addWidget(self._text, 1, Qt.AlignmentFlag.AlignTop)
        self.body.addLayout(content)

        self._hint = text_label(rank="muted")
        self._hint.setVisible(hold)
        action_label = action_label.rstrip("…")  # “…” announces a question; this button acts
        self.action_button: QPushButton
        if hold:
            self.action_button = HoldButton(controller, action_label)
            self.action_button.held.connect(self.accept)
        else:
            self.action_button = push_button("", action_label, on_enter=False)
            self.action_button.clicked.connect(self.accept)
        self.cancel_button = push_button(on_enter=True)
        self.cancel_button.clicked.connect(self.reject)
        fill(self.footer, self._hint, STRETCH, self.action_button, self.cancel_button)
        # with the focus on Cancel, neither Enter nor the space bar does what is asked about
        self.cancel_button.setFocus()
        self._recolor()
        self.retranslate_ui()

    def accept(self) -> None:
        """Agree, unless it is about another arm by now."""
        if self.holds():
            super().accept()

    def holds(self) -> bool:
        """Return whether arm and text are unchanged; withdraw the question if not."""
        asked_for = self._asked_for
        if asked_for is not None and not asked_for.is_still(self._controller.mark):
            reason = ARM_CHANGED()
        elif not self._still():
            reason = ASKED_OTHERWISE()
        else:
            return True
        self.reject()
        self._controller.report_withdrawn(self.windowTitle(), reason)
        self.withdrawn.emit(reason)
        return False

    def _check(self) -> None:
        if self.isVisible():
            self.holds()

    def show_text(self, text: str) -> None:
        """Replace the question's text while it is open."""
        self._text.setText(text)

    def text(self) -> str:
        """Return the question's text as it is shown."""
        return self._text.text()

    def retranslate_ui(self) -> None:
        """Set the dialog's own texts; the asker sets the others."""
        self._hint.setText(self.tr("Hold the button, or the space bar on it, for one second."))
        self.cancel_button.setText(self.tr("Cancel"))

    def _recolor(self) -> None:
        ink = colors_of(self).warn
        self._sign.setPixmap(icons.pixmap("warning", ink, _SIGN_PX, self.devicePixelRatioF()))


class SaveQuestion(ConfirmDialog):
    """A question with the choices to save, discard, or stay.

    Args:
        controller: Receives the emergency stop.
        parent: The window that asks.
        text: The text on what has not been saved.
        concerns_arm: True if it would be saved to the arm.

    Signals:
        save_wanted: The changes shall be saved; `accepted` alone means that they are discarded.
    """

    save_wanted = Signal()

    def __init__(
        self, controller: ArmController, parent: QWidget, text: str, *, concerns_arm: bool
    ) -> None:
        super().__init__(
            controller,
            parent,
            title=QCoreApplication.translate("SaveQuestion", "Changes are not saved"),
            text=text,
            action_label=QCoreApplication.translate("SaveQuestion", "Discard changes"),
            concerns_arm=concerns_arm,
        )
        self.save_button = push_button("", self.tr("Save"), primary=True, on_enter=False)
        self.save_button.clicked.connect(self._on_save)
        self.footer.insertWidget(self.footer.count() - 1, self.save_button)

    def allow_saving(self, reason: str) -> None:
        """Enable saving, or disable it with the reason in the button's tooltip."""
        enable_or_explain(self.save_button, reason)

    def _on_save(self) -> None:
        if self.holds():
            self.reject()
            self.save_wanted.emit()


class LeaveQuestion(SaveQuestion):
    """A question with the choices to save a trajectory, discard its changes, or stay.

    Args:
        controller: Receives the emergency stop.
        parent: The editor.
        name: The name of the trajectory.
    """

    def __init__(self, controller: ArmController, parent: QWidget, name: str) -> None:
        text = QCoreApplication.translate(
            "LeaveQuestion", "What you changed in “{name}” has not been saved."
        )
        super().__init__(controller, parent, text.format(name=name), concerns_arm=False)


class CloseQuestion(ConfirmDialog):
    """A question with the choices to end the motion and close, let it finish and close, or stay.

    It is withdrawn as soon as nothing moves any more, because its text is wrong then.

    Signals:
        let_finish: The program shall close and the arm go on to its target; `accepted` means that
            the motion is ended before.
    """

    let_finish = Signal()

    def __init__(self, controller: ArmController, parent: QWidget) -> None:
        super().__init__(
            *(controller, parent),
            title="",
            text="",
            action_label="",
            still=lambda: _under_way(controller.operating_state),
        )
        self.set_title(self.tr("The arm is moving"))
        self.show_text(
            self.tr(
                "If you end the motion, the arm comes to rest where it is; its motors stay "
                "enabled. If you let it finish, it goes on to its target, and this program can "
                "no longer stop it. Press the emergency stop if it must not move."
            )
        )
        self.action_button.setText(self.tr("End the motion and close"))
        self.action_button.setProperty("primary", True)
        self.let_finish_button = push_button("", self.tr("Let it finish and close"), on_enter=False)
        self.let_finish_button.clicked.connect(self._on_let_finish)
        self.footer.insertWidget(self.footer.count() - 1, self.let_finish_button)

    def _on_let_finish(self) -> None:
        if self.holds():
            self.reject()
            self.let_finish.emit()


def _under_way(now: OperatingState) -> bool:
    return now.moving or now.running or bool(now.holds)
