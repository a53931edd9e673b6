"""The context that each part of the controller gets: the connection and the arm's state."""

from __future__ import annotations

from collections.abc import Callable, Sequence
from dataclasses import dataclass
from typing import TYPE_CHECKING

from armui.arm.refusal import Reason, Refusal
from armui.arm.state import ArmState
from armui.control.authority import Authority
from armui.control.events import Notice
from armui.control.link.link_state import LINK_LOST, LinkState, why_unreachable
from armui.control.motion.motion_command import CommandKind, End, MotionCommand
from armui.control.operating_state import OperatingState
from armui.control.operations.outcome_events import EmitEvent, close_and_emit, report_and_emit
from armui.control.operations.started import Ending, Started
from armui.control.parameters.planning_model import planning_model
from armui.control.safety.overspeed import tool_pace
from armui.control.safety.standstill import STILL_MOVING, why_moving
from armui.protocol import commands
from armui.protocol.codes import ControlMode, TrajectoryCommand
from armui.telemetry.events import EventKind, Level

if TYPE_CHECKING:
    from armui.control.link.connection import Connection
    from armui.control.safety.overspeed import ToolPace
    from armui.kinematics.poses import Matrix
    from armui.protocol.codes import MoveMode
    from armui.protocol.frame import Frame
    from armui.ways.passes import Pass

COMMAND_OVER = Reason(
    "command_over", "Something else has ended this motion. Look at the arm, then start again."
)
GENERATION_UNKNOWN = Reason(
    "generation_unknown",
    "The program is still finding out which protocol the arm speaks. Wait a second.",
)
REFUSED = Notice("refused", "Not sent. {reason}", Level.WARNING, EventKind.COMMAND)
NOT_DONE = Notice("not_done", "Not done. {reason}", Level.WARNING, EventKind.COMMAND)


def why_not_asked(now: OperatingState) -> Refusal | None:
    """Return why the arm can be neither asked nor set: not there, or its protocol not known yet."""
    return now.unreachable or (GENERATION_UNKNOWN() if now.generation is None else None)


@dataclass(frozen=True, slots=True)
class Context:
    """The objects and functions that the parts of the controller share.

    Attributes:
        connection: The way to the arm.
        emit_event: Takes the events.
        clock: Monotonic time in seconds.
        state: The arm as last heard.
        operating_state: Returns the operating state of the last assessment, by the controller's
            tick or :attr:`refresh`.
        refresh: Observes the arm and the other hosts anew, tells the windows if the operating state
            has changed, and returns it. Each command of the operator begins with it, and ends with
            it where it has changed that state itself.
        observe: Gives the authority all feedback received so far, and does nothing more.
        authority: Knows who moves the arm, and our own command.
        begun: Takes the id of each operation that begins, before it sends anything.
    """

    connection: Connection
    emit_event: EmitEvent
    clock: Callable[[], float]
    state: Callable[[], ArmState]
    operating_state: Callable[[], OperatingState]
    refresh: Callable[[], OperatingState]
    observe: Callable[[], None]
    authority: Authority
    begun: Callable[[str], object]

    @property
    def rests(self) -> bool:
        """True if no motion of ours may be under way: what they are checked with may change."""
        authority, now = self.authority, self.operating_state()
        if self.connection.device is None:
            return True
        if authority.may_be_ours or authority.about_to_move or now.occupied is not None:
            return False
        # without feedback a motion of ours may still go on
        heard_at_rest = now.link is LinkState.ONLINE and authority.at_rest
        return heard_at_rest or authority.number == 0

    def refuse(self, refusal: Refusal, *, sends: bool = True) -> Refusal:
        """Tell the operator why something was not done; return the reason.

        Args:
            refusal: The reason.
            sends: True if something would have been sent to the arm.
        """
        self.emit_event(REFUSED if sends else NOT_DONE, reason=refusal)
        return refusal

    def close(
        self, started: Started | None, ending: Ending, notice: Notice, **params: object
    ) -> None:
        """Note how a command ended, and tell the operator.

        Args:
            started: The command.
            ending: The way it ended.
            notice: The notice for the operator.
            **params: The figures of that.
        """
        close_and_emit(self.emit_event, self.clock(), started, ending, notice, **params)

    def report(self, started: Started, notice: Notice, **params: object) -> None:
        """Tell the operator what is known of a command that has not ended."""
        report_and_emit(self.emit_event, self.clock(), started, notice, **params)

    def why_no_motion(self) -> Refusal | None:
        """Return why who moves the arm now rules out a motion frame of ours, or ``None``.

        Every motion frame passes this check, which uses the newest feedback and not that of the
        controller's last tick.
        """
        self.observe()
        return self.authority.why_not()

    def why_moving(self) -> Refusal | None:
        """Return why the arm cannot be taken to stand still: it moves, or is about to by our word.

        What motions are checked against is not changed then: the one that has just been sent was
        checked against it, and is not measured to move yet.
        """
        refusal = why_moving(self.state())
        about_to = self.authority.about_to_move or self.operating_state().moving
        return refusal or (STILL_MOVING() if about_to else None)

    def send_motion(
        self,
        kind: CommandKind,
        frames: Sequence[Frame],
        *,
        passed: Pass,
        started: Started,
        move_mode: MoveMode,
        speed_percent: int,
        most_percent: int = 100,
        joints_deg: Sequence[float] | None = None,
        tool: Matrix | None = None,
        leads_away: bool = False,
        way: Sequence[Sequence[float]] = (),
        keep_s: float | None = None,
    ) -> MotionCommand | Refusal:
        """Send the frames of a new motion command, if this program may move the arm now.

        Args:
            kind: The kind of the command.
            frames: Targets and mode word, in order.
            passed: The gate's pass for it.
            started: The operation that the motion carries out; a refusal closes it.
            move_mode: The kind of motion in the mode word.
            speed_percent: The speed percentage in the mode word.
            most_percent: The highest one that it may be given on its way.
            joints_deg: Six target angles, where the command names them.
            tool: The target of the tool centre point, where the command names it.
            leads_away: True if the tool was measured elsewhere than its target.
            way: Of a line or an arc, the poses of the flange that it is told by: what its speed is
                compared with follows from them.
            keep_s: Frames that could not be sent within this time are dropped.

        Returns:
            The command, now ours, or why nothing was sent.
        """
        refusal = self.why_no_motion()
        if refusal is not None:
            started.close(Ending.REFUSED)
            return refusal
        lead = [*self.cancel_frames(), *self.lead_frames(speed_percent)]
        command = self.authority.begin(
            kind,
            started=started,
            now_s=self.clock(),
            move_mode=move_mode,
            speed_percent=speed_percent,
            joints_deg=joints_deg,
            tool=tool,
            leads_away=leads_away,
            pace=self._pace(way) if way else None,
            way=passed.way,
            most_percent=most_percent,
        )
        self.connection.void(command.number)
        if not self.connection.send([*lead, *frames], keep_s, command.number, passed):
            self.authority.end_command(End.NOT_SENT)
            return LINK_LOST()
        return command

    def _pace(self, way: Sequence[Sequence[float]]) -> ToolPace:
        """Return how fast a line or an arc is at 100 %, from where the joints stand."""
        state = self.state()
        start_deg = None if self.authority.moves else state.angles_deg()
        return tool_pace(way, start_deg, planning_model(state, self.operating_state()))

    def send_on(
        self,
        command: MotionCommand,
        frames: Sequence[Frame],
        *,
        passed: Pass,
        joints_deg: Sequence[float],
        keep_s: float | None = None,
    ) -> MotionCommand | Refusal:
        """Send the next setpoint of a stream; see :meth:`send_motion`.

        Args:
            command: The stream's command, as returned by the last call.
            frames: The setpoint's.
            passed: The gate's pass for it.
            joints_deg: Its six angles.
            keep_s: Frames that could not be sent within this time are dropped.
        """
        refusal = self.why_no_motion()
        if refusal is not None:
            return refusal
        further = self.authority.extend(command, joints_deg, self.clock())
        if further is None:
            return COMMAND_OVER()
        if not self.connection.send(frames, keep_s, further.number, passed):
            self.authority.end_command(End.NOT_SENT)
            return LINK_LOST()
        return further

    def cancel_frames(self) -> list[Frame]:
        """Return frames that drop another host's motion held back in the arm (0x150 byte 1 = 6).

        It precedes each 0x151 that would set such a motion going.
        """
        if not self.authority.may_hold_another:
            return []
        return commands.trajectory_command(self.connection.codec, TrajectoryCommand.ABORT)

    def lead_frames(self, speed_percent: int) -> list[Frame]:
        """Return 0x151 to precede a target slower than the last, so that none starts too fast."""
        mode = self.authority.mode_in_force()
        if mode is None or mode[0] is not ControlMode.CAN_CONTROL:
            return []  # in standby the arm starts no target
        if not self.authority.lowers_speed(speed_percent):
            return []
        return self.speed_frames(mode, speed_percent)

    def speed_frames(self, mode: tuple[ControlMode, MoveMode], percent: int) -> list[Frame]:
        """Return 0x151 with another speed, 0–100 %, in the arm's present modes."""
        return commands.set_mode(
            self.connection.codec, control_mode=mode[0], move_mode=mode[1], speed_percent=percent
        )

    def why_unknown(self) -> Refusal | None:
        """Return why the arm cannot be asked: it is not there, or its protocol is not known yet."""
        connection = self.connection
        refusal = why_unreachable(connection.link, connection.device)
        if refusal is None and connection.generation is None:
            return GENERATION_UNKNOWN()
        return refusal


class ControllerPart:
    """A part of the controller that follows something over time.

    A part overrides those of the three methods that it needs. A stop does not touch one without
    `halt`: a motion under way ends with the arm's own, and a setting moves nothing.
    """

    def follow_arm(self) -> None:
        """Take in the feedback and advance; called at each tick while a device is open."""

    def halt(self) -> None:
        """Give up what would move the arm: a stop was asked for, or the arm has stopped."""

    def forget_arm(self) -> None:
        """Forget the arm and await nothing more of it: it is lost or was disconnected."""
