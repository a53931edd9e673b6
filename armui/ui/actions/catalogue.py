"""What can be done in the whole window, whether a panel or a page has been shown yet or not."""

from __future__ import annotations

import enum
from collections.abc import Iterator
from functools import cache
from typing import Final, NamedTuple

from PySide6.QtCore import QT_TRANSLATE_NOOP

from armui.arm.limits import JOINTS
from armui.kinematics.axes import AXES
from armui.protocol.codes import ALL_JOINTS
from armui.ui.actions import page_commands
from armui.ui.actions.keys import SHORTCUTS
from armui.ui.actions.places import PANELS, PLACES, Title


class Need(enum.Enum):
    """What must be so before something can be done; see :mod:`armui.ui.actions.reasons`."""

    NOTHING = enum.auto()
    MOVE = enum.auto()
    SWITCH_ON = enum.auto()
    SWITCH_OFF = enum.auto()
    ZERO = enum.auto()
    CLEAR = enum.auto()
    ANGLES = enum.auto()
    POSE = enum.auto()
    LAMPS = enum.auto()
    LINKAGE = enum.auto()
    REACH = enum.auto()
    REACH_FREE = enum.auto()
    SETTINGS = enum.auto()
    SETTINGS_FREE = enum.auto()
    EDITING = enum.auto()
    GRIPPER_MOVE = enum.auto()
    GRIPPER = enum.auto()
    GRIPPER_LET_GO = enum.auto()
    TEACHING = enum.auto()
    PLAN = enum.auto()


class Command(NamedTuple):
    """Something that can be done.

    Attributes:
        name: Its own, with its place before the dot; of its shortcut, too, if it has one.
        title: What the palette calls it.
        target: The object name of the button that does it, or of the field it leads to. Empty: the
            window does it.
        need: What must be so where its button is not seen.
    """

    name: str
    title: Title
    target: str = ""
    need: Need = Need.NOTHING

    @property
    def place(self) -> str:
        """Where it is done, a key of :data:`armui.ui.actions.places.PLACES`."""
        return self.name.partition(".")[0]

    @property
    def keys(self) -> str:
        """Its shortcut as this system writes it; empty: it has none."""
        shortcut = SHORTCUTS.get(self.name)
        return "" if shortcut is None else shortcut.text()


# fmt: off
_WINDOW: Final = (
    ("window.connect", "ConnectDialog", QT_TRANSLATE_NOOP("ConnectDialog", "Connect arm"),
     "communication_button"),
    ("window.enable", "Action", QT_TRANSLATE_NOOP("Action", "Enable or disable all motors"),
     "enable_button"),
    ("everywhere.stop", "StopButton", QT_TRANSLATE_NOOP("StopButton", "Emergency stop"), ""),
    ("everywhere.halt", "HaltButton", QT_TRANSLATE_NOOP("HaltButton", "Halt"), ""),
    ("window.resume", "TopBar",
     QT_TRANSLATE_NOOP("TopBar", "Resume after the emergency stop"), ""),
    ("window.next_step", "RecoveryLine", QT_TRANSLATE_NOOP("RecoveryLine", "Next step"), ""),
    ("window.speed", "SpeedControl", QT_TRANSLATE_NOOP("SpeedControl", "Speed percentage"),
     "speed_field"),
    ("window.joint_status", "Action", QT_TRANSLATE_NOOP("Action", "Joint status"),
     "joint_status_button"),
    ("library.open", "LibraryButton",
     QT_TRANSLATE_NOOP("LibraryButton", "Trajectory library"), "library_button"),
    ("plots.open", "WatchMenu", QT_TRANSLATE_NOOP("WatchMenu", "Curves"), "plots_button"),
    ("events.open", "WatchMenu", QT_TRANSLATE_NOOP("WatchMenu", "Events"), "events_button"),
    ("bus.open", "WatchMenu", QT_TRANSLATE_NOOP("WatchMenu", "Bus"), "bus_button"),
    ("window.sessions", "Action", QT_TRANSLATE_NOOP("Action", "Session recordings"),
     "sessions_button"),
    ("replay.open", "Action", QT_TRANSLATE_NOOP("Action", "Replay a recording"), ""),
    ("window.export", "Action", QT_TRANSLATE_NOOP("Action", "Export a recording"), ""),
    ("window.backup", "Action", QT_TRANSLATE_NOOP("Action", "Back up, compare, restore parameters"),
     ""),
    ("window.diagnosis", "DoctorDialog", QT_TRANSLATE_NOOP("DoctorDialog", "Diagnosis"), ""),
    ("window.about_arm", "AboutArmDialog", QT_TRANSLATE_NOOP("AboutArmDialog", "About this arm"),
     ""),
    ("window.settings", "ViewRegion", QT_TRANSLATE_NOOP("ViewRegion", "Settings"),
     "settings_button"),
    ("window.language", "Action", QT_TRANSLATE_NOOP("Action", "Language: Chinese or English"), ""),
    ("window.theme", "Action", QT_TRANSLATE_NOOP("Action", "Theme: light or dark"), ""),
    ("window.reset_view", "ViewRegion", QT_TRANSLATE_NOOP("ViewRegion", "Reset view"),
     "reset_view_button"),
    ("view.front", "ViewBar", QT_TRANSLATE_NOOP("ViewBar", "Front view"), "view_front_button"),
    ("view.side", "ViewBar", QT_TRANSLATE_NOOP("ViewBar", "Side view"), "view_side_button"),
    ("view.top", "ViewBar", QT_TRANSLATE_NOOP("ViewBar", "Top view"), "view_top_button"),
    ("view.iso", "ViewBar", QT_TRANSLATE_NOOP("ViewBar", "Oblique view"), "view_iso_button"),
    ("view.fit", "ViewBar", QT_TRANSLATE_NOOP("ViewBar", "Fit"), "view_fit_button"),
    ("view.follow", "ViewBar", QT_TRANSLATE_NOOP("ViewBar", "Follow the tool"),
     "view_follow_button"),
    ("view.orthographic", "ViewBar", QT_TRANSLATE_NOOP("ViewBar", "Without perspective"), ""),
    ("view.tool_frame", "ViewBar", QT_TRANSLATE_NOOP("ViewBar", "Tool frame"), ""),
    ("view.reach", "ViewBar", QT_TRANSLATE_NOOP("ViewBar", "Workspace"), ""),
    ("view.save", "ViewBar", QT_TRANSLATE_NOOP("ViewBar", "Save picture…"), ""),
    ("view.copy", "ViewBar", QT_TRANSLATE_NOOP("ViewBar", "Copy picture"), ""),
    ("view.handles", "ViewBar",
     QT_TRANSLATE_NOOP("ViewBar", "Drag the target in the picture"), ""),
    ("view.help", "HelpDialog", QT_TRANSLATE_NOOP("HelpDialog", "Help: 3D view"), "help_button"),
    ("everywhere.guide", "Action", QT_TRANSLATE_NOOP("Action", "User guide"), ""),
    ("everywhere.shortcuts", "Action", QT_TRANSLATE_NOOP("Action", "Keyboard shortcuts"), ""),
    ("window.close", "Action", QT_TRANSLATE_NOOP("Action", "Close the program"), ""),
)

_PANELS: Final = (
    ("motion.home", "MotionPanel", QT_TRANSLATE_NOOP("MotionPanel", "Home"),
     "home_button", Need.MOVE),
    ("motion.load", "MotionPanel", QT_TRANSLATE_NOOP("MotionPanel", "Load"),
     "load_button", Need.ANGLES),
    ("motion.send", "MotionPanel", QT_TRANSLATE_NOOP("MotionPanel", "Send"),
     "send_button", Need.MOVE),
    ("motion.keys", "JogPanel", QT_TRANSLATE_NOOP("JogPanel", "Keyboard jogging"),
     "jog_keys_button", Need.NOTHING),
    ("motion.step", "JogPanel", QT_TRANSLATE_NOOP("JogPanel", "Step of − and +"),
     "jog_step", Need.NOTHING),
    ("cartesian.base", "FrameChoice", QT_TRANSLATE_NOOP("FrameChoice", "Base frame"),
     "frame_base", Need.NOTHING),
    ("cartesian.tool", "FrameChoice", QT_TRANSLATE_NOOP("FrameChoice", "Tool frame"),
     "frame_tool", Need.NOTHING),
    ("cartesian.load", "CartesianPanel", QT_TRANSLATE_NOOP("CartesianPanel", "Load"),
     "load_pose_button", Need.POSE),
    ("cartesian.move_p", "Action", QT_TRANSLATE_NOOP("Action", "MOVE P: to the pose"),
     "move_p_button", Need.MOVE),
    ("cartesian.move_l", "Action",
     QT_TRANSLATE_NOOP("Action", "MOVE L: on a straight line to the pose"),
     "move_l_button", Need.MOVE),
    ("cartesian.capture_start", "ArcBox", QT_TRANSLATE_NOOP("ArcBox", "Capture start"),
     "capture_start", Need.POSE),
    ("cartesian.capture_middle", "ArcBox", QT_TRANSLATE_NOOP("ArcBox", "Capture middle"),
     "capture_middle", Need.POSE),
    ("cartesian.capture_end", "ArcBox", QT_TRANSLATE_NOOP("ArcBox", "Capture end"),
     "capture_end", Need.POSE),
    ("cartesian.arc_start", "ArcBox", QT_TRANSLATE_NOOP("ArcBox", "Go to start"),
     "arc_start_button", Need.MOVE),
    ("cartesian.move_c", "Action", QT_TRANSLATE_NOOP("Action", "MOVE C: along the arc"),
     "move_c_button", Need.MOVE),
    ("cartesian.keys", "JogPanel", QT_TRANSLATE_NOOP("JogPanel", "Keyboard jogging"),
     "tool_keys_button", Need.NOTHING),
    ("light.all", "LightPanel", QT_TRANSLATE_NOOP("LightPanel", "All lamps of the joint"),
     "all_lamps", Need.NOTHING),
    ("light.hue", "LightPanel", QT_TRANSLATE_NOOP("LightPanel", "Hue and saturation"),
     "hue_field", Need.NOTHING),
    ("light.brightness", "LightPanel", QT_TRANSLATE_NOOP("LightPanel", "Brightness"),
     "brightness_slider", Need.NOTHING),
    ("light.confirm", "LightPanel", QT_TRANSLATE_NOOP("LightPanel", "Confirm"),
     "light_confirm_button", Need.LAMPS),
    ("linkage.input", "Action", QT_TRANSLATE_NOOP("Action", "Master arm (teaching input arm)"),
     "linkage_input", Need.NOTHING),
    ("linkage.output", "Action", QT_TRANSLATE_NOOP("Action", "Slave arm (motion output arm)"),
     "linkage_output", Need.NOTHING),
    ("linkage.confirm", "LinkagePanel", QT_TRANSLATE_NOOP("LinkagePanel", "Confirm"),
     "linkage_confirm_button", Need.LINKAGE),
    ("gripper.send", "GripperPanel", QT_TRANSLATE_NOOP("GripperPanel", "Send"),
     "gripper_send_button", Need.GRIPPER_MOVE),
    ("gripper.enable", "GripperAct", QT_TRANSLATE_NOOP("GripperAct", "Enable"),
     "gripper_enable_button", Need.GRIPPER_MOVE),
    ("gripper.disable", "GripperAct", QT_TRANSLATE_NOOP("GripperAct", "Disable"),
     "gripper_disable_button", Need.GRIPPER_LET_GO),
    ("gripper.clear", "GripperAct", QT_TRANSLATE_NOOP("GripperAct", "Clear error"),
     "gripper_clear_button", Need.GRIPPER),
    ("gripper.zero", "GripperAct", QT_TRANSLATE_NOOP("GripperAct", "Set zero"),
     "gripper_zero_button", Need.GRIPPER),
    ("end_load.empty", "EndLoad", QT_TRANSLATE_NOOP("EndLoad", "No load"),
     "load_empty", Need.NOTHING),
    ("end_load.half", "EndLoad", QT_TRANSLATE_NOOP("EndLoad", "Half load"),
     "load_half", Need.NOTHING),
    ("end_load.full", "EndLoad", QT_TRANSLATE_NOOP("EndLoad", "Full load"),
     "load_full", Need.NOTHING),
    ("end_load.confirm", "EndLoadPanel", QT_TRANSLATE_NOOP("EndLoadPanel", "Confirm"),
     "load_confirm_button", Need.REACH_FREE),
    ("end_load.feedback", "EndLoadPanel",
     QT_TRANSLATE_NOOP("EndLoadPanel", "Speed and acceleration of the end, by joint"),
     "end_feedback_button", Need.REACH),
    ("teaching.start_recording", "TeachingCommand",
     QT_TRANSLATE_NOOP("TeachingCommand", "Start recording"),
     "teaching_start_recording", Need.TEACHING),
    ("teaching.stop_recording", "TeachingCommand",
     QT_TRANSLATE_NOOP("TeachingCommand", "Stop recording"),
     "teaching_stop_recording", Need.TEACHING),
    ("teaching.run_recording", "TeachingCommand", QT_TRANSLATE_NOOP("TeachingCommand", "Replay"),
     "teaching_run_recording", Need.TEACHING),
    ("teaching.move_to_start", "TeachingCommand",
     QT_TRANSLATE_NOOP("TeachingCommand", "Move to start"),
     "teaching_move_to_start", Need.TEACHING),
    ("teaching.pause", "TeachingCommand", QT_TRANSLATE_NOOP("TeachingCommand", "Pause"),
     "teaching_pause", Need.TEACHING),
    ("teaching.continue", "TeachingCommand", QT_TRANSLATE_NOOP("TeachingCommand", "Continue"),
     "teaching_continue", Need.TEACHING),
    ("teaching.abort", "TeachingCommand", QT_TRANSLATE_NOOP("TeachingCommand", "Terminate"),
     "teaching_abort", Need.TEACHING),
    ("teaching.plan_pause", "Action", QT_TRANSLATE_NOOP("Action", "Pause the planned motion"),
     "plan_pause", Need.PLAN),
    ("teaching.plan_continue", "Action", QT_TRANSLATE_NOOP("Action", "Continue the held motion"),
     "plan_continue", Need.PLAN),
    ("teaching.plan_abort", "Action", QT_TRANSLATE_NOOP("Action", "Terminate the planned motion"),
     "plan_abort", Need.PLAN),
    ("teaching.plan_clear_current", "TrajectoryCommand",
     QT_TRANSLATE_NOOP("TrajectoryCommand", "Clear current"), "plan_clear_current", Need.PLAN),
    ("teaching.plan_clear_all", "TrajectoryCommand",
     QT_TRANSLATE_NOOP("TrajectoryCommand", "Clear all"), "plan_clear_all", Need.PLAN),
)

_PARAMETERS: Final = (
    ("read", QT_TRANSLATE_NOOP("ParameterButtons", "Read"), Need.SETTINGS),
    ("reset", QT_TRANSLATE_NOOP("ParameterButtons", "Initialise"), Need.SETTINGS_FREE),
    ("edit", QT_TRANSLATE_NOOP("ParameterButtons", "Edit"), Need.SETTINGS),
    ("cancel", QT_TRANSLATE_NOOP("ParameterButtons", "Cancel"), Need.EDITING),
    ("save", QT_TRANSLATE_NOOP("ParameterButtons", "Save"), Need.EDITING),
)
_WITH_PARAMETERS: Final = ("joint_settings", "end_limits", "collision", "gripper_settings")
_CAN_RESET: Final = ("joint_settings", "end_limits")

_MOTOR: Final = (
    ("enable", QT_TRANSLATE_NOOP("ActButtons", "Enable"), Need.SWITCH_ON),
    ("disable", QT_TRANSLATE_NOOP("ActButtons", "Disable"), Need.SWITCH_OFF),
    ("zero", QT_TRANSLATE_NOOP("ActButtons", "Set zero"), Need.ZERO),
    ("clear", QT_TRANSLATE_NOOP("ActButtons", "Clear error"), Need.CLEAR),
)
_TARGET: Final = QT_TRANSLATE_NOOP("Action", "Target of")
_LAMPS: Final = QT_TRANSLATE_NOOP("Action", "Lamps of")
# fmt: on


@cache
def actions() -> tuple[Command, ...]:
    """All of them, in the order in which they are listed."""
    return tuple(_all())


def _all() -> Iterator[Command]:
    for name, context, source, target in _WINDOW:
        yield Command(name, Title(context, str(source)), target)
    for panel in PANELS:
        yield Command(f"{panel}.open", PLACES[panel], f"menu_{panel}")
    for panel in PANELS:
        yield from _of_panel(panel)
    for name, context, source, target in page_commands.rows():
        yield Command(name, Title(context, source), target)


def _of_panel(panel: str) -> Iterator[Command]:
    for name, context, source, target, need in _PANELS:
        if name.partition(".")[0] == panel:
            yield Command(name, Title(context, str(source)), target, need)
    for place, source, suffix, target in _rows():
        if place == panel:
            yield Command(f"{panel}.{target}", Title("Action", str(source), suffix), target)
    if panel == "motor":
        yield from _of_motors()
    if panel in _WITH_PARAMETERS:
        yield from _of_parameters(panel)


def _rows() -> Iterator[tuple[str, object, str, str]]:
    """What there is of each joint or axis: its panel, title, what follows that, its field."""
    for joint in JOINTS:
        yield "motion", _TARGET, f"J{joint}", f"target_field_{joint}"
        yield "light", _LAMPS, f"J{joint}", f"light_joint_{joint}"
    for axis in AXES:
        yield "cartesian", _TARGET, axis, f"pose_field_{axis}"


def _of_parameters(panel: str) -> Iterator[Command]:
    for act, source, need in _PARAMETERS:
        if act != "reset" or panel in _CAN_RESET:
            title = Title("ParameterButtons", str(source))
            yield Command(f"{panel}.{act}", title, f"{panel}_{act}_button", need)


def _of_motors() -> Iterator[Command]:
    for joint in (ALL_JOINTS, *JOINTS):
        whose = "J1–J6" if joint == ALL_JOINTS else f"J{joint}"
        for act, source, need in _MOTOR:
            title = Title("ActButtons", str(source), whose)
            yield Command(f"motor.{act}_{joint}", title, f"{act}_motor_{joint}", need)
