"""Connects the picture, the choices for it, and the operator's work beside it."""

from __future__ import annotations

from collections.abc import Callable
from functools import cached_property, partial
from typing import TYPE_CHECKING, Final

from PySide6.QtCore import QBuffer, QByteArray, QIODevice, QObject
from PySide6.QtGui import QGuiApplication, QImage
from PySide6.QtWidgets import QApplication, QWidget

from armui.arm.refusal import Refusal
from armui.control.events import Level
from armui.control.run.progress import OVER
from armui.control.run.runner import Runner
from armui.system.atomic import write_whole
from armui.telemetry.events import EventKind
from armui.ui import words
from armui.ui.dialogs.files import FileExport
from armui.ui.freshness import is_stale
from armui.ui.panels.cell.cell_panel import CellPanel
from armui.ui.panels.jogging.cartesian_panel import CartesianPanel
from armui.ui.panels.jogging.motion_panel import JointRow, MotionPanel
from armui.ui.picture.cell_in_picture import CellInPicture
from armui.ui.picture.picture_note import PictureNote
from armui.ui.picture.target_drag import CartesianTarget, LedArm, MotionTarget, TargetDrag
from armui.ui.picture.view_bar import ViewBar
from armui.viewport.camera import ViewDirection, poses_equal
from armui.viewport.path_picture import FindingMark, Reach
from armui.viewport.robot_shape import moved
from armui.viewport.tool_trail import ToolTrail

if TYPE_CHECKING:
    from collections.abc import Sequence
    from pathlib import Path

    from armui.arm.state import ArmState
    from armui.control.arm_controller import ArmController
    from armui.control.events import Event
    from armui.control.operating_state import OperatingState
    from armui.setting_fields import Settings
    from armui.settings import SettingsStore
    from armui.ui.background import Background
    from armui.ui.picture.target_drag import DragTarget, HandGuide, ZoneTarget
    from armui.ui.trajectory.preview.path_preview import PathPreview
    from armui.ui.trajectory.preview.preview_link import PreviewLink
    from armui.viewport.vectors import Vector
    from armui.viewport.view import ArmView

_MM_PER_M: Final = 1000.0
_BETWEEN_S: Final = 0.1
"""The period of updating a growing trail, which is copied and drawn as a whole."""
_PRESSES: Final = frozenset({EventKind.COMMAND, EventKind.LINK})
_M_PER_MM: Final = 0.001


class PictureExport(FileExport):
    """Exports the picture on the screen, unless it is missing or too old.

    Args:
        controller: Receives the stop of the file chooser.
        view: Shows the picture.
        background: Writes files.
        window: The parent of the file chooser.
    """

    def __init__(
        self, controller: ArmController, view: ArmView, background: Background, window: QWidget
    ) -> None:
        super().__init__(controller, background, window)
        self._view = view

    def copy(self) -> None:
        """Copy the picture to the clipboard."""
        image = self._taken()
        if image is not None:
            QGuiApplication.clipboard().setImage(image)
            self.message_changed.emit(self.tr("Picture copied"), Level.DONE)

    def save(self) -> None:
        """Let the operator choose a file for the picture as it is now."""
        image = self._taken()
        if image is not None:
            self._choose(self.tr("Save picture"), "armui", "png", partial(self.write, image))

    def write(self, image: QImage, path: Path) -> None:
        """Write a picture to a file in the background."""
        self._background.begin_here(self._job(path), _write, image, path)

    def _taken(self) -> QImage | None:
        if not self._view.is_current:
            text = self.tr("The present picture is not drawn yet. Wait a moment, then try again.")
            self.message_changed.emit(text, Level.WARNING)
            return None
        return self._view.grab_picture()


def _write(image: QImage, path: Path) -> None:
    """Write a PNG; a file that was there is replaced when the new one is whole.

    Raises:
        OSError: It cannot be written.
    """
    data = QByteArray()
    buffer = QBuffer(data)
    buffer.open(QIODevice.OpenModeFlag.WriteOnly)
    if not image.save(buffer, "PNG"):  # type: ignore[call-overload]
        raise OSError(str(path))
    write_whole(path, bytes(data.data()))


class TrailKeeper:
    """Records the path of the tool while the picture is visible.

    The point is the same as for the figures, the frame and the planned path in the picture: the
    tool centre point, which is the flange if no tool is set.

    Args:
        controller: Gives the arm's state and the last setpoints.
        view: Shows the trail.
        length_s: The seconds of motion shown.
    """

    def __init__(self, controller: ArmController, view: ArmView, length_s: float) -> None:
        self._controller = controller
        self._view = view
        self._trail = ToolTrail(length_s)
        self._device = controller.operating_state.device
        self._seen: tuple[tuple[float, ...] | None, tuple[float, ...] | None] = (None, None)
        self._is_new = False
        self._handed_over_s = 0.0

    def set_length(self, length_s: float) -> None:
        """Set the seconds of motion shown; 0 for none."""
        self._trail.set_length(length_s)
        if length_s <= 0:
            self._trail.clear()
        self._view.set_trail(self._trail.trail)

    def clear(self) -> None:
        """Delete the trail, because device or tool have changed."""
        self._trail.clear()
        self._view.set_trail(None)

    def follow(self, state: ArmState) -> None:
        """Add the place in the newest state."""
        operating_state = self._controller.operating_state
        if operating_state.device != self._device:
            self._device = operating_state.device
            self.clear()
        angles_deg = state.angles_deg()
        if self._trail.length_s <= 0 or angles_deg is None or not self._view.isVisible():
            return
        if any(is_stale(heard, state, operating_state) for heard in state.joints_deg):
            return
        now_s = state.last_feedback_s or 0.0
        if self._is_new and not 0.0 <= now_s - self._handed_over_s < _BETWEEN_S:
            self._is_new, self._handed_over_s = False, now_s
            self._view.set_trail(self._trail.trail)
        setpoint_deg = self._controller.motion.setpoint_deg
        if poses_equal(tuple(angles_deg), self._seen[0]) and setpoint_deg == self._seen[1]:
            return
        self._seen = (tuple(angles_deg), setpoint_deg)
        driven_mm = self._tool_mm(angles_deg)
        if driven_mm is None:
            return
        commanded_mm = None if setpoint_deg is None else self._tool_mm(setpoint_deg)
        self._is_new |= self._trail.add(now_s, driven_mm, commanded_mm)

    def _tool_mm(self, angles_deg: Sequence[float]) -> Vector | None:
        """Return the place of the tool at six angles, in the base frame."""
        shape = self._view.shape
        if shape is None:
            return None
        x, y, z = self._controller.cartesian.tool[:3]
        rows = shape.flange(shape.links(angles_deg))
        place = moved(rows, (x / _MM_PER_M, y / _MM_PER_M, z / _MM_PER_M))
        return (place[0] * _MM_PER_M, place[1] * _MM_PER_M, place[2] * _MM_PER_M)


class PictureWork(QObject):
    """Shows around the arm what the operator has chosen.

    It sends nothing to a real arm.

    The mouse can lead a simulated arm of this program in drag teaching, as a hand would.

    Args:
        controller: Gives the limits and the tool.
        view: Shows the arm.
        preferences: The settings of the picture.
        background: Writes files.
        preview: Shows the path of a trajectory.
        window: The main window.
        hand: Gives access to the hand that leads the simulated arm of this program.

    Attributes:
        bar: Buttons and menu for the picture.
        note: Shows results over the picture.
    """

    def __init__(
        self,
        controller: ArmController,
        view: ArmView,
        preferences: SettingsStore,
        background: Background,
        *,
        preview: PathPreview,
        window: QWidget,
        hand: Callable[[], HandGuide | None] = lambda: None,
    ) -> None:
        super().__init__(window)
        self._controller = controller
        self._view = view
        self._preview = preview
        self.bar = ViewBar(view, preferences)
        self.note = PictureNote()
        self._export = PictureExport(controller, view, background, window)
        self._export.message_changed.connect(self.note.show_message)
        self._reach = self.bar.view_actions["reach"]
        self._reach.toggled.connect(self._show_reach)
        self._panel: Callable[[], QWidget | None] | None = None
        self._cell = CellInPicture(controller, view, self.bar.view_actions, self, self._zone)
        self.bar.view_actions["save"].triggered.connect(self._export.save)
        self.bar.view_actions["copy"].triggered.connect(self._export.copy)
        controller.cell.use_own_tool(preferences.settings.tool)
        self._tool = controller.cartesian.tool
        view.set_tool(self._tool)
        controller.cell_changed.connect(self._on_cell_changed)
        view.look_from(ViewDirection(preferences.settings.picture_direction))
        self._unsubscribe = preferences.subscribe(self._on_settings)
        self.destroyed.connect(self._unsubscribe)
        self._trail = TrailKeeper(controller, view, preferences.settings.picture_trail_s)
        self._trail_s = preferences.settings.picture_trail_s
        controller.operating_state_changed.connect(self._on_operating_state)
        controller.state_changed.connect(self._on_state)
        controller.noticed.connect(self._on_noticed)
        self._shows_range = False
        self._link: PreviewLink | None = None
        self._targets: dict[QWidget, DragTarget] = {}
        self._led_arm = LedArm(controller, hand)
        self._drag = TargetDrag(controller, view, preview, self.note, self._target, zone=self._zone)
        self.bar.handles_wanted.connect(self._drag.set_kind)
        self._drag.put_away.connect(lambda: self.bar.choose_handles(None))
        preview.row_shown.connect(self._drag.refresh)
        application = QApplication.instance()
        if isinstance(application, QApplication):
            application.focusChanged.connect(self._on_focus)

    def link(self, link: PreviewLink) -> None:
        """Connect the picture to the library: points edited there can be clicked and dragged."""
        self._link = link
        self._view.mark_picked.connect(link.on_mark_picked)
        self._view.finding_picked.connect(link.on_finding_picked)

    def follow_panels(self, panel: Callable[[], QWidget | None]) -> None:
        """Set the function that returns the visible panel, whose target can be dragged."""
        self._panel = panel

    def refresh(self) -> None:
        """Move ghost and handles to the present target."""
        self._drag.refresh()

    def _zone(self) -> ZoneTarget | None:
        """Return where a plane or box is typed, if that is seen; it can be dragged then."""
        panel = None if self._panel is None else self._panel()
        return panel.zone_target() if isinstance(panel, CellPanel) and panel.isVisible() else None

    def _target(self) -> DragTarget | None:
        """Return what can be dragged: a simulated arm that gives way, a point, or a target.

        The point is the chosen one while an editor is seen; the target is that of the panel.
        """
        if self._led_arm.gives_way():
            return self._led_arm
        point = None if self._link is None else self._link.target
        if point is not None or self._panel is None:
            return point
        panel = self._panel()
        if panel is None or not panel.isVisible():
            return None
        if panel not in self._targets:
            if isinstance(panel, MotionPanel):
                self._targets[panel] = MotionTarget(panel, self._controller)
            elif isinstance(panel, CartesianPanel):
                self._targets[panel] = CartesianTarget(panel, self._controller)
        return self._targets.get(panel)

    def _on_settings(self, settings: Settings) -> None:
        self._controller.cell.use_own_tool(settings.tool)
        if settings.picture_trail_s != self._trail_s:
            self._trail_s = settings.picture_trail_s
            self._trail.set_length(self._trail_s)

    def _on_cell_changed(self, _cell: object) -> None:
        tool = self._controller.cartesian.tool
        if tool != self._tool:
            self._tool = tool
            self._view.set_tool(tool)
            self.bar.show_tool(tool)
            self._trail.clear()
            self._show_reach()

    @cached_property
    def _runner(self) -> Runner:
        """Follows the runs, from the first path that is shown on."""
        return Runner(self._controller, self)

    def _on_state(self, state: ArmState) -> None:
        self._trail.follow(state)
        if self._preview.name is not None:
            progress = self._runner.progress
            under_way = progress.phase not in OVER and progress.name == self._preview.name
            row = progress.index if progress.count else -1  # a recording has no points to highlight
            self._preview.light_row(row if under_way else None)

    def _on_noticed(self, event: Event) -> None:
        """Show where a refused motion would first touch, until the next press."""
        reason = event.params.get("reason")
        if isinstance(reason, Refusal) and reason.contact is not None:
            at, text = reason.contact, words.refusal(reason)
            mark = FindingMark(at.place_mm, True, None, text, at.joints_deg, at.links)
            self._drag.show_refused(mark)
        elif event.notice.kind in _PRESSES:
            self._drag.show_refused(None)

    def _on_operating_state(self, _state: OperatingState) -> None:
        if self._reach.isChecked():
            self._show_reach()  # the limits have changed, or are those of another arm

    def _show_reach(self) -> None:
        """Show the reach within the arm's limits, the factory's until they are read; or hide it."""
        if not self._reach.isChecked():
            self._view.set_reach(None)
            return
        limits = self._controller.operating_state.limits
        x, y, z = (length * _M_PER_MM for length in self._tool[:3])
        self._view.set_reach(
            Reach(tuple((each.min_deg, each.max_deg) for each in limits), (x, y, z))
        )

    def _on_focus(self, _old: QWidget | None, new: QWidget | None) -> None:
        """Show the range of a joint while a widget of its row has the focus."""
        widget = new
        while widget is not None and not isinstance(widget, JointRow):
            widget = widget.parentWidget()
        if widget is None:
            if self._shows_range:
                self._shows_range = False
                self._view.show_joint_range(None)
            return
        self._shows_range = True
        limits = self._controller.operating_state.limits[widget.joint - 1]
        self._view.show_joint_range(widget.joint, (limits.min_deg, limits.max_deg))
