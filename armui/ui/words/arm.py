"""The arm and its parts in words: codes of its status frame (0x2A1), joints, gripper, lamps, modes.

Both generations share the tables: generation 2 only adds codes at their ends. A code that is in
no table is shown as unknown with its number, never as its nearest neighbour.
"""

from __future__ import annotations

from typing import TYPE_CHECKING, Final

from PySide6.QtCore import QT_TRANSLATE_NOOP, QCoreApplication

from armui.arm.device import Device
from armui.arm.joint_status import Item, StatusVerdict, Word
from armui.arm.model_check import OLDER_ZEROS
from armui.arm.quirks import frees_gripper
from armui.arm.state import GripperFault, Status
from armui.protocol.codes import ControlMode, EndLoad, Mounting, TeachingState, TrajectoryCommand
from armui.protocol.generation import Generation
from armui.ui import format as fmt
from armui.ui.words.text import Text, Texts, sentence

if TYPE_CHECKING:
    from armui.arm.state import ArmState

_CONTROL_MODES: Final = Texts("ControlMode") | {
    0x00: "Standby mode",
    0x01: "CAN command control mode",
    0x02: "Teaching mode",
    0x03: "Ethernet control mode",
    0x04: "Wi-Fi control mode",
    0x05: "Remote controller mode",
    0x06: "Linked teaching input mode",
    0x07: "Offline trajectory mode",
}

_SHORT_CONTROL_MODES: Final = Texts("ControlModeShort") | {
    0x00: "Standby",
    0x01: "CAN commands",
    0x02: "Teaching",
    0x03: "Ethernet",
    0x04: "Wi-Fi",
    0x05: "Remote controller",
    0x06: "Linked teaching input",
    0x07: "Offline trajectory",
}

_ARM_STATUSES: Final = Texts("ArmStatus") | {
    0x00: "Normal",
    0x01: "Emergency stop",
    0x02: "No solution",
    0x03: "Singularity",
    0x04: "Target angle beyond limit",
    0x05: "Joint communication fault",
    0x06: "Joint brake not released",
    0x07: "Collision",
    0x08: "Overspeed in drag teaching",
    0x09: "Joint status fault",
    0x0A: "Other fault",
    0x0B: "Teaching: recording",
    0x0C: "Teaching: replaying",
    0x0D: "Teaching: paused",
    0x0E: "Main controller too hot",
    0x0F: "Brake resistor too hot",
}

_MOVE_MODES: Final = Texts("MoveMode") | {
    0x00: "Point mode",
    0x01: "Joint mode",
    0x02: "Linear mode",
    0x03: "Arc mode",
    0x04: "MIT mode",
    0x05: "CPV mode",
    0x06: "MIT mode",
}

_TEACHING_STATES: Final = Texts("Teaching") | {
    0x00: "Off",
    0x01: "Start of recording (drag teaching on)",
    0x02: "End of recording (drag teaching off)",
    0x03: "Replaying the taught trajectory",
    0x04: "Replay paused",
    0x05: "Replay resumed",
    0x06: "Replay terminated",
    0x07: "Moving to the start of the trajectory",
}
_FIGURES: Final = Texts("Figure") | {
    "joint": "Joint number",
    "lamp": "Lamp number",
    "red": "R channel",
    "green": "G channel",
    "blue": "B channel",
    "opening": "Opening",
    "torque": "Torque",
    "angle": "Angle",
    "speed": "Speed",
    "percent": "Speed",
    "axis": "Axis",
    "name": "Name",
    "agreed_mm": "Height over the floor, mm",
}

GRIPPER_ACTS: Final = Texts("GripperAct") | {
    "enable": "Enable",
    "disable": "Disable",
    "clear": "Clear error",
    "zero": "Set zero",
}
"""The actions on the gripper («清除错误»)."""

GRIPPER_FAULTS: Final = Texts("GripperFault") | {
    GripperFault.UNDERVOLTAGE: "supply voltage too low",
    GripperFault.MOTOR_OVERTEMPERATURE: "motor too hot",
    GripperFault.OVERCURRENT: "driver overcurrent",
    GripperFault.DRIVER_OVERTEMPERATURE: "driver too hot",
    GripperFault.SENSOR: "sensor abnormal",
    GripperFault.DRIVER: "driver error",
}
"""The faults of the gripper's driver («电机过温»)."""

END_LOADS: Final = Texts("EndLoad") | {
    EndLoad.EMPTY: "No load",
    EndLoad.HALF: "Half load",
    EndLoad.FULL: "Full load",
    EndLoad.NOT_GIVEN: "Not given",
}
"""The loads («半载»)."""
_ITEMS: Final = Texts("JointItem") | {
    Item.STATUS_CODE: "Status code:",
    Item.SUPPLY_VOLTAGE: "Supply voltage:",
    Item.MOTOR_TEMPERATURE: "Motor temperature:",
    Item.DRIVER_CURRENT: "Driver current:",
    Item.DRIVER_TEMPERATURE: "Driver temperature:",
    Item.SENSOR: "Sensor:",
    Item.COLLISION_PROTECTION: "Collision protection:",
    Item.DRIVER_FAULT: "Driver error:",
    Item.DRIVER_ENABLED: "Driver enabled:",
    Item.HOMED: "Homing:",
    Item.STALL_PROTECTION: "Stall protection:",
    Item.COMMUNICATION: "Joint communication:",
}

_WORDS: Final = Texts("JointWord") | {
    Word.NORMAL: "Normal",
    Word.TOO_LOW: "Too low",
    Word.TOO_HOT: "Too hot",
    Word.OVERCURRENT: "Overcurrent",
    Word.ABNORMAL: "Abnormal",
    Word.ERROR: "Error",
    Word.TRIGGERED: "Triggered",
    Word.ENABLED: "Enabled",
    Word.DISABLED: "Disabled",
    Word.NOT_HOMED: "Not homed",
    Word.HOMED: "Homed",
}

_VERDICTS: Final = Texts("JointVerdict") | {
    StatusVerdict.NORMAL: "Normal",
    StatusVerdict.DISABLED: "Disabled",
    StatusVerdict.UNKNOWN: "Unknown",
    StatusVerdict.FAULT: "Fault",
    StatusVerdict.OFFLINE: "Offline",
}
MOUNTINGS: Final = Texts("Mounting") | {
    Mounting.UNCHANGED: "Unchanged",
    Mounting.LEVEL: "Level",
    Mounting.ON_THE_LEFT_SIDE: "Left side",
    Mounting.ON_THE_RIGHT_SIDE: "Right side",
    Mounting.UPSIDE_DOWN: "Upside down",
}
"""The mountings («水平»)."""
TEACHING_COMMANDS: Final = Texts("TeachingCommand") | {
    TeachingState.START_RECORDING: "Start recording",
    TeachingState.STOP_RECORDING: "Stop recording",
    TeachingState.RUN_RECORDING: "Replay",
    TeachingState.PAUSE: "Pause",
    TeachingState.CONTINUE: "Continue",
    TeachingState.ABORT: "Terminate",
    TeachingState.MOVE_TO_START: "Move to start",
}
"""The commands of 0x150 byte 2 («开始示教记录»)."""

TRAJECTORY_COMMANDS: Final = Texts("TrajectoryCommand") | {
    TrajectoryCommand.PAUSE: "Pause",
    TrajectoryCommand.CONTINUE: "Continue",
    TrajectoryCommand.CLEAR_CURRENT: "Clear current",
    TrajectoryCommand.CLEAR_ALL: "Clear all",
    TrajectoryCommand.ABORT: "Terminate",
}
"""The commands of 0x150 byte 1 («暂停当前轨迹»)."""

OTHER_MODES: Final = Texts("OtherMode") | {
    "mit": "MIT",
    "cpv": "CPV",
    "high_follow": "high-follow",
}
"""The modes that another host can set."""
_KINDS: Final = Texts("ArmKind") | {"older": "{model} (zeros before S-V1.6-3)"}
ARM_PARTS: Final = Texts("ArmPart") | {
    "base": "the base",
    "shoulder": "the shoulder",
    "upper arm": "the upper arm",
    "forearm": "the forearm",
    "hand": "the wrist",
    "gripper": "the gripper",
    "wrist": "the fourth link",
    "tool": "the tool",
    "held object": "the held object",
}
"""The parts of the arm and its load, by the names that checks use."""


def arm_kind(kind: str) -> str:
    """Return a `ModelFit.kind` in the operator's language."""
    model = kind.removesuffix(OLDER_ZEROS)
    return kind if model == kind else _KINDS.text("older", {"model": model})


def held_target(angles_deg: object) -> str:
    """Return the target of a motion held back: six angles in degrees, or that they are unknown."""
    if not isinstance(angles_deg, tuple):
        return QCoreApplication.translate("HeldTarget", "a target this program does not know")
    return fmt.listed(f"{angle:.1f}°" for angle in angles_deg)


def device_name(device: Device) -> str:
    """Return the operator's name of a device: an adapter's channel, or that an arm is simulated."""
    if not device.simulated:
        return device.name
    source = QT_TRANSLATE_NOOP("Device", "Simulated arm, gen. {generation}")
    return sentence("Device", source, {"generation": device.generation})


def disabling(danger: str, generation: Generation | None, state: ArmState) -> str:
    """Return what disabling all joints does, the gripper included.

    Args:
        danger: The text on the danger to the arm.
        generation: The protocol it speaks.
        state: The arm's state.
    """
    freed = False if generation is Generation.ONE else frees_gripper(state)
    if freed is None:
        text = QCoreApplication.translate(
            "Disabling",
            "From firmware S-V1.9-0 on the gripper lets go, too, and what it holds falls. To keep "
            "it, disable joints 1–6 singly.",
        )
    elif freed:
        text = QCoreApplication.translate(
            "Disabling",
            "The gripper lets go, too, and what it holds falls. To keep it, disable joints 1–6 "
            "singly.",
        )
    return danger if freed is False else f"{danger}\n{text}"


def mounting_check(needed: Mounting | None, told: Mounting | None) -> str:
    """Return a warning if the arm's mounting does not fit the base; empty if it does.

    Args:
        needed: The mounting for the placement of the base; ``None`` if none fits.
        told: The mounting that this program has sent last; ``None`` if none.
    """
    if needed is told or (told is None and needed is Mounting.LEVEL):
        return ""
    text = QCoreApplication.translate(
        "Mounting",
        "The base is placed for the mounting “{needed}”, which the arm was not told: it would hold "
        "its weight wrongly. Tell it under End load; the program never does so by itself.",
    )
    if needed is None:
        text = QCoreApplication.translate(
            "Mounting",
            "The base is tilted so that no mounting fits that the arm knows: it holds its weight "
            "wrongly. Correct the figures, or mind it when the arm is led by hand.",
        )
    elif told is not None:
        text = QCoreApplication.translate(
            "Mounting",
            "The arm was told the mounting “{told}”, but the cell places its base for “{needed}”: "
            "one of them is wrong. Correct the figures, or tell the arm under End load.",
        )
    return text.format(
        needed="" if needed is None else MOUNTINGS.text(needed),
        told="" if told is None else MOUNTINGS.text(told),
    )


def figure(name: str) -> str:
    """Return the name of a figure of a command («开度»); see `armui.arm.figures`."""
    return _FIGURES.word(name)


def operation_title(title: str) -> str:
    """Return the title of an operation by its English one («失能电机»)."""
    return Text("Operation", title).text()


def joint_item(item: Item) -> str:
    """Return the name of a row («电源电压:»)."""
    return _ITEMS.text(item)


def joint_word(word: Word) -> str:
    """Return the word of a cell («过低»)."""
    return _WORDS.text(word)


def joint_verdict(verdict: StatusVerdict) -> str:
    """Return the overall state of the six joints («有故障»)."""
    return _VERDICTS.text(verdict)


def calibrated_mm() -> str:
    """Return the unit of an opening by the gripper's table («mm，已校准»)."""
    return QCoreApplication.translate("Gripper", "mm, calibrated")


def control_mode(code: int) -> str:
    """Return the source of the arm's commands, byte 0, in the protocol's words («待机模式»)."""
    return _word(_CONTROL_MODES, code)


def control_mode_short(code: int) -> str:
    """Return the source of the arm's commands, byte 0, as in the manual's status bar («待机»)."""
    return _word(_SHORT_CONTROL_MODES, code)


def arm_status(code: int) -> str:
    """Return the arm's status, byte 1 («正常»)."""
    return _word(_ARM_STATUSES, code)


def move_mode(code: int) -> str:
    """Return the kind of motion, byte 2 («点位模式»)."""
    return _word(_MOVE_MODES, code)


def teaching(code: int) -> str:
    """Return the state of drag teaching, byte 3 («关闭»)."""
    return _word(_TEACHING_STATES, code)


def teaching_now(status: Status) -> str:
    """Return the state of drag teaching, also after a recording while the mode is still on."""
    ended = status.teaching == TeachingState.STOP_RECORDING
    if ended and status.control_mode == ControlMode.TEACHING:
        return QCoreApplication.translate("Teaching", "Recording ended; still in drag teaching")
    if status.teaching == TeachingState.OFF and status.control_mode == ControlMode.TEACHING:
        return QCoreApplication.translate("Teaching", "No command; still in drag teaching")
    return teaching(status.teaching)


def reached(is_reached: bool, *, left: bool = False) -> str:
    """Return whether the arm has arrived, byte 4, in words («已达指定点»).

    Args:
        is_reached: The arm's report; it stays true if the arm sinks from there.
        left: True if the arm was measured to move since then without a command.
    """
    if is_reached and left:
        return QCoreApplication.translate("Reached", "Target left again")
    if is_reached:
        return QCoreApplication.translate("Reached", "Target reached")
    return QCoreApplication.translate("Reached", "Target not reached")


def _word(table: Texts[int], code: int) -> str:
    if code in table:
        return table.text(code)
    unknown = QT_TRANSLATE_NOOP("UnknownCode", "unknown ({code})")
    return sentence("UnknownCode", unknown, {"code": f"0x{code:02X}"})
