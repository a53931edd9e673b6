"""Drag teaching and planned motions in the protocol's words (0x150 bytes 1 and 2)."""

from __future__ import annotations

from typing import Final

from armui.control.devices.teaching_phase import TeachingPhase
from armui.protocol.codes import TeachingState, TrajectoryCommand
from armui.ui.words.text import Texts

_COMMANDS: Final = Texts("TeachingCommand") | {
    TeachingState.START_RECORDING: "Start recording",
    TeachingState.STOP_RECORDING: "Stop recording",
    TeachingState.RUN_RECORDING: "Replay",
    TeachingState.PAUSE: "Pause",
    TeachingState.CONTINUE: "Continue",
    TeachingState.ABORT: "Terminate",
    TeachingState.MOVE_TO_START: "Move to start",
}

_PLANS: Final = Texts("TrajectoryCommand") | {
    TrajectoryCommand.PAUSE: "Pause",
    TrajectoryCommand.CONTINUE: "Continue",
    TrajectoryCommand.CLEAR_CURRENT: "Clear current",
    TrajectoryCommand.CLEAR_ALL: "Clear all",
    TrajectoryCommand.ABORT: "Terminate",
}

_PHASES: Final = Texts("TeachingPhase") | {
    TeachingPhase.OFF: "Not in drag teaching",
    TeachingPhase.IDLE: "In drag teaching, nothing under way",
    TeachingPhase.RECORDING: "Recording: lead the arm by hand",
    TeachingPhase.REPLAYING: "Moving along the recording",
    TeachingPhase.PAUSED: "Replay paused",
}


def teaching_command(command: TeachingState) -> str:
    """What a command of 0x150 byte 2 is called («开始示教记录»)."""
    return _COMMANDS.text(command)


def trajectory_command(command: TrajectoryCommand) -> str:
    """What a command of 0x150 byte 1 is called («暂停当前规划»)."""
    return _PLANS.text(command)


def teaching_phase(phase: TeachingPhase) -> str:
    """What drag teaching does, for a heading."""
    return _PHASES.text(phase)
