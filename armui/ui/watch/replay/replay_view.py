"""One recording as if it were live: picture, figures, joints, curves, events, status, time line."""

from __future__ import annotations

from typing import TYPE_CHECKING, Final

from PySide6.QtCore import QRectF, Qt, Signal
from PySide6.QtGui import QColor, QFontMetrics, QPainter, QPen
from PySide6.QtWidgets import (
    QAbstractItemView,
    QHeaderView,
    QLabel,
    QSplitter,
    QTableView,
    QTabWidget,
    QWidget,
)

from armui.arm.joint_status import Item, Word
from armui.control.devices.joint_monitor import JointMonitor
from armui.protocol.generation import Generation
from armui.session.log_model import told_cell
from armui.ui import format as fmt
from armui.ui import words
from armui.ui.picture.cell_in_picture import area_picture, held_picture
from armui.ui.shell.robot_in_view import RobotInView, show_in_view
from armui.ui.shell.status_bar import StatusBar
from armui.ui.theme import DARK, colors_of, scaled_font
from armui.ui.watch.curves_item import Missing
from armui.ui.watch.joint_status_page import JointCellDelegate, JointStatusModel
from armui.ui.watch.plot_layout import SETS
from armui.ui.watch.plots_area import PlotsArea
from armui.ui.watch.replay.log_time import moment, wall_time
from armui.ui.watch.replay.mark_places import MarkSearch
from armui.ui.watch.replay.replay_events import ReplayEvents
from armui.ui.watch.replay.replay_frames import ReplayFrames
from armui.ui.watch.replay.time_line import TimeLine
from armui.ui.watch.replay.transport import SPEEDS, Transport
from armui.ui.watch.replay.whole_curves import WholeCurves
from armui.ui.widgets import icons
from armui.ui.widgets.buttons import drop_down, named
from armui.ui.widgets.layouts import in_column, in_row
from armui.ui.widgets.seen_timer import SeenTimer
from armui.ui.widgets.text_label import ElidedLabel, text_label
from armui.ui.widgets.translated import Translated
from armui.ui.words.text import localized
from armui.viewport import palette as scene_palette
from armui.viewport.robot_shape import pose_rows
from armui.viewport.strokes import FrameMark

if TYPE_CHECKING:
    from collections.abc import Sequence

    from PySide6.QtGui import QPaintEvent, QShowEvent

    from armui.arm.joint_status import StatusCell
    from armui.control.arm_controller import ArmController
    from armui.control.log_replay import LogReplay
    from armui.session.frames import Channel
    from armui.session.session import SessionMark
    from armui.session.survey import ChannelSurvey
    from armui.telemetry.events import EventLog
    from armui.ui.background import Background
    from armui.viewport.view import ArmView


_LOOK_MS: Final = 33
"""The period of updating: 30 pictures a second."""
_PICTURE_PX, _TABS_PX = 480, 900
_HEADER_PAD_PX: Final = 16
_MARK_PX: Final = 40
"""The width of the mark before a word, with the space around both."""
_LINE_PX: Final = 4
_BANNER_PX: Final = 38
_ICON_PX: Final = 22
_WORD_SCALE: Final = 1.2


class ReplayFrame(Translated, QWidget):
    """A thick line in a colour of its own around the content, with a banner on top.

    The banner shows 回放 in every language, that it is not live, the file, and the recorded time of
    day.

    Args:
        content: The widget with the recording's content.
        name: The file.
    """

    def __init__(self, content: QWidget, name: str) -> None:
        super().__init__()
        self.setObjectName("replay_frame")
        self._icon = QLabel()
        self.word = text_label("replay_word", plain=True)
        self.name = ElidedLabel()
        self.name.show_text(name)
        self.clock = text_label("replay_clock", plain=True)
        banner = in_row(
            self._icon,
            self.word,
            16,
            (self.name, 1),
            self.clock,
            spacing=10,
            margins=(14, 0, 14, 0),
        )
        holder = named("replay_banner", QWidget())
        holder.setFixedHeight(_BANNER_PX)
        holder.setLayout(banner)
        in_column(holder, (content, 1), on=self, spacing=0, margins=_LINE_PX)
        self.retranslate_ui()
        self._recolor()

    def retranslate_ui(self) -> None:
        """Set the texts in the operator's language."""
        self.word.setText(self.tr("REPLAY · NOT LIVE"))
        self.name.setToolTip(self.tr("Nothing can be sent from here: there is no bus behind it."))

    def _recolor(self) -> None:
        ink = colors_of(self).on_replay
        ratio = self.devicePixelRatioF()
        self._icon.setPixmap(icons.pixmap("replay", ink, _ICON_PX, ratio))
        for label in (self.word, self.name, self.clock):
            label.setFont(scaled_font(self, _WORD_SCALE, bold=label is not self.name))

    def paintEvent(self, _event: QPaintEvent) -> None:
        """Draw the line and the banner's background."""
        color = QColor(colors_of(self).replay)
        painter = QPainter(self)
        painter.fillRect(QRectF(0, 0, self.width(), _BANNER_PX + _LINE_PX), color)
        painter.setPen(QPen(color, _LINE_PX, j=Qt.PenJoinStyle.MiterJoin))
        half = _LINE_PX / 2
        painter.drawRect(QRectF(self.rect()).adjusted(half, half, -half, -half))
        painter.end()


class RecordedJoints(JointMonitor):
    """The state of the joints in a log.

    It omits the time since when a fault lasts, which may lie before a jump; the time line shows it.
    """

    def cell(self, item: Item, joint: int) -> StatusCell:
        """Return one cell of the table, without the beginning of a fault."""
        return super().cell(item, joint)._replace(since=None)


class JointTable(Translated, QWidget):
    """The table of the joints, updated only while visible.

    Args:
        controller: The controller of the log.
    """

    def __init__(self, controller: ArmController) -> None:
        super().__init__()
        self.monitor = RecordedJoints(controller, parent=self)
        self.model = JointStatusModel(self.monitor)
        self.table = named("replay_joint_table", QTableView())
        self.table.setModel(self.model)
        self.table.setItemDelegate(JointCellDelegate(self.table))
        self.table.setSelectionMode(QAbstractItemView.SelectionMode.NoSelection)
        self.table.setEditTriggers(QAbstractItemView.EditTrigger.NoEditTriggers)
        self.table.setFocusPolicy(Qt.FocusPolicy.NoFocus)
        self.table.setCornerButtonEnabled(False)
        across, down = self.table.horizontalHeader(), self.table.verticalHeader()
        across.setSectionResizeMode(QHeaderView.ResizeMode.Stretch)
        across.setSectionsClickable(False)
        across.setDefaultAlignment(Qt.AlignmentFlag.AlignCenter)
        down.setSectionResizeMode(QHeaderView.ResizeMode.ResizeToContents)
        down.setDefaultAlignment(Qt.AlignmentFlag.AlignRight | Qt.AlignmentFlag.AlignVCenter)
        in_column(self.table, on=self, margins=(8, 8, 8, 6))
        self.monitor.updated.connect(self._on_updated)
        self.retranslate_ui()

    def _on_updated(self) -> None:
        if self.isVisible():
            self.model.refresh()

    def retranslate_ui(self) -> None:
        """Set all texts in the operator's language."""
        self.table.setAccessibleName(self.tr("Joint status in the log"))
        self.model.retranslate()
        metrics = self.table.fontMetrics()
        names = max(metrics.horizontalAdvance(words.joint_item(item)) for item in Item)
        self.table.verticalHeader().setFixedWidth(names + _HEADER_PAD_PX)
        bold = scaled_font(self.table, 1.0, bold=True)
        widest = max(QFontMetrics(bold).horizontalAdvance(words.joint_word(word)) for word in Word)
        self.table.horizontalHeader().setMinimumSectionSize(widest + _MARK_PX)

    def showEvent(self, event: QShowEvent) -> None:
        """Update the table, which was not updated while hidden."""
        self.model.refresh()
        super().showEvent(event)


class ReplayView(Translated, QWidget):
    """Shows one replay, updated only while visible.

    Args:
        replay: The replay, to be closed by its owner.
        view: The 3D picture.
        live: The controller of the connected arm, for the stop in file choosers.
        background: Writes files.
        name: The file.
        urdf_path: The operator's own robot description.

    Signals:
        other_wanted: Another channel or protocol was chosen: a :data:`Channel` and a
            :class:`Generation`.
    """

    other_wanted = Signal(object, object)

    def __init__(
        self,
        replay: LogReplay,
        view: ArmView,
        live: ArmController,
        background: Background,
        *,
        name: str,
        urdf_path: str | None = None,
    ) -> None:
        super().__init__()
        self.replay = replay
        self.view = view
        view.set_tool(replay.controller.cartesian.tool)
        self._cell = told_cell(getattr(replay.session, "lines", ()))
        shapes = (*area_picture(self._cell.area), *held_picture(self._cell.held))
        view.set_area(shapes, self._cell.placement.pose)
        frame = self._cell.frame
        if frame is not None:
            view.set_frames((FrameMark(frame.name, pose_rows(frame.pose), lit=True),))
        self.robot = RobotInView(view, replay.controller, urdf_path, self)
        self._controller = controller = replay.controller
        controller.telemetry.wall_time = wall_time
        session = replay.session
        self._search = MarkSearch(session.marks, replay.channel)
        self.joints = JointTable(controller)
        self.curves = PlotsArea(controller.telemetry, live, background)
        self.curves.setContentsMargins(8, 8, 8, 6)
        self.curves.board.show_plots(SETS["follow"])
        self.events = ReplayEvents(live, background)
        self.tabs = named("replay_tabs", QTabWidget())
        self.tabs.setDocumentMode(True)
        self.whole = WholeCurves(replay, live, background)
        self.frames = ReplayFrames(replay, background)
        for tab in (self.joints, self.curves, self.events, self.whole, self.frames):
            self.tabs.addTab(tab, "")
        self.status = StatusBar(controller, with_notices=False)
        self.time_line = TimeLine()
        self.time_line.show_log(session.start_s, session.end_s, self._search.marks)
        self.transport = Transport()
        self.note = text_label("replay_note", rank="muted", wraps=True, plain=True)
        self.channels = drop_down("replay_channel")
        self.generations = drop_down("replay_generation")
        self._surveys: tuple[ChannelSurvey, ...] = ()
        self._lay_out(name)
        self._connect()
        self._timer = SeenTimer(self, _LOOK_MS, self._refresh)
        self.retranslate_ui()
        self._recolor()

    def _lay_out(self, name: str) -> None:
        splitter = QSplitter(Qt.Orientation.Horizontal)
        splitter.setChildrenCollapsible(False)
        splitter.addWidget(self.view)
        splitter.addWidget(self.tabs)
        splitter.setStretchFactor(0, 1)
        splitter.setStretchFactor(1, 0)
        splitter.setSizes([_PICTURE_PX, _TABS_PX])
        self._channel_label = text_label(rank="muted", plain=True)
        self._generation_label = text_label(rank="muted", plain=True)
        of_channel = (self._channel_label, self.channels)
        of_generation = (self._generation_label, self.generations)
        choices = in_row((self.note, 1), *of_channel, *of_generation, spacing=8)
        below = in_column(
            self.time_line, self.transport, choices, spacing=6, margins=(12, 6, 12, 10)
        )
        content = QWidget()
        in_column((splitter, 1), self.status, below, on=content, spacing=0, margins=0)
        self.frame = ReplayFrame(content, name)
        in_column(self.frame, on=self, margins=0)

    def _connect(self) -> None:
        replay, transport = self.replay, self.transport
        transport.play_wanted.connect(lambda: replay.play(on=not replay.is_playing))
        transport.step_wanted.connect(replay.step)
        transport.step_back_wanted.connect(replay.step_back)
        transport.fault_wanted.connect(self._on_fault_wanted)
        transport.speed_wanted.connect(replay.set_speed)
        self.time_line.wanted.connect(replay.go_to)
        for part in (self.events, self.whole, self.frames):
            part.wanted.connect(replay.go_to)
        replay.moved.connect(self._refresh)
        replay.moved.connect(self.curves.board.draw_soon)
        self._controller.state_changed.connect(self._show_arm)
        self._controller.operating_state_changed.connect(self._show_arm)
        self.channels.activated.connect(self._on_other)
        self.generations.activated.connect(self._on_other)

    # What can be chosen -----------------------------------------------------------------------

    def offer(self, surveys: tuple[ChannelSurvey, ...], generation: Generation) -> None:
        """Offer the choice among the channels and the protocols.

        Args:
            surveys: The surveys of the log's channels.
            generation: The present protocol.
        """
        self._surveys = surveys
        self.channels.clear()
        for each in surveys:
            self.channels.addItem("", each.channel)
        channels = [each.channel for each in surveys]
        self.channels.setCurrentIndex(channels.index(self.replay.channel))
        several = len(surveys) > 1
        self.channels.setVisible(several)
        self._channel_label.setVisible(several)
        self.generations.clear()
        for each_generation in Generation:
            self.generations.addItem("", each_generation)
        self.generations.setCurrentIndex(list(Generation).index(generation))
        self._name_choices()

    def _on_other(self, _place: int) -> None:
        channel: Channel = self.channels.currentData()
        self.other_wanted.emit(channel, Generation(self.generations.currentData()))

    def _name_choices(self) -> None:
        own = next((each for each in self._surveys if each.channel == self.replay.channel), None)
        for place, each in enumerate(self._surveys):
            arm = self.tr("arm") if each.arm_ids else self.tr("no arm")
            text = "—" if each.channel is None else str(each.channel)
            self.channels.setItemText(place, f"{text} ({arm})")
        for place in range(self.generations.count()):
            generation = Generation(self.generations.itemData(place))
            text = self.tr("generation {number}").format(number=int(generation))
            is_told = own is not None and own.is_certain and own.generation is generation
            text += " " + self.tr("(as the log tells)") if is_told else ""
            self.generations.setItemText(place, text)
        if own is not None:
            tip = f"{int(own.generation)}: {localized(own.reason)}"
            self.generations.setToolTip(tip)

    # What is shown ----------------------------------------------------------------------------

    def show_events(self, log: EventLog, marks: Sequence[SessionMark]) -> None:
        """Show events, and their marks on the time line."""
        self.events.show_log(log)
        if marks is not self.replay.session.marks:
            self._search = MarkSearch(marks, self.replay.channel)
            self.time_line.show_marks(self._search.marks)
        self._refresh()

    def _refresh(self) -> None:
        if not self.isVisible():
            return
        replay, session = self.replay, self.replay.session
        at_s = replay.position_s
        self.time_line.show_position(at_s)
        for part in (self.events, self.whole, self.frames):
            part.show_position(at_s)
        self.frame.clock.setText(moment(at_s))
        ends_s = at_s, session.end_s
        since, whole = (fmt.clock(each_s - session.start_s, 3) for each_s in ends_s)
        self.transport.place.setText(f"{since} / {whole}")
        self.transport.show_playing(playing=replay.is_playing, at_end=replay.is_at_end)
        self.transport.show_faults(
            before=self._search.trouble_before(at_s) is not None,
            after=self._search.next_trouble(at_s) is not None,
        )
        speed = min(SPEEDS, key=lambda each: abs(each - replay.speed))
        if self.transport.speeds.currentIndex() != SPEEDS.index(speed):
            self.transport.speeds.setCurrentIndex(SPEEDS.index(speed))
        self._see_to_curves(at_s)
        self._show_frame()

    def _see_to_curves(self, at_s: float) -> None:
        """Request the samples of the visible curves, and mark the time that is not loaded yet."""
        board = self.curves.board
        seen = board.isVisible()
        shown_s = board.edge_s() + board.frame.shown.begin_s
        self.replay.want_curves(at_s - shown_s if seen else 0.0)
        loading = self.replay.loading
        if loading is None or not seen:
            board.show_missing(None)
            return
        begin_s, end_s, share = loading
        text = self.tr("Loading: {percent} %").format(percent=round(100.0 * share))
        board.show_missing(Missing(begin_s, end_s, text))

    def _show_frame(self) -> None:
        """Show the last decoded frame and its number, from which single steps go on."""
        last = self.replay.last_frame
        if last is None or self.replay.is_playing:
            self.transport.frame.setText("")
            return
        number = self.tr("Frame {number}").format(number=last.number + 1)
        text = f"{number}: {last.frame}" if last.number >= 0 else str(last.frame)
        self.transport.frame.setText(text)

    def _show_arm(self, _news: object = None) -> None:
        if self.isVisible():
            controller = self._controller
            tool = controller.cartesian.tool
            now = controller.state, controller.operating_state
            show_in_view(self.view, *now, tool, frame=self._cell.frame)

    def _on_fault_wanted(self, way: int) -> None:
        at_s = self.replay.position_s
        mark = self._search.next_trouble(at_s) if way > 0 else self._search.trouble_before(at_s)
        if mark is not None:
            self.replay.go_to(mark.at_s)

    def end(self) -> None:
        """Cancel reading, because the log is about to be closed."""
        self.frames.end()

    def retranslate_ui(self) -> None:
        """Set the texts in the operator's language."""
        titles = (
            *(self.tr("Joint status"), self.tr("Curves"), self.tr("Events")),
            *(self.tr("Whole log"), self.tr("Frames")),
        )
        for place, title in enumerate(titles):
            self.tabs.setTabText(place, title)
        self._channel_label.setText(self.tr("Channel"))
        self._generation_label.setText(self.tr("Protocol"))
        self.channels.setAccessibleName(self._channel_label.text())
        self.generations.setAccessibleName(self._generation_label.text())
        self.view.setAccessibleName(self.tr("3D view of the recorded arm"))
        self._name_choices()
        self._refresh()

    def _recolor(self) -> None:
        dark = colors_of(self) is DARK
        self.view.set_theme(scene_palette.DARK if dark else scene_palette.LIGHT)

    def showEvent(self, event: object) -> None:
        """Update everything that is shown."""
        super().showEvent(event)  # type: ignore[arg-type]
        self._refresh()
        self._show_arm()

    def hideEvent(self, event: object) -> None:
        """Pause the log."""
        super().hideEvent(event)  # type: ignore[arg-type]
        self.replay.play(on=False)
