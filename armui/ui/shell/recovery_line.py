"""The next step towards an arm that may be moved: one line, one button, above the panels."""

from __future__ import annotations

from collections.abc import Callable
from typing import TYPE_CHECKING, Final

from PySide6.QtCore import QEvent, QObject, QRect, QRectF, QSize, Qt, Signal
from PySide6.QtGui import QMouseEvent, QPaintEvent
from PySide6.QtWidgets import QLabel, QPushButton, QSizePolicy, QWidget

from armui.control.events import Level
from armui.control.link.link_state import LinkState
from armui.control.operating_state import OperatingState
from armui.control.safety.recovery_steps import NO_DEVICE, OPENING, Action, Step, StepKind
from armui.ui import words
from armui.ui.dialogs.confirm_dialog import confirm
from armui.ui.theme import Colors, colors_of
from armui.ui.widgets import icons, painting
from armui.ui.widgets.buttons import enable_or_explain, named, show_primary
from armui.ui.widgets.hold_button import HoldButton
from armui.ui.widgets.layouts import in_row
from armui.ui.widgets.painting import repolish
from armui.ui.widgets.text_label import text_label
from armui.ui.widgets.translated import Translated

if TYPE_CHECKING:
    from armui.control.arm_controller import ArmController

_ICON_PX: Final = 20
_BUTTON_PX: Final = 132
_GAP_PX: Final = 10
_MARGIN_PX: Final = 16
_TOP_PX: Final = 6
_PADDING_PX: Final = 5
_TWO_LINES: Final = "急\n急"

_CALM: Final = frozenset(
    {StepKind.OPENING, StepKind.HANDSHAKE, StepKind.RUNNING, StepKind.MOVING, StepKind.READY}
)
"""Steps without a fault, shown in muted text without background and button."""
_OF_A_RUN: Final = frozenset(
    {
        StepKind.RUNNING,
        StepKind.RUN_WAITS,
        StepKind.RUN_PAUSED,
        StepKind.MOVING,
        StepKind.READY,
    }
)
"""The steps that need not be shown beside a run, because its strip says the same."""


class StepButton(QPushButton):
    """Carries out a step; a double click does not also confirm the step that follows."""

    def mouseDoubleClickEvent(self, event: QMouseEvent) -> None:
        """Ignore the second click."""
        event.accept()


class RecoveryLine(Translated, QWidget):
    """Shows the next step and carries it out; dangerous steps ask first.

    Its room is kept when there is nothing to do, so that nothing moves under the mouse when a fault
    comes or goes.

    Args:
        controller: Gives the step.
        open_connection: Opens the window in which a CAN device is chosen.
        open_reference_check: Opens the window of the reference check.

    Signals:
        step_shown: Another step is shown.
    """

    step_shown = Signal()

    def __init__(
        self,
        controller: ArmController,
        open_connection: Callable[[], None],
        open_reference_check: Callable[[], None],
    ) -> None:
        super().__init__()
        self.setObjectName("recovery_line")
        self._controller = controller
        self._open_connection = open_connection
        self._open_reference_check = open_reference_check
        self._asking = ""
        self._texts: tuple[str, ...] = ("",)
        begun = controller.operating_state.link is not LinkState.NO_DEVICE
        self._step = controller.recovery.step if begun else NO_DEVICE
        self._area: QWidget | None = None
        self._pressed = self._step
        self._pressed_for = controller.mark
        self._icon = QLabel()
        self._icon.setFixedWidth(_ICON_PX)
        self._text = text_label("recovery_text", wraps=True, plain=True)
        self._text.setSizePolicy(QSizePolicy.Policy.Ignored, QSizePolicy.Policy.Ignored)
        self._text.installEventFilter(self)
        self._button = named("recovery_button", StepButton())
        self._button.setMinimumWidth(_BUTTON_PX)
        self._hold_button = named("recovery_hold_button", HoldButton(controller))
        self._hold_button.setMinimumWidth(_BUTTON_PX)
        self._other_button = named("recovery_other_button", StepButton())
        side = _MARGIN_PX + _GAP_PX
        margins = (side, _TOP_PX + _PADDING_PX, side, _PADDING_PX)
        layout = in_row(self._icon, (self._text, 1), on=self, spacing=_GAP_PX, margins=margins)
        for button in (self._other_button, self._hold_button, self._button):
            layout.addWidget(button, 0, Qt.AlignmentFlag.AlignVCenter)
        self.setSizePolicy(QSizePolicy.Policy.Expanding, QSizePolicy.Policy.Fixed)
        for button in (self._button, self._hold_button, self._other_button):
            button.pressed.connect(self._on_pressed)
        self._button.clicked.connect(self._on_clicked)
        self._hold_button.held.connect(lambda: self._act(self._pressed.action))
        self._other_button.clicked.connect(lambda: self._carry_out(self._pressed.alternative))
        controller.step_changed.connect(self._on_step_changed)
        controller.operating_state_changed.connect(self._on_operating_state_changed)
        self._show_step()

    @property
    def step_button(self) -> QPushButton | HoldButton | None:
        """The button that carries out the next step, or ``None`` if there is none."""
        shown = (each for each in (self._button, self._hold_button) if each.isVisible())
        return next(shown, None)

    def stand_back_for(self, area: QWidget) -> None:
        """Highlight no step while a button in an area of the window is highlighted."""
        self._area = area
        self._controller.state_changed.connect(self._highlight)

    def show_asking(self, name: str) -> None:
        """Show that a trajectory waits for the operator's confirmation.

        Args:
            name: The trajectory; "" if none waits.
        """
        self._asking = name
        self._show_step()

    @property
    def says_more_than_a_run(self) -> bool:
        """True if the step must be shown beside the strip of a run."""
        return self._asks or self._warns or self._step.kind not in _OF_A_RUN

    @property
    def _is_calm(self) -> bool:
        return self._step.kind in _CALM and not self._asks and not self._warns

    @property
    def _warns(self) -> bool:
        """True if the arm moves, or may move, without a command."""
        return self._step.motion is not None and self._step.motion.is_danger

    @property
    def _asks(self) -> bool:
        """True if a question about a run is the only thing to do."""
        return bool(self._asking) and self._step.kind is StepKind.READY and not self._warns

    @property
    def _level(self) -> Level:
        return Level.INFO if self._asks else self._step.level

    # -- behaviour ----------------------------------------------------------------------------

    def _on_pressed(self) -> None:
        """Remember the step shown at the press: a step that follows must not be carried out."""
        self._pressed = self._step
        self._pressed_for = self._controller.mark

    def _on_clicked(self) -> None:
        self._carry_out(self._pressed.action)

    def _carry_out(self, action: Action | None) -> None:
        step = self._pressed
        if action is Action.CONNECT:
            self._open_connection()
        elif action is Action.CHECK_REFERENCE:
            self._open_reference_check()
        elif action is not None and action.value.danger:
            confirm(
                self.window(),
                self._controller,
                title=words.step_question(action),
                text=words.step_danger(action),
                action_label=words.step_action(action),
                on_confirmed=lambda: self._controller.recovery.act(step, action),
                hold=True,
                still=lambda: self._controller.recovery.step.kind is step.kind,
                sinks=action in {Action.RESET, Action.LEAVE_MODE},
            )
        else:
            self._act(action)

    def _act(self, action: Action | None) -> None:
        if action is not None:
            self._controller.recovery.act(self._pressed, action, self._pressed_for)

    # -- appearance ---------------------------------------------------------------------------

    def _on_step_changed(self, step: Step) -> None:
        self._step = step
        self._show_step()

    def _on_operating_state_changed(self, now: OperatingState) -> None:
        if self._step is NO_DEVICE and now.link is LinkState.OPENING:
            self._on_step_changed(OPENING)  # `expect_device` has only changed the link
        elif self._button.isVisible() or self._hold_button.isVisible():
            self._show_button()

    def _show_step(self) -> None:
        step = self._step
        self._texts = tuple(f"{text}{self._below(text)}" for text in words.step_texts(step))
        text = self._texts[0]
        if self._asks:
            text = self.tr(
                "“{name}” has not started: the check asks first. Read what was found, and "
                "press the button beside it."
            ).format(name=self._asking)
            self._texts = (text,)
        self._fit_text()
        self._text.setProperty("rank", "muted" if self._is_calm else None)
        repolish(self._text)
        self.setAccessibleName(text)
        self._show_button()
        self._highlight()
        self._recolor()
        self.update()
        self.step_shown.emit()

    def _below(self, text: str) -> str:
        """Return a sentence with what a released arm would drop on (S32).

        Empty if the text describes the arm's motion already, which includes this.
        """
        motion = self._step.motion
        told = motion is not None and motion.below and words.uncommanded_motion(motion) in text
        if self._step.action is not Action.RESUME or told:
            return ""
        names = self._controller.area_guard.below()
        sentence = self.tr("Below the arm: {names}.").format(names=names)
        return f" {sentence}" if names else ""

    def _fit_text(self) -> None:
        """Show the longest version of the text that fits; the tooltip has the full one."""
        room = self._text.contentsRect()
        flags = Qt.TextFlag.TextWordWrap | self._text.alignment()
        unlimited = QRect(0, 0, max(room.width(), 1), 1 << 16)
        measured = self._text.fontMetrics()
        fitting = (
            text
            for text in self._texts
            if measured.boundingRect(unlimited, flags, text).height() <= room.height()
        )
        self._text.setText(next(fitting, self._texts[-1] if room.height() else self._texts[0]))
        self._text.setToolTip(self._texts[0] if self._text.text() != self._texts[0] else "")

    def eventFilter(self, watched: QObject, event: QEvent) -> bool:
        """Fit the text into its room when that has changed."""
        if watched is self._text and event.type() == QEvent.Type.Resize:
            self._fit_text()
        return super().eventFilter(watched, event)

    def _show_button(self) -> None:
        step = self._step
        action = None if step.kind in _CALM else step.action
        free = action in {None, Action.CONNECT, Action.CHECK_REFERENCE}
        blocked = None if free else self._controller.recovery.why_not(step)
        button = self._hold_button if step.held else self._button
        policy = self._button.sizePolicy()
        policy.setRetainSizeWhenHidden(not step.held)  # a hidden button keeps its width
        self._button.setSizePolicy(policy)
        self._button.setVisible(action is not None and not step.held)
        self._hold_button.setVisible(action is not None and step.held)
        waiting = self.tr("Waiting for the arm") if step.waiting else ""
        button.setAccessibleName(self.tr("Next step"))
        if action is not None:
            label = self.tr("Waiting…") if step.waiting else words.step_action(action)
            button.setText(label)
            button.setAccessibleName(label)
            use = words.step_danger(action) if step.dangerous else words.step(step)
            use = f"{use}{self._below(use)}"
            enable_or_explain(button, waiting or words.why_not(blocked), use)
        self._other_button.setVisible(step.alternative is not None)
        self._hold_button.setAccessibleName(self.tr("Next step"))
        self._other_button.setAccessibleName(self.tr("Another way"))
        if step.held and action is not None:
            self._hold_button.setAccessibleName(self._hold_button.text())
        if step.alternative is not None:
            label = words.step_action(step.alternative)
            self._other_button.setText(label)
            self._other_button.setAccessibleName(label)

    def _highlight(self, *_: object) -> None:
        """Highlight the step's button if it is recommended and no other button is highlighted."""
        step = self._step
        one_of_two = step.alternative is not None and step.failed is None
        wanted = (step.level is Level.INFO or one_of_two) and not step.dangerous
        if wanted and self._area is not None and self._button.isVisible():
            others = self._area.findChildren(QPushButton)
            wanted = not any(
                each.isVisible() and each.isEnabled() and each.property("primary")
                for each in others
            )
        show_primary(self._button, wanted=wanted)

    def _recolor(self) -> None:
        colors = colors_of(self)
        ratio = self.devicePixelRatioF()
        if self._is_calm:
            if self._step.kind is StepKind.READY:
                self._icon.setPixmap(icons.pixmap("done", colors.ok, _ICON_PX, ratio))
            else:
                self._icon.clear()
            return
        _fill, ink = _paint_colors(colors, self._level)
        name = "info" if self._level is Level.INFO else "warning"
        self._icon.setPixmap(icons.pixmap(name, ink, _ICON_PX, ratio))

    def retranslate_ui(self) -> None:
        """Set all texts in the operator's language."""
        self._show_step()

    def hasHeightForWidth(self) -> bool:  # noqa: N802 - the name Qt calls
        """Return false: the height does not depend on the width."""
        return False

    def sizeHint(self) -> QSize:
        """Return a size with room for two lines and the button."""
        text = self.fontMetrics().size(0, _TWO_LINES).height()
        height = max(text, self._button.sizeHint().height())
        return QSize(400, height + 2 * _PADDING_PX + _TOP_PX)

    def minimumSizeHint(self) -> QSize:
        """Return the same height without a minimal width."""
        return QSize(0, self.sizeHint().height())

    def paintEvent(self, _event: QPaintEvent) -> None:
        """Draw the background, unless there is nothing to do."""
        if self._is_calm:
            return
        fill, _ink = _paint_colors(colors_of(self), self._level)
        painter = painting.begin(self)
        ground = QRectF(self.rect()).adjusted(_MARGIN_PX, _TOP_PX, -_MARGIN_PX, 0)
        painting.panel(painter, ground, fill, fill)
        painter.end()


def _paint_colors(colors: Colors, level: Level) -> tuple[str, str]:
    """Return the colours of background and sign."""
    return {
        Level.INFO: (colors.accent_pale, colors.accent),
        Level.DONE: (colors.accent_pale, colors.ok),
        Level.WARNING: (colors.warn_pale, colors.warn),
        Level.FAULT: (colors.stop_pale, colors.stop_ink),
    }[level]
