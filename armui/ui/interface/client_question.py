"""The questions of clients to the operator: for the arm, and for consent to one operation (S29)."""

from __future__ import annotations

import re
from typing import TYPE_CHECKING, Final

from PySide6.QtCore import Qt, QTimer
from PySide6.QtWidgets import QApplication, QButtonGroup, QLabel, QWidget

from armui.arm.limits import JOINTS
from armui.control.safety.recovery_steps import Action
from armui.interface.lease import GRANT_WITHIN_S
from armui.protocol.codes import ALL_JOINTS
from armui.ui import words
from armui.ui.dialogs.base import place
from armui.ui.dialogs.confirm_dialog import ConfirmDialog, below
from armui.ui.widgets.buttons import caption, choice_button, named, spin_box
from armui.ui.widgets.layouts import STRETCH, empty_grid, fill, in_row
from armui.ui.widgets.text_label import text_label
from armui.ui.words.arm import operation_title
from armui.ui.words.text import Text

if TYPE_CHECKING:
    from collections.abc import Callable, Iterator

    from armui.control.arm_controller import ArmController
    from armui.interface.interface import Interface
    from armui.interface.interface_view import Consented, InterfaceView
    from armui.interface.lease import Ask, Client

_TICK_MS: Final = 250
_LONG_WORD: Final = re.compile(r"(\S{20})(?=\S)")
_BREAK: Final = "\u200b"
_FIELD_PX: Final = 90
_MOST_FOUND: Final = 6
_OF_ALL_JOINTS: Final = frozenset(
    {"motors.enable", "motors.disable", "joints.set_zero", "joints.clear_error"}
)
"""The operations that concern all joints if the client names none."""
_ALL: Final = ("joint", ALL_JOINTS)
_DROPS: Final = Text("MotorPanel", "The arm will drop when it loses its power. Hold the arm.")
_DANGERS: Final = {
    "gripper.disable": Text(
        "GripperPanel", "The gripper loses its power and drops what it holds. Hold the workpiece."
    ),
    "gripper.set_zero": Text(
        "GripperPanel",
        "Where the gripper stands now becomes its 0 mm, and it loses its power: it drops "
        "what it holds.\nClose it by hand before. With a wrong zero it presses against its "
        "stop, or does not close.",
    ),
    "joints.set_zero": Text(
        "MotorPanel",
        "The limits move with the zero, and so does every stored trajectory. With a wrong zero "
        "the arm runs into its stops.\nSet it only at the mark of the joint's zero, with the "
        "arm standing still. The arm keeps it; there is no way back but to set it again.",
    ),
}
"""The warnings that the operator reads before his own press."""


def breakable(text: str) -> str:
    """Return a client's text with break points in long words, which would widen the window."""
    return _LONG_WORD.sub(rf"\1{_BREAK}", text)


class ClientQuestion(ConfirmDialog):
    """A question by a client, open until it is answered or withdrawn; closing it refuses.

    It opens without a press by the operator, so it does not take the keyboard, and covers the panel
    only.

    Args:
        interface: The interface that gets the answer.
        controller: Receives the emergency stop.
        parent: The main window.
        client: The client that asks.
        since_s: The monotonic time of the question.
        asked: Returns whether the question is still open.
        still: Returns whether its subject is unchanged.
    """

    _built = False

    def __init__(
        self,
        interface: Interface,
        controller: ArmController,
        parent: QWidget,
        *,
        client: Client,
        since_s: float,
        asked: Callable[[], bool],
        still: Callable[[], bool] = lambda: True,
    ) -> None:
        super().__init__(
            *(controller, parent),
            title="",
            text="",
            action_label="",
            hold=True,
            still=still,
        )
        self.setAttribute(Qt.WidgetAttribute.WA_ShowWithoutActivating)
        self.setAttribute(Qt.WidgetAttribute.WA_DeleteOnClose)
        self._interface, self._client, self._since_s = interface, client, since_s
        self._asked = asked
        self._seconds = named("client_seconds_left", text_label(rank="muted"))
        self._tick = QTimer(self, interval=_TICK_MS)
        self._tick.timeout.connect(self._show_time_left)
        self.finished.connect(self._tick.stop)
        self._tick.start()

    @property
    def asked(self) -> bool:
        """True while the client still asks."""
        return self._asked()

    def open(self) -> None:
        """Show it over the panel without taking the keyboard focus."""
        place(self)
        self.show()
        self.raise_()
        QApplication.alert(self)

    def done(self, result: int) -> None:
        """Answer, if it is still asked."""
        super().done(result)
        if self.asked:
            self.answer(given=bool(result))

    def answer(self, *, given: bool) -> None:
        """Tell the client what the operator has decided."""
        raise NotImplementedError

    def _who(self) -> str:
        program = breakable(self._client.program) or "?"
        return self.tr("It is the program “{program}”, process {process}, run by you.").format(
            program=program, process=self._client.process
        )

    def _show_time_left(self) -> None:
        left_s = max(0, round(GRANT_WITHIN_S - self._interface.seconds_since(self._since_s)))
        said = self.tr("Refused by itself in {seconds} s.").format(seconds=left_s)
        if said != self._seconds.text():
            self._seconds.setText(said)

    def _set_texts(self) -> tuple[str, str, str]:
        """Set the texts of its own, and return title, text and the word on the button."""
        raise NotImplementedError

    def retranslate_ui(self) -> None:
        """Set all texts in the operator's language; the client's own texts are not translated."""
        super().retranslate_ui()
        if not self._built:
            return
        title, text, label = self._set_texts()
        self.set_title(title)
        self.show_text(text)
        self.action_button.setText(label)
        self.cancel_button.setText(self.tr("Refuse"))
        self._show_time_left()


class GrantDialog(ClientQuestion):
    """Asks whether a client may have the arm, how fast, and for how long.

    Args:
        interface: The interface that gets the answer.
        controller: Receives the emergency stop; gives the operator's speed.
        parent: The main window.
        ask: The request.
    """

    def __init__(
        self, interface: Interface, controller: ArmController, parent: QWidget, ask: Ask
    ) -> None:
        super().__init__(
            *(interface, controller, parent),
            client=ask.client,
            since_s=ask.since_s,
            asked=lambda: interface.view.asked == ask,
        )
        self._ask = ask
        self._limit_label = QLabel()
        self.limit = named("grant_limit", spin_box(1, ask.max_speed_percent, " %"))
        self.limit.setFixedWidth(_FIELD_PX)
        self.limit.setValue(min(ask.max_speed_percent, controller.motion.speed_percent))
        self.once = choice_button("grant_once")
        self.lasting = choice_button("grant_for_connection")
        self._choice = QButtonGroup(self)
        for button in (self.once, self.lasting):
            self._choice.addButton(button)
        self.once.setChecked(True)
        self._limit_label.setBuddy(self.limit)
        grid = empty_grid(gaps=(12, 10))
        grid.addWidget(self._limit_label, 0, 0)
        grid.addLayout(in_row(self.limit, STRETCH), 0, 1)
        grid.addLayout(in_row(self.once, self.lasting, STRETCH, spacing=8), 1, 0, 1, 2)
        for each in (self._limit_label, self.limit, self.once, self.lasting):
            each.setVisible(ask.moves)  # without motion there is no speed to choose
        fill(self.body, grid, self._seconds)
        self._built = True
        self.retranslate_ui()

    def answer(self, *, given: bool) -> None:
        """Grant the arm, or decline."""
        if given:
            self._interface.grant(self.limit.value(), for_session=self.lasting.isChecked())
        else:
            self._interface.decline()

    def _set_texts(self) -> tuple[str, str, str]:
        """Set the texts of its own, and return title, text and the word on the button."""
        ask = self._ask
        title = self.tr("“{client}” asks for the arm").format(client=breakable(ask.client.name))
        purpose = breakable(ask.purpose.strip())
        wants = (
            self.tr(
                "It then moves the arm by itself, within every check, until you take it back. "
                "Keep clear of the arm. Stop, halt, and any motion you begin end it."
            )
            if ask.moves
            else self.tr("It wants to set something, and moves nothing.")
        )
        said = self.tr("Purpose: {purpose}").format(purpose=purpose) if purpose else ""
        text = "\n".join(filter(None, (said, self._who(), wants)))
        self._limit_label.setText(self.tr("Highest speed"))
        self.limit.setAccessibleName(self._limit_label.text())
        tip = self.tr("It asks for at most {percent} %. The speed at the top slows it at once.")
        self.limit.setToolTip(tip.format(percent=ask.max_speed_percent))
        caption(self.once, self.tr("Once"), tip=self.tr("It asks again for the next time."))
        caption(
            self.lasting,
            self.tr("For this connection"),
            tip=self.tr("Until it disconnects, or you take the arm back, it need not ask again."),
        )
        return title, text, self.tr("Grant")


class ConsentDialog(ClientQuestion):
    """Asks whether the client with the arm may do something dangerous, once.

    Args:
        interface: The interface that gets the answer.
        controller: Receives the emergency stop; gives the arm's state.
        parent: The main window.
        consent: The call that needs consent.
    """

    def __init__(
        self, interface: Interface, controller: ArmController, parent: QWidget, consent: Consented
    ) -> None:
        super().__init__(
            *(interface, controller, parent),
            client=consent.client,
            since_s=consent.since_s,
            asked=lambda: interface.view.consent == consent,
            still=_unchanged(controller, consent),
        )
        self._consent = consent
        fill(self.body, self._seconds)
        self._built = True
        self.retranslate_ui()

    def answer(self, *, given: bool) -> None:
        """Let it be done, or refuse it."""
        self._interface.consent(given=given)

    def _set_texts(self) -> tuple[str, str, str]:
        """Set the texts of its own, and return title, text and the word on the button."""
        consent = self._consent
        operation = operation_title(consent.title)
        title = self.tr("“{client}” wants: {operation}").format(
            client=breakable(consent.client.name), operation=operation
        )
        said = (self._figures(), *self._findings(), self._danger(), self._who())
        return title, "\n".join(filter(None, said)), self.tr("Allow once")

    def _findings(self) -> Iterator[str]:
        """Yield the findings of the check before a run, as sentences."""
        from armui.ui.words.findings import finding_line  # noqa: PLC0415 - scipy

        findings = self._consent.findings
        yield from map(finding_line, findings[:_MOST_FOUND])
        if len(findings) > _MOST_FOUND:
            yield self.tr("{count} more").format(count=len(findings) - _MOST_FOUND)

    def _figures(self) -> str:
        """Return the arguments of the operation as text."""
        whole = dict((_ALL,)) if self._consent.operation in _OF_ALL_JOINTS else {}
        joints = f"{JOINTS[0]}–{JOINTS[-1]}"
        return " · ".join(
            f"{words.figure(name)}: {joints if (name, each) == _ALL else breakable(str(each))}"
            for name, each in {**whole, **self._consent.arguments}.items()
        )

    def _danger(self) -> str:
        """Return what will physically happen, as before the operator's own press."""
        controller, name = self._controller, self._consent.operation
        if name == "motors.disable" and _joint_of(self._consent) != ALL_JOINTS:
            return _DROPS.text() + below(controller)
        if name == "motors.disable":
            generation = controller.operating_state.generation
            return words.disabling(_DROPS.text(), generation, controller.state) + below(controller)
        if name == "motors.resume":
            return words.step_danger(Action.RESUME) + below(controller)
        return _DANGERS[name].text() if name in _DANGERS else ""


def _joint_of(consent: Consented) -> int:
    """Return the joint in the arguments; an invalid one is refused by the operation."""
    joint = consent.arguments.get("joint")
    return joint if isinstance(joint, int) and joint in JOINTS else ALL_JOINTS


def _unchanged(controller: ArmController, consent: Consented) -> Callable[[], bool]:
    """Return a function that tells whether the arm still stands where a zero is to be set."""
    state = controller.state
    if consent.operation == "gripper.set_zero":
        return lambda: controller.gripper.stands_as(state)
    if consent.operation == "joints.set_zero":
        return lambda: controller.zeroing.stands_as(state, _joint_of(consent))
    return lambda: True


class ClientQuestions:
    """Opens a question of a client when it arises, and closes it when it is withdrawn.

    Args:
        interface: The interface with the questions.
        controller: Receives the emergency stops.
        window: The main window.
    """

    def __init__(self, interface: Interface, controller: ArmController, window: QWidget) -> None:
        self._interface, self._controller, self._window = interface, controller, window
        self._open: list[ClientQuestion] = []
        interface.changed.connect(self._on_changed)

    def _on_changed(self, view: InterfaceView) -> None:
        for each in [each for each in self._open if not each.asked]:
            each.reject()
        kinds = {type(each) for each in self._open}
        if view.asked is not None and GrantDialog not in kinds:
            self._show(GrantDialog(self._interface, self._controller, self._window, view.asked))
        if view.consent is not None and ConsentDialog not in kinds:
            self._show(ConsentDialog(self._interface, self._controller, self._window, view.consent))

    def _show(self, question: ClientQuestion) -> None:
        self._open.append(question)
        question.finished.connect(lambda _result: self._open.remove(question))
        question.open()
