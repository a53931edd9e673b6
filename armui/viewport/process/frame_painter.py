"""Draws the state of the view, and no more often than it changes."""

from __future__ import annotations

import contextlib
import math
import sys
import time
from dataclasses import replace
from typing import TYPE_CHECKING, Final

from armui.arm.refusal import Reason, Refusal
from armui.system.files import read_file
from armui.viewport.messages import PicturePhase, SceneError
from armui.viewport.process.urdf_file import URDF_MALFORMED
from armui.viewport.view_state import BUILT_IN_ROBOT, ViewState

if TYPE_CHECKING:
    from collections.abc import Callable, Iterator

    from armui.viewport.process.offscreen import Pixels
    from armui.viewport.process.robot import Robot
    from armui.viewport.process.scene import Scene

URDF_NO_MEMORY = Reason(
    "urdf_no_memory",
    "Robot description: {path} takes more than {most} MB of memory to load. Export its meshes "
    "with fewer triangles.",
)


_LOADING_BYTES: Final = 2 << 30
"""More memory than any description within the limits of `urdf_file` takes."""
_CHEAP_FRAME_S = 0.010
"""Smooth frames that take less are drawn even while the arm moves."""


class FramePainter:
    """Owns the scene; used in one thread only.

    Smooth edges cost little on a graphics card, but more than double the time of a frame drawn by
    the processor. So while the arm moves, edges stay rough if smoothing was measured to be slow,
    and `refine` draws the picture again when the arm has come to rest.

    Args:
        on_load_failed: called with the reason why a robot can't be shown; the one before stays.
        on_picked: called with the joint number at a picked place, or None.
        on_mark_picked: called with the row of the mark that was clicked.
        on_phase: called with the phase of long work.
    """

    def __init__(
        self,
        on_load_failed: Callable[[Refusal], None],
        on_picked: Callable[[int | None], None],
        on_mark_picked: Callable[[int], None],
        on_phase: Callable[[PicturePhase], None] = lambda _phase: None,
    ) -> None:
        self._on_load_failed = on_load_failed
        self._on_picked = on_picked
        self._on_mark_picked = on_mark_picked
        self._on_phase = on_phase
        self._scene: Scene | None = None
        self._shown: ViewState | None = None
        self._smooth_frame_s = math.inf
        self._is_rough = False

    @property
    def is_rough(self) -> bool:
        """True if the last picture would look better after `refine`."""
        return self._is_rough or (self._scene is not None and self._scene.is_unfinished)

    @property
    def robot(self) -> Robot | None:
        """The robot in the picture."""
        return None if self._scene is None else self._scene.robot

    @property
    def pixel_ratio(self) -> float:
        """Device pixels for each logical pixel of the last picture."""
        return 1.0 if self._shown is None else self._shown.pixel_ratio

    def open(self) -> None:
        """Import VTK, which takes a second; the readers of files are imported when needed."""
        from armui.viewport.process import scene  # noqa: F401, PLC0415 - see above

    def paint(self, state: ViewState, known: Robot | None = None) -> Pixels | None:
        """Draw a state; return None if the picture is still the same.

        Args:
            state: the state.
            known: its robot, if it was read before: the file is not read again.

        Raises:
            SceneError: this computer can't draw at all.
        """
        scene = self._scene or self._open()
        before, self._shown = self._shown, state
        if before is None or state.robot != before.robot:
            self._load(scene, state, known)
        scene.show(state)
        if state.pick is not None and (before is None or state.pick != before.pick):
            self._on_picked(scene.pick(state.pick.x_px, state.pick.y_px))
        question = state.mark_pick
        if question is not None and (before is None or question != before.mark_pick):
            row = scene.pick_mark(question.x_px, question.y_px)
            if row is not None:
                self._on_mark_picked(row)
        unasked = before and replace(state, pick=before.pick, mark_pick=before.mark_pick)
        if before is not None and unasked == before:
            return None
        return self._render(scene, smooth=self._smooth_frame_s < _CHEAP_FRAME_S)

    def refine(self) -> Pixels | None:
        """Draw the last state with smooth edges and with results that have become ready.

        Returns:
            The image, or None if there is nothing to improve.
        """
        if self._scene is None:
            return None
        has_come = self._scene.catch_up()
        if not (self._is_rough or has_come):
            return None
        return self._render(self._scene, smooth=True)

    def close(self) -> None:
        """Release the scene and its graphics memory."""
        if self._scene is not None:
            self._scene.close()
            self._scene = None

    def _render(self, scene: Scene, *, smooth: bool) -> Pixels:
        started_s = time.perf_counter()
        pixels = scene.render(smooth=smooth)
        if smooth:
            self._smooth_frame_s = time.perf_counter() - started_s
        self._is_rough = not smooth
        return pixels

    def _open(self) -> Scene:
        from armui.viewport.process.scene import Scene  # noqa: PLC0415 - see `open`

        self._on_phase(PicturePhase.OPENING)
        self._scene = Scene()
        return self._scene

    def _load(self, scene: Scene, state: ViewState, known: Robot | None) -> None:
        if known is not None:
            scene.show_robot(known)
            self._on_phase(PicturePhase.FIRST_DRAWING)
            return
        self._on_phase(PicturePhase.STARTING)
        from armui.viewport.process import urdf_file  # noqa: F401, PLC0415 - see `open`

        self._on_phase(PicturePhase.LOADING)
        path = state.robot.path
        try:
            with limited_memory(_LOADING_BYTES):
                scene.load(path)
        except SceneError as error:
            self._on_load_failed(error.refusal)
        except MemoryError:
            params: dict[str, float | int | str] = {"path": str(path), "most": _LOADING_BYTES >> 20}
            self._on_load_failed(URDF_NO_MEMORY(**params))
        except Exception as error:  # noqa: BLE001 - libraries raise anything for a malformed file
            text = " ".join(f"{type(error).__name__}: {error}".split())
            self._on_load_failed(URDF_MALFORMED(path=str(path), text=text))
        if scene.robot is None and path != BUILT_IN_ROBOT.path:
            scene.load(BUILT_IN_ROBOT.path)  # the built-in robot, so that there is any
        self._on_phase(PicturePhase.FIRST_DRAWING)


@contextlib.contextmanager
def limited_memory(more_bytes: int) -> Iterator[None]:
    """Limit the memory that this process may add; beyond it MemoryError is raised.

    It is counted from the present use, because graphics drivers reserve gigabytes of addresses.
    Linux only: Windows allocates no more than there is, and macOS ignores such limits.
    """
    if sys.platform != "linux":
        yield
    else:
        import resource  # noqa: PLC0415 - not on Windows

        pages = int(read_file("/proc/self/statm").split()[0])
        before, most = resource.getrlimit(resource.RLIMIT_AS)
        limit = pages * resource.getpagesize() + more_bytes
        if before != resource.RLIM_INFINITY:
            limit = min(limit, before)
        resource.setrlimit(resource.RLIMIT_AS, (limit, most))
        try:
            yield
        finally:
            resource.setrlimit(resource.RLIMIT_AS, (before, most))
