"""What the tool can reach: a border that shines through, and within it one around what it can't."""

from __future__ import annotations

import logging
import threading
from typing import TYPE_CHECKING, Final

from armui.viewport.palette import ScenePalette, rgb
from armui.viewport.process.geometry import actor_of

if TYPE_CHECKING:
    import pyvista as pv
    from vtkmodules.vtkRenderingCore import vtkActor, vtkRenderer

    from armui.viewport.path_picture import Reach
    from armui.viewport.process.reach_shell import ReachShell
    from armui.viewport.process.robot import Robot

_LOG = logging.getLogger(__name__)
_OUTER_OPACITY: Final = 0.10
_INNER_OPACITY: Final = 0.30
_FLOOR_OPACITY: Final = 0.6


class ReachActor:
    """Keeps the border in a renderer.

    It is worked out beside the drawing, in a thread: pictures go on meanwhile, without it.
    """

    def __init__(self, renderer: vtkRenderer) -> None:
        self._renderer = renderer
        self._actors: list[vtkActor] = []
        self._job: _Job | None = None
        self._palette: ScenePalette | None = None

    @property
    def is_unfinished(self) -> bool:
        """Whether what was asked for is not in the picture yet, and may come."""
        return self._job is not None and not self._actors and not self._job.has_failed

    def show(self, reach: Reach | None, robot: Robot, palette: ScenePalette) -> None:
        """Show the reach of a robot as soon as it is known, or nothing."""
        job = self._job
        if reach is None:
            self._job = None
            self._clear()
        elif job is None or job.reach != reach or job.robot is not robot:
            self._job = _Job(robot, reach)
            self._clear()
        elif palette != self._palette:
            self._clear()
        self._palette = palette
        self.catch_up()

    def catch_up(self) -> bool:
        """Take what has been worked out meanwhile into the picture; whether there was anything."""
        job, palette = self._job, self._palette
        if job is None or palette is None or self._actors or not job.is_done:
            return False
        shell = job.shell
        if shell is None:
            return False
        self._add(shell.outer, palette.accent, _OUTER_OPACITY)
        self._add(shell.inner, palette.speeds[1], _INNER_OPACITY)
        self._add(shell.floor, palette.accent, _FLOOR_OPACITY)
        return True

    def _add(self, surface: pv.PolyData, color: str, opacity: float) -> None:
        actor = actor_of(surface)
        look = actor.GetProperty()
        look.SetColor(*rgb(color))
        look.SetOpacity(opacity)
        look.LightingOff()
        actor.PickableOff()
        self._renderer.AddActor(actor)
        self._actors.append(actor)

    def _clear(self) -> None:
        for actor in self._actors:
            self._renderer.RemoveActor(actor)
        self._actors.clear()


class _Job:
    """One border, worked out in a thread."""

    def __init__(self, robot: Robot, reach: Reach) -> None:
        self.robot, self.reach = robot, reach
        self.shell: ReachShell | None = None
        self._thread = threading.Thread(target=self._work, name="armui-reach", daemon=True)
        self._thread.start()

    @property
    def is_done(self) -> bool:
        return not self._thread.is_alive()

    @property
    def has_failed(self) -> bool:
        return self.is_done and self.shell is None

    def _work(self) -> None:
        try:
            from armui.viewport.process.reach_shell import shell_of  # noqa: PLC0415 - when wanted

            self.shell = shell_of(self.robot, self.reach)
        except Exception:  # noqa: BLE001 - whatever it is, the picture goes on without its reach
            # for one, all axes of a foreign arm may lie in one plane
            _LOG.exception("The reach of the robot cannot be worked out")
