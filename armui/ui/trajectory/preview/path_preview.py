"""Connects a planned path, the 3D view and the bar with the time slider."""

from __future__ import annotations

from dataclasses import replace
from typing import TYPE_CHECKING, Final, Protocol

from PySide6.QtCore import QObject, Signal

from armui.viewport.path_picture import NOTHING, PathPicture, Preview

if TYPE_CHECKING:
    from collections.abc import Callable

    from armui.trajectory.planning.planned_path import PlannedPath
    from armui.ui.trajectory.preview.preview_bar import PreviewBar
    from armui.viewport.path_picture import Array, FindingMark


_MOST_PLACES: Final = 30_000
"""The most places of the line: 200,000 cost a picture drawn in software 50 ms, and look the same.
"""


class ShowsPreviews(Protocol):
    """The interface needed of the 3D view."""

    def set_preview(self, preview: Preview) -> None: ...  # noqa: D102 - as in ArmView

    def show_joint_range(  # noqa: D102 - as in ArmView
        self, number: int | None, limits_deg: tuple[float, float] = ...
    ) -> None: ...


class PathPreview(QObject):
    """Shows one path at a time.

    It has no access to the arm, so it cannot move one.

    Args:
        view: Shows the path and the ghost.
        bar: Moves the ghost.

    Signals:
        closed: The operator has closed the preview.
        row_shown: The selected point has changed, or another one is selected.
    """

    closed = Signal()
    row_shown = Signal()

    def __init__(self, view: ShowsPreviews, bar: PreviewBar, parent: QObject | None = None) -> None:
        super().__init__(parent)
        self._view = view
        self._bar = bar
        self._path: PlannedPath | None = None
        self._ends: dict[int, int] = {}
        self._name = ""
        self._wanted_deg: tuple[float, ...] | None = None
        self._target_deg: tuple[float, ...] | None = None
        self._target_finding: FindingMark | None = None
        self._is_seen = True
        self._scrubbed = False
        """True if the operator's last choice was a time on the slider, where the ghost stays."""
        self._shown = NOTHING
        bar.time_changed.connect(self._on_time)
        bar.closed.connect(self._on_closed)

    @property
    def name(self) -> str | None:
        """The name of the trajectory whose path is shown."""
        return None if self._path is None else self._name

    def show(
        self,
        path: PlannedPath | None,
        bad_rows: frozenset[int] = frozenset(),
        findings: tuple[FindingMark, ...] = (),
        name: str = "",
        *,
        numbered: bool = True,
        places_of: Callable[[Array], Array] | None = None,
    ) -> None:
        """Show a path, or remove it with ``None``.

        Args:
            path: The planned path.
            bad_rows: Rows in which something forbids a run.
            findings: The findings, at their places.
            name: The trajectory's.
            numbered: True if its rows are points; those of a recording are samples.
            places_of: Computes the (n, 3) places to draw, in mm, from (n, 6) joint angles; by
                default those of the plan, the tip of the tool.
        """
        self._name = name
        self._path = path
        self._scrubbed = False
        self._ends = {} if path is None else path.ends()
        if path is None or path.duration_s <= 0.0:
            self._bar.set_shown(False)
            self._set(NOTHING)
            return
        outline, ends = path.outline(_MOST_PLACES), list(self._ends.values())
        picture = PathPicture(
            path.places_mm[outline] if places_of is None else places_of(path.joints_deg[outline]),
            path.speeds_mm_s[outline],
            path.places_mm[ends] if places_of is None else places_of(path.joints_deg[ends]),
            tuple(self._ends),
            bad_rows,
            findings,
            numbered,
        )
        self._shown = Preview(picture, self._shown.selected_row, tuple(path.at(0.0)))
        self._bar.open(path.duration_s)
        self._bar.set_shown(self._is_seen)
        self._scrubbed = False
        self._set(self._shown)

    def play(self) -> None:
        """Let the ghost go along the path that is shown, from its beginning."""
        if self._path is not None and self._path.duration_s > 0.0:
            self._bar.play()

    def show_points(
        self, marks: PathPicture | None, row: int | None, ghost_deg: tuple[float, ...] | None
    ) -> None:
        """Show points that were not checked, unless a checked path is shown.

        Args:
            marks: The points; None for none, or too many.
            row: The chosen one.
            ghost_deg: Its angles; None if it can't be reached.
        """
        if self._path is None:
            self._set(Preview(marks, row, ghost_deg))
        self.row_shown.emit()

    def set_seen(self, seen: bool) -> None:
        """Set whether the page is visible to which path, points and ghost belong.

        They are hidden with it, but the path of a present run stays.
        """
        if seen != self._is_seen:
            self._is_seen = seen
            self._bar.set_shown(seen and self._path is not None and self._path.duration_s > 0.0)
            self._set(self._shown)

    def show_joint_range(
        self, number: int | None, limits_deg: tuple[float, float] = (0.0, 0.0)
    ) -> None:
        """Show the range of joint 1–6 while its cell is edited; None hides it."""
        self._view.show_joint_range(number, limits_deg)

    def select_row(self, row: int | None) -> None:
        """Highlight the mark of a row, and move the ghost there."""
        if self._path is None:
            return
        self._set(replace(self._shown, selected_row=row))
        if row in self._ends:
            self._bar.go_to(float(self._path.times_s[self._ends[row]]))
            self._scrubbed = False
        self.row_shown.emit()

    def show_findings(self, findings: tuple[FindingMark, ...]) -> None:
        """Show other findings on the same path; the ghost stays at none that is gone."""
        path, ghost = self._shown.path, self._shown.finding
        if self._path is not None and path is not None:
            ghost = ghost if ghost in findings else None
            self._set(replace(self._shown, path=replace(path, findings=findings), finding=ghost))

    def show_finding(self, finding: FindingMark) -> None:
        """Show the ghost at a finding until another place is chosen."""
        if self._path is not None and finding.joints_deg is not None:
            self._scrubbed, self._target_deg = True, None
            self._set(replace(self._shown, ghost_deg=finding.joints_deg, finding=finding))

    def light_row(self, row: int | None) -> None:
        """Highlight the point to which the arm moves, without a ghost until a place is chosen.

        Args:
            row: That of the point; −1 while a recording runs, ``None`` while nothing does.
        """
        if self._path is not None and row != self._shown.current_row:
            self._set(replace(self._shown, current_row=row, ghost_deg=None, finding=None))

    def _on_time(self, time_s: float) -> None:
        if self._path is not None:
            self._scrubbed = True
            self._target_deg = None
            ghost_deg = tuple(self._path.at(time_s))
            self._set(replace(self._shown, ghost_deg=ghost_deg, finding=None))

    def _on_closed(self) -> None:
        self.show(None)
        self.closed.emit()

    def show_target(
        self, angles_deg: tuple[float, ...] | None, finding: FindingMark | None = None
    ) -> None:
        """Show the ghost at a target instead of on the path; None ends that.

        After the operator has chosen a time of the motion, the ghost stays there until a row is
        selected or the target changes.

        Args:
            angles_deg: The angles of the target.
            finding: What the ghost shows, if it stands where a refused motion would touch.
        """
        if angles_deg is not None and angles_deg != self._wanted_deg:
            self._wanted_deg = angles_deg
            self._scrubbed = False
        if self._scrubbed or self._bar.is_playing:
            angles_deg = None
        if (angles_deg, finding) != (self._target_deg, self._target_finding):
            self._target_deg, self._target_finding = angles_deg, finding
            self._set(self._shown)

    def _set(self, preview: Preview) -> None:
        self._shown = preview
        if not self._is_seen and preview.current_row is None:
            preview = NOTHING
        if self._target_deg is not None:
            finding = self._target_finding
            path = preview.path if finding is None else _with_sign(preview.path, finding)
            preview = replace(preview, path=path, ghost_deg=self._target_deg, finding=finding)
        self._view.set_preview(preview)


def _with_sign(path: PathPicture | None, finding: FindingMark) -> PathPicture:
    """Return a path, or none, with the sign of a finding alone."""
    import numpy as np  # noqa: PLC0415 - the rules that find it have loaded it

    path = path or PathPicture(np.empty((0, 3)), np.empty(0), np.empty((0, 3)), ())
    return replace(path, findings=(finding,))
