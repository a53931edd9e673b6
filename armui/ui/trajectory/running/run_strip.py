"""The present run, shown for the whole window: name, place, remaining time; pause and end."""

from __future__ import annotations

import math
from collections.abc import Mapping
from typing import TYPE_CHECKING, Final

from PySide6.QtCore import QEvent, QObject, QRectF, QSize, Qt, QTimer, Signal
from PySide6.QtGui import QKeyEvent, QMouseEvent
from PySide6.QtWidgets import QApplication, QProgressBar, QSizePolicy, QWidget

from armui.control.motion.abort import RUN_STOPPED
from armui.control.operations.operation import operation_of
from armui.control.run.player import NOT_RUNNING, RUN_SPEED_ZERO, Player
from armui.control.run.progress import ENDLESS, OVER, Progress, RunPhase
from armui.control.run.runner import Runner, can_pause
from armui.ui import format as fmt
from armui.ui import words
from armui.ui.actions.act import Act, HasActs
from armui.ui.actions.command import Command, Target
from armui.ui.theme import colors_of
from armui.ui.widgets import icons, painting
from armui.ui.widgets.buttons import named
from armui.ui.widgets.layouts import fill, in_column, in_row
from armui.ui.widgets.text_label import ElidedLabel
from armui.ui.widgets.translated import Translated
from armui.ui.words.text import Text

if TYPE_CHECKING:
    from PySide6.QtGui import QHideEvent, QPaintEvent, QShowEvent

    from armui.arm.refusal import Refusal
    from armui.control.arm_controller import ArmController
    from armui.control.operating_state import OperatingState

_STEPS: Final = 1000
"""The steps of the progress bar."""
_BAR_PX: Final = 100
_ICON_PX: Final = 16
_MARGIN_PX: Final = 16
_TOP_PX: Final = 6
_SIDE_PX: Final = _MARGIN_PX + 10
_LEAST_PX: Final = 220
"""The width of the texts beside an obstacle, unless the run's buttons were there."""
_UNBOUNDED_PX: Final = 10_000
END_MS: Final = 5000
"""The time for which the end of a run is shown; a failed run is shown until it is closed."""
_SAID: Final = frozenset({RUN_SPEED_ZERO, RUN_STOPPED})
"""The reasons that the word for the phase already names."""
_PRESSES: Final = frozenset({QEvent.Type.MouseButtonPress, QEvent.Type.KeyPress})


class RunStrip(HasActs, Translated, QWidget):
    """Visible from the beginning of a run until 5 s after its end, or the first press after it.

    A failed run is shown until it is closed. It follows every run, of points or of a
    recording.

    Args:
        controller: Gives the run.

    Signals:
        turned: It is shown now, was put away, or stands on the other side of an obstacle.
    """

    turned = Signal()
    commands = (Command("run.go_on", operation=operation_of(Player.go_on)),)
    # buttons never take each other's place: a late press of Pause must not move the arm
    _next = Act("Next step", named="run_next")
    _pause = Act(
        "Pause",
        named="run_pause",
        does=Player.pause,
        key="run.pause",
        title=Text("RunStrip", "Pause"),
        tip="The run waits until it is continued. The Pause key of the keyboard stays the "
        "emergency stop.",
    )
    # must be held, so that no slip sets a paused motion going
    _continue = Act("Continue", named="run_continue", held=True)
    _stop = Act("End run", named="run_stop", key="run.stop")
    _close = Act("Close", named="run_close", tip="Puts this line away; the run is over.", flat=True)

    def __init__(self, controller: ArmController) -> None:
        super().__init__()
        self._controller = controller
        self.setObjectName("run_strip")
        self._runner = Runner(controller, self)
        self._refusal: Refusal | None = None
        self._name = named("run_name", ElidedLabel("heading"))
        self._text = named("run_text", ElidedLabel())
        self._bar = named("run_bar", QProgressBar(maximum=_STEPS, textVisible=False))
        self._bar.setFixedWidth(_BAR_PX)
        self._text_box = QWidget()
        self._beside = self._stood_first = False
        self._buttons_px = 0
        self._ends = QTimer(self, singleShot=True, interval=END_MS)
        self._ends.timeout.connect(self._on_end_shown)
        self._shows_end = False
        self._close.setIconSize(QSize(_ICON_PX, _ICON_PX))
        lines = in_column(self._name, self._text, spacing=0, margins=0)
        lines.setAlignment(Qt.AlignmentFlag.AlignVCenter)
        in_row((lines, 1), self._bar, on=self._text_box, spacing=12, margins=0)
        self._row = in_row((self._text_box, 1), self._next, on=self, spacing=12)
        fill(self._row, self._pause, self._continue, self._stop, self._close)
        self._row.setContentsMargins(_SIDE_PX, _TOP_PX, _SIDE_PX, 0)
        self._runner.progressed.connect(self._on_progress)
        controller.operating_state_changed.connect(self._on_operating_state)
        self.retranslate_ui()
        self._recolor()
        self.hide()

    def command_targets(self) -> Mapping[str, Target]:
        """Return the target of each command, by the command's name."""
        targets = super().command_targets()
        # a button to hold: the palette only focuses it, and never starts a motion
        go_on = self.go_on_button
        return targets if go_on is None else {**targets, "run.go_on": go_on}

    @property
    def go_on_button(self) -> QWidget | None:
        """The visible button that continues a paused or waiting run, or ``None``."""
        shown = (each for each in (self._continue, self._next) if each.isVisible())
        return next(shown, None)

    @property
    def stands_first(self) -> bool:
        """True if it is beside an obstacle without buttons, so that the obstacle's do not move.

        Once it had buttons their width is kept, so that no other button moves under the pointer.
        """
        return self._beside and not self._runner.running and not self._buttons_px

    def stand_beside(self, wanted: bool) -> None:
        """Leave room for an obstacle; its own buttons stay where they are.

        Args:
            wanted: Whether there is one.
        """
        self._beside = wanted
        policy = QSizePolicy.Policy.Fixed if wanted else QSizePolicy.Policy.Expanding
        self.setSizePolicy(policy, QSizePolicy.Policy.Preferred)
        self._show(self._runner.progress)

    @_pause.why_not
    def _why_not_pause(self) -> Refusal | None:
        return None if can_pause(self._runner.progress) else NOT_RUNNING()

    @_pause.pressed
    def _on_pause(self) -> None:
        self._refusal = self._runner.pause()
        self._show(self._runner.progress)

    @_next.pressed
    @_continue.pressed
    def _on_go_on(self) -> None:
        self._refusal = self._runner.go_on()
        self._show(self._runner.progress)

    @_stop.pressed
    def _on_stop(self) -> None:
        self._runner.stop()

    @_close.pressed
    def _on_close(self) -> None:
        self.hide()

    def _on_progress(self, progress: Progress) -> None:
        if self.isHidden() and self._runner.running:
            self._refusal = None
            self.show()
        elif progress.phase is RunPhase.IDLE:
            self.hide()
        elif self.isVisible():
            self._show(progress)

    def _on_operating_state(self, _operating_state: OperatingState) -> None:
        if self.isVisible() and self._is_paused:
            self._show(self._runner.progress)

    def _show(self, progress: Progress) -> None:
        running = self._runner.running
        self._bar.setValue(round(progress.done * _STEPS))
        self._name.show_text(progress.name)
        self._text.show_text(self._describe(progress))
        paused = self._is_paused
        self._next.setVisible(progress.phase is RunPhase.WAITING)
        self._pause.setVisible(running and not paused)
        RunStrip._pause.show(self)
        self._continue.setVisible(running and paused)
        self._stop.setVisible(running)
        self._text_box.setVisible(not (running and self._beside))
        # beside an obstacle the end's text takes their width, so that its button stays in place
        if running:
            self._buttons_px = self._row.sizeHint().width() - 2 * _SIDE_PX if self._beside else 0
        self._close.setVisible(not running and (self.stands_first or not self._beside))
        told_px = self._buttons_px or _LEAST_PX
        self._text_box.setMaximumWidth(told_px if self._beside else _UNBOUNDED_PX)
        self._text_box.setMinimumWidth(told_px if self._beside else 0)
        self._bar.setVisible(not self._beside)
        self._show_end(wanted=self.isVisible() and not running)
        self.update()
        if self.stands_first != self._stood_first:
            self._stood_first = self.stands_first
            self.turned.emit()

    def _show_end(self, *, wanted: bool) -> None:
        """Show the end of a run until a time has passed, or until the first press anywhere.

        A failed one is closed only by its own button. Beside an obstacle no press elsewhere closes
        it, which might move the obstacle's button under the pointer.
        """
        app = QApplication.instance()
        if wanted == self._shows_end or app is None:
            return
        self._shows_end = wanted
        if not wanted:
            self._ends.stop()
            app.removeEventFilter(self)
            return
        if self._runner.progress.phase is not RunPhase.FAILED:
            app.installEventFilter(self)
            self._ends.start()

    def _on_end_shown(self) -> None:
        row = self.parentWidget()
        if self._beside and row is not None and row.underMouse():
            self._ends.start()
        else:
            self.hide()

    def eventFilter(self, watched: QObject, event: QEvent) -> bool:
        """Hide the end of a run at a press, which has its usual effect, too."""
        # `event.type()` of every event of the program would take ten times as long in Python
        pressed = isinstance(event, QMouseEvent | QKeyEvent) and event.type() in _PRESSES
        if pressed and not self._beside:
            # after the press has reached its widget, which hiding might move
            QTimer.singleShot(0, self, self.hide)
        return super().eventFilter(watched, event)

    @property
    def _is_paused(self) -> bool:
        return self._runner.progress.phase is RunPhase.PAUSED

    def _describe(self, progress: Progress) -> str:
        if progress.phase is RunPhase.IDLE:
            return ""
        place = self.tr("{done} of the recording")
        if progress.name == self._controller.inspection.name:
            place = self.tr("{done} of the inspection")
        if progress.count:
            place = self.tr("point {row} of {count}")
        done = fmt.percent(100.0 * progress.done)
        place = place.format(row=progress.index + 1, count=progress.count, done=done)
        reason = progress.refusal if progress.phase in OVER else self._refusal
        told = reason is not None and reason.reason not in _SAID
        if self._beside:
            word = self._phase_word(progress)
            return f"{word} · {place}" if told and progress.phase in OVER else word
        parts = [place]
        if progress.cycles != 1:
            total = "∞" if progress.cycles == ENDLESS else progress.cycles
            text = self.tr("cycle {cycle} of {cycles}")
            parts.append(text.format(cycle=progress.cycle, cycles=total))
        if progress.remaining_s is not None and self._runner.running:
            left = fmt.duration(progress.remaining_s)
            parts.append(self.tr("{time} left").format(time=left))
        parts.append(self._phase_word(progress))
        if progress.percent is not None:
            parts.append(self._speed(progress.percent, progress.tool_mm_s))
        if told:
            over = progress.phase in OVER
            parts.append(words.why_ended(reason) if over else words.why_not(reason))
        return " · ".join(parts)

    def _speed(self, percent: int, tool_mm_s: float) -> str:
        """Return the speed that a motion is measured against."""
        if math.isinf(tool_mm_s):
            return self.tr("speed {percent}").format(percent=fmt.percent(percent))
        figures = {"percent": fmt.percent(percent), "speed": f"{tool_mm_s:.3g} mm/s"}
        return self.tr("speed {percent}, tool ≤ {speed}").format(**figures)

    def _phase_word(self, progress: Progress) -> str:
        if progress.refusal is not None and progress.refusal.reason == RUN_STOPPED:
            return self.tr("ended by the emergency stop")
        if self._is_paused and self._controller.operating_state.speed_percent == 0:
            return self.tr("paused: raise the speed at the top, then hold “Continue” for 1 s")
        return {
            RunPhase.IDLE: "",
            RunPhase.MOVING: self.tr("moving"),
            RunPhase.DWELLING: self.tr("dwelling"),
            RunPhase.WAITING: self.tr("waiting: press “Next step”"),
            RunPhase.PAUSED: self.tr("paused: hold “Continue” for 1 s"),
            RunPhase.STOPPING: self.tr("coming to rest"),
            RunPhase.DONE: self.tr("done"),
            RunPhase.STOPPED: self.tr("ended"),
            RunPhase.FAILED: self.tr("ended early"),
        }[progress.phase]

    def retranslate_ui(self) -> None:
        """Set all texts in the operator's language."""
        self._bar.setAccessibleName(self.tr("Progress of the run"))
        self.show_acts()
        self._show(self._runner.progress)

    def _recolor(self) -> None:
        self._close.setIcon(icons.icon("close", colors_of(self).muted))

    def showEvent(self, event: QShowEvent) -> None:
        """Update the progress, which was not updated while it was hidden."""
        super().showEvent(event)
        self._show(self._runner.progress)

        self.turned.emit()

    def hideEvent(self, event: QHideEvent) -> None:
        """Drop a refusal, which does not concern the next run."""
        super().hideEvent(event)
        self._refusal = None
        self._show_end(wanted=False)
        self.turned.emit()

    def paintEvent(self, _event: QPaintEvent) -> None:
        """Draw the background; a run that is held back attracts attention."""
        colors = colors_of(self)
        fill = colors.warn_pale if self._is_paused else colors.accent_pale
        painter = painting.begin(self)
        ground = QRectF(self.rect()).adjusted(_MARGIN_PX, _TOP_PX, -_MARGIN_PX, 0)
        painting.panel(painter, ground, fill, fill)
        painter.end()
