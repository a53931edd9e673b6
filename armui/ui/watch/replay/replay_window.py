"""The window 回放: a log is chosen, read, and shown as if it were live."""

from __future__ import annotations

from functools import partial
from pathlib import Path
from typing import TYPE_CHECKING, Final

from PySide6.QtCore import QCoreApplication, QRectF, QSize, Qt, Signal
from PySide6.QtWidgets import QLabel, QProgressBar, QVBoxLayout, QWidget

from armui.arm.device import RecordedArm
from armui.arm.refusal import Refusal
from armui.control.events import Level
from armui.control.link.link_state import LinkState
from armui.session.log_model import told_cell
from armui.session.reader import SUFFIXES
from armui.session.session import KeepsCounts
from armui.system.helper_process import HelperProcess
from armui.ui import format as fmt
from armui.ui import words
from armui.ui.actions.act import Act
from armui.ui.background import Job
from armui.ui.dialogs.base import ArmDialog
from armui.ui.dialogs.files import choose_file
from armui.ui.shell.status_bar import StatusBar
from armui.ui.theme import colors_of
from armui.ui.watch.replay.log_opening import REPLAY_FAILED, LogOpening
from armui.ui.watch.replay.log_time import wall_time
from armui.ui.widgets import icons, painting
from armui.ui.widgets.buttons import named
from armui.ui.widgets.layouts import STRETCH, fill, in_column, in_row
from armui.ui.widgets.message_line import MessageLine, Words
from armui.ui.widgets.text_label import text_label
from armui.ui.widgets.translated import Translated
from armui.ui.words.text import joined, localized

if TYPE_CHECKING:
    from collections.abc import Callable
    from concurrent.futures import Executor

    from PySide6.QtGui import QKeyEvent, QPaintEvent

    from armui.control.arm_controller import ArmController
    from armui.control.event_log.log_events import LoggedEvents
    from armui.control.operating_state import OperatingState
    from armui.control.safety.recovery_steps import Step
    from armui.protocol.generation import Generation
    from armui.session.foreign.indexed import ReadingProgress
    from armui.session.frames import Channel
    from armui.session.session import Session
    from armui.session.survey import ChannelSurvey
    from armui.ui.background import Background
    from armui.ui.watch.replay.log_opening import OpenOwn
    from armui.ui.watch.replay.replay_view import ReplayView
    from armui.viewport.view import ArmView


_SIZE: Final = QSize(1440, 920)
_MOST_TOLD: Final = 12
_FIRST_LOOK_S: Final = 0.1
"""The first time shown of a log: until then an arm has sent every message once."""
_ICON_PX: Final = 18


class LiveStrip(Translated, QWidget):
    """The state of the connected arm, shown while a device is open; without commands.

    Args:
        controller: The controller of the connected arm, not of the log.
    """

    def __init__(self, controller: ArmController) -> None:
        super().__init__()
        self.setObjectName("live_strip")
        self._controller = controller
        self._step = controller.recovery.step
        self._heading = text_label("live_heading", plain=True)
        self._icon = QLabel()
        self._text = text_label("live_step", wraps=True, plain=True)
        self.status = StatusBar(controller)
        row = in_row(spacing=10, margins=(14, 8, 14, 0))
        row.addWidget(self._heading, 0, Qt.AlignmentFlag.AlignTop)
        row.addWidget(self._icon, 0, Qt.AlignmentFlag.AlignTop)
        row.addWidget(self._text, 1)
        in_column(row, self.status, on=self, spacing=2, margins=3)
        controller.step_changed.connect(self._on_step)
        controller.operating_state_changed.connect(self._on_operating_state)
        self._on_operating_state(controller.operating_state)
        self.retranslate_ui()

    def _on_step(self, step: Step) -> None:
        self._step = step
        self._show_step()

    def _on_operating_state(self, operating_state: OperatingState) -> None:
        self.setVisible(operating_state.link is not LinkState.NO_DEVICE)

    def _show_step(self) -> None:
        colors = colors_of(self)
        self._text.setText(words.step(self._step))
        color = {Level.WARNING: colors.warn, Level.FAULT: colors.stop_ink}.get(self._step.level)
        self._icon.setVisible(color is not None)
        if color is not None:
            ratio = self.devicePixelRatioF()
            self._icon.setPixmap(icons.pixmap("warning", color, _ICON_PX, ratio))
        self.update()

    def retranslate_ui(self) -> None:
        """Set the texts in the operator's language."""
        self._heading.setText(self.tr("The arm that is connected now:"))
        self._show_step()

    def _recolor(self) -> None:
        self._show_step()

    def paintEvent(self, _event: QPaintEvent) -> None:
        """Draw a background in the colour of the severity."""
        colors = colors_of(self)
        ground = {Level.WARNING: colors.warn_pale, Level.FAULT: colors.stop_pale}
        line = {Level.WARNING: colors.warn, Level.FAULT: colors.stop_ink}
        painter = painting.begin(self)
        painting.panel(
            painter,
            QRectF(self.rect()),
            ground.get(self._step.level, colors.surface),
            line.get(self._step.level, colors.ok),
            2,
        )
        painter.end()


class ReplayWindow(ArmDialog):
    """Opens one log after another.

    Its stop and halt are those of the connected arm.

    Args:
        controller: The controller of the connected arm, never of the log.
        background: Reads and writes files.
        make_view: Creates the 3D picture.
        parent: The main window.
        open_own: Opens recordings of this program, which need not be read first.
        urdf_path: The operator's own robot description; by default that of the log's model.

    Attributes:
        view: The view of the open log; ``None`` if none is open.

    Signals:
        export_wanted: The path of the open log, to be exported.
    """

    export_wanted = Signal(object)
    choose_button = Act("Choose a log…", named="replay_choose", primary=True, on_enter=True)
    cancel_button = Act("Cancel", named="replay_cancel")
    other_button = Act("Open another log…", named="replay_other")
    export_button = Act(
        "Export…", named="replay_export", tip="As ROS 2 messages in MCAP, as CSV or as Parquet."
    )

    def __init__(
        self,
        controller: ArmController,
        background: Background,
        make_view: Callable[[], ArmView],
        parent: QWidget | None = None,
        *,
        open_own: OpenOwn | None = None,
        urdf_path: str | None = None,
    ) -> None:
        super().__init__(controller, parent)
        self.setObjectName("replay_window")
        self.setWindowFlags(Qt.WindowType.Window)
        self._controller = controller
        self._background = background
        self._make_view = make_view
        self._make_helper: Callable[[], Executor] = HelperProcess
        self._open_own = open_own
        self._urdf_path = urdf_path
        self._opening: LogOpening | None = None
        self._path: Path | None = None
        self._session: Session | None = None
        self._surveys: tuple[ChannelSurvey, ...] = ()
        self._events: Job[LoggedEvents] | None = None
        self.view: ReplayView | None = None
        self.live_strip = LiveStrip(controller)
        self.body.addWidget(self.live_strip)
        self._place = QVBoxLayout()
        self.body.addLayout(self._place, 1)
        self._waiting = self._waiting_part()
        self._place.addWidget(self._waiting, 1)
        self.message = named("replay_message", MessageLine())
        self.message.hide()
        self.body.addWidget(self.message)
        application = QCoreApplication.instance()
        if application is not None:
            # a child gets no close event when the main window closes
            application.aboutToQuit.connect(self.end)
        self.retranslate_ui()
        self.resize(_SIZE.boundedTo(self.screen().availableSize()))

    def _waiting_part(self) -> QWidget:
        """Return the part shown before a log is open: a choice, or the progress of reading."""
        part = QWidget()
        self._hint = text_label("replay_hint", wraps=True, plain=True)
        self._hint.setAlignment(Qt.AlignmentFlag.AlignCenter)
        # without text, for which its height is too small
        self.progress = named("replay_progress", QProgressBar(textVisible=False))
        self.progress.setFixedWidth(480)
        layout = in_column(on=part, spacing=14)
        layout.addStretch(2)
        layout.addWidget(self._hint)
        centre = Qt.AlignmentFlag.AlignHCenter
        layout.addWidget(self.progress, 0, centre)
        buttons = in_row(STRETCH, self.choose_button, self.cancel_button, STRETCH)
        layout.addLayout(buttons)
        layout.addStretch(3)
        fill(self.footer, self.export_button, self.other_button, STRETCH)
        return part

    # Opening ----------------------------------------------------------------------------------

    @choose_button.pressed
    @other_button.pressed
    def choose(self) -> None:
        """Let the operator choose a log."""
        endings = " ".join(f"*{each} *{each}.gz" for each in SUFFIXES)
        choose_file(
            self,
            self._controller,
            title=self.tr("Open a log"),
            name_filter=self.tr("CAN logs") + f" ({endings})",
            on_chosen=self.open_log,
            start=self._path,
        )

    @property
    def log(self) -> Path | None:
        """The log that is open or being opened."""
        return self._path

    def open_log(self, path: Path) -> None:
        """Open a log in place of the present one."""
        self._leave()
        self._path = path
        self.message.hide()
        self._opening = LogOpening(
            path, self._background, self._make_helper, self, open_own=self._open_own
        )
        self._opening.progressed.connect(self._on_progress)
        self._opening.opened.connect(self._on_opened)
        self._opening.refused.connect(self._on_refused)
        self.progress.setRange(0, 0)
        self._show_waiting()
        self._opening.begin()

    @export_button.pressed
    def _on_export(self) -> None:
        self.export_wanted.emit(self._path)

    def _on_progress(self, progress: ReadingProgress) -> None:
        share = progress.share
        if share is not None:
            self.progress.setRange(0, 1000)
            self.progress.setValue(round(1000 * share))
        text = self.tr("Reading {name}: {count} frames so far")
        name = "" if self._path is None else self._path.name
        self._hint.setText(text.format(name=name, count=fmt.count(progress.frames)))

    @cancel_button.pressed
    def _on_cancel(self) -> None:
        self._leave()
        self._show_waiting()

    def _on_refused(self, reason: Refusal) -> None:
        self._opening = None
        self._show_waiting()
        self._show_message(partial(words.refusal, reason), Level.FAULT)

    def _on_opened(self, session: Session, surveys: tuple[ChannelSurvey, ...]) -> None:
        self._opening = None
        self._session, self._surveys = session, surveys
        first = surveys[0]
        self._show(first.channel, first.generation, session.start_s + _FIRST_LOOK_S)
        self._show_oddities(session)

    # Showing ----------------------------------------------------------------------------------

    def _show(self, channel: Channel, generation: Generation, at_s: float) -> None:
        """Show a channel of the log that is open, decoded by a protocol, from a place on."""
        from armui.control.log_replay import LogReplay  # noqa: PLC0415 - with the first log
        from armui.ui.watch.replay.replay_view import ReplayView  # noqa: PLC0415 - pyqtgraph

        self._end_view()
        if self._session is None or self._path is None:
            return
        own = next(each for each in self._surveys if each.channel == channel)
        arm = RecordedArm(
            int(generation),
            own.feedback_offset,
            own.firmware,
            own.model,
            own.older_zeros,
            told_cell(getattr(self._session, "lines", ())).tool.pose,
        )
        replay = LogReplay(self._session, channel, arm, self._path.name, self)
        replay.failed.connect(self._on_failed)
        self.view = ReplayView(
            replay,
            self._make_view(),
            self._controller,
            self._background,
            name=self._path.name,
            urdf_path=self._urdf_path,
        )
        self.view.offer(self._surveys, generation)
        self.view.other_wanted.connect(self._on_other)
        self._waiting.hide()
        self._place.addWidget(self.view, 1)
        self.other_button.show()
        self.export_button.show()
        self._find_events(self.view, arm)
        replay.open()
        replay.go_to(at_s)
        self.retranslate_ui()

    def _find_events(self, view: ReplayView, arm: RecordedArm) -> None:
        """Load the events of the shown channel, or detect them in its frames."""
        from armui.control.event_log.log_events import log_events  # noqa: PLC0415 - with a log

        def show(found: LoggedEvents | Refusal) -> None:
            self._events = None
            if isinstance(found, Refusal):
                self._show_message(partial(words.refusal, found), Level.FAULT)
            else:
                view.show_events(found.log, found.marks)
                self._keep_counts(view.replay.session, found)

        job = self._events = Job(show)
        replay = view.replay
        work = partial(
            log_events, replay.session, replay.channel, arm, wall_time, lambda: job.wanted
        )
        self._background.begin_here(job, work)

    def _keep_counts(self, session: Session, found: LoggedEvents) -> None:
        """Store the counted faults and stops, which the list of recordings shows."""
        if isinstance(session, KeepsCounts) and session.lacks_counts:
            self._background.begin_here(Job(lambda _done: None), session.keep_counts, found.marks)

    def _on_other(self, channel: Channel, generation: Generation) -> None:
        at_s = 0.0 if self.view is None else self.view.replay.position_s
        self._show(channel, generation, at_s)

    def _on_failed(self, text: str) -> None:
        name = "" if self._path is None else self._path.name
        reason = REPLAY_FAILED(name=name, text=text)
        self._show_message(partial(words.refusal, reason), Level.FAULT)

    def _oddities(self, session: Session) -> str:
        """Return a text on the parts of the log that could not be read or were corrected."""
        parts = [words.refusal(each) for each in getattr(session, "notes", ())]
        if session.damage_count:
            text = self.tr("{count} places of the log could not be read; the rest is shown.")
            parts.append(text.format(count=fmt.count(session.damage_count)))
        if session.reversed_times:
            text = self.tr(
                "{count} frames had an earlier time than the frame before them; this was corrected."
            )
            parts.append(text.format(count=fmt.count(session.reversed_times)))
        cut = getattr(session, "cut", "")
        if cut == "frames":
            text = self.tr("The log is longer: only its first {count} frames are shown.")
            parts.append(text.format(count=fmt.count(session.frames)))
        elif cut == "disk":
            text = self.tr(
                "The disk for temporary files is full: only the first {count} frames are shown."
            )
            parts.append(text.format(count=fmt.count(session.frames)))
        own = self._surveys[0]
        if not own.arm_ids:
            parts.append(self.tr("It contains no frames of this kind of arm."))
        elif not own.is_certain:
            parts.append(
                self.tr(
                    "The log does not show which protocol the arm spoke: choose it under "
                    "“Protocol” if you know."
                )
            )
        return joined(*parts)

    def _show_oddities(self, session: Session) -> None:
        if self._oddities(session):
            self._show_message(partial(self._oddities, session), Level.WARNING)
            lines = [localized(each.text()) for each in session.damages[:_MOST_TOLD]]
            self.message.setToolTip("\n".join(lines))

    def _show_message(self, text: Words, level: Level) -> None:
        self.message.show_message(text, level)
        self.message.setToolTip("")
        self.message.show()

    def _show_waiting(self) -> None:
        reading = self._opening is not None
        self._waiting.show()
        self.progress.setVisible(reading)
        self.cancel_button.setVisible(reading)
        self.choose_button.setVisible(not reading)
        self.other_button.setVisible(False)
        self.export_button.setVisible(False)
        name = "" if self._path is None else self._path.name
        self._hint.setText(
            self.tr("Reading {name}…").format(name=name)
            if reading
            else self.tr(
                "Choose a CAN log, of this program or of another one. It is shown here as if it "
                "were live; nothing can be sent."
            )
        )
        self.retranslate_ui()

    # Leaving ----------------------------------------------------------------------------------

    def _leave(self) -> None:
        """Close the log that is open, or cancel its opening."""
        if self._opening is not None:
            self._opening.call_off()
            self._opening = None
        self._end_view()
        if self._session is not None:
            session, self._session = self._session, None
            self._background.begin_here(Job(lambda _done: None), partial(_close, session))

    def _end_view(self) -> None:
        if self._events is not None:
            self._events.wanted, self._events = False, None
        view, self.view = self.view, None
        if view is None:
            return
        self._place.removeWidget(view)
        view.hide()
        view.view.shutdown()
        view.end()
        view.replay.close()
        view.replay.deleteLater()
        view.deleteLater()

    def done(self, result: int) -> None:
        """Close the log with the window, to free its memory and its place on the disk."""
        self._leave()
        self._show_waiting()
        super().done(result)

    def keyPressEvent(self, event: QKeyEvent) -> None:
        """Ignore Escape, because a log takes a while to open."""
        if event.key() == Qt.Key.Key_Escape:
            event.ignore()
        else:
            super().keyPressEvent(event)

    def end(self) -> None:
        """Release the log, because the program ends."""
        opening, self._opening = self._opening, None
        if opening is not None:
            opening.end()
        self._end_view()
        session, self._session = self._session, None
        if session is not None:
            session.close()

    def retranslate_ui(self) -> None:
        """Set all texts in the operator's language."""
        title = self.tr("Replay")
        if self._path is not None and self.view is not None:
            title = self.tr("Replay – {name}").format(name=self._path.name)
        self.set_title(title)
        self.show_acts()
        self.live_strip.retranslate_ui()


def _close(session: Session) -> None:
    session.close()
