"""Region 11: on the left the last event, on the right the arm's status (0x2A1)."""

from __future__ import annotations

from datetime import datetime
from typing import TYPE_CHECKING, Final

from PySide6.QtCore import QEvent, QObject, Qt, Signal
from PySide6.QtGui import QGuiApplication, QMouseEvent, QShowEvent
from PySide6.QtWidgets import QLabel, QToolButton, QWidget

from armui.arm.limits import JOINTS
from armui.arm.models import model_data
from armui.arm.refusal import Refusal
from armui.arm.state import ArmState, Status
from armui.control.events import Event, Level
from armui.control.link.link_state import LinkState
from armui.control.operating_state import OperatingState
from armui.control.safety.uncommanded_motion import MotionKind, UncommandedMotion
from armui.protocol.codes import AT_WORK, TARGET_REFUSALS, ArmStatusCode, TeachingState
from armui.system.failures import Failure
from armui.telemetry.events import EventKind
from armui.ui import format as fmt
from armui.ui import words
from armui.ui.actions.act import Act, HasActs
from armui.ui.freshness import is_stale
from armui.ui.theme import colors_of
from armui.ui.widgets import icons
from armui.ui.widgets.buttons import MARK_ICON_PX, named, show_as_mark
from armui.ui.widgets.curve_menu import set_quantities
from armui.ui.widgets.layouts import STRETCH, in_column, in_row
from armui.ui.widgets.message_line import MessageLine
from armui.ui.widgets.painting import set_rank
from armui.ui.widgets.text_label import ElidedLabel, text_label
from armui.ui.widgets.translated import Translated
from armui.ui.words.arm import OTHER_MODES
from armui.ui.words.text import joined

if TYPE_CHECKING:
    from collections.abc import Callable

    from armui.control.arm_controller import ArmController


_WARNINGS: Final = TARGET_REFUSALS | {ArmStatusCode.OVERSPEED_WHILE_TEACHING}
_LEAVES: Final = frozenset({MotionKind.SINKS, MotionKind.MOVES, MotionKind.LED})
"""The motions by which an arm leaves a target that it still reports as reached."""
_ICON_PX: Final = 16
_QUANTITIES: Final = {
    "control": ("arm.control_mode",),
    "arm": ("arm.arm_status",),
    "mode": ("arm.move_mode", "own.move_mode", "other.move_mode"),
    "teaching": ("arm.teaching",),
    "reached": ("arm.not_reached",),
    "joints": ("arm.no_communication", "arm.beyond_limit"),
}


class FailureLine(HasActs, Translated, QWidget):
    """Shows the newest unexpected failure and its count; hidden until there is one.

    Its height is taken from the picture, so that buttons that move the arm keep their places.
    """

    copy = Act("Copy details", named="failure_copy_button")
    dismiss = Act("Close", named="failure_close_button")

    def __init__(self) -> None:
        super().__init__()
        self.setObjectName("failure_line")
        self._failure: Failure | None = None
        self._motion_ended = True
        self._message = MessageLine()
        buttons = in_row(STRETCH, self.copy, self.dismiss)
        in_column(self._message, buttons, on=self, spacing=4, margins=(8, 4, 8, 8))
        self.retranslate_ui()
        self.hide()

    def text(self) -> str:
        """Return the text."""
        return self._message.text()

    def show_failure(self, failure: Failure, *, motion_ended: bool) -> None:
        """Show a failure; the same one again, put away, is only counted if it ends no motion.

        Args:
            failure: The failure.
            motion_ended: True if every motion of this program was ended because of it.
        """
        again = self._failure is not None and self._failure.error == failure.error
        self._failure, self._motion_ended = failure, motion_ended
        self._show_text()
        if motion_ended or not again:
            self.show()

    @dismiss.pressed
    def _on_dismiss(self) -> None:
        self.hide()

    @copy.pressed
    def _on_copy(self) -> None:
        if self._failure is not None:
            QGuiApplication.clipboard().setText(self._failure.text)

    def _show_text(self) -> None:
        if self._failure is None:
            return
        if self._motion_ended:
            text = self.tr(
                "An error in the program ({error}). The emergency stop works; every motion of this "
                "program has been ended. Copy the details for the developers."
            )
        else:
            text = self.tr(
                "An error in the program ({error}). The emergency stop works; the part that failed "
                "can move nothing, and no motion was ended. Copy the details for the developers."
            )
        text = text.format(error=self._failure.error)
        if self._failure.count > 1:
            times = self.tr("It has happened {count} times.").format(count=self._failure.count)
            text = joined(text, times)
        self._message.show_message(text, Level.FAULT)

    def retranslate_ui(self) -> None:
        """Update the texts in the operator's language."""
        self.show_acts()
        self._show_text()


class ModelMark(Translated, QToolButton):
    """The model's name while a device is open; a click opens the window to choose it.

    Args:
        controller: Gives the model.
        open_connection: Opens that window.
    """

    def __init__(self, controller: ArmController, open_connection: Callable[[], object]) -> None:
        super().__init__()
        self._controller = controller
        self.setObjectName("model_mark")
        show_as_mark(self)
        controller.operating_state_changed.connect(self._show)
        self.clicked.connect(lambda _checked: open_connection())
        self.retranslate_ui()

    def retranslate_ui(self) -> None:
        """Set all texts in the operator's language."""
        self._show(self._controller.operating_state)

    def _recolor(self) -> None:
        self._show(self._controller.operating_state)

    def _show(self, now: OperatingState) -> None:
        self.setVisible(now.link is not LinkState.NO_DEVICE)
        fit, name = now.model_fit, model_data(now.model).name
        colors = colors_of(self)
        wrong = fit.wrong is not None or fit.before is not None
        if fit.other is not None:
            other = model_data(fit.other).name
            text = self.tr("{model}? The pose is that of a {other}").format(model=name, other=other)
            tip = self.tr("Click to connect it as a {other}.").format(other=other)
        elif fit.before is not None:
            before = model_data(fit.before).name
            text = self.tr("{model}? It was a {before}").format(model=name, before=before)
            tip = self.tr("Last time this arm was a {before}. Click to choose.").format(
                before=before
            )
        elif wrong:
            text = self.tr("{model}? The pose fits none").format(model=name)
            tip = self.tr("The pose the arm reports fits none of the models.")
        elif fit.confirmed:
            text, tip = name, self.tr("Model of the arm, confirmed by the pose it reports.")
        else:
            text, tip = name, self.tr("Model of the arm, as chosen; not checked yet.")
        if fit.older_zeros:
            tip += "\n" + self.tr("Joints 2 and 3 use the zeros from before S-V1.6-3.")
        self.setText(text)
        self.setToolTip(tip)
        self.setAccessibleName(self.tr("Model of the arm: {text}").format(text=text))
        if wrong:
            self.setIcon(icons.icon("warning", colors.warn, MARK_ICON_PX))
        style = (
            Qt.ToolButtonStyle.ToolButtonTextBesideIcon
            if wrong
            else Qt.ToolButtonStyle.ToolButtonTextOnly
        )
        self.setToolButtonStyle(style)
        set_rank(self, "warning" if wrong else "muted")


class StatusBar(Translated, QWidget):
    """The last event and the arm's status; the event is shortened if there is no room.

    Args:
        controller: Gives the events and the arm's state.
        with_notices: True to show the last event; for a log its time line shows them.

    Signals:
        event_wanted: The number of the notice's entry in the event log, or ``None``, when the
            notice was clicked.
    """

    event_wanted = Signal(object)

    def __init__(self, controller: ArmController, *, with_notices: bool = True) -> None:
        super().__init__()
        self.setObjectName("status_bar")
        self.setAttribute(Qt.WidgetAttribute.WA_StyledBackground)  # else no background is drawn
        self._controller = controller
        self._event: Event | None = None
        self._entry: int | None = None
        self._problem: tuple[datetime, Refusal] | None = None
        self._shown: tuple[Status | None, bool, str, bool] | None = None
        self._left = False
        self._notice_icon = QLabel()
        self._notice_label = named("notice_label", ElidedLabel())
        self._notice_label.installEventFilter(self)
        self._status_icon = QLabel()
        self._motion_label = text_label("status_motion", plain=True)
        self._motion_label.hide()
        self._motion_separator = text_label(text="│", rank="muted")
        self._motion_separator.hide()
        self._labels = {
            name: text_label(f"status_{name}", plain=True)
            for name in ("control", "arm", "mode", "teaching", "reached", "joints")
        }
        notice = (self._notice_icon, (self._notice_label, 1), 16)
        moves = self._motion_label, self._motion_separator
        self._layout = in_row(*notice, *moves, on=self, spacing=8, margins=(14, 6, 14, 6))
        self._separators: dict[str, QLabel] = {}
        for name, label in self._labels.items():
            set_quantities(label, *_QUANTITIES[name])
            if name != "control":
                self._separators[name] = text_label(text="│", rank="muted")
                self._layout.addWidget(self._separators[name])
            if name == "arm":
                self._layout.addWidget(self._status_icon)
            self._layout.addWidget(label)
        if with_notices:
            controller.noticed.connect(self._on_noticed)
        controller.state_changed.connect(self._on_state_changed)
        controller.operating_state_changed.connect(self._on_operating_state_changed)
        self.retranslate_ui()

    def add_mark(self, mark: QWidget) -> None:
        """Add a widget at the left."""
        self._layout.insertWidget(0, mark)

    # -- notice -------------------------------------------------------------------------------

    def _on_noticed(self, event: Event) -> None:
        if event.notice.kind is EventKind.ODDITY and self._outweighs_an_oddity:
            return  # such an event is only listed in the page of events
        self._event, self._problem = event, None
        self._entry = self._controller.event_collector.number_of(event)
        self._show_notice()

    @property
    def _outweighs_an_oddity(self) -> bool:
        """True if the bar shows something more important than an oddity on the bus."""
        event = self._event
        matters = event and event.level is not Level.INFO and event.notice.kind != EventKind.ODDITY
        return self._problem is not None or bool(matters)

    def show_problem(self, reason: Refusal) -> None:
        """Show a problem of the program itself."""
        self._problem = (datetime.now().astimezone(), reason)
        self._entry = self._controller.event_collector.on_problem(reason).number
        self._show_notice()

    def _show_notice(self) -> None:
        text, level = "", Level.INFO
        if self._problem is not None:
            at, reason = self._problem
            text, level = f"{at:%H:%M:%S}  {words.refusal(reason)}", Level.WARNING
        elif self._event is not None:
            text = f"{self._event.at:%H:%M:%S}  {words.event(self._event)}"
            level = self._event.level
        self._notice_label.show_text(text)
        shape = Qt.CursorShape.PointingHandCursor if text else Qt.CursorShape.ArrowCursor
        self._notice_label.setCursor(shape)
        colors = colors_of(self)
        color = {Level.WARNING: colors.warn, Level.FAULT: colors.stop_ink}.get(level)
        self._notice_icon.setVisible(color is not None)
        if color is not None:
            self._draw_warning(self._notice_icon, color)

    def eventFilter(self, watched: QObject, event: QEvent) -> bool:
        """Open the details of the event at a click on it."""
        if event.type() == QEvent.Type.MouseButtonRelease and isinstance(event, QMouseEvent):
            within = self._notice_label.rect().contains(event.position().toPoint())
            if within and event.button() is Qt.MouseButton.LeftButton and self._notice_label.text():
                self.event_wanted.emit(self._entry)
                return True
        return super().eventFilter(watched, event)

    # -- status -------------------------------------------------------------------------------

    def _on_state_changed(self, state: ArmState) -> None:
        if self.isVisible():
            self._show_status(state)

    def _on_operating_state_changed(self, _operating_state: OperatingState) -> None:
        if self.isVisible():
            self._show_status(self._controller.state)

    def _show_status(self, state: ArmState) -> None:
        heard = state.status
        stale = is_stale(heard, state, self._controller.operating_state)
        now = self._controller.operating_state
        self._show_motion(now.uncommanded)
        self._left |= now.uncommanded is not None and now.uncommanded.kind in _LEAVES
        self._left &= heard is not None and heard.value.reached and not now.moving
        shown = (None if heard is None else heard.value, stale, _foreign_mode(now), self._left)
        if shown != self._shown:
            self._shown = shown
            self._spell_out(*shown)

    def _show_motion(self, motion: UncommandedMotion | None) -> None:
        """Show an uncommanded motion of the arm while it lasts."""
        text = "" if motion is None else words.uncommanded_motion_short(motion)
        if text != self._motion_label.text():
            self._motion_label.setText(text)
            self._motion_label.setVisible(bool(text))
            self._motion_separator.setVisible(bool(text))
            set_rank(self._motion_label, "warning" if motion and motion.is_danger else "")

    def _spell_out(self, status: Status | None, stale: bool, mode: str, left: bool) -> None:
        """Show the codes in words; ``None`` is a status that was never received."""
        texts = self._texts_of(status, mode, left=left)
        # only a fresh status may raise an alarm: an old one may no longer hold
        alarm = None if stale or status is None else self._alarm(status)
        ranks = self._ranks(alarm, muted=stale or status is None)
        if mode and not stale:
            ranks["mode"] = "warning"
        self._labels["control"].setToolTip(
            "" if status is None else words.control_mode(status.control_mode)
        )
        for name, label in self._labels.items():
            label.setText(texts.get(name, ""))
            label.setVisible(name in texts)
            if name in self._separators:
                self._separators[name].setVisible(name in texts)
            set_rank(label, ranks[name])
        self._status_icon.setVisible(alarm is not None)
        if alarm is not None:
            colors = colors_of(self)
            color = colors.warn if alarm == "warning" else colors.stop_ink
            self._draw_warning(self._status_icon, color)

    def _texts_of(self, status: Status | None, mode: str, *, left: bool) -> dict[str, str]:
        """Return the text of each label by its name; a label without one is hidden."""
        if status is None:
            texts = dict.fromkeys(("control", "arm", "mode", "reached"), fmt.NOTHING)
        else:
            texts = {
                "control": words.control_mode_short(status.control_mode),
                "arm": words.arm_status(status.arm_status),
                "mode": self._mode(status.move_mode, mode),
                "reached": words.reached(status.reached, left=left),
            }
            if status.teaching != TeachingState.OFF:
                texts["teaching"] = words.teaching_now(status)
            if any(status.communication_fault) or any(status.limit_exceeded):
                texts["joints"] = self._joint_faults(status)
        texts["control"] = self.tr("Control: {mode}").format(mode=texts["control"])
        texts["arm"] = self.tr("Status: {status}").format(status=texts["arm"])
        return texts

    def _ranks(self, alarm: str | None, *, muted: bool) -> dict[str, str]:
        """Return the rank of each label; an alarm applies to the status and the faulty joints.

        Args:
            alarm: See `_alarm`.
            muted: True for a status that is stale, or was never received.
        """
        ranks = dict.fromkeys(self._labels, "muted" if muted else "")
        if alarm is not None:
            ranks |= {"arm": alarm, "joints": alarm}
        return ranks

    def _mode(self, code: int, foreign_mode: str) -> str:
        """Return the mode of motion in words; one chosen by another program is named as such."""
        if not foreign_mode:
            return words.move_mode(code)
        mode = OTHER_MODES.text(foreign_mode)
        text = self.tr("{mode} by another program").format(mode=mode)
        return text[:1].upper() + text[1:]

    def _alarm(self, status: Status) -> str | None:
        """Return the rank of the text: "fault", "warning", or ``None`` if all is well."""
        if any(status.communication_fault):
            return "fault"
        if status.arm_status in _WARNINGS:
            return "warning"
        if status.arm_status not in AT_WORK:
            return "fault"
        return "warning" if any(status.limit_exceeded) else None

    def _joint_faults(self, status: Status) -> str:
        """Return the faulty joints briefly, because the bar has only one line."""
        parts = []
        for text, flags in (
            (self.tr("No communication: {joints}"), status.communication_fault),
            (self.tr("Beyond limit: {joints}"), status.limit_exceeded),
        ):
            joints = [joint for joint, flag in zip(JOINTS, flags, strict=True) if flag]
            if joints:
                parts.append(text.format(joints=fmt.joints(joints)))
        return "  ".join(parts)

    def _draw_warning(self, label: QLabel, color: str) -> None:
        label.setPixmap(icons.pixmap("warning", color, _ICON_PX, self.devicePixelRatioF()))

    # -- appearance ---------------------------------------------------------------------------

    def retranslate_ui(self) -> None:
        """Update texts and colours to the present language and theme."""
        self._shown = None
        self._notice_label.setAccessibleName(self.tr("Last event"))
        self._show_notice()
        self._show_status(self._controller.state)

    def _recolor(self) -> None:
        self.retranslate_ui()

    def showEvent(self, event: QShowEvent) -> None:
        """Update the status, which was not updated while the bar was hidden."""
        super().showEvent(event)
        self._show_status(self._controller.state)


def _foreign_mode(now: OperatingState) -> str:
    """Return the mode commanded by another host (MIT, CPV, high-follow), or "".

    It is taken from that host's frames, because the arm's status (0x2A1) has no high-follow mode.
    """
    other = now.other_host
    return "" if other is None else str(other.refusal.params.get("other_mode", ""))
