"""运动控制: six joints, jogged at once or sent together (manual section 1.0.7.1)."""

from __future__ import annotations

from typing import TYPE_CHECKING, Final

from PySide6.QtCore import QEvent, Qt
from PySide6.QtGui import QKeySequence, QShowEvent
from PySide6.QtWidgets import (
    QFrame,
    QHBoxLayout,
    QLabel,
    QPushButton,
    QToolButton,
    QVBoxLayout,
    QWidget,
)

from armui.arm.device import Device
from armui.arm.limits import JOINTS
from armui.arm.refusal import Refusal
from armui.arm.state import ArmState
from armui.control.jog_ways import JointJog
from armui.control.situation import Level, Notice, Situation
from armui.ui import format as fmt
from armui.ui import words
from armui.ui.freshness import is_stale
from armui.ui.widgets.card import scrolled
from armui.ui.widgets.joint_row import JointRow
from armui.ui.widgets.key_pad import KeyPad
from armui.ui.widgets.message_line import MessageLine
from armui.ui.widgets.step_box import StepBox

if TYPE_CHECKING:
    from armui.control.arm_controller import ArmController

_FAULTS: Final = frozenset({"stopped", "stop_requested", "arm_fault", "link_lost"})
_FIELD_INDENT_PX: Final = 80
_TALLEST_CARD_PX: Final = 600
_KEYS: Final = tuple(
    (f"J{joint}", plus, minus)
    for joint, plus, minus in zip(JOINTS, "QWERTY", "ASDFGH", strict=True)
)
_HOME_KEY, _LOAD_KEY, _SEND_KEY = "Ctrl+Shift+H", "Ctrl+L", "Ctrl+Return"


class MotionPanel(QWidget):
    """Targets on the left, measured angles on the right; says why if the arm can't move.

    The fields hold what the arm measured until the operator types something else, so that
    sending them never moves a joint nobody touched.

    Args:
        controller: Whom to ask for motion.
        jog_step_deg: Step of − and + to begin with.
    """

    def __init__(
        self, controller: ArmController, jog_step_deg: float, parent: QWidget | None = None
    ) -> None:
        super().__init__(parent)
        self._controller = controller
        self._situation = controller.situation
        self._refusal: Refusal | None = None
        self._filled_for: Device | None = None
        self._jogged: int | None = None
        self._title = QLabel()
        self._title.setProperty("rank", "title")
        self._step_label = QLabel()
        self._step_box = StepBox(fmt.short_angle)
        self._keys = QToolButton()
        self._keys.setObjectName("jog_keys_button")
        self._keys.setCheckable(True)
        self._keys.setProperty("choice", True)
        self._key_pad = KeyPad(_KEYS, "key_pad")
        self._key_pad.hide()
        self._step_label.setBuddy(self._step_box)
        self._target_head = QLabel()
        self._measured_head = QLabel()
        self._rows = [JointRow(j, self._situation.limits[j - 1]) for j in JOINTS]
        self._home = QPushButton()
        self._load = QPushButton()
        self._send = QPushButton()
        self._message = MessageLine()
        self._message.setObjectName("motion_message")
        self._name_buttons()
        self._lay_out()
        self._connect()
        self.set_jog_step(jog_step_deg)
        self.retranslate_ui()

    def _name_buttons(self) -> None:
        for button, name, key in (
            (self._home, "home_button", _HOME_KEY),
            (self._load, "load_button", _LOAD_KEY),
            (self._send, "send_button", _SEND_KEY),
        ):
            button.setObjectName(name)
            button.setShortcut(QKeySequence(key))
            button.setMinimumHeight(38)
        self._send.setProperty("primary", True)

    def _lay_out(self) -> None:
        head = QHBoxLayout()
        head.addWidget(self._title)
        head.addStretch(1)
        head.addWidget(self._keys)
        head.addWidget(self._step_label)
        head.addWidget(self._step_box)

        card = QFrame()
        rows = QVBoxLayout(card)
        rows.setContentsMargins(16, 10, 16, 12)
        rows.setSpacing(4)
        columns = QHBoxLayout()
        columns.addSpacing(_FIELD_INDENT_PX)
        for label in (self._target_head, self._measured_head):
            label.setProperty("rank", "muted")
        columns.addWidget(self._target_head)
        columns.addStretch(1)
        columns.addWidget(self._measured_head)
        rows.addLayout(columns)
        for row in self._rows:
            rows.addWidget(row, 1)

        buttons = QHBoxLayout()
        buttons.setSpacing(10)
        for button in (self._home, self._load, self._send):
            buttons.addWidget(button, 1)

        layout = QVBoxLayout(self)
        layout.setContentsMargins(16, 14, 16, 14)
        layout.setSpacing(12)
        layout.addLayout(head)
        layout.addWidget(scrolled(card, _TALLEST_CARD_PX), 1)
        layout.addWidget(self._key_pad)
        layout.addLayout(buttons)
        layout.addWidget(self._message)
        layout.addStretch(0)

    def _connect(self) -> None:
        for row in self._rows:
            row.stepped.connect(self._on_stepped)
            row.repeated.connect(self._on_repeated)
            row.held.connect(self._on_held)
            row.let_go.connect(self._on_let_go)
            row.edited.connect(self._on_edited)
        self._step_box.chosen.connect(self._on_step_chosen)
        self._keys.toggled.connect(self._on_keys_toggled)
        self._key_pad.pressed.connect(self._on_key_pressed)
        self._key_pad.let_go.connect(self._on_let_go)
        self._home.clicked.connect(self._on_home)
        self._load.clicked.connect(self._on_load)
        self._send.clicked.connect(self._on_send)
        self._controller.state_changed.connect(self._on_state_changed)
        self._controller.situation_changed.connect(self._on_situation_changed)
        self._controller.noticed.connect(self._on_noticed)

    # -- step ---------------------------------------------------------------------------------

    @property
    def jog_step_deg(self) -> float:
        """How far one press of − or + goes."""
        return self._step_box.step

    def set_jog_step(self, step_deg: float) -> None:
        """Take the step of the settings; the usual ones can still be chosen."""
        self._step_box.set_step(step_deg)
        self._on_step_chosen()

    def focus_joint(self, joint: int) -> None:
        """Bring the operator to the target field of a joint."""
        field = self._rows[joint - 1].field
        field.setFocus(Qt.FocusReason.OtherFocusReason)
        field.selectAll()

    def _on_step_chosen(self) -> None:
        for row in self._rows:
            row.set_step(self.jog_step_deg, continuous=self._step_box.continuous)
        self._key_pad.set_continuous(self._step_box.continuous)
        self._show_possible()

    # -- actions ------------------------------------------------------------------------------

    def _on_repeated(self, joint: int, direction: int) -> None:
        """A held button waits for an arm that doesn't keep up: letting go must end the motion."""
        if not self._controller.motion.jog_lagging(joint, self.jog_step_deg):
            self._on_stepped(joint, direction)

    def _on_stepped(self, joint: int, direction: int) -> None:
        if self._took(self._controller.motion.jog(joint, direction * self.jog_step_deg)):
            setpoint_deg = self._controller.motion.setpoint_deg
            if setpoint_deg is not None:
                self._rows[joint - 1].show_target(setpoint_deg[joint - 1])
                self._show_message()

    def _on_held(self, joint: int, direction: int) -> None:
        self._jogged = joint
        self._took(self._controller.jogging.start(JointJog(joint, direction)))

    def _on_let_go(self) -> None:
        self._controller.jogging.stop()
        self._show_jogged()

    def _on_key_pressed(self, place: int, direction: int) -> None:
        joint = JOINTS[place]
        if self._step_box.continuous:
            self._on_held(joint, direction)
        else:
            self._on_stepped(joint, direction)

    def _on_keys_toggled(self, wanted: bool) -> None:
        self._key_pad.setVisible(wanted)
        if wanted:
            self._key_pad.setFocus(Qt.FocusReason.OtherFocusReason)

    def _on_noticed(self, notice: Notice) -> None:
        """What ended a jog is said where the operator looks."""
        reason = notice.params.get("reason")
        if notice.code == "jog_ended" and isinstance(reason, Refusal) and self.isVisible():
            self._took(reason)
            self._show_jogged()

    def _show_jogged(self) -> None:
        """The field of the joint goes along with a jog: sending it must not take it back."""
        setpoint_deg, joint = self._controller.motion.setpoint_deg, self._jogged
        if setpoint_deg is not None and joint is not None:
            self._rows[joint - 1].show_target(setpoint_deg[joint - 1])

    def _on_home(self) -> None:
        self._took(self._controller.motion.go_home())

    def _on_load(self) -> None:
        angles_deg = self._controller.state.angles_deg()
        if angles_deg is None:
            self._took(Refusal("joints_unknown"))
            return
        self._fill(angles_deg)
        self._took(None)

    def _on_send(self) -> None:
        targets_deg: list[float] = []
        for row in self._rows:
            if row.target_deg is None:
                self._took(self._why_no_figure(row))
                return
            targets_deg.append(row.target_deg)
        self._took(self._controller.motion.send_joints(targets_deg))

    @staticmethod
    def _why_no_figure(row: JointRow) -> Refusal:
        if row.field.is_nonsense():
            return Refusal("joint_not_a_number", {"joint": row.joint, "value": row.field.text()})
        return Refusal("joints_unknown")

    def _took(self, refusal: Refusal | None) -> bool:
        """Show the controller's answer; whether it was a yes."""
        self._refusal = refusal
        self._show_message()
        return refusal is None

    def _on_edited(self) -> None:
        self._refusal = None
        self._show_message()

    # -- what the arm says --------------------------------------------------------------------

    def _on_state_changed(self, state: ArmState) -> None:
        self._fill_once(state)
        if self.isVisible():
            self._show_measured(state)
            if self._controller.jogging.active:
                self._show_jogged()

    def _show_measured(self, state: ArmState) -> None:
        for row, heard in zip(self._rows, state.joints_deg, strict=True):
            angle_deg = None if heard is None else heard.value
            row.show_measured(angle_deg, stale=is_stale(heard, state, self._situation))

    def _fill_once(self, state: ArmState) -> None:
        """Load the first angles heard from a device, where the operator has not typed one."""
        device = self._situation.device
        if device is None or device == self._filled_for:
            return
        angles_deg = state.angles_deg()
        if angles_deg is not None:
            self._filled_for = device
            for row, angle_deg in zip(self._rows, angles_deg, strict=True):
                if not row.field.text():
                    row.show_target(angle_deg)
            self._show_possible()

    def _fill(self, angles_deg: tuple[float, ...] | None) -> None:
        for row, angle_deg in zip(self._rows, angles_deg or (None,) * len(JOINTS), strict=True):
            row.show_target(angle_deg)

    def _on_situation_changed(self, situation: Situation) -> None:
        old, self._situation = self._situation, situation
        if old.device != situation.device:
            # another arm: targets made for the last one would be a trap
            self._filled_for = None
            self._fill(None)
        if old.cannot_move != situation.cannot_move:
            self._refusal = None
        self._fill_once(self._controller.state)
        if self.isVisible():
            self._show_situation()

    def _show_situation(self) -> None:
        for row, limits, read in zip(
            self._rows, self._situation.limits, self._situation.limits_read, strict=True
        ):
            row.set_limits(limits, read=read)
        self._show_possible()
        self._show_message()
        self._show_measured(self._controller.state)

    # -- appearance ---------------------------------------------------------------------------

    def _show_possible(self) -> None:
        """Enable what can be used now; say in the tooltips of the rest why not."""
        blocked = self._situation.cannot_move
        why_not = "" if blocked is None else words.refusal(blocked)
        for row in self._rows:
            row.allow_jog(why_not)
        self._key_pad.allow(why_not)
        heard = self._controller.state.angles_deg() is not None
        no_angles = "" if heard else words.refusal(Refusal("joints_unknown"))
        for button, hindrance, use, key in (
            (self._home, why_not, self.tr("Moves all joints to 0°."), _HOME_KEY),
            (
                self._load,
                no_angles,
                self.tr("Fills the fields with the measured angles; nothing moves."),
                _LOAD_KEY,
            ),
            (self._send, why_not, self.tr("Moves the arm to the angles in the fields."), _SEND_KEY),
        ):
            button.setEnabled(not hindrance)
            shortcut = QKeySequence(key).toString(QKeySequence.SequenceFormat.NativeText)
            button.setToolTip(hindrance or f"{use} ({shortcut})")

    def _show_message(self) -> None:
        refusal = self._refusal or self._situation.cannot_move or self._first_out_of_limits()
        if refusal is None:
            self._message.show_message("")
            return
        level = Level.FAULT if refusal.code in _FAULTS else Level.WARNING
        if refusal.code == "not_connected":
            level = Level.INFO
        self._message.show_message(words.refusal(refusal), level)

    def _first_out_of_limits(self) -> Refusal | None:
        for row in self._rows:
            if row.field.is_nonsense():
                return self._why_no_figure(row)
            beyond = row.beyond_limits()
            if beyond is not None:
                return beyond
        return None

    def retranslate_ui(self) -> None:
        """Put every word into the operator's language."""
        self._title.setText(self.tr("Motion control"))
        self._step_label.setText(self.tr("Step"))
        self._step_box.setAccessibleName(self.tr("Step of − and +"))
        self._step_box.setToolTip(self.tr("How far one press of − or + moves a joint"))
        self._keys.setText(self.tr("Keys"))
        self._keys.setAccessibleName(self.tr("Keyboard jogging"))
        self._keys.setToolTip(self.tr("Jog by keys, with the space bar held as dead-man key"))
        self._target_head.setText(self.tr("Target"))
        self._measured_head.setText(self.tr("Measured"))
        for button, text in (
            (self._home, self.tr("Home")),
            (self._load, self.tr("Load")),
            (self._send, self.tr("Send")),
        ):
            shortcut = button.shortcut()
            button.setText(text)
            button.setShortcut(shortcut)
            button.setAccessibleName(text)
        self._show_possible()
        self._show_message()

    def changeEvent(self, event: QEvent) -> None:
        """Follow the language."""
        if event.type() == QEvent.Type.LanguageChange:
            self.retranslate_ui()
        super().changeEvent(event)

    def showEvent(self, event: QShowEvent) -> None:
        """Catch up with what went by while the panel was hidden."""
        super().showEvent(event)
        self._show_situation()
