"""Drag teaching and planned motions in the protocol's words (0x150 bytes 1 and 2)."""

from __future__ import annotations

from collections.abc import Mapping
from typing import Final

from PySide6.QtCore import QT_TRANSLATE_NOOP, QCoreApplication

from armui.control.devices.teaching_phase import TeachingPhase
from armui.protocol.codes import TeachingState, TrajectoryCommand

_COMMANDS: Final[Mapping[TeachingState, object]] = {
    TeachingState.START_RECORDING: QT_TRANSLATE_NOOP("TeachingCommand", "Start recording"),
    TeachingState.STOP_RECORDING: QT_TRANSLATE_NOOP("TeachingCommand", "Stop recording"),
    TeachingState.RUN_RECORDING: QT_TRANSLATE_NOOP("TeachingCommand", "Replay"),
    TeachingState.PAUSE: QT_TRANSLATE_NOOP("TeachingCommand", "Pause"),
    TeachingState.CONTINUE: QT_TRANSLATE_NOOP("TeachingCommand", "Continue"),
    TeachingState.ABORT: QT_TRANSLATE_NOOP("TeachingCommand", "Terminate"),
    TeachingState.MOVE_TO_START: QT_TRANSLATE_NOOP("TeachingCommand", "Move to start"),
}

_PLANS: Final[Mapping[TrajectoryCommand, object]] = {
    TrajectoryCommand.PAUSE: QT_TRANSLATE_NOOP("TrajectoryCommand", "Pause"),
    TrajectoryCommand.CONTINUE: QT_TRANSLATE_NOOP("TrajectoryCommand", "Continue"),
    TrajectoryCommand.CLEAR_CURRENT: QT_TRANSLATE_NOOP("TrajectoryCommand", "Clear current"),
    TrajectoryCommand.CLEAR_ALL: QT_TRANSLATE_NOOP("TrajectoryCommand", "Clear all"),
    TrajectoryCommand.ABORT: QT_TRANSLATE_NOOP("TrajectoryCommand", "Terminate"),
}

_PHASES: Final[Mapping[TeachingPhase, object]] = {
    TeachingPhase.OFF: QT_TRANSLATE_NOOP("TeachingPhase", "Not in drag teaching"),
    TeachingPhase.IDLE: QT_TRANSLATE_NOOP("TeachingPhase", "In drag teaching, nothing under way"),
    TeachingPhase.RECORDING: QT_TRANSLATE_NOOP("TeachingPhase", "Recording: lead the arm by hand"),
    TeachingPhase.REPLAYING: QT_TRANSLATE_NOOP("TeachingPhase", "Moving along the recording"),
    TeachingPhase.PAUSED: QT_TRANSLATE_NOOP("TeachingPhase", "Replay paused"),
}


def teaching_command(command: TeachingState) -> str:
    """What a command of 0x150 byte 2 is called («开始示教记录»)."""
    return QCoreApplication.translate("TeachingCommand", str(_COMMANDS[command]))


def trajectory_command(command: TrajectoryCommand) -> str:
    """What a command of 0x150 byte 1 is called («暂停当前规划»)."""
    return QCoreApplication.translate("TrajectoryCommand", str(_PLANS[command]))


def teaching_phase(phase: TeachingPhase) -> str:
    """What drag teaching does, for a heading."""
    return QCoreApplication.translate("TeachingPhase", str(_PHASES[phase]))
