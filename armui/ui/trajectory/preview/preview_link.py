"""Connects the library's pages, the 3D view and the bar of the preview."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import replace
from functools import partial
from typing import TYPE_CHECKING, Final

import numpy as np
from PySide6.QtCore import QCoreApplication, QEvent, QModelIndex, QObject

from armui.arm.refusal import Refusal
from armui.kinematics.forward import flange_transforms
from armui.kinematics.poses import pose_to_matrix
from armui.trajectory.planning.convert import joints_above, to_joints
from armui.trajectory.planning.findings import Severity
from armui.trajectory.planning.user_frames import (
    Frames,
    frames_of,
    in_base,
    pose_in_frame,
    why_unknown,
)
from armui.trajectory.points import edits
from armui.trajectory.points.cells import VALUES
from armui.trajectory.points.program import VALUE_COUNT, Trajectory, check_point
from armui.ui.trajectory.recording.recording_page import RecordingPage
from armui.ui.words.findings import finding as finding_text
from armui.viewport.path_picture import FindingMark, PathPicture

if TYPE_CHECKING:
    from numpy.typing import NDArray

    from armui.cell.cell import Cell
    from armui.control.arm_controller import ArmController
    from armui.control.run.preflight import Preflight
    from armui.kinematics.geometry import Geometry
    from armui.trajectory.planning.findings import Finding
    from armui.trajectory.points.program import Waypoint
    from armui.ui.trajectory.editor.editor_page import EditorPage
    from armui.ui.trajectory.library.library_page import LibraryPage
    from armui.ui.trajectory.preview.path_preview import PathPreview
    from armui.ui.trajectory.recording.recording_page import RecordingCut
    from armui.ui.widgets.page import Page

    Array = NDArray[np.float64]


_MOST = 200
"""The most signs of findings; more would hide the path."""


def tool_points(flanges: Array, tool: Sequence[float]) -> Array:
    """Return the (n, 3) tool centre points of (n, 4, 4) flange poses, in mm.

    Args:
        flanges: In the base frame.
        tool: The tool centre point in the flange; with zeros it is the flange itself.
    """
    points: Array = flanges[:, :3, 3] + flanges[:, :3, :3] @ np.array(tool[:3])
    return points


def finding_marks(checked: Preflight, tool: Sequence[float]) -> tuple[FindingMark, ...]:
    """Return the findings with a place, errors first."""
    marks = (finding_mark(checked, found, tool) for found in checked.findings[:_MOST])
    return tuple(mark for mark in marks if mark is not None)


def finding_mark(checked: Preflight, found: Finding, tool: Sequence[float]) -> FindingMark | None:
    """Return a finding with its place: where the arm touches, else where its tool is."""
    place_mm = _place_mm(checked, found, tool)
    if place_mm is None:
        return None
    return FindingMark(
        place_mm,
        found.severity is Severity.ERROR,
        found.row,
        finding_text(found),
        found.joints_deg,
        () if found.contact is None else found.contact.links,
    )


def _place_mm(
    checked: Preflight, found: Finding, tool: Sequence[float]
) -> tuple[float, float, float] | None:
    arm, path, content = checked.order.arm, checked.path, checked.content
    if found.contact is not None:
        return found.contact.place_mm
    joints_deg: Sequence[float] | None = found.joints_deg
    if joints_deg is None and found.row is not None:
        point = content.points[found.row] if isinstance(content, Trajectory) else None
        if point is not None and point.frame:
            return None  # the frame is not known here
        if point is not None and not point.is_joint:
            flange = pose_to_matrix(point.target)
            x, y, z = tool_points(flange[np.newaxis], tool)[0].tolist()
            return x, y, z
        end = path.ends().get(found.row)
        joints_deg = None if end is None else path.joints_deg[end].tolist()
    if joints_deg is None:
        return None
    flange = arm.kinematics.matrix(joints_deg)
    x, y, z = tool_points(flange[np.newaxis], tool)[0].tolist()
    return x, y, z


MOST_POINTS: Final = 3000
"""The most points computed in the GUI thread, in a few milliseconds; for longer trajectories a
check shows them.
"""


def marks_of(
    points: Sequence[Waypoint], geometry: Geometry, tool: Sequence[float], frames: Frames
) -> PathPicture | None:
    """Return the tool centre point at each point; None for none, or more than `MOST_POINTS`.

    Points in a frame that is not known have no place, and no mark.
    """
    if not 0 < len(points) <= MOST_POINTS:
        return None
    rows = [row for row, point in enumerate(points) if not point.frame or point.frame in frames]
    points = [points[row] for row in rows]
    if not points:
        return None
    targets = np.array([point.target for point in points], dtype=np.float64)
    joint = np.array([point.is_joint for point in points])
    flanges = np.empty((len(points), 4, 4))
    flanges[joint] = flange_transforms(geometry, targets[joint])
    flanges[~joint] = pose_to_matrix(targets[~joint])
    names = np.array([point.frame for point in points])
    for name in set(names[names != ""].tolist()):
        flanges[names == name] = pose_to_matrix(frames[name]) @ flanges[names == name]
    marks = tool_points(flanges, tool)
    return PathPicture(np.empty((0, 3)), np.empty(0), marks, tuple(rows))


_MOST_PLACES: Final = 2000
"""The most places of a trimmed recording's path, which is drawn again while a handle is dragged."""


def cut_picture(
    cut: RecordingCut, geometry: Geometry, tool: Sequence[float]
) -> tuple[PathPicture | None, tuple[float, ...] | None]:
    """Return the path of a trimmed recording with marks at its ends, and a pose of it.

    Args:
        cut: The trimmed recording.
        geometry: The arm's geometry.
        tool: The tool centre point in the flange.

    Returns:
        The picture, and the six angles at the operator's place; None if no sample is left.
    """
    times_s, angles_deg = cut.recording.times_s, cut.recording.joints_deg
    first, last = np.searchsorted(times_s, (cut.from_s, cut.to_s + _ROUNDED_S), side="left")
    last -= 1
    if last < first:
        return None, None
    kept = np.unique(np.linspace(first, last, min(last - first + 1, _MOST_PLACES)).round())
    rows = kept.astype(np.intp)
    places = tool_points(flange_transforms(geometry, angles_deg[rows]), tool)
    spans_s = np.maximum(np.diff(times_s[rows]), _LEAST_S)
    speeds = np.linalg.norm(np.diff(places, axis=0), axis=1) / spans_s
    speeds = np.append(speeds, speeds[-1] if len(speeds) else 0.0)
    picture = PathPicture(places, speeds, places[[0, -1]], (0, 1), is_numbered=False)
    here = min(max(int(np.searchsorted(times_s, cut.at_s)), first), last)
    return picture, tuple(angles_deg[here].tolist())


_ROUNDED_S: Final = 0.0005
"""The rounding of the fields, which show milliseconds: the last sample may be a bit later."""
_LEAST_S: Final = 1e-6
"""The least time between two samples, so that nothing is divided by zero."""
_ZERO: Final = (0.0,) * VALUE_COUNT
_DECIMALS: Final = 3
"""The decimals of targets, as they are sent and shown in the table."""


class PointTarget:
    """The drag target for the current row of an editor.

    Args:
        editor: The editor.
        controller: Gives the arm's state and its kinematics.

    Attributes:
        editor: As given.
    """

    def __init__(self, editor: EditorPage, controller: ArmController) -> None:
        self.editor = editor
        self._controller = controller
        self._solved: tuple[object, int, Frames, tuple[float, ...] | None] | None = None
        self._begun = self._at()

    @property
    def is_seen(self) -> bool:
        """True if the editor is visible."""
        return self.editor.isVisible()

    def angles_deg(self) -> tuple[float, ...] | None:
        """Return the angles of the current row's point, or None if there are none."""
        points, row = self.editor.document.points, self.editor.table.current_row()
        if not 0 <= row < len(points):
            return None
        solved, frames = self._solved, frames_of(self._controller.cell.cell)
        if solved is None or solved[0] is not points or solved[1:3] != (row, frames):
            solved = self._solved = (points, row, frames, self._solve(points, row, frames))
        return solved[3]

    def typed_deg(self) -> None:
        """Return None: the selected point's ghost is shown by `PathPreview.show_points`."""

    def frame(self) -> tuple[float, ...] | None:
        """Return the frame of the point; of joint angles the one in force. None for the base."""
        points, row = self._at()
        if 0 <= row < len(points) and not points[row].is_joint:
            return frames_of(self._controller.cell.cell).get(points[row].frame)
        frame = self._controller.cartesian.frame
        return None if frame is None else frame.pose

    def begin(self) -> None:
        """Note the grabbed point, which stays unchanged until the drag ends."""
        self._begun = self._at()

    def is_as_begun(self) -> bool:
        """Return whether the same row of the same points is still the current one."""
        points, row = self._at()
        return points is self._begun[0] and row == self._begun[1]

    def _at(self) -> tuple[Sequence[Waypoint], int]:
        return self.editor.document.points, self.editor.table.current_row()

    def carry(self, _angles_deg: tuple[float, ...]) -> None:
        """Do nothing: the ghost shows the place, and the point is changed at the end."""

    def drop(self, angles_deg: tuple[float, ...]) -> Refusal | None:
        """Set the point to this place; its motion, speed and actions stay."""
        points, row = self.editor.document.points, self.editor.table.current_row()
        point = points[row]
        if point.is_joint:
            values: Sequence[float] = angles_deg
        else:
            pose = self._controller.cartesian.kinematics().forward(angles_deg)
            values = pose_in_frame(pose, point.frame, frames_of(self._controller.cell.cell))
        tool = self.editor.model.tool
        shown = tool.shown(replace(point, target=tuple(values)))
        rounded = tuple(round(value, _DECIMALS) for value in shown.target)
        changed = tool.kept(replace(shown, target=rounded), point)
        refusal = check_point(changed)
        if refusal is None:
            label = QCoreApplication.translate("PointTarget", "Drag in the picture")
            self.editor.document.edit(edits.change(points, {row: changed}), label)
            # cached: these angles are known to reach the new pose
            frames = frames_of(self._controller.cell.cell)
            self._solved = (self.editor.document.points, row, frames, angles_deg)
        return refusal

    def give_up(self, _angles_deg: tuple[float, ...]) -> None:
        """Do nothing: the point was not changed."""

    def _solve(
        self, points: Sequence[Waypoint], row: int, frames: Frames
    ) -> tuple[float, ...] | None:
        if why_unknown((points[row],), frames) is not None:
            return None
        (based,) = in_base((points[row],), frames)
        model = self._controller.cartesian.kinematics()
        measured_deg = self._controller.state.angles_deg() or _ZERO
        near_deg = joints_above(points, row, measured_deg)
        limits = self._controller.operating_state.limits
        point = to_joints(based, model, near_deg, limits)
        return None if isinstance(point, Refusal) else point.target


_FIRST_VALUE: Final = min(VALUES)
_SHOWN: Final = frozenset({QEvent.Type.Show, QEvent.Type.WindowActivate})


class PreviewLink(QObject):
    """Shows the visible page's content in the picture, where a click on a mark leads to its row.

    Before a check it shows the points of an editor, with the ghost at the selected one; after it
    the whole path. They are hidden and shown with the page.

    Args:
        library: The library's page, in which trajectories are opened and checked.
        preview: Shows one path.
        controller: Gives the arm's state.
    """

    def __init__(
        self, library: LibraryPage, preview: PathPreview, controller: ArmController
    ) -> None:
        super().__init__(library)
        self._library = library
        self._preview = preview
        self._controller = controller
        self._pages: list[Page] = []
        self._targets: dict[Page, PointTarget] = {}  # the draggable point of each editor
        self._checked: dict[Page, Preflight] = {}
        self._page: Page | None = None
        self._shown: Preflight | None = None
        self._marks: tuple[object, PathPicture | None] = (None, None)
        library.preview_wanted.connect(self._on_preview)
        library.found_changed.connect(partial(self._renew, library))
        library.finding_wanted.connect(self._on_finding)
        library.page_made.connect(self._watch)
        library.editor_opened.connect(self._follow)
        library.editors.recorder_opened.connect(self._follow_recorder)
        preview.closed.connect(self._on_closed)
        controller.cell_changed.connect(self._on_cell_changed)
        self._watch(library)

    @property
    def target(self) -> PointTarget | None:
        """The current point of the visible editor, or ``None``."""
        target = None if self._page is None else self._targets.get(self._page)
        return target if target is not None and target.is_seen else None

    def on_mark_picked(self, row: int) -> None:
        """Select the row of a point that was clicked in 3D."""
        target = self.target
        if target is not None:
            target.editor.select_row(row)

    def on_finding_picked(self, finding: FindingMark) -> None:
        """Select the row of a finding whose sign was clicked in 3D, and show where it is."""
        if finding.row is not None:
            self.on_mark_picked(finding.row)
        self._preview.show_finding(finding)

    def _on_finding(self, finding: Finding) -> None:
        """Show the ghost at a finding, on the way or at a point."""
        tool = self._controller.cartesian.tool
        mark = None if self._shown is None else finding_mark(self._shown, finding, tool)
        if mark is not None:
            self._preview.show_finding(mark)

    # the visible page -------------------------------------------------------------------------

    def _watch(self, page: Page) -> None:
        if page not in self._pages:
            self._pages.append(page)
            page.installEventFilter(self)
            page.closed.connect(partial(self._on_left, page))
            if page.isVisible():
                self._turn_to(page)

    def eventFilter(self, watched: QObject, event: QEvent) -> bool:
        """Show the content of the page that is shown or brought to the front last."""
        if event.type() in _SHOWN:
            self._turn_to(next(page for page in self._pages if page is watched))
        elif event.type() == QEvent.Type.Hide and watched is self._page:
            self._preview.show_joint_range(None)
            other = next((page for page in self._pages if page.isVisible()), None)
            if other is None:
                self._preview.set_seen(False)
            else:
                self._turn_to(other)
        return False

    def _turn_to(self, page: Page) -> None:
        """Show what belongs to a page, and nothing of the others."""
        if page is not self._page:
            self._preview.show_joint_range(None)
        self._page = page
        checked = self._checked.get(page)
        if checked is not None:
            if checked is not self._shown:
                self._show(checked)
            self._preview.set_seen(True)
        elif page in self._targets:
            self._preview.set_seen(True)
            self._show_points()
        elif isinstance(page, RecordingPage) and page.cut is not None:
            self._preview.set_seen(True)
            self._show_cut(page.cut)
        else:
            self._preview.set_seen(False)

    # what is shown ----------------------------------------------------------------------------

    def _follow(self, editor: EditorPage) -> None:
        editor.preview_wanted.connect(partial(self._take, editor))
        editor.found_changed.connect(partial(self._renew, editor))
        editor.finding_wanted.connect(self._on_finding)
        editor.play_wanted.connect(self._preview.play)
        editor.selected_row_changed.connect(partial(self._on_row, editor))
        editor.table.selectionModel().currentChanged.connect(partial(self._on_cell, editor))
        self._targets[editor] = PointTarget(editor, self._controller)
        self._watch(editor)

    def _on_preview(self, checked: Preflight | None) -> None:
        """Show a check of the library page or the visible recording; None drops the library's."""
        if checked is None:
            self._take(self._library, None)
            return
        pages = (page for page in self._pages if page not in self._targets and page.isVisible())
        self._take(next(pages, self._library), checked)

    def _take(self, page: Page, checked: Preflight | None) -> None:
        if checked is None:
            self._checked.pop(page, None)
        else:
            self._checked[page] = checked
        if page.isVisible():
            self._turn_to(page)

    def _renew(self, page: Page, checked: Preflight) -> None:
        """Update the findings of a path that is shown; its view and ghost stay."""
        before = self._checked.get(page)
        if before is None or before.path is not checked.path:
            return
        self._checked[page] = checked
        if self._shown is before:
            self._shown = checked
            self._preview.show_findings(finding_marks(checked, self._controller.cartesian.tool))

    def _show(self, checked: Preflight) -> None:
        self._shown = checked
        errors = (each for each in checked.findings if each.severity is Severity.ERROR)
        bad_rows = frozenset(
            each.row for each in errors if each.row is not None and not each.approach
        )
        content, tool = checked.content, self._controller.cartesian.tool
        geometry = checked.order.arm.kinematics.geometry
        self._preview.show(
            checked.path,
            bad_rows,
            finding_marks(checked, tool),
            content.name,
            numbered=isinstance(content, Trajectory),
            places_of=lambda joints_deg: tool_points(flange_transforms(geometry, joints_deg), tool),
        )

    def _show_points(self) -> None:
        """Show the points as they are edited, with the ghost at the chosen one."""
        target = self.target
        if target is None:
            return
        if self._shown is not None:
            self._shown = None
            self._preview.show(None)
        points, cartesian = target.editor.document.points, self._controller.cartesian
        geometry, frames = cartesian.kinematics().geometry, frames_of(self._controller.cell.cell)
        key = (points, geometry, cartesian.tool, frames)
        if self._marks[0] != key:
            self._marks = (key, marks_of(points, geometry, cartesian.tool, frames))
        row = target.editor.table.current_row()
        self._preview.show_points(self._marks[1], row if row >= 0 else None, target.angles_deg())

    def _follow_recorder(self, recorder: RecordingPage) -> None:
        recorder.cut_changed.connect(partial(self._on_cut, recorder))

    def _on_cut(self, recorder: RecordingPage) -> None:
        """Drop the check of a recording when another part of it is kept."""
        self._checked.pop(recorder, None)
        if recorder is self._page and recorder.isVisible():
            self._turn_to(recorder)

    def _show_cut(self, cut: RecordingCut) -> None:
        """Show the path of the kept part, its ends, and the ghost at the end moved last."""
        if self._shown is not None:
            self._shown = None
            self._preview.show(None)
        cartesian = self._controller.cartesian
        picture, ghost_deg = cut_picture(cut, cartesian.kinematics().geometry, cartesian.tool)
        self._preview.show_points(picture, None, ghost_deg)

    def _on_cell_changed(self, cell: Cell | None) -> None:
        """Show points in their present frames; drop checks that were made in other frames."""
        now = frames_of(cell)
        for page, checked in tuple(self._checked.items()):
            moved = any(now.get(name) != pose for name, pose in checked.order.arm.frames)
            if checked.outcome.as_checked is not None and moved:
                self._take(page, None)
        if self._page is not None and self._page not in self._checked:
            self._show_points()

    def _on_row(self, editor: EditorPage, row: int) -> None:
        if editor is not self._page:
            return
        if self._shown is not None and self._shown is self._checked.get(editor):
            self._preview.select_row(row if row >= 0 else None)
        else:
            self._show_points()

    def _on_cell(self, editor: EditorPage, cell: QModelIndex, _before: QModelIndex) -> None:
        """Show the range of a joint while its cell is edited."""
        points, row = editor.document.points, cell.row()
        if cell.column() in VALUES and 0 <= row < len(points) and points[row].is_joint:
            number = cell.column() - _FIRST_VALUE + 1
            limits = self._controller.operating_state.limits[number - 1]
            self._preview.show_joint_range(number, (limits.min_deg, limits.max_deg))
        else:
            self._preview.show_joint_range(None)

    def _on_left(self, page: Page) -> None:
        """Drop a closed page, and remove its content from the picture."""
        if page is self._library:
            return
        self._pages.remove(page)
        self._targets.pop(page, None)
        checked = self._checked.pop(page, None)
        if page is self._page:
            self._page = None
            self._preview.show_joint_range(None)
        if self._page is None or (checked is not None and checked is self._shown):
            self._shown = None
            self._preview.show(None)

    def _on_closed(self) -> None:
        """The operator has closed the preview: the points are shown again."""
        self._shown = None
        if self._page is not None:
            self._checked.pop(self._page, None)
            self._turn_to(self._page)
