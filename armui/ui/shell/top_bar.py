"""Regions 1, 3, 4 and 5: communication, speed, enable, halt and emergency stop."""

from __future__ import annotations

from collections.abc import Callable, Mapping
from typing import TYPE_CHECKING, Final

from PySide6.QtCore import QPointF, QRectF, QSize, Qt
from PySide6.QtGui import QColor, QFont, QFontMetrics, QPainter, QPaintEvent, QPen, QResizeEvent
from PySide6.QtWidgets import QAbstractButton, QLabel, QSizePolicy, QWidget

from armui.arm.device import Device
from armui.arm.limits import JOINTS
from armui.arm.state import ArmState
from armui.control.devices.motors import why_not_disable, why_not_enable
from armui.control.link.link_state import LinkState
from armui.control.motion.joint_motion import Motion
from armui.control.operating_state import Busy, OperatingState, StopState
from armui.control.operations.operation import operation_of
from armui.control.safety.uncommanded_motion import MotionKind, UncommandedMotion
from armui.protocol.addressing import Addressing
from armui.protocol.codes import MoveMode
from armui.protocol.generation import Generation
from armui.ui import format as fmt
from armui.ui import words
from armui.ui.actions.command import Command, Target, also
from armui.ui.actions.keys import key_text
from armui.ui.dialogs.confirm_dialog import confirm
from armui.ui.freshness import is_stale
from armui.ui.theme import Colors, colors_of, scaled_font
from armui.ui.widgets import painting
from armui.ui.widgets.buttons import describe, enable_or_explain, named
from armui.ui.widgets.curve_menu import set_quantities
from armui.ui.widgets.halt_button import HaltButton
from armui.ui.widgets.layouts import fill, in_row
from armui.ui.widgets.percent_input import PercentInput
from armui.ui.widgets.stop_button import StopButton
from armui.ui.widgets.text_label import ValueLabel, text_label
from armui.ui.widgets.tips import keep_in_sight
from armui.ui.widgets.translated import Translated
from armui.ui.words.text import Text, Texts

if TYPE_CHECKING:
    from armui.arm.state import EndLimits, Reading
    from armui.control.arm_controller import ArmController
    from armui.control.devices.joint_monitor import JointMonitor


_SIGN_PX: Final = 8.0
_WIDTH_PX: Final = 188
_HEIGHT_PX: Final = 46
_TEXT_LEFT_PX: Final = 12 + 2 * _SIGN_PX + 12
_TEXT_RIGHT_PX: Final = 8
_MARK_PX: Final = 20.0
_RING_PX: Final = 2.6
_GAP_PX: Final = 4.0
_PAD_PX: Final = 10.0
_WORDS: Final = Texts("EnableButton") | {
    "enabling": "Enabling…",
    "disabling": "Disabling…",
    "enabled": "Enabled",
    "partly": "Partly enabled",
    "unknown": "Unknown",
    "disabled": "Disabled",
    "stopped": "Stopped",
}
_OF_ITSELF: Final = (
    MotionKind.SINKS,
    MotionKind.MOVES,
    MotionKind.UNMEASURED,
    MotionKind.UNHEARD,
)
"""The uncommanded motions that replace the state of the motors on the button."""
_WIDEST_PX: Final = 620
_MEANING_FROM_PX: Final = 400
_CONNECT: Final = also(
    "open port device adapter can baud bitrate disconnect simulator simulated simulate "
    "设备 端口 打开 波特率 断开 仿真 模拟"
)


class SpeedControl(Translated, QWidget):
    """Slider and field for the one speed, 0–100 % of the arm's highest, or of a run's own.

    While dragging, a lower speed is sent at once, a higher one when the handle is released; keys,
    clicks and the field send at once.

    Attributes:
        field: The field for a figure.
    """

    def __init__(self, controller: ArmController) -> None:
        super().__init__()
        self._controller = controller
        self.setMaximumWidth(_WIDEST_PX)
        self._label = QLabel()
        self._input = PercentInput(
            "speed",
            lambda: controller.operating_state.speed_percent,
            controller.motion.set_speed_percent,
            self,
        )
        self._slider, self.field = self._input.slider, self._input.field
        self.field.setFixedHeight(34)
        self._label.setBuddy(self.field)
        self._means = named("speed_means", ValueLabel(f"≤ {fmt.append_unit('0000', 'mm/s')}"))
        self._means.show_text("")
        # the text may shrink: else it would keep the window from becoming narrower
        self._means.setSizePolicy(QSizePolicy.Policy.Maximum, QSizePolicy.Policy.Fixed)
        self._arm_label = text_label(rank="muted")
        self._arm_value = named("arm_speed", ValueLabel(fmt.percent(100)))
        set_quantities(self, "arm.speed_percent", "own.speed_percent", "other.speed_percent")
        wanted = (self._label, (self._slider, 1), self.field, self._means)
        in_row(*wanted, self._arm_label, self._arm_value, on=self, spacing=8, margins=0)
        controller.state_changed.connect(self._on_state_changed)
        controller.operating_state_changed.connect(self._on_operating_state_changed)
        self.retranslate_ui()
        self._input.show_value()

    def _show_meaning(self, now: OperatingState, state: ArmState) -> None:
        """Show what the percentage means for a motion of the present mode; a jog has its own."""
        mode = None if state.status is None else state.status.value.move_mode
        quiet = now.link is not LinkState.ONLINE or now.running or now.jogging
        text = "" if quiet else _meaning(now, state.end_limits, mode)
        if text != self._means.text():
            self._means.show_text(text)
            self._describe()

    def resizeEvent(self, event: QResizeEvent) -> None:
        """Show what the percentage means only if there is room; else it is in the tooltip."""
        super().resizeEvent(event)
        self._means.setVisible(event.size().width() >= _MEANING_FROM_PX)
        self._describe()

    def _on_operating_state_changed(self, operating_state: OperatingState) -> None:
        self._input.follow_value()
        self._show_what_is_told(operating_state.generation)
        self._on_state_changed(self._controller.state)

    def _on_state_changed(self, state: ArmState) -> None:
        if not self.isVisible():
            return
        percent = None if state.status is None else state.status.value.speed_percent
        stale = is_stale(state.status, state, self._controller.operating_state)
        self._show_meaning(self._controller.operating_state, state)
        self._arm_value.show_text(fmt.percent(percent), stale=stale)
        self._slider.show_measured(None if stale else percent)

    def _show_what_is_told(self, generation: Generation | None) -> None:
        """Show the speed that the arm reports; only firmware of generation 1 does."""
        for widget in (self._arm_label, self._arm_value):
            widget.setVisible(generation is Generation.ONE)
            widget.setToolTip(self.tr("The speed percentage the arm reports"))

    def retranslate_ui(self) -> None:
        """Set all texts in the operator's language."""
        self._label.setText(self.tr("Speed"))
        self._arm_label.setText(self.tr("Arm"))
        self._means.setAccessibleName(self.tr("Speed at most, for a motion of the present mode"))
        self._means.setToolTip(self._means.accessibleName())
        self._describe()
        self._arm_value.setAccessibleName(self.tr("Speed percentage reported by the arm"))
        self._show_what_is_told(self._controller.operating_state.generation)

    def _describe(self) -> None:
        """Set the tooltip: the purpose, and the meaning of the percentage if it is not shown."""
        tip = self.tr(
            "The speed of everything, 0–100 %: of the arm's highest, and in a run of each point's "
            "or the recorded one. 0 % holds a run back. Slower {slower}, faster {faster}. A motion "
            "measured to be more than 1.5 times as fast as it was told is ended."
        ).format(slower=key_text("everywhere.slower"), faster=key_text("everywhere.faster"))
        if self._means.isHidden() and self._means.text():
            tip = f"{self._means.text()}\n{tip}"
        for widget in (self._slider, self.field):
            describe(widget, self.tr("Speed percentage"), tip)


def _meaning(now: OperatingState, end: Reading[EndLimits] | None, mode: int | None) -> str:
    """Return the highest speed of the tool along a line or an arc, else of the fastest joint."""
    share = now.speed_percent / 100.0
    if mode not in {MoveMode.MOVE_L, MoveMode.MOVE_C}:
        fastest_deg_s = max(each.max_speed_deg_s for each in now.limits)
        return f"≤ {fmt.with_unit(share * fastest_deg_s, '°/s', 1)}"
    if end is None:
        return ""
    return f"≤ {fmt.with_unit(share * 1e3 * end.value.max_linear_speed_m_s, 'mm/s', 0)}"


class EnableButton(Translated, QAbstractButton):
    """Shows for each joint whether it is enabled: filled, hollow, or dashed if not known.

    After an emergency stop the button says that the arm is stopped: the motors report disabled, but
    still brake until the release. If the arm moves without a command, it names that motion, and
    «Stopped» is shown only after the arm is measured at rest. A joint with a fault has a ring with
    «!», enabled or not.
    """

    def __init__(self) -> None:
        super().__init__()
        self.setObjectName("enable_button")
        keep_in_sight(self)
        self._enabled: tuple[bool | None, ...] = (None,) * len(JOINTS)
        self._faulty: tuple[int, ...] = ()
        self._busy: Busy | None = None
        self._stopped = False
        self._motion: MotionKind | None = None
        self.setFocusPolicy(Qt.FocusPolicy.StrongFocus)
        self.setSizePolicy(QSizePolicy.Policy.Fixed, QSizePolicy.Policy.Fixed)
        self.setAttribute(Qt.WidgetAttribute.WA_Hover)
        self.retranslate_ui()

    @property
    def marks(self) -> tuple[bool | None, ...]:
        """The state of each mark, joint 1 first."""
        return self._enabled

    @property
    def faulty(self) -> tuple[int, ...]:
        """The joints whose mark warns of a fault."""
        return self._faulty

    @property
    def turns_off(self) -> bool:
        """True if a click would disable: all six are enabled."""
        return all(self._enabled)

    @property
    def offer(self) -> str:
        """What a click does, as the second line; "" if the line of the next step shows it."""
        return self.tr("Disable…") if self.turns_off and self._state_name() == "enabled" else ""

    def show_faults(self, joints: tuple[int, ...]) -> None:
        """Let the marks of these joints warn of a fault that the arm reports."""
        if joints != self._faulty:
            self._faulty = joints
            self.retranslate_ui()

    def show_operating_state(self, operating_state: OperatingState) -> None:
        """Show the state of the motors as reported by the arm."""
        stopped = operating_state.stop is StopState.STOPPED
        motion = _told_as_a_word(operating_state.uncommanded, stopped=stopped)
        now = operating_state.enabled, operating_state.busy, stopped, motion
        if now != (self._enabled, self._busy, self._stopped, self._motion):
            self._enabled, self._busy, self._stopped, self._motion = now
            self.retranslate_ui()

    def retranslate_ui(self) -> None:
        """Set the text in the operator's language."""
        motion = self._motion
        self.setText(
            _WORDS.text(self._state_name())
            if motion is None
            else words.uncommanded_motion_word(motion)
        )
        known = [fmt.joints([j for j, on in zip(JOINTS, self._enabled, strict=True) if on])]
        if self._faulty:
            known.append(self.tr("Fault: {joints}").format(joints=fmt.joints(list(self._faulty))))
        self.setAccessibleName(" ".join(filter(None, (self.text(), *known))))
        self.updateGeometry()
        self.update()

    def _state_name(self) -> str:
        if self._stopped:
            return "stopped"
        if self._busy is Busy.ENABLING:
            return "enabling"
        if self._busy is Busy.DISABLING:
            return "disabling"
        if all(self._enabled):
            return "enabled"
        if any(self._enabled):
            return "partly"
        return "unknown" if None in self._enabled else "disabled"

    def _word_width(self) -> int:
        metrics = QFontMetrics(scaled_font(self, 1.0, bold=True))
        said = [_WORDS.text(word) for word in _WORDS]
        said += [words.uncommanded_motion_word(kind) for kind in _OF_ITSELF]
        return max(map(metrics.horizontalAdvance, said))

    def sizeHint(self) -> QSize:
        """Return the preferred size."""
        marks = len(JOINTS) * (_MARK_PX + _GAP_PX) - _GAP_PX
        return QSize(int(2 * _PAD_PX + self._word_width() + _PAD_PX + marks), 40)

    def minimumSizeHint(self) -> QSize:
        """Return the same size."""
        return self.sizeHint()

    def paintEvent(self, _event: QPaintEvent) -> None:
        """Draw the button."""
        colors = colors_of(self)
        painter = painting.begin(self)
        active = self.isEnabled() and (self.underMouse() or self.isDown())
        fill = colors.accent_pale if active else colors.surface
        line = colors.accent if self.hasFocus() else fill
        ink = colors.text if self.isEnabled() else colors.muted
        if self._motion is not None:
            fill, line, ink = colors.warn_pale, colors.warn, colors.warn
        painting.panel(painter, QRectF(self.rect()), fill, line, 2 if self.hasFocus() else 1)
        painter.setFont(scaled_font(self, 1.0, bold=True))
        painter.setPen(QColor(ink))
        area = QRectF(_PAD_PX, 0, self._word_width() + 2, self.height())
        left_middle = Qt.AlignmentFlag.AlignVCenter | Qt.AlignmentFlag.AlignLeft
        if self.offer:
            painter.drawText(area.adjusted(0, 0, 0, -self.height() / 2.5), left_middle, self.text())
            painter.setFont(scaled_font(self, 0.85))
            area.adjust(0, self.height() / 2.5, 0, 0)
        painter.drawText(area, left_middle, self.offer or self.text())
        left = self.width() - _PAD_PX - len(JOINTS) * (_MARK_PX + _GAP_PX) + _GAP_PX
        painter.setFont(scaled_font(self, 0.85, bold=True))
        for joint, enabled in zip(JOINTS, self._enabled, strict=True):
            x = left + (joint - 1) * (_MARK_PX + _GAP_PX) + _MARK_PX / 2
            center = QPointF(x, self.height() / 2)
            if joint in self._faulty:
                _draw_fault(painter, colors, center)
            else:
                _draw_mark(painter, colors, center, joint, enabled)
        painter.end()


def _told_as_a_word(motion: UncommandedMotion | None, *, stopped: bool) -> MotionKind | None:
    """Return the uncommanded motion that replaces the state of the motors, or ``None``."""
    if motion is None or motion.kind not in _OF_ITSELF:
        return None
    return motion.kind if stopped or motion.is_danger else None


def _draw_mark(
    painter: QPainter, colors: Colors, center: QPointF, joint: int, enabled: bool | None
) -> None:
    pen = QPen(QColor(colors.ok if enabled else colors.muted), 1.4)
    if enabled is None:
        pen.setStyle(Qt.PenStyle.DotLine)
    painter.setPen(pen)
    painter.setBrush(QColor(colors.ok) if enabled else Qt.BrushStyle.NoBrush)
    radius = _MARK_PX / 2 - 0.7
    painter.drawEllipse(center, radius, radius)
    painter.setPen(QColor(colors.surface if enabled else colors.muted))
    box = QRectF(center.x() - radius, center.y() - radius, 2 * radius, 2 * radius)
    painter.drawText(box, Qt.AlignmentFlag.AlignCenter, str(joint))


def _draw_fault(painter: QPainter, colors: Colors, center: QPointF) -> None:
    painter.setPen(QPen(QColor(colors.stop_ink), _RING_PX))
    painter.setBrush(QColor(colors.stop_pale))
    radius = (_MARK_PX - _RING_PX) / 2
    painter.drawEllipse(center, radius, radius)
    box = QRectF(center.x() - radius, center.y() - radius, 2 * radius, 2 * radius)
    painter.drawText(box, Qt.AlignmentFlag.AlignCenter, "!")


class CommunicationButton(Translated, QAbstractButton):
    """A sign, a word and the device's name; each state has a sign of its own shape."""

    def __init__(self) -> None:
        super().__init__()
        self.setObjectName("communication_button")
        self._link = LinkState.NO_DEVICE
        self._device: Device | None = None
        self._addressing = Addressing()
        self._may_move = False
        self.setFocusPolicy(Qt.FocusPolicy.StrongFocus)
        self.setSizePolicy(QSizePolicy.Policy.Maximum, QSizePolicy.Policy.Fixed)
        self.setAttribute(Qt.WidgetAttribute.WA_Hover)
        self.retranslate_ui()

    @property
    def link(self) -> LinkState:
        """The state shown."""
        return self._link

    @property
    def device_name(self) -> str:
        """The device shown; empty if there is none."""
        return "" if self._device is None else words.device_name(self._device)

    def show_operating_state(self, operating_state: OperatingState) -> None:
        """Show the state of the connection."""
        motion = operating_state.uncommanded
        may_move = motion is not None and motion.kind is MotionKind.UNHEARD
        device, addressing = operating_state.device, operating_state.addressing
        now = (operating_state.link, device, addressing, may_move)
        if now != (self._link, self._device, self._addressing, self._may_move):
            self._link, self._device, self._addressing, self._may_move = now
            self.retranslate_ui()

    def retranslate_ui(self) -> None:
        """Set the text in the operator's language."""
        tips = {
            LinkState.NO_DEVICE: self.tr("No CAN device is connected. Press to choose one."),
            LinkState.OPENING: self.tr("The CAN device is being opened."),
            LinkState.OFFLINE: self.tr(
                "The CAN device is open, but no arm is heard on it. "
                "Check the arm's power, the cable and the bit rate."
            ),
            LinkState.ONLINE: self.tr("The arm is heard. Press to disconnect or choose another."),
            LinkState.LOST: self.tr(
                "The CAN device is gone. Plug it in again: it is reconnected by itself."
            ),
        }
        self.setText(self._link_words()[self._link])
        lines = (self.device_name, tips[self._link], self._offset_text())
        self.setToolTip("\n".join(filter(None, lines)))
        self.setAccessibleName(f"{self.text()} {self.device_name}".strip())
        self.updateGeometry()
        self.update()

    def _offset_text(self) -> str:
        """Return a sentence with the first identifier of the feedback; "" for the usual one."""
        offset = self._addressing.feedback_offset
        if self._link is not LinkState.ONLINE or self._addressing == Addressing():
            return ""
        return self.tr("Its feedback comes from {feedback} on; see Linkage control.").format(
            feedback=f"0x{0x2A1 + offset:03X}"
        )

    def _link_words(self) -> dict[LinkState, str]:
        return {
            LinkState.NO_DEVICE: self.tr("Not connected"),
            LinkState.OPENING: self.tr("Connecting…"),
            LinkState.OFFLINE: self.tr("Offline"),
            LinkState.ONLINE: self.tr("Online"),
            LinkState.LOST: self.tr("Connection lost"),
        }

    def sizeHint(self) -> QSize:
        """Return the preferred size."""
        return self.minimumSizeHint().expandedTo(QSize(_WIDTH_PX, _HEIGHT_PX))

    def minimumSizeHint(self) -> QSize:
        """Return a size for the word, which is never cut; the device's name is shortened."""
        metrics = QFontMetrics(self._word_font())
        word = max(metrics.horizontalAdvance(word) for word in self._link_words().values())
        return QSize(int(_TEXT_LEFT_PX + word + _TEXT_RIGHT_PX) + 1, _HEIGHT_PX)

    def _word_font(self) -> QFont:
        return scaled_font(self, 1.05, bold=True)

    def _second_line(self) -> str:
        if self._may_move:
            return self.tr("May be moving")
        nothing = "" if self._link is LinkState.OPENING else self.tr("Choose a device")
        return self.device_name or nothing

    def paintEvent(self, _event: QPaintEvent) -> None:
        """Draw the button."""
        colors = colors_of(self)
        painter = painting.begin(self)
        active = self.underMouse() or self.isDown()
        fill = colors.accent_pale if active else colors.surface
        line = colors.accent if self.hasFocus() else fill
        painting.panel(painter, QRectF(self.rect()), fill, line, 2 if self.hasFocus() else 1)
        _draw_sign(painter, colors, QPointF(12 + _SIGN_PX, self.height() / 2), self._link)
        half = self.height() / 2
        width = self.width() - _TEXT_LEFT_PX - _TEXT_RIGHT_PX
        painter.setFont(self._word_font())
        painter.setPen(QColor(colors.text))
        above = QRectF(_TEXT_LEFT_PX, 0, width, half)
        painter.drawText(above, Qt.AlignmentFlag.AlignBottom, self.text())
        font = scaled_font(self, 0.88)
        name = QFontMetrics(font).elidedText(
            self._second_line(), Qt.TextElideMode.ElideRight, int(width)
        )
        painter.setFont(font)
        painter.setPen(QColor(colors.warn if self._may_move else colors.muted))
        below = QRectF(_TEXT_LEFT_PX, half + 1, width, half)
        painter.drawText(below, Qt.AlignmentFlag.AlignTop, name)
        painter.end()


def _draw_sign(painter: QPainter, colors: Colors, center: QPointF, link: LinkState) -> None:
    """Draw the link's sign: tick online, ring offline, dotted none, arc opening, triangle lost."""
    round_cap = Qt.PenCapStyle.RoundCap
    painter.setBrush(Qt.BrushStyle.NoBrush)
    box = QRectF(
        center.x() - _SIGN_PX + 1, center.y() - _SIGN_PX + 1, 2 * _SIGN_PX - 2, 2 * _SIGN_PX - 2
    )
    if link is LinkState.ONLINE:
        painter.setPen(Qt.PenStyle.NoPen)
        painter.setBrush(QColor(colors.ok))
        painter.drawEllipse(center, _SIGN_PX, _SIGN_PX)
        painter.setPen(QPen(QColor(colors.surface), 2, c=round_cap))
        painter.drawLine(center + QPointF(-3.5, 0.3), center + QPointF(-1.0, 3.0))
        painter.drawLine(center + QPointF(-1.0, 3.0), center + QPointF(3.8, -2.8))
    elif link is LinkState.OFFLINE:
        painter.setPen(QPen(QColor(colors.warn), 2.4))
        painter.drawEllipse(box)
        painter.setPen(QPen(QColor(colors.warn), 2.4, c=round_cap))
        painter.drawLine(center + QPointF(-2.6, 0), center + QPointF(2.6, 0))
    elif link is LinkState.OPENING:
        painter.setPen(QPen(QColor(colors.accent), 2.4, c=round_cap))
        painter.drawArc(box, 30 * 16, 240 * 16)
    elif link is LinkState.LOST:
        painter.setPen(Qt.PenStyle.NoPen)
        painter.setBrush(QColor(colors.stop))
        painter.drawPolygon(painting.triangle(center + QPointF(0, 1.5), _SIGN_PX + 1.5))
        painter.setPen(QPen(QColor(colors.surface), 1.8, c=round_cap))
        painter.drawLine(center + QPointF(0, -2.5), center + QPointF(0, 1.8))
        painter.drawPoint(center + QPointF(0, 4.6))
    else:
        painter.setPen(QPen(QColor(colors.muted), 1.6, Qt.PenStyle.DotLine))
        painter.drawEllipse(box)


class TopBar(Translated, QWidget):
    """Connection, speed, motors and stops: always visible, whatever panel is open.

    Args:
        controller: The controller of the arm.
        open_connection: Opens the window in which a CAN device is chosen.
        monitor: Gives the faults of the joints.
    """

    commands = (
        Command("window.connect", Text("ConnectDialog", "Connect arm"), synonyms=_CONNECT),
        Command(
            "window.enable",
            Text("Action", "Enable or disable all motors"),
            synonyms=also("power servo on off 上电 下电 断电 伺服"),
        ),
        Command(
            "window.speed",
            Text("SpeedControl", "Speed percentage"),
            operation_of(Motion.set_speed_percent),
            synonyms=also("velocity fast slow override 速度 倍率 快 慢"),
        ),
    )

    def __init__(
        self,
        controller: ArmController,
        open_connection: Callable[[], None],
        monitor: JointMonitor,
        parent: QWidget | None = None,
    ) -> None:
        super().__init__(parent)
        self.setObjectName("top_bar")
        self.setAttribute(Qt.WidgetAttribute.WA_StyledBackground)  # else no background is drawn
        self._controller = controller
        self._monitor = monitor
        self._communication = CommunicationButton()
        self._enable = EnableButton()
        self._speed = SpeedControl(controller)
        left = (self._communication, (self._speed, 1))
        layout = in_row(*left, on=self, spacing=12, margins=(8, 6, 8, 6))
        layout.addStretch(0)
        fill(layout, self._enable, HaltButton(controller), StopButton(controller))
        self._communication.clicked.connect(open_connection)
        self._enable.clicked.connect(self._on_enable)
        controller.operating_state_changed.connect(self._show_operating_state)
        monitor.worst_changed.connect(self._show_faults)
        self._show_operating_state(controller.operating_state)
        self._show_faults()

    def command_targets(self) -> Mapping[str, Target]:
        """Return the target of each command, by the command's name."""
        return {
            "window.connect": self._communication,
            "window.enable": self._enable,
            "window.speed": self._speed.field,
        }

    def _show_operating_state(self, operating_state: OperatingState) -> None:
        self._communication.show_operating_state(operating_state)
        self._enable.show_operating_state(operating_state)
        self._describe_enable(operating_state)

    def _show_faults(self) -> None:
        joints = {joint for joint, _item, _word in self._monitor.faults}
        self._enable.show_faults(tuple(sorted(joints)))
        self._describe_enable(self._controller.operating_state)

    def _describe_enable(self, operating_state: OperatingState) -> None:
        off = self._enable.turns_off
        blocked = (why_not_disable if off else why_not_enable)(operating_state)
        drops = self.tr("Disables all six motors: the arm will drop, so hold it first.")
        use = drops if off else self.tr("Enables all six motors.")
        enable_or_explain(self._enable, words.why_not(blocked), use)
        faults = [
            f"J{joint}  {words.joint_item(item)} {words.joint_word(word)}"
            for joint, item, word in self._monitor.faults
        ]
        if faults:
            self._enable.setToolTip("\n".join([*faults, self._enable.toolTip()]))

    def _on_enable(self) -> None:
        if not self._enable.turns_off:
            self._controller.motors.enable()
            return
        danger = self.tr("The arm will drop when its motors are disabled. Hold the arm.")
        generation = self._controller.operating_state.generation
        confirm(
            self.window(),
            self._controller,
            title=self.tr("Disable the motors"),
            text=words.disabling(danger, generation, self._controller.state),
            action_label=self.tr("Disable"),
            on_confirmed=self._controller.motors.disable,
            hold=True,
            still=lambda: self._enable.turns_off,
            sinks=True,
        )

    def retranslate_ui(self) -> None:
        """Set all texts in the operator's language."""
        self._describe_enable(self._controller.operating_state)
