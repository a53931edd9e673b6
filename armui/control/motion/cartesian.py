"""末端控制: sends the tool to poses, on lines and arcs, and in steps (0x152–0x154, 0x158).

Every target is checked before it is sent, by the inverse kinematics and the limits of the joints; a
line and an arc over their whole length. The arm's own verdict on a target (0x2A1 byte 1) still
counts.
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import replace
from typing import TYPE_CHECKING, Annotated, Final

from armui.arm.figures import Count, Range, RangeOfArm
from armui.arm.model_check import MODEL_DIFFERS, ModelFit, fitting_models
from armui.arm.models import all_models
from armui.arm.refusal import Reason, Refusal
from armui.arm.state import ArmState
from armui.cell.user_frames import UserFrame
from armui.control.context import ControllerPart
from armui.control.events import Notice
from armui.control.motion.jog_path import MotionFrame, axes_of, axis_in
from armui.control.motion.joint_motion import why_not_move
from armui.control.motion.motion_command import CommandKind
from armui.control.motion.motion_context import MotionContext, drop_waiting
from armui.control.motion.point_frames import leading_mode, point_way
from armui.control.operations.operation import operation
from armui.control.operations.started import Started
from armui.control.parameters.planning_model import planning_model
from armui.control.safety.gate import Agreed, MotionRequest
from armui.control.safety.interlocks import JOINTS_UNKNOWN
from armui.kinematics import poses
from armui.kinematics.arm_kinematics import Kinematics
from armui.kinematics.axes import AXES, LINEAR_AXES
from armui.kinematics.poses import Pose, apart, flange_pose, matrix_to_pose, pose_to_matrix
from armui.protocol import commands
from armui.protocol.codes import MoveMode
from armui.telemetry.events import EventKind, Level
from armui.trajectory.points.program import Waypoint

# The kinematics and the planning import numpy and scipy. They are loaded when the first pose is
# asked for: the window starts without them.
if TYPE_CHECKING:
    from armui.arm.models import ArmModel
    from armui.control.motion.joint_motion import Motion
    from armui.control.safety.gate import Plan
    from armui.kinematics.poses import Matrix
    from armui.protocol.frame import Frame
    from armui.ways.way import Way

POSE_UNKNOWN = Reason(
    "pose_unknown", "The arm reports no pose now. Wait until all six values are shown, none muted."
)
ARC_NOT_AT_START = Reason(
    "arc_not_at_start",
    "The arm stands {distance} mm and {turned}° away from the start of the arc. Press Go to "
    "start first.",
)
FRAME_NOT_IN_FORCE = Reason(
    "frame_not_in_force",
    "No user frame is in force, or another one than at the press. Choose one under Cell, then "
    "press again; or move along base or tool.",
)
SENT_POSE = Notice(
    "sent_pose",
    "Sent MOVE P (base) to X {x}  Y {y}  Z {z} mm  RX {rx}°  RY {ry}°  RZ {rz}°",
    Level.INFO,
    EventKind.COMMAND,
)
SENT_LINE = Notice(
    "sent_line",
    "Sent MOVE L (base) to X {x}  Y {y}  Z {z} mm  RX {rx}°  RY {ry}°  RZ {rz}°",
    Level.INFO,
    EventKind.COMMAND,
)
SENT_ARC = Notice(
    "sent_arc", "Sent MOVE C through the three captured poses", Level.INFO, EventKind.COMMAND
)
STEPPED_TOOL = Notice(
    "stepped_tool",
    "Sent a step of {step} along {axis}",
    Level.INFO,
    EventKind.COMMAND,
    streams=True,
)


ToolAxis = Annotated[int, Range(0, len(AXES) - 1)]
"""0–5 for X, Y, Z, RX, RY, RZ."""

_NO_TOOL: Final = (0.0,) * 6
_MODEL_MM: Final = 5.0
_MODEL_DEG: Final = 2.0
"""The most by which the program's kinematics and the arm's own may differ."""
_ARRIVED_MM: Final = 5.0
_ARRIVED_DEG: Final = 0.5
"""A resting tool this near to its target has arrived, but for sag: steps start from the target."""
_AWAY_MM: Final = 1.0
"""A tool this near to its target has arrived: half a degree of a joint moves it so far."""
_AT_START_MM: Final = 1.0
_AT_START_DEG: Final = 1.0
"""An arc is refused if the tool is farther than this from the arc's first pose."""


class Cartesian(ControllerPart):
    """Motions of the tool centre point.

    Args:
        context: The context that the controller's parts share.
        motion: Owns the speed.

    Attributes:
        tool_radius_mm: The radius of the capsule that stands for the tool in checks; 0 without one.
        frame: The user frame in force; ``None`` for the base. What is sent is always of the base.
    """

    def __init__(self, context: MotionContext, motion: Motion) -> None:
        self._context = context
        self._motion = motion
        self._model: Kinematics | None = None
        self._tool: tuple[float, ...] = _NO_TOOL
        self.tool_radius_mm = 0.0
        self.frame: UserFrame | None = None

    @property
    def tool(self) -> tuple[float, ...]:
        """The tool centre point in the flange: X, Y, Z in mm, RX, RY, RZ in degrees.

        The arm has no tool setting: its commands and feedback refer to the flange.
        """
        return self._tool

    @tool.setter
    def tool(self, tool: tuple[float, ...]) -> None:
        self._tool = tool
        self._context.connection.telemetry.set_tool(tool)

    # State ----------------------------------------------------------------------------------

    def prepare(self) -> None:
        """Load the modules for poses before an arm is connected, so that it need not wait."""
        from armui.trajectory.planning import planning  # noqa: F401, PLC0415 - scipy, for a line
        from armui.ways import inside, law  # noqa: F401, PLC0415 - numpy, for the gate

        all_models()  # an arm is compared with each of them: files, which are read now
        self.kinematics()

    def kinematics(self) -> Kinematics:
        """Return the kinematics of the chosen model, with the joint zeros of this arm."""
        geometry = self._context.operating_state().model_fit.geometry
        if self._model is None or self._model.geometry != geometry:
            self._model = Kinematics(geometry)
        return self._model

    def tool_pose(self, state: ArmState) -> Pose | None:
        """Return the measured pose of the tool centre point, or ``None`` if it is unknown."""
        flange = state.end_pose()
        if flange is None:
            return None
        return poses.tool_pose(flange, self.tool) if any(self.tool) else poses.Pose(*flange)

    def in_frame(self, pose: Sequence[float]) -> Pose:
        """Return a pose of the base as it is shown: in the user frame in force, if there is one."""
        return Pose(*pose) if self.frame is None else poses.from_base(pose, self.frame.pose)

    def in_base(self, shown: Sequence[float]) -> Pose:
        """Return a pose that was typed, which is of the user frame in force, as one of the base."""
        return Pose(*shown) if self.frame is None else poses.to_base(shown, self.frame.pose)

    def why_no_frame(self, frame: MotionFrame | None) -> Refusal | None:
        """Return why nothing may move along the axes of a frame: a user frame not in force."""
        off = isinstance(frame, UserFrame) and frame != self.frame
        return FRAME_NOT_IN_FORCE() if off else None

    def why_unknown(self) -> Refusal | None:
        """Return why poses cannot be computed: not heard, or not those of this kind of arm."""
        state = self._context.state()
        if state.angles_deg() is None:
            return JOINTS_UNKNOWN()
        if state.end_pose() is None:
            return POSE_UNKNOWN()
        now = self._context.operating_state()
        if now.model_fit.wrong is not None:
            return now.model_fit.wrong
        if now.moving or self._fits(self.kinematics(), state):
            return None
        return self._other_model(state) or MODEL_DIFFERS()

    def _other_model(self, state: ArmState) -> Refusal | None:
        """Return that another model fits, as a reason; ``None`` if no other one does."""
        joints_deg, pose = state.angles_deg(), state.end_pose()
        if joints_deg is None or pose is None:
            return None
        fitting = fitting_models(joints_deg, pose, state.firmware)
        return ModelFit(self._context.connection.model, fitting).wrong if fitting else None

    @staticmethod
    def _fits(model: Kinematics, state: ArmState) -> bool:
        joints_deg, pose = state.angles_deg(), state.end_pose()
        if joints_deg is None or pose is None:
            return True
        off_mm, off_deg = apart(model.forward(joints_deg), Pose(*pose))
        return off_mm <= _MODEL_MM and off_deg <= _MODEL_DEG

    # Motions --------------------------------------------------------------------------------

    def _plan(self, target: Sequence[float], move_mode: MoveMode) -> Plan:
        """Return the function that plans the way to a pose: by the nearest angles, or on a line."""

        def plan(start_deg: Sequence[float]) -> Way | Refusal:
            unknown = self.why_unknown()
            if unknown is not None:
                return unknown
            point = Waypoint(move_mode, tuple(flange_pose(target, self.tool)))
            return point_way(point, self._arm(), start_deg)

        return plan

    @operation(
        "tool.move",
        "Move the tool to a pose",
        why_not_move,
        moves=True,
        shown_first=True,
        first=drop_waiting,
    )
    def move(
        self,
        started: Started,
        target: Annotated[Sequence[float], "mm, °"],
        move_mode: MoveMode,
        agreed_mm: Agreed = 0.0,
    ) -> Refusal | None:
        """Send the tool centre point to a pose, with MOVE P or on a straight line with MOVE L.

        Args:
            started: The record of the command.
            target: The pose.
            move_mode: MOVE P or MOVE L.
            agreed_mm: The height down to which the operator has agreed to go.
        """
        notice = SENT_LINE if move_mode is MoveMode.MOVE_L else SENT_POSE
        figures: dict[str, object] = dict(zip(map(str.lower, AXES), target, strict=True))
        return self._move(started, target, move_mode, notice, figures, agreed_mm=agreed_mm)

    @operation("tool.step", "Move the tool by a step", why_not_move, moves=True)
    def step(
        self,
        started: Started,
        axis: ToolAxis,
        amount: Annotated[float, RangeOfArm("mm or °")],
        frame: MotionFrame,
    ) -> Refusal | None:
        """Move the tool centre point by a step, on a straight line.

        The step is added to the target of the last motion, while that is ours and the tool is on
        its way there or has arrived; otherwise to the measured pose.

        Args:
            started: The record of the command.
            axis: The axis.
            amount: In mm or degrees.
            frame: The frame of the axes.
        """
        unknown = self.why_no_frame(frame) or self.why_unknown()
        measured_deg = self._context.authority.measured_deg()
        if unknown is not None or measured_deg is None:
            return unknown or self._context.authority.why_unmeasured()
        measured = poses.tool_matrix(self.kinematics().matrix(measured_deg), self.tool)
        base = self._base(measured)
        target = poses.shifted(base, axis, amount, axes_of(frame))
        unit = " mm" if axis < LINEAR_AXES else "°"
        figures: dict[str, object] = {"axis": axis_in(frame, axis), "step": f"{amount:+g}{unit}"}
        pose = poses.matrix_to_pose(target)
        return self._move(started, pose, MoveMode.MOVE_L, STEPPED_TOOL, figures)

    @operation(
        "tool.arc",
        "Move the tool along an arc",
        why_not_move,
        moves=True,
        shown_first=True,
        first=drop_waiting,
    )
    def move_arc(
        self,
        started: Started,
        *points: Annotated[Sequence[float], Count(3), "mm, °"],
        agreed_mm: Agreed = 0.0,
    ) -> Refusal | None:
        """Move on the arc through three poses of the tool centre point (MOVE C).

        The arm must stand at the first of them, so that it takes no unchecked path.

        Args:
            started: The record of the command.
            *points: Start, middle and end.
            agreed_mm: As in :meth:`move`.
        """
        start, middle, end = (flange_pose(point, self.tool) for point in points)
        context = self._context

        def frames(percent: int) -> list[Frame]:
            codec = context.connection.codec
            leading = leading_mode(codec, context.state(), MoveMode.MOVE_C, percent)
            return leading + commands.move_arc(codec, start, middle, end, speed_percent=percent)

        way = (start, middle, end)
        request = self._request(started, MoveMode.MOVE_C, points[-1], self._plan_arc(points))
        request = replace(request, frames=frames, tool_way=way, sent_event=(SENT_ARC, {}))
        request = replace(request, agreed_mm=agreed_mm)
        return context.gate().send(request)

    def _plan_arc(self, points: Sequence[Sequence[float]]) -> Plan:
        """Return the function that plans an arc, which begins at the first of three poses."""

        def plan(start_deg: Sequence[float]) -> Way | Refusal:
            unknown = self.why_unknown()
            if unknown is not None:
                return unknown
            flanges = [flange_pose(point, self.tool) for point in points]
            off_mm, off_deg = apart(flanges[0], self.kinematics().forward(start_deg))
            if off_mm > _AT_START_MM or off_deg > _AT_START_DEG:
                return ARC_NOT_AT_START(distance=round(off_mm, 1), turned=round(off_deg, 1))
            point = Waypoint(MoveMode.MOVE_C, tuple(flanges[2]), tuple(flanges[1]))
            return point_way(point, self._arm(), start_deg)

        return plan

    def _move(
        self,
        started: Started,
        target: Sequence[float],
        move_mode: MoveMode,
        notice: Notice,
        figures: dict[str, object],
        *,
        agreed_mm: float | None = None,
    ) -> Refusal | None:
        context = self._context
        flange = flange_pose(target, self.tool)

        def frames(percent: int) -> list[Frame]:
            codec = context.connection.codec
            leading = leading_mode(codec, context.state(), move_mode, percent)
            return leading + commands.move_pose(
                codec, flange, speed_percent=percent, move_mode=move_mode
            )

        request = self._request(started, move_mode, target, self._plan(target, move_mode))
        way = (flange,) if move_mode is MoveMode.MOVE_L else ()
        request = replace(request, frames=frames, tool_way=way, sent_event=(notice, figures))
        request = replace(request, agreed_mm=agreed_mm)
        return context.gate().send(request)

    def _request(
        self, started: Started, move_mode: MoveMode, target: Sequence[float], plan: Plan
    ) -> MotionRequest:
        """Return the gate request that all tool motions share; the caller adds the frames."""
        return MotionRequest(
            started=started,
            kind=CommandKind.POSE,
            move_mode=move_mode,
            speed_percent=lambda: self._motion.speed_percent,
            plan=plan,
            frames=lambda _percent: [],
            why_not=why_not_move,
            tool=pose_to_matrix(target),
            leads_away=self._leads_away(target),
        )

    def _arm(self) -> ArmModel:
        return planning_model(self._context.state(), self._context.operating_state())

    def _leads_away(self, target: Sequence[float]) -> bool:
        """Return whether the tool is measured elsewhere than at a pose."""
        here = self.tool_pose(self._context.state())
        if here is None:
            return False
        off_mm, off_deg = apart(here, Pose(*target))
        return off_mm > _AWAY_MM or off_deg > _ARRIVED_DEG

    def _base(self, measured: Matrix) -> Matrix:
        """Return the pose from which a step of the tool starts."""
        authority = self._context.authority
        asked = authority.tool_base()
        if asked is None or authority.under_way:
            return measured if asked is None else asked
        off_mm, off_deg = apart(matrix_to_pose(asked), matrix_to_pose(measured))
        arrived = off_mm <= _ARRIVED_MM and off_deg <= _ARRIVED_DEG
        return asked if arrived else measured

    def forget_arm(self) -> None:
        """Forget the geometry of an arm that is gone; another one may have another."""
        self._model = None
