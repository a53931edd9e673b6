"""Brings together the picture, what is chosen of it, and what the operator works at beside it."""

from __future__ import annotations

from typing import TYPE_CHECKING

from PySide6.QtCore import QObject
from PySide6.QtWidgets import QApplication, QWidget

from armui.control.run.progress import OVER
from armui.ui.panels.jogging.joint_row import JointRow
from armui.ui.picture.picture_export import PictureExport
from armui.ui.picture.picture_note import PictureNote
from armui.ui.picture.trail_keeper import TrailKeeper
from armui.ui.picture.view_bar import ViewBar
from armui.viewport.camera import ViewDirection
from armui.viewport.path_picture import Reach

if TYPE_CHECKING:
    from armui.arm.state import ArmState
    from armui.control.arm_controller import ArmController
    from armui.control.operating_state import OperatingState
    from armui.settings import Settings, SettingsStore
    from armui.ui.background import Background
    from armui.ui.trajectory.preview.path_preview import PathPreview
    from armui.viewport.view import ArmView

_MM = 0.001


class PictureWork(QObject):
    """Shows around the arm what the operator wants to see of it. Nothing it does moves the arm.

    Args:
        controller: Knows the limits and the tool.
        view: Shows the arm.
        preferences: What was chosen of the picture.
        background: Writes files.
        preview: Shows the path of a trajectory.
        window: The main window.

    Attributes:
        bar: Buttons and menu for the picture.
        note: Says over the picture what became of something.
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
    ) -> None:
        super().__init__(window)
        self._controller = controller
        self._view = view
        self._preview = preview
        self.bar = ViewBar(view, preferences)
        self.note = PictureNote()
        self._export = PictureExport(controller, view, background, window)
        self._export.said.connect(self.note.say)
        self._reach = self.bar.view_actions["reach"]
        self._reach.toggled.connect(self._show_reach)
        self.bar.view_actions["save"].triggered.connect(self._export.save)
        self.bar.view_actions["copy"].triggered.connect(self._export.copy)
        self._tool = preferences.settings.tool
        view.set_tool(self._tool)
        view.look_from(ViewDirection(preferences.settings.picture_direction))
        self._unsubscribe = preferences.subscribe(self._on_settings)
        self.destroyed.connect(self._unsubscribe)
        self._trail = TrailKeeper(controller, view, preferences.settings.picture_trail_s)
        self._trail_s = preferences.settings.picture_trail_s
        controller.operating_state_changed.connect(self._on_operating_state)
        controller.state_changed.connect(self._on_state)
        application = QApplication.instance()
        if isinstance(application, QApplication):
            application.focusChanged.connect(self._on_focus)

    def _on_settings(self, settings: Settings) -> None:
        if settings.tool != self._tool:
            self._tool = settings.tool
            self._view.set_tool(settings.tool)
            self._trail.clear()
            self._show_reach()
        if settings.picture_trail_s != self._trail_s:
            self._trail_s = settings.picture_trail_s
            self._trail.set_length(self._trail_s)

    def _on_state(self, state: ArmState) -> None:
        self._trail.follow(state)
        if self._preview.name is not None:
            progress = self._controller.player.progress
            under_way = progress.phase not in OVER and progress.name == self._preview.name
            self._preview.light_row(progress.index if under_way else None)

    def _on_operating_state(self, _state: OperatingState) -> None:
        if self._reach.isChecked():
            self._show_reach()  # other limits, or those of another arm

    def _show_reach(self) -> None:
        """The reach by the limits as read from the arm, the factory's until they are."""
        if not self._reach.isChecked():
            self._view.set_reach(None)
            return
        limits = self._controller.operating_state.limits
        x, y, z = (length * _MM for length in self._tool[:3])
        self._view.set_reach(
            Reach(tuple((each.min_deg, each.max_deg) for each in limits), (x, y, z))
        )

    def _on_focus(self, _old: QWidget | None, new: QWidget | None) -> None:
        """The range of a joint is shown while its row is edited."""
        widget = new
        while widget is not None and not isinstance(widget, JointRow):
            widget = widget.parentWidget()
        if widget is None:
            self._view.show_joint_range(None)
            return
        limits = self._controller.operating_state.limits[widget.joint - 1]
        self._view.show_joint_range(widget.joint, (limits.min_deg, limits.max_deg))
