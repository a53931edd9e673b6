"""Brings together the picture, what is chosen of it, and what the operator works at beside it."""

from __future__ import annotations

from collections.abc import Callable
from typing import TYPE_CHECKING

from PySide6.QtCore import QObject
from PySide6.QtWidgets import QApplication, QWidget

from armui.ui.panels.jogging.motion_panel import JointRow, MotionPanel
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
    from armui.ui.picture.drag_targets import DragTarget
    from armui.ui.picture.target_drag import TargetDrag
    from armui.ui.trajectory.preview.path_preview import PathPreview
    from armui.ui.trajectory.preview.preview_link import PreviewLink
    from armui.viewport.handles import HandleKind
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
        self._shows_range = False
        self._link: PreviewLink | None = None
        self._panel: Callable[[], QWidget | None] | None = None
        self._targets: dict[QWidget, DragTarget] = {}
        self._drag: TargetDrag | None = None
        self.bar.handles_wanted.connect(self._choose_handles)
        preview.row_shown.connect(self.look)
        application = QApplication.instance()
        if isinstance(application, QApplication):
            application.focusChanged.connect(self._on_focus)

    def link(self, link: PreviewLink) -> None:
        """The library is open: what is edited in it can be clicked and dragged."""
        self._link = link
        self._view.mark_picked.connect(link.on_mark_picked)
        self._view.finding_picked.connect(link.on_finding_picked)

    def follow_panels(self, panel: Callable[[], QWidget | None]) -> None:
        """Say which panel is shown: its target can be dragged."""
        self._panel = panel

    def doings(self) -> dict[str, Callable[[], object]]:
        """What the picture offers without a button, by the name of its shortcut."""
        return {f"view.{name}": action.trigger for name, action in self.bar.without_button.items()}

    def look(self) -> None:
        """Stand the handles where the target is now."""
        if self._drag is not None:
            self._drag.look()

    def _choose_handles(self, kind: HandleKind | None) -> None:
        if self._drag is None:
            from armui.ui.picture.target_drag import TargetDrag  # noqa: PLC0415 - faster start

            self._drag = TargetDrag(
                self._controller, self._view, self._preview, self.note, self._target
            )
        self._drag.set_kind(kind)

    def _target(self) -> DragTarget | None:
        """The chosen point while an editor is seen, else the target of the panel that is shown."""
        from armui.ui.panels.jogging.cartesian_panel import CartesianPanel  # noqa: PLC0415 - faster start
        from armui.ui.picture.drag_targets import CartesianTarget, MotionTarget  # noqa: PLC0415 - as above

        point = None if self._link is None else self._link.target
        if point is not None or self._panel is None:
            return point
        panel = self._panel()
        if panel is None or not panel.isVisible():
            return None
        if panel not in self._targets:
            if isinstance(panel, MotionPanel):
                self._targets[panel] = MotionTarget(panel)
            elif isinstance(panel, CartesianPanel):
                self._targets[panel] = CartesianTarget(panel, self._controller)
        return self._targets.get(panel)

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
            from armui.control.run.progress import OVER  # noqa: PLC0415 - faster start

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
            if self._shows_range:
                self._shows_range = False
                self._view.show_joint_range(None)
            return
        self._shows_range = True
        limits = self._controller.operating_state.limits[widget.joint - 1]
        self._view.show_joint_range(widget.joint, (limits.min_deg, limits.max_deg))
