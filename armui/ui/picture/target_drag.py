"""Targets in the picture: a ghost shows one that was typed or dragged; the arm does not move."""

from __future__ import annotations

from collections.abc import Callable, Mapping, Sequence
from dataclasses import dataclass
from functools import partial
from typing import TYPE_CHECKING, Final, Protocol

from PySide6.QtCore import QObject, QTimer, Signal

from armui.arm.limits import ANGLE_STEP_DEG, check_joints
from armui.arm.refusal import Reason, Refusal
from armui.control.context import REFUSED
from armui.control.devices.teaching_phase import TeachingPhase, phase_of
from armui.control.events import Event, Level
from armui.control.link.link_state import LinkState
from armui.control.operating_state import StopState
from armui.control.safety.recovery_steps import StepKind
from armui.kinematics import poses
from armui.kinematics.axes import JogFrame
from armui.kinematics.poses import flange_pose
from armui.ui import words
from armui.viewport.grips import GripKind, snapped
from armui.viewport.handles import HandleKind, HandlePlace
from armui.viewport.robot_shape import pose_rows

if TYPE_CHECKING:
    from armui.arm.limits import JointLimits
    from armui.cell.work_area import Zone
    from armui.control.arm_controller import ArmController
    from armui.kinematics.arm_kinematics import Kinematics
    from armui.ui.panels.jogging.cartesian_panel import CartesianPanel
    from armui.ui.panels.jogging.motion_panel import MotionPanel
    from armui.ui.picture.picture_note import PictureNote
    from armui.ui.trajectory.preview.path_preview import PathPreview
    from armui.viewport.handles import Dragged
    from armui.viewport.path_picture import FindingMark
    from armui.viewport.view import ArmView

DRAG_GIVEN_UP = Reason(
    "drag_given_up",
    "The drag was cancelled: the arm, or what was dragged, has changed. Drag again.",
)


_BASE: Final = (0.0,) * 6
COARSE: Final = {GripKind.AXIS: 10.0, GripKind.RING: 15.0, GripKind.JOINT: 5.0}
"""The steps with Ctrl held: mm along an axis, degrees about one."""
FINE: Final = {GripKind.AXIS: 1.0, GripKind.RING: 1.0, GripKind.JOINT: 1.0}
"""The steps with Shift held."""
_LEAD_DEG_S: Final = 30.0
"""The speed of a careful hand: far below the one at which drag teaching ends."""
_LOOK_MS: Final = 100
"""The period of following the typed target and the arm."""
_ELSEWHERE_DEG: Final = 0.05
"""A ghost nearer to the arm than this would coincide with it."""


@dataclass(frozen=True)
class DragBase:
    """The state at the beginning of a drag.

    Attributes:
        angles_deg: The joint angles of the arm, or of its ghost.
        kind: The kind of handles.
        tool: The tool centre point in the flange, mm and degrees.
        kinematics: The arm's kinematics.
        limits: The limits of its joints.
        frame: The frame that its figures are in, in the base; ``None`` for the base itself.
    """

    angles_deg: tuple[float, ...]
    kind: HandleKind
    tool: tuple[float, ...]
    kinematics: Kinematics
    limits: Sequence[JointLimits]
    frame: tuple[float, ...] | None = None

    def place(self, angles_deg: tuple[float, ...]) -> HandlePlace:
        """Return the handles of the target at these angles."""
        axes = None if self.frame is None else pose_rows(self.frame)
        return HandlePlace(angles_deg, self.kind, axes=axes)


def dragged_to(
    base: DragBase,
    dragged: Dragged,
    near_deg: Sequence[float],
    *,
    coarse: bool = False,
    fine: bool = False,
) -> tuple[float, ...] | Refusal:
    """Return the six joint angles with the handle at the place it was dragged to.

    Args:
        base: The state at the beginning of the drag.
        dragged: The handle, and its distance or angle.
        near_deg: The angles before; the nearest solution is taken.
        coarse: True for the steps of `COARSE`: to multiples of the figures that are shown and of a
            joint's angle, but along the tool's own axes in steps from where it was.
        fine: Likewise, for the steps of `FINE`.

    Returns:
        The angles as they can be sent, or why the arm can't reach them.
    """
    grip = dragged.grip
    steps = COARSE if coarse else FINE if fine else {}
    amount = dragged.amount
    if grip.kind is GripKind.JOINT:
        angles = list(base.angles_deg)
        angle_deg = angles[grip.number - 1] + amount
        if grip.kind in steps:
            angle_deg = snapped(angle_deg, steps[grip.kind])
        angles[grip.number - 1] = _rounded(angle_deg)
        return check_joints(angles, base.limits) or tuple(angles)

    from armui.arm.reach import check_pose  # noqa: PLC0415 - scipy, loaded when needed

    tool_point = poses.tool_matrix(base.kinematics.matrix(base.angles_deg), base.tool)
    target = moved_to(tool_point, base.kind, dragged, steps, base.frame)
    flange = poses.matrix_to_pose(poses.flange_matrix(target, base.tool))
    answer = check_pose(base.kinematics, flange, near_deg, base.limits)
    return answer if isinstance(answer, Refusal) else tuple(map(_rounded, answer))


def moved_to(
    begun: poses.Matrix,
    kind: HandleKind,
    dragged: Dragged,
    steps: Mapping[GripKind, float],
    frame: Sequence[float] | None = None,
) -> poses.Matrix:
    """Return where a frame is with its handle dragged, from where it was at the beginning.

    Args:
        begun: Where it was, in the base.
        kind: The kind of handles.
        dragged: The handle, and its distance or angle.
        steps: The steps of each kind of handle, if it goes in steps.
        frame: The frame that its figures are in; ``None`` for the base.
    """
    grip, amount = dragged.grip, dragged.amount
    own = kind is HandleKind.TOOL_FRAME
    within = poses.pose_to_matrix(frame or _BASE)
    if grip.kind in steps:
        begun_at = 0.0
        if grip.kind is GripKind.AXIS and not own:
            begun_at = float(within[:3, grip.number] @ (begun - within)[:3, 3])
        amount = snapped(begun_at + amount, steps[grip.kind]) - begun_at
    place = grip.number + (3 if grip.kind is GripKind.RING else 0)
    return poses.shifted(begun, place, amount, JogFrame.TOOL if own else within[:3, :3])


def _rounded(angle_deg: float) -> float:
    """Return an angle in degrees, rounded to the resolution in which angles are sent."""
    return round(angle_deg / ANGLE_STEP_DEG) * ANGLE_STEP_DEG


def _differ(one: object, other: object) -> bool:
    """Return whether two targets differ by more than the noise of measured angles."""
    if not (isinstance(one, tuple) and isinstance(other, tuple)):
        return one != other
    return any(abs(a - b) > _ELSEWHERE_DEG for a, b in zip(one, other, strict=True))


class DragTarget(Protocol):
    """A target pose of the arm that can be dragged."""

    def angles_deg(self) -> tuple[float, ...] | None:
        """Return the six angles of the target, or None if it has none."""

    def typed_deg(self) -> tuple[float, ...] | Refusal | None:
        """Return the angles of a target that was given but not sent, or why there are none.

        Returns:
            The angles or the reason; None if nothing was given, or another part shows it.
        """

    def frame(self) -> tuple[float, ...] | None:
        """Return the frame that the target's figures are in, or None for the base."""

    def begin(self) -> None:
        """Begin a drag: one of its handles was grabbed."""

    def is_as_begun(self) -> bool:
        """Return whether the target is still the one that was grabbed."""

    def carry(self, angles_deg: tuple[float, ...]) -> None:
        """Show the target at these angles during the drag; nothing is sent."""

    def drop(self, angles_deg: tuple[float, ...]) -> Refusal | None:
        """End the drag at these angles; return the reason if they can't be kept."""

    def give_up(self, angles_deg: tuple[float, ...]) -> None:
        """Cancel the drag, and restore the target from before it."""


class ZoneTarget(Protocol):
    """A plane or box whose figures are typed, and can be dragged; a press applies them."""

    def typed_zone(self) -> Zone | None:
        """Return it as typed, or ``None`` while there is none to be seen."""

    def take_pose(self, pose: Sequence[float]) -> object:
        """Put a pose into the fields."""


class _InForce:
    """A target whose figures, or those over the picture, are in the user frame in force."""

    _controller: ArmController

    def frame(self) -> tuple[float, ...] | None:
        """Return the user frame in force, or None for the base."""
        frame = self._controller.cartesian.frame
        return None if frame is None else frame.pose


class MotionTarget(_InForce):
    """The target fields of 运动控制, which 发送 sends.

    Args:
        panel: The panel.
        controller: Gives the limits of the joints.
    """

    def __init__(self, panel: MotionPanel, controller: ArmController) -> None:
        self._panel = panel
        self._controller = controller
        self._given = panel.given()

    def begin(self) -> None:
        """Note which fields follow the arm."""
        self._given = self._panel.given()

    def is_as_begun(self) -> bool:
        """Return true: the fields are always the same ones; see `DragTarget`."""
        return True

    def angles_deg(self) -> tuple[float, ...] | None:
        """Return the figures of the six fields."""
        return self._panel.targets()

    def typed_deg(self) -> tuple[float, ...] | Refusal | None:
        """Return the angles in the fields, or the one that is beyond its limits."""
        typed = self._panel.typed()
        limits = self._controller.operating_state.limits
        return None if typed is None else check_joints(typed, limits) or typed

    def carry(self, angles_deg: tuple[float, ...]) -> None:
        """Put the angles into the fields."""
        self._panel.take_targets(angles_deg)

    def drop(self, angles_deg: tuple[float, ...]) -> Refusal | None:
        """Leave the angles in the fields."""
        self._panel.take_targets(angles_deg)
        return None

    def give_up(self, angles_deg: tuple[float, ...]) -> None:
        """Restore the fields; those that followed the arm follow it again."""
        self._panel.take_targets(angles_deg, self._given)


class CartesianTarget(_InForce):
    """The target fields of 末端控制, which MOVE P and MOVE L send.

    Args:
        panel: The panel.
        controller: Gives the arm's state and its kinematics.
    """

    def __init__(self, panel: CartesianPanel, controller: ArmController) -> None:
        self._panel = panel
        self._controller = controller
        self._solved: tuple[object, tuple[float, ...] | Refusal] | None = None
        self._given = panel.given()
        self._pose = panel.targets()

    def begin(self) -> None:
        """Note which fields follow the arm, and their contents."""
        self._given = self._panel.given()
        self._pose = self._panel.targets()

    def is_as_begun(self) -> bool:
        """Return true: the fields are always the same ones; see `DragTarget`."""
        return True

    def angles_deg(self) -> tuple[float, ...] | None:
        """Return angles for the pose in the fields, near the arm's own, or None if it has none."""
        pose = self._panel.targets()
        answer = None if pose is None else self._solve(pose)
        return None if isinstance(answer, Refusal) else answer

    def typed_deg(self) -> tuple[float, ...] | Refusal | None:
        """Return angles for the pose in the fields, or why the arm can't reach it."""
        pose = self._panel.typed()
        answer = None if pose is None else self._solve(pose)
        self._panel.note_unreachable(pose if isinstance(answer, Refusal) else None)
        return answer

    def carry(self, angles_deg: tuple[float, ...]) -> None:
        """Put the pose of the tool centre point into the fields."""
        cartesian = self._controller.cartesian
        tool_point = poses.tool_matrix(cartesian.kinematics().matrix(angles_deg), cartesian.tool)
        self._panel.take_targets(poses.matrix_to_pose(tool_point))
        pose = self._panel.targets()
        if pose is not None:
            # the pose was made from these angles: keep them instead of solving it again
            self._solved = (self._key(pose), angles_deg)

    def drop(self, angles_deg: tuple[float, ...]) -> Refusal | None:
        """Leave the pose in the fields."""
        self.carry(angles_deg)
        return None

    def give_up(self, _angles_deg: tuple[float, ...]) -> None:
        """Restore the fields; those that followed the arm follow it again."""
        if self._pose is not None:
            self._panel.take_targets(self._pose, self._given)

    def _key(self, pose: tuple[float, ...]) -> object:
        """Return all that a solution depends on except the arm's pose at the request."""
        cartesian, state = self._controller.cartesian, self._controller.operating_state
        return pose, cartesian.tool, state.model_fit.geometry, state.limits

    def _solve(self, pose: tuple[float, ...]) -> tuple[float, ...] | Refusal | None:
        """Return the solution nearest to the arm's pose at the request; None without feedback."""
        key, near_deg = self._key(pose), self._controller.state.angles_deg()
        if near_deg is None:
            return None
        if self._solved is None or self._solved[0] != key:
            from armui.arm.reach import check_pose  # noqa: PLC0415 - scipy, loaded when needed

            cartesian = self._controller.cartesian
            limits = self._controller.operating_state.limits
            flange = flange_pose(pose, cartesian.tool)
            answer = check_pose(cartesian.kinematics(), flange, near_deg, limits)
            self._solved = (key, answer if isinstance(answer, Refusal) else tuple(answer))
        return self._solved[1]


class HandGuide(Protocol):
    """Leads a simulated arm that gives way, and switches its faults (`armui.sim`).

    Attributes:
        faults: The faults begun and not ended: name and joint, 0 for a fault of the whole arm.
    """

    faults: set[tuple[str, int]]

    def lead_to(self, joints_deg: Sequence[float], speed_deg_s: float = ...) -> None:
        """Lead all joints to six angles; the joint with the longest way turns at this speed."""

    def release(self) -> None:
        """Release the arm, which stays in place."""

    def switch(self, name: str, joint: int, *, begins: bool) -> None:
        """Begin or end a fault by its name, at a joint, or with 0 at the whole arm."""


class LedArm(_InForce):
    """A simulated arm in drag teaching, led by the mouse as a real one is by hand.

    No frame is sent for it: it only tells the simulator of this program, and only if its arm gives
    way. It never moves a real arm.

    Args:
        controller: Gives the connected arm and its state of drag teaching.
        hand: Returns the hand of the simulated arm of this program, or None.
    """

    def __init__(self, controller: ArmController, hand: Callable[[], HandGuide | None]) -> None:
        self._controller = controller
        self._hand = hand
        self._held: HandGuide | None = None

    def gives_way(self) -> bool:
        """Return whether the simulated arm is connected and reports that it gives way."""
        now = self._controller.operating_state
        device, status = now.device, now.status
        if device is None or not device.simulated or now.link is not LinkState.ONLINE:
            return False
        records = status is not None and phase_of(status) is TeachingPhase.RECORDING
        return records and now.stop is StopState.RUNNING and self._hand() is not None

    def angles_deg(self) -> tuple[float, ...] | None:
        """Return the measured angles."""
        return self._controller.state.angles_deg()

    def typed_deg(self) -> None:
        """Return None: the arm itself is led, so no target is typed."""

    def begin(self) -> None:
        """Grab the arm."""
        self._held = self._hand()

    def is_as_begun(self) -> bool:
        """Return whether it is still the same arm, and gives way."""
        return self._held is not None and self._held is self._hand() and self.gives_way()

    def carry(self, angles_deg: tuple[float, ...]) -> None:
        """Lead the arm to these angles."""
        if self._held is not None:
            self._held.lead_to(angles_deg, _LEAD_DEG_S)

    def drop(self, angles_deg: tuple[float, ...]) -> None:
        """Release the arm, which stays where it is."""
        self.give_up(angles_deg)

    def give_up(self, _angles_deg: tuple[float, ...]) -> None:
        """Release the arm; it is not led back."""
        if self._held is not None:
            self._held.release()
        self._held = None


class TargetDrag(QObject):
    """Shows the present target: a ghost at its pose, and handles if wanted.

    Args:
        controller: Gives the arm's state; nothing is sent.
        view: Shows the handles.
        preview: Shows the ghost.
        note: Shows the reason why something can't be reached.
        target: Returns the target that can be dragged now, or None.
        zone: Returns the plane or box that can be dragged instead, or None.

    Signals:
        put_away: The plane or box for which the handles were switched on is hidden now.
    """

    put_away = Signal()

    def __init__(
        self,
        controller: ArmController,
        view: ArmView,
        preview: PathPreview,
        note: PictureNote,
        target: Callable[[], DragTarget | None],
        *,
        zone: Callable[[], ZoneTarget | None],
    ) -> None:
        super().__init__(view)
        self._controller = controller
        self._view = view
        self._preview = preview
        self._note = note
        self._target = target
        self._zone = zone
        self._of_zone = False
        self._zone_held: tuple[ZoneTarget, tuple[float, ...]] | None = None
        self._held: DragTarget | None = None
        self._base: DragBase | None = None
        self._last_deg: tuple[float, ...] = ()
        self._began_with: object = None
        self._refused = False
        self._shown_note: Refusal | Callable[[], str] | None = None
        self._refusal: tuple[FindingMark, DragTarget | None, object] | None = None
        """The first contact of a refused motion, the target then, and its typed angles."""
        self.kind: HandleKind | None = None
        self._timer = QTimer(self, interval=_LOOK_MS)
        self._timer.timeout.connect(self.refresh)
        self._timer.start()
        view.handle_taken.connect(self._on_taken)
        view.handle_moved.connect(self._on_moved)
        view.handle_left.connect(self._on_left)
        controller.noticed.connect(self._on_noticed)

    def _on_noticed(self, event: Event) -> None:
        """Hide the reason here if the message beside the pressed button already shows it."""
        if event.notice == REFUSED:
            self.refresh()  # the press may have come right after the last digit
            if event.params.get("reason") == self._shown_note:
                self._show_refusal(None)

    def set_kind(self, kind: HandleKind | None) -> None:
        """Show handles of another kind, or none with None."""
        if kind is not self.kind:
            self._view.give_up_drag()
        self.kind = kind
        self._of_zone = kind is not None and self._zone() is not None
        self._show_refusal(None)
        self.refresh()

    def refresh(self) -> None:
        """Move ghost and handles to the present target; does nothing while hidden."""
        if self._held is not None:
            # during a drag the pointer places both; only another arm or another target ends it
            if not self._is_as_begun(self._held):
                self._view.give_up_drag()
            return
        if not self._view.isVisible() or self._zone_held is not None:
            return
        zone = self._zone()
        if self._of_zone and zone is None:
            self.put_away.emit()
        if not self._shows_zone(zone):
            self._show_target(self._target())

    def _shows_zone(self, zone: ZoneTarget | None) -> bool:
        """Show the handles of a plane or box that is dragged; return whether one is."""
        typed_zone = None if zone is None or self.kind is None else zone.typed_zone()
        if typed_zone is None:
            return False
        frame = pose_rows(typed_zone.pose)
        self._view.set_handles(HandlePlace((), self._zone_kind, frame))
        self._preview.show_target(None)
        return True

    def show_refused(self, finding: FindingMark | None) -> None:
        """Show the ghost where a refused motion would touch; None ends that.

        Another target ends it, too.
        """
        target = self._target()
        typed = None if target is None else target.typed_deg()
        before = self._refusal
        self._refusal = None if finding is None else (finding, target, typed)
        if self._refusal != before:
            self.refresh()

    def _show_target(self, target: DragTarget | None) -> None:
        """Show ghost and handles of a target, or where the way back inside the limits ends."""
        typed = None if target is None else target.typed_deg()
        kind = self._kind_for(target)
        if self._refusal is not None:
            _, refused, typed_then = self._refusal
            if target is not refused or _differ(typed, typed_then):
                self._refusal = None
        angles_deg = None if isinstance(typed, Refusal) else typed
        place = None
        if target is not None and kind is not None:
            # handles need angles even where nothing was typed and the fields follow the arm
            angles_deg = target.angles_deg()
            if angles_deg is not None:
                place = self._drag_base(target, angles_deg, kind).place(angles_deg)
        self._view.set_handles(place)
        if self._refusal is not None:
            finding = self._refusal[0]
            self._preview.show_target(finding.joints_deg, finding)
            self._show_note(self._touching_text)
            return
        inside_deg = self._inside_deg() if angles_deg is None else None
        ghost_deg = angles_deg if self._is_elsewhere(angles_deg) else inside_deg
        self._preview.show_target(ghost_deg)
        self._show_note(
            self._note_on(target, typed, ghost_deg, leads_inside=inside_deg is not None)
        )

    def _note_on(
        self,
        target: DragTarget | None,
        typed: tuple[float, ...] | Refusal | None,
        ghost_deg: tuple[float, ...] | None,
        *,
        leads_inside: bool,
    ) -> Refusal | Callable[[], str] | None:
        """Return the note over the picture: why there is no ghost, or what the ghost shows.

        Args:
            target: The target, if there is one.
            typed: Its angles as they were given, or why there are none.
            ghost_deg: The angles of the ghost, if one is shown.
            leads_inside: True if the ghost is at the end of the way back inside the limits.
        """
        if isinstance(typed, Refusal):
            return typed
        if isinstance(target, LedArm):
            return self._led_text
        if leads_inside:
            return self._inside_text
        if typed is None or ghost_deg is None:
            return None
        return self._controller.gate.judge_target(typed) or self._preview_text

    @property
    def _zone_kind(self) -> HandleKind:
        """The kind of handles of a plane or box: along the axes of the base, or along its own."""
        return HandleKind.TOOL if self.kind is HandleKind.TOOL else HandleKind.TOOL_FRAME

    def _kind_for(self, target: DragTarget | None) -> HandleKind | None:
        """Return the handles of a target; an arm that is led has some without being asked."""
        led = isinstance(target, LedArm)
        return self.kind or (HandleKind.JOINTS if led else None)

    def _preview_text(self) -> str:
        return self.tr("Preview of the target: it has not been sent")

    def _touching_text(self) -> str:
        return self.tr("The ghost shows where the arm would touch")

    def _inside_text(self) -> str:
        return self.tr("The ghost shows where Move inside brings the arm")

    def _inside_deg(self) -> tuple[float, ...] | None:
        """Return the end of the way back inside the limits while that is the next step."""
        if self._controller.recovery.step.kind is not StepKind.OUTSIDE:
            return None
        ways = self._controller.gate.ways_inside()
        return ways[-1] if ways else None

    def _led_text(self) -> str:
        return self.tr(
            "Simulated arm in drag teaching: lead it by the handles in the picture, as by hand"
        )

    def _is_elsewhere(self, angles_deg: Sequence[float] | None) -> bool:
        """Return whether a ghost there can be told apart from the arm."""
        measured_deg = self._controller.state.angles_deg()
        return angles_deg is not None and _differ(tuple(angles_deg), measured_deg)

    def _show_note(self, told: Refusal | Callable[[], str] | None) -> None:
        """Say what is seen, or why nothing is, until something else is to be said."""
        if told == self._shown_note:
            return
        self._shown_note = told
        if isinstance(told, Refusal):
            self._show_refusal(told)
        elif told is not None:
            self._refused = True
            self._note.show_message(told, stays=True)
        else:
            self._show_refusal(None)

    # a drag -----------------------------------------------------------------------------------

    def _on_taken(self) -> None:
        zone = self._zone()
        typed_zone = None if zone is None else zone.typed_zone()
        if zone is not None and typed_zone is not None:
            self._zone_held = zone, tuple(typed_zone.pose)
            return
        target = self._target()
        angles_deg = None if target is None else target.angles_deg()
        kind = self._kind_for(target)
        if target is None or angles_deg is None or kind is None:
            return
        target.begin()
        self._shown_note = None
        self._held = target
        self._began_with = self._basis(target)
        self._base = self._drag_base(target, angles_deg, kind)
        self._last_deg = angles_deg

    def _drag_base(
        self, target: DragTarget, angles_deg: tuple[float, ...], kind: HandleKind
    ) -> DragBase:
        cartesian, limits = self._controller.cartesian, self._controller.operating_state.limits
        model, tool = cartesian.kinematics(), tuple(cartesian.tool)
        return DragBase(angles_deg, kind, tool, model, limits, target.frame())

    def _basis(self, target: DragTarget) -> object:
        """Return what a drag is worked out with: arm, link, limits, tool and frame."""
        state = self._controller.operating_state
        tool = tuple(self._controller.cartesian.tool)
        return state.link, state.model_fit.geometry, state.limits, tool, target.frame()

    def _is_as_begun(self, held: DragTarget) -> bool:
        """Return whether the arm and what is dragged are still the same."""
        same_target = self._target() is held and held.is_as_begun()
        return same_target and self._basis(held) == self._began_with

    def _on_moved(self, dragged: Dragged, coarse: bool, fine: bool) -> None:
        if self._zone_held is not None:
            zone, begun = self._zone_held
            steps = COARSE if coarse else FINE if fine else {}
            moved = moved_to(poses.pose_to_matrix(begun), self._zone_kind, dragged, steps)
            pose = tuple(poses.matrix_to_pose(moved))
            zone.take_pose(pose)
            self._view.set_handles(HandlePlace((), self._zone_kind, pose_rows(pose)))
            return
        held, base = self._held, self._base
        if held is None or base is None:
            return
        if not self._is_as_begun(held):
            self._view.give_up_drag()
            return
        answer = dragged_to(base, dragged, self._last_deg, coarse=coarse, fine=fine)
        if isinstance(answer, Refusal):
            self._show_refusal(answer)  # the ghost stays where it could be
            return
        self._show_refusal(None)
        self._last_deg = answer
        held.carry(answer)
        self._preview.show_target(answer)
        self._view.set_handles(base.place(answer))

    def _on_left(self, given_up: bool) -> None:
        if self._zone_held is not None:
            zone, begun = self._zone_held
            self._zone_held = None
            if given_up:
                zone.take_pose(begun)
            self.refresh()
            return
        held, base = self._held, self._base
        self._held = self._base = None
        if held is None or base is None:
            return
        self._show_refusal(None)
        # a drag ends in one of three ways: with another arm or target, without effect, or kept
        refusal: Refusal | None = None
        if not self._is_as_begun(held):
            held.give_up(base.angles_deg)
            refusal = DRAG_GIVEN_UP()
        elif given_up or self._last_deg == base.angles_deg:
            # a click without a move changes no field, so that those which follow the arm go on
            # doing so
            held.give_up(base.angles_deg)
        else:
            refusal = held.drop(self._last_deg)
        self.refresh()
        if refusal is not None:
            self._show_refusal(refusal)

    def _show_refusal(self, reason: Refusal | None) -> None:
        if reason is not None:
            self._refused = True
            self._note.show_message(partial(words.refusal, reason), Level.WARNING, stays=True)
        elif self._refused:
            self._refused = False
            self._note.show_message("")
