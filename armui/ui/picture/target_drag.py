"""Dragging in the picture: a handle moves a ghost and what it stands for, never the arm."""

from __future__ import annotations

from collections.abc import Callable
from functools import partial
from typing import TYPE_CHECKING, Final

from PySide6.QtCore import QObject, QTimer

from armui.arm.refusal import Refusal
from armui.arm.refusal_codes import RefusalCode
from armui.control.events import Level
from armui.ui import words
from armui.ui.picture.drag_solver import DragBase, dragged_to
from armui.viewport.handles import HandleKind, HandlePlace

if TYPE_CHECKING:
    from armui.control.arm_controller import ArmController
    from armui.ui.picture.drag_targets import DragTarget
    from armui.ui.picture.picture_note import PictureNote
    from armui.ui.trajectory.preview.path_preview import PathPreview
    from armui.viewport.handles import Dragged
    from armui.viewport.view import ArmView

_LOOK_MS: Final = 100
_ELSEWHERE_DEG: Final = 0.05
"""A ghost nearer to the arm than this would be one with it."""


class TargetDrag(QObject):
    """Stands handles where the target of the moment is, and carries it with them.

    Args:
        controller: Knows the arm; it is told nothing.
        view: Shows the handles.
        preview: Shows the ghost.
        note: Says why something can't be reached.
        target: What would be dragged now; None: nothing.
    """

    def __init__(
        self,
        controller: ArmController,
        view: ArmView,
        preview: PathPreview,
        note: PictureNote,
        target: Callable[[], DragTarget | None],
    ) -> None:
        super().__init__(view)
        self._controller = controller
        self._view = view
        self._preview = preview
        self._note = note
        self._target = target
        self._held: DragTarget | None = None
        self._base: DragBase | None = None
        self._last_deg: tuple[float, ...] = ()
        self._began_with: object = None
        self._refused = False
        self.kind: HandleKind | None = None
        self._look = QTimer(self, interval=_LOOK_MS)
        self._look.timeout.connect(self.look)
        view.handle_taken.connect(self._on_taken)
        view.handle_moved.connect(self._on_moved)
        view.handle_left.connect(self._on_left)

    def set_kind(self, kind: HandleKind | None) -> None:
        """Offer other handles; None: none."""
        if kind is not self.kind:
            self._view.give_up_drag()
        self.kind = kind
        if kind is None:
            self._look.stop()
            self._view.set_handles(None)
            self._preview.show_target(None)
            self._say(None)
        else:
            self._look.start()
            self.look()

    def look(self) -> None:
        """Stand the handles where the target is now; a picture that nobody sees costs nothing."""
        if self._held is not None:
            if not self._is_as_begun(self._held):
                self._view.give_up_drag()
            return
        if self.kind is None or not self._view.isVisible():
            return
        target = self._target()
        angles_deg = None if target is None else target.angles_deg()
        measured_deg = self._controller.state.angles_deg()
        if angles_deg is None:
            self._view.set_handles(None)
            self._preview.show_target(None)
            return
        self._view.set_handles(HandlePlace(angles_deg, self.kind))
        elsewhere = measured_deg is None or any(
            abs(one - other) > _ELSEWHERE_DEG
            for one, other in zip(angles_deg, measured_deg, strict=True)
        )
        self._preview.show_target(angles_deg if elsewhere else None)

    # a drag -----------------------------------------------------------------------------------

    def _on_taken(self) -> None:
        target = self._target()
        angles_deg = None if target is None else target.angles_deg()
        if target is None or angles_deg is None or self.kind is None:
            return
        cartesian = self._controller.cartesian
        limits = self._controller.operating_state.limits
        target.begin()
        self._held = target
        self._began_with = self._basis()
        self._base = DragBase(
            angles_deg, self.kind, tuple(cartesian.tool), cartesian.kinematics(), limits
        )
        self._last_deg = angles_deg

    def _basis(self) -> object:
        """What a drag is worked out with: arm, link, limits and tool."""
        state = self._controller.operating_state
        tool = tuple(self._controller.cartesian.tool)
        return state.link, state.model_fit.geometry, state.limits, tool

    def _is_as_begun(self, held: DragTarget) -> bool:
        """Tell whether the arm and what is dragged are still the same."""
        same_target = self._target() is held and held.is_as_begun()
        return same_target and self._basis() == self._began_with

    def _on_moved(self, dragged: Dragged, coarse: bool, fine: bool) -> None:
        held, base = self._held, self._base
        if held is None or base is None:
            return
        if not self._is_as_begun(held):
            self._view.give_up_drag()
            return
        answer = dragged_to(base, dragged, self._last_deg, coarse=coarse, fine=fine)
        if isinstance(answer, Refusal):
            self._say(answer)  # the ghost stays where it could be
            return
        self._say(None)
        self._last_deg = answer
        held.carry(answer)
        self._preview.show_target(answer)
        self._view.set_handles(HandlePlace(answer, base.kind))

    def _on_left(self, given_up: bool) -> None:
        held, base = self._held, self._base
        self._held = self._base = None
        if held is None or base is None:
            return
        self._say(None)
        if not self._is_as_begun(held):
            held.give_up(base.angles_deg)
            self._say(Refusal(RefusalCode.DRAG_GIVEN_UP))
        elif given_up:
            held.give_up(base.angles_deg)
        elif self._last_deg != base.angles_deg:
            refusal = held.drop(self._last_deg)
            if refusal is not None:
                self._say(refusal)
        self.look()

    def _say(self, reason: Refusal | None) -> None:
        if reason is not None:
            self._refused = True
            self._note.say(partial(words.refusal, reason), Level.WARNING, stays=True)
        elif self._refused:
            self._refused = False
            self._note.say("")
