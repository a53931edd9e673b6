"""Drag teaching: the arm records how a hand moves it, and replays the recording (0x150 byte 2)."""

from __future__ import annotations

import enum
from collections.abc import Callable
from functools import partial
from typing import Final

from armui.arm.rest_pose import from_rest_deg
from armui.protocol.codes import ArmStatusCode, ControlMode, MotionState, TeachingState
from armui.sim.condition import Condition
from armui.sim.mechanics.mechanics import HandGuiding, Mechanics
from armui.sim.mechanics.powered_joints import SixValues
from armui.sim.motion.tool_plan import PathMotion, PlanningError, plan_replay
from armui.sim.parameters.settings import ArmSettingsRecord

_SAMPLE_S: Final = 0.05
_LONGEST_S: Final = 600.0
_NEAR_REST_DEG: Final = 15.0
_TO_START_SHARE: Final = 0.2
"""The share of the joints' highest speeds with which the arm goes to a recording's start."""


class _Phase(enum.Enum):
    IDLE = enum.auto()
    RECORDING = enum.auto()
    TO_START = enum.auto()
    RUNNING = enum.auto()
    PAUSED = enum.auto()


class SimulatedTeaching:
    """Records the arm's motion under a hand, and replays it.

    A replay is as fast as the hand was, but slower where the motors cannot follow. Once in drag
    teaching the arm obeys no mode until it is reset near its rest pose; from S-V1.8-5 on a mode
    word ends it.

    Attributes:
        entered: True if the arm is in drag teaching.
        recording: The joint angles, every 50 ms.
    """

    def __init__(
        self,
        mechanics: Mechanics,
        condition: Condition,
        settings: ArmSettingsRecord,
        hand_guiding: HandGuiding,
    ) -> None:
        self._mechanics = mechanics
        self._condition = condition
        self._settings = settings
        self._hand = hand_guiding
        self._phase = _Phase.IDLE
        self._since_sample_s = 0.0
        self._path: PathMotion | None = None
        self._goes_on = False
        self.entered = False
        self.recording: list[SixValues] = []
        self._commands: dict[TeachingState, Callable[[], bool]] = {
            TeachingState.START_RECORDING: self._start_recording,
            TeachingState.STOP_RECORDING: self._stop_recording,
            TeachingState.RUN_RECORDING: self._run,
            TeachingState.PAUSE: self._pause,
            TeachingState.CONTINUE: self._continue,
            TeachingState.ABORT: self._abort,
            TeachingState.MOVE_TO_START: partial(self._go_to_start, goes_on=False),
        }

    def command(self, command: TeachingState) -> None:
        """Obeys 0x150 byte 2; a command that does not fit the present state is ignored."""
        obey = self._commands.get(command)
        if obey is not None and obey():
            self._condition.teaching_state = command

    def interrupt(self) -> None:
        """Ends the activity, as a stop or a power cut does; the recording stays."""
        self._phase, self._path = _Phase.IDLE, None
        self._condition.teaching_state = TeachingState.OFF
        self._condition.activity = ArmStatusCode.NORMAL

    def reset(self) -> bool:
        """Leaves drag teaching if the arm is near its rest pose; returns whether it was left."""
        if self.entered and max(from_rest_deg(self._mechanics.positions_deg)) > _NEAR_REST_DEG:
            return False
        self.entered = False
        return True

    def leave(self) -> None:
        """Leaves drag teaching as a mode word does from S-V1.8-5 on: the arm holds or brakes."""
        if self._phase is _Phase.RECORDING:
            self._stop_recording()
        else:
            self._abort()
        self.interrupt()
        self.entered = False

    def time_passed(self, dt_s: float) -> None:
        """Records, unless the hand is too fast, and detects the ends of motions."""
        if self._phase is _Phase.RECORDING:
            self._record(dt_s)
        elif self._phase is not _Phase.IDLE and self._condition.hindered:
            self._abort()
        elif self._phase is _Phase.TO_START and not self._mechanics.moving:
            self._at_start()
        elif self._phase is _Phase.RUNNING and self._path is not None and self._path.at_end:
            self._finish()

    def _record(self, dt_s: float) -> None:
        limits, speeds = self._settings.limits, self._mechanics.speeds_deg_s
        if any(abs(v) > each.max_speed_deg_s for v, each in zip(speeds, limits, strict=True)):
            self._stop_recording()
            self._condition.activity = ArmStatusCode.OVERSPEED_WHILE_TEACHING
            self._condition.teaching_state = TeachingState.STOP_RECORDING
            return
        self._since_sample_s += dt_s
        if self._since_sample_s > _SAMPLE_S - 1e-9 and len(self.recording) * _SAMPLE_S < _LONGEST_S:
            self._since_sample_s = 0.0
            self.recording.append(self._mechanics.positions_deg)

    def _start_recording(self) -> bool:
        if not all(self._mechanics.powered) or self._condition.hindered:
            return False
        self.entered = True
        self.recording = [self._mechanics.positions_deg]
        self._since_sample_s = 0.0
        self._phase, self._path = _Phase.RECORDING, None
        self._condition.control_mode = ControlMode.TEACHING
        self._condition.activity = ArmStatusCode.TEACHING_RECORDING
        self._mechanics.give_way(self._hand)
        return True

    def _stop_recording(self) -> bool:
        if self._phase is not _Phase.RECORDING:
            return False
        self.recording.append(self._mechanics.positions_deg)
        self._mechanics.hold()
        self._phase = _Phase.IDLE
        self._condition.activity = ArmStatusCode.NORMAL
        return True

    def _run(self) -> bool:
        if not self._go_to_start(goes_on=True):
            return False
        self._condition.activity = ArmStatusCode.TEACHING_RUNNING
        return True

    def _go_to_start(self, *, goes_on: bool) -> bool:
        ready = self.entered and self._phase is _Phase.IDLE and all(self._mechanics.powered)
        if not ready or not self.recording or self._condition.hindered:
            return False
        settings = self._settings
        speeds = [_TO_START_SHARE * limits.max_speed_deg_s for limits in settings.limits]
        self._mechanics.move_to(self.recording[0], speeds, settings.accelerations_deg_s2)
        self._phase, self._goes_on = _Phase.TO_START, goes_on
        self._condition.activity = ArmStatusCode.NORMAL
        self._condition.motion_state = MotionState.NOT_REACHED
        return True

    def _at_start(self) -> None:
        if not self._goes_on:
            self._finish()
            return
        try:
            path = plan_replay(self.recording, _SAMPLE_S, self._settings)
        except PlanningError:
            self._finish()
            self._condition.no_solution = True
            return
        self._path, self._phase = path, _Phase.RUNNING
        path.run(1.0)
        self._mechanics.follow_path(path)

    def _pause(self) -> bool:
        if self._phase is not _Phase.RUNNING or self._path is None:
            return False
        self._path.run(0.0)
        self._phase = _Phase.PAUSED
        self._condition.activity = ArmStatusCode.TEACHING_PAUSED
        return True

    def _continue(self) -> bool:
        if self._phase is not _Phase.PAUSED or self._path is None:
            return False
        self._path.run(1.0)
        self._mechanics.follow_path(self._path)
        self._phase = _Phase.RUNNING
        self._condition.activity = ArmStatusCode.TEACHING_RUNNING
        return True

    def _abort(self) -> bool:
        if self._phase in (_Phase.IDLE, _Phase.RECORDING):
            return False
        self._mechanics.brake(self._settings.accelerations_deg_s2)
        self.interrupt()
        return True

    def _finish(self) -> None:
        self.interrupt()
        self._condition.motion_state = MotionState.REACHED
