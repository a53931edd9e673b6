"""联动控制: the arm's role beside another arm, and the offsets of its identifiers (0x470)."""

from __future__ import annotations

from collections.abc import Mapping
from functools import partial
from typing import Final

from PySide6.QtWidgets import QButtonGroup, QComboBox, QFrame, QLabel

from armui.arm.refusal import Refusal
from armui.control.arm_controller import ArmController
from armui.control.devices.linkage import LinkageControl
from armui.control.link.link_state import LinkState
from armui.control.operating_state import OperatingState
from armui.control.operations.started import Started
from armui.control.safety.interlocks import CONTROL_OFFSET_UNKNOWN
from armui.protocol.addressing import OFFSETS
from armui.protocol.codes import LinkageRole
from armui.ui.actions.act import Act
from armui.ui.actions.command import Command, Target
from armui.ui.panels.panel import Panel
from armui.ui.widgets.buttons import caption, choice_button, named
from armui.ui.widgets.layouts import empty_grid, scrolled
from armui.ui.widgets.text_label import text_label
from armui.ui.words.text import Text

_BASES: Final = {"feedback": (0x2A1, 0x2A8), "control": (0x150, 0x15F), "target": (0x150, 0x15F)}


class LinkagePanel(Panel):
    """The role to be set, the identifiers in use, and the way back from a teaching input."""

    commands = (
        Command("linkage.input", Text("Action", "Leader arm (teaching input)"), risky=True),
        Command("linkage.output", Text("Action", "Follower arm (motion output)"), risky=True),
    )
    back = Act(
        "Back to a motion output arm without offsets",
        named="linkage_back_button",
        does=LinkageControl.set,
    )
    confirm = Act(
        "Set linkage…",
        named="linkage_confirm_button",
        does=LinkageControl.set,
        tip="Says what will change, and asks first.",
        whose=True,
        key="linkage.confirm",
        title=Text("LinkagePanel", "Set linkage…"),
        least_height_px=38,
    )

    def __init__(self, controller: ArmController) -> None:
        super().__init__(controller, "linkage_message")
        self._role_label = QLabel()
        self._roles = QButtonGroup(self)
        self._role_buttons = {
            LinkageRole.TEACHING_INPUT: choice_button("linkage_input"),
            LinkageRole.MOTION_OUTPUT: choice_button("linkage_output"),
        }
        self._labels = {name: text_label(wraps=True) for name in _BASES}
        self._boxes = {name: named(f"linkage_{name}_offset", QComboBox()) for name in _BASES}
        self._in_use = text_label("linkage_in_use", wraps=True)
        self._teaching = text_label("linkage_teaching_input", wraps=True)
        self._note = text_label(rank="muted", wraps=True)
        self._lay_out()
        self._roles.idToggled.connect(lambda _role, _on: self.show_acts())
        for box in self._boxes.values():
            box.currentIndexChanged.connect(lambda _place: self.show_acts())
        self._listen("linkage_")
        self.retranslate_ui()

    def command_targets(self) -> Mapping[str, Target]:
        """Return the target of each command, by the command's name."""
        return {
            **super().command_targets(),
            "linkage.input": self._role_buttons[LinkageRole.TEACHING_INPUT],
            "linkage.output": self._role_buttons[LinkageRole.MOTION_OUTPUT],
        }

    def _lay_out(self) -> None:
        card = QFrame()
        grid = empty_grid(card, gaps=(10, 10), margins=(16, 12, 16, 12))
        grid.addWidget(self._role_label, 0, 0, 1, 2)
        for row, (role, button) in enumerate(self._role_buttons.items(), start=1):
            button.setSizePolicy(self.confirm.sizePolicy())
            self._roles.addButton(button, int(role))
            grid.addWidget(button, row, 0, 1, 2)
        self._role_buttons[LinkageRole.MOTION_OUTPUT].setChecked(True)
        for row, (name, box) in enumerate(self._boxes.items(), start=3):
            for offset in OFFSETS:
                box.addItem(f"0x{offset:02X}  ({_span(name, offset)})", offset)
            self._labels[name].setBuddy(box)
            grid.addWidget(self._labels[name], row, 0)
            grid.addWidget(box, row, 1)
        grid.addWidget(self._in_use, 6, 0, 1, 2)
        grid.setColumnStretch(0, 1)
        grid.setRowStretch(7, 1)
        self._stack(self._teaching, self.back, scrolled(card), self.confirm, self._note)

    # -- actions ------------------------------------------------------------------------------

    @back.pressed
    def _on_back(self) -> None:
        self._accepted(self._controller.linkage.release())

    @confirm.pressed
    def _ask(self) -> None:
        chosen = self._chosen()
        becomes_input = chosen[0] is LinkageRole.TEACHING_INPUT
        what = (
            self.tr(
                "The arm becomes a teaching input and goes deaf: it obeys no command, not even "
                "the emergency stop; only cutting its power stops it. Its feedback ends, it can "
                "be led by hand and sends its own commands to the following arm."
            )
            if becomes_input
            else self.tr(
                "The arm becomes, or stays, a motion output arm. The program listens and talks on "
                "the identifiers that the offsets lead to."
            )
        )
        rest = self.tr(
            "Every arm on this bus obeys this setting: leave only the one meant connected. The "
            "arm keeps it when switched off. It takes effect in standby, or after a power "
            "cycle."
        )
        self._ask_to_hold(
            self.tr("Set the linkage"),
            f"{what}\n{rest}",
            self.tr("Set linkage"),
            partial(self._set, *chosen),
            still=lambda: self._chosen() == chosen,
        )

    def _chosen(self) -> tuple[LinkageRole, dict[str, int]]:
        """Return the chosen role, and the chosen offsets by their names."""
        offsets = {name: int(box.currentData()) for name, box in self._boxes.items()}
        return LinkageRole(self._roles.checkedId()), offsets

    def _set(self, role: LinkageRole, offsets: dict[str, int]) -> Started | Refusal:
        named = {f"{name}_offset": offset for name, offset in offsets.items()}
        return self._controller.linkage.set(role, **named)

    # -- appearance ---------------------------------------------------------------------------

    def _forget_outdated(self, old: OperatingState) -> None:
        led_back = old.teaching_input and not self._operating_state.teaching_input
        if led_back:
            self._role_buttons[LinkageRole.MOTION_OUTPUT].setChecked(True)
        if led_back or old.device != self._operating_state.device:
            self._refusal = self._event = None

    def _show_all(self) -> None:
        operating_state = self._operating_state
        teaching, becomes = operating_state.teaching_input, operating_state.becomes_input
        if becomes:
            self._teaching.setText(
                self.tr(
                    "Stored: teaching input. The arm still obeys; it goes deaf at the next "
                    "standby, also when an emergency stop is released, or after a power cycle. "
                    "To undo it:"
                )
            )
        elif teaching:
            self._teaching.setText(
                self.tr(
                    "The arm on this bus is a teaching input: it sends commands for a following "
                    "arm and no feedback. It obeys nothing but this:"
                )
            )
        self._teaching.setVisible(teaching or becomes)
        self.back.setVisible(teaching or becomes)
        self.show_acts()
        self._show_in_use()
        self._show_message()

    @confirm.lit
    def _is_new(self) -> bool:
        """Return true while the choice differs from what is in use.

        A teaching input does not report its offsets; the button that ends this role is above.
        """
        teaching, addressing = (
            self._operating_state.teaching_input,
            self._operating_state.addressing,
        )
        in_use = (LinkageRole.MOTION_OUTPUT, addressing.feedback_offset, addressing.control_offset)
        offsets = (self._boxes[name].currentData() for name in ("feedback", "control"))
        chosen = (self._roles.checkedId(), *offsets)
        return not teaching and chosen != in_use

    def _show_in_use(self) -> None:
        operating_state = self._operating_state
        if operating_state.link is not LinkState.ONLINE:
            self._in_use.setText(self.tr("In use: —"))
            return
        addressing = operating_state.addressing
        feedback = _span("feedback", addressing.feedback_offset)
        certain = operating_state.control_certain
        control = _span("control", addressing.control_offset) if certain else self.tr("not known")
        text = self.tr("In use: feedback {feedback}, commands {control}")
        self._in_use.setText(text.format(feedback=feedback, control=control))

    def _show_message(self) -> None:
        operating_state = self._operating_state
        refusal = self._refusal
        if refusal is None and not operating_state.control_certain:
            refusal = CONTROL_OFFSET_UNKNOWN()
        if refusal is None and not operating_state.teaching_input and self._event is None:
            refusal = self._unless_told(operating_state.unreachable)
        self._show_outcome(refusal, self._event)

    def retranslate_ui(self) -> None:
        """Set all texts in the operator's language."""
        self._title.setText(self.tr("Linkage control"))
        self._role_label.setText(self.tr("Linkage setting"))
        for role, text in (
            (LinkageRole.TEACHING_INPUT, self.tr("Leader arm (teaching input)")),
            (LinkageRole.MOTION_OUTPUT, self.tr("Follower arm (motion output)")),
        ):
            caption(self._role_buttons[role], text)
        for name, text in (
            ("feedback", self.tr("Feedback offset")),
            ("control", self.tr("Control offset")),
            ("target", self.tr("Address offset")),
        ):
            self._labels[name].setText(text)
            self._boxes[name].setAccessibleName(text)
        self._boxes["target"].setToolTip(
            self.tr("Where a teaching input sends its commands: the control offset of its follower")
        )
        self._note.setText(
            self.tr("The arm cannot be asked for this setting: armui uses the IDs it hears.")
        )
        self._show_all()


def _span(name: str, offset: int) -> str:
    """Return the first and the last CAN identifier of a group with an offset, as text."""
    first, last = _BASES[name]
    return f"0x{first + offset:03X}–0x{last + offset:03X}"
