"""What can be done in the whole window, whether a panel or a page has been shown yet or not."""

from __future__ import annotations

from collections.abc import Iterator
from functools import cache
from typing import Final

from armui.arm.limits import JOINTS
from armui.control.devices.end_reports import EndReports
from armui.control.devices.gripper import GripperControl
from armui.control.devices.joint_errors import JointErrors
from armui.control.devices.lights import Lights
from armui.control.devices.linkage import LinkageControl
from armui.control.devices.motors import Motors
from armui.control.devices.teaching import TeachingControl
from armui.control.devices.zeroing import Zeroing
from armui.control.motion.cartesian import Cartesian
from armui.control.motion.joint_motion import Motion
from armui.control.motion.planned_motion import PlannedMotion
from armui.control.operations.operation import operation_of
from armui.control.parameters.arm_settings import ArmSettings
from armui.kinematics.axes import AXES
from armui.protocol.codes import ALL_JOINTS, TeachingState, TrajectoryCommand
from armui.ui.actions import page_commands
from armui.ui.actions.command import Command, while_editing, with_angles, with_pose
from armui.ui.actions.places import PANELS, PLACES
from armui.ui.words.text import Text

_TEACH: Final = operation_of(TeachingControl.command)
_PLAN: Final = operation_of(PlannedMotion.command)

# fmt: off
_WINDOW: Final = (
    Command("window.connect", Text("ConnectDialog", "Connect arm"), "communication_button"),
    Command("window.enable", Text("Action", "Enable or disable all motors"), "enable_button"),
    Command("everywhere.stop"),
    Command("everywhere.halt", Text("HaltButton", "Halt")),
    Command("everywhere.slower"),
    Command("everywhere.faster"),
    Command("window.resume", Text("TopBar", "Resume after the emergency stop"),
            does=operation_of(Motors.resume)),
    Command("window.next_step", Text("RecoveryLine", "Next step")),
    Command("window.speed", Text("SpeedControl", "Speed percentage"), "speed_field"),
    Command("window.joint_status", Text("Action", "Joint status"), "joint_status_button"),
    Command("library.open", Text("LibraryButton", "Trajectory library"), "library_button"),
    Command("plots.open", Text("WatchMenu", "Curves"), "plots_button"),
    Command("events.open", Text("WatchMenu", "Events"), "events_button"),
    Command("bus.open", Text("WatchMenu", "Bus"), "bus_button"),
    Command("window.sessions", Text("Action", "Session recordings"), "sessions_button"),
    Command("replay.open", Text("Action", "Replay a recording")),
    Command("window.export", Text("Action", "Export a recording")),
    Command("window.backup", Text("Action", "Back up, compare, restore parameters"), risky=True),
    Command("window.diagnosis", Text("DoctorDialog", "Diagnosis")),
    Command("window.about_arm", Text("AboutArmDialog", "About this arm")),
    Command("window.settings", target="settings_button"),
    Command("window.language", Text("Action", "Language: Chinese or English")),
    Command("window.theme", Text("Action", "Theme: light or dark")),
    Command("window.reset_view", target="reset_view_button"),
    Command("view.front", target="view_front_button"),
    Command("view.side", target="view_side_button"),
    Command("view.top", target="view_top_button"),
    Command("view.iso", target="view_iso_button"),
    Command("view.below"),
    Command("view.fit", target="view_fit_button"),
    Command("view.follow", target="view_follow_button"),
    Command("view.orthographic"),
    Command("view.tool_frame"),
    Command("view.reach"),
    Command("view.save"),
    Command("view.copy"),
    Command("view.handles"),
    Command("view.help", Text("HelpDialog", "Help: 3D view"), "help_button"),
    Command("everywhere.guide", Text("Action", "User guide")),
    Command("everywhere.shortcuts", Text("Action", "Keyboard shortcuts")),
    Command("window.close", Text("Action", "Close the program")),
)

_PANELS: Final = (
    Command("motion.home", target="home_button", does=operation_of(Motion.go_home)),
    Command("motion.load", target="load_button", does=with_angles),
    Command("motion.send", target="send_button", does=operation_of(Motion.send_joints)),
    Command("motion.keys", Text("JogPanel", "Keyboard jogging"), "jog_keys_button"),
    Command("motion.step", Text("JogPanel", "Step of − and +"), "jog_step"),
    Command("cartesian.base", Text("FrameChoice", "Base frame"), "frame_base"),
    Command("cartesian.tool", Text("FrameChoice", "Tool frame"), "frame_tool"),
    Command("cartesian.load", Text("CartesianPanel", "Load"), "load_pose_button", with_pose),
    Command("cartesian.move_p", Text("Action", "MOVE P: to the pose"), "move_p_button",
            does=operation_of(Cartesian.move)),
    Command("cartesian.move_l", Text("Action", "MOVE L: on a straight line to the pose"),
            "move_l_button", does=operation_of(Cartesian.move)),
    Command("cartesian.capture_start", Text("ArcBox", "Capture start"), "capture_start", with_pose),
    Command("cartesian.capture_middle", Text("ArcBox", "Capture middle"), "capture_middle",
            with_pose),
    Command("cartesian.capture_end", Text("ArcBox", "Capture end"), "capture_end", with_pose),
    Command("cartesian.arc_start", Text("ArcBox", "Go to start"), "arc_start_button",
            does=operation_of(Cartesian.move)),
    Command("cartesian.move_c", Text("Action", "MOVE C: along the arc"), "move_c_button",
            does=operation_of(Cartesian.move_arc)),
    Command("cartesian.keys", Text("JogPanel", "Keyboard jogging"), "tool_keys_button"),
    Command("light.all", Text("LightPanel", "All lamps of the joint"), "all_lamps"),
    Command("light.pick", Text("LightPanel", "Colour of the lamps"), "pick_color_button"),
    Command("light.confirm", target="light_confirm_button", does=operation_of(Lights.set_light)),
    Command("linkage.input", Text("Action", "Master arm (teaching input arm)"), "linkage_input",
            risky=True),
    Command("linkage.output", Text("Action", "Slave arm (motion output arm)"), "linkage_output",
            risky=True),
    Command("linkage.confirm", Text("LinkagePanel", "Confirm"), "linkage_confirm_button",
            does=operation_of(LinkageControl.set)),
    Command("gripper.send", target="gripper_send_button", does=operation_of(GripperControl.move)),
    Command("gripper.enable", Text("GripperAct", "Enable"), "gripper_enable_button",
            does=operation_of(GripperControl.enable)),
    Command("gripper.disable", Text("GripperAct", "Disable"), "gripper_disable_button",
            does=operation_of(GripperControl.disable)),
    Command("gripper.clear", Text("GripperAct", "Clear error"), "gripper_clear_button",
            does=operation_of(GripperControl.clear_error)),
    Command("gripper.zero", Text("GripperAct", "Set zero"), "gripper_zero_button",
            does=operation_of(GripperControl.set_zero)),
    Command("end_load.empty", Text("EndLoad", "No load"), "load_empty"),
    Command("end_load.half", Text("EndLoad", "Half load"), "load_half"),
    Command("end_load.full", Text("EndLoad", "Full load"), "load_full"),
    Command("end_load.confirm", Text("EndLoadPanel", "Confirm"), "load_confirm_button",
            does=operation_of(EndReports.set_load)),
    Command("end_load.feedback",
            Text("EndLoadPanel", "Speed and acceleration of the end, by joint"),
            "end_feedback_button", does=operation_of(EndReports.switch)),
    Command("teaching.start_recording", Text("TeachingCommand", "Start recording"),
            "teaching_start_recording", _TEACH, {"command": TeachingState.START_RECORDING}),
    Command("teaching.stop_recording", Text("TeachingCommand", "Stop recording"),
            "teaching_stop_recording", _TEACH, {"command": TeachingState.STOP_RECORDING}),
    Command("teaching.run_recording", Text("TeachingCommand", "Replay"), "teaching_run_recording",
            _TEACH, {"command": TeachingState.RUN_RECORDING}, leads=True),
    Command("teaching.move_to_start", Text("TeachingCommand", "Move to start"),
            "teaching_move_to_start", _TEACH, {"command": TeachingState.MOVE_TO_START}, leads=True),
    Command("teaching.pause", Text("TeachingCommand", "Pause"), "teaching_pause", _TEACH,
            {"command": TeachingState.PAUSE}),
    Command("teaching.continue", Text("TeachingCommand", "Continue"), "teaching_continue",
            _TEACH, {"command": TeachingState.CONTINUE}),
    Command("teaching.abort", Text("TeachingCommand", "Terminate"), "teaching_abort",
            _TEACH, {"command": TeachingState.ABORT}),
    Command("teaching.plan_pause", Text("Action", "Pause the planned motion"), "plan_pause",
            _PLAN, {"command": TrajectoryCommand.PAUSE}),
    Command("teaching.plan_continue", Text("Action", "Continue the held motion"), "plan_continue",
            _PLAN, {"command": TrajectoryCommand.CONTINUE}),
    Command("teaching.plan_abort", Text("Action", "Terminate the planned motion"), "plan_abort",
            _PLAN, {"command": TrajectoryCommand.ABORT}),
    Command("teaching.plan_clear_current", Text("TrajectoryCommand", "Clear current"),
            "plan_clear_current", _PLAN, {"command": TrajectoryCommand.CLEAR_CURRENT}),
    Command("teaching.plan_clear_all", Text("TrajectoryCommand", "Clear all"), "plan_clear_all",
            _PLAN, {"command": TrajectoryCommand.CLEAR_ALL}),
)

_PARAMETERS: Final = (
    ("read", Text("ParameterButtons", "Read"), operation_of(ArmSettings.read)),
    ("reset", Text("ParameterButtons", "Initialise"), operation_of(ArmSettings.reset_joint_limits)),
    ("edit", Text("ParameterButtons", "Edit"), operation_of(ArmSettings.read)),
    ("cancel", Text("ParameterButtons", "Cancel"), while_editing),
    ("save", Text("ParameterButtons", "Save"), while_editing),
)
_WITH_PARAMETERS: Final = ("joint_settings", "end_limits", "collision", "gripper_settings")
_CAN_RESET: Final = ("joint_settings", "end_limits")

_SYNONYMS: Final = {
    "everywhere.stop": "stop estop e-stop emo kill panic 停止 紧急停止 停机",
    "everywhere.halt": "hold freeze brake 停下 保持 刹车",
    "motion.home": "zero zeros origin home 归零 零位 零点 原点 复位",
    "motion.send": "movej joints 关节运动",
    "motion.keys": "keyboard teach 键盘",
    "window.connect": "open port device adapter can 设备 端口 打开",
    "window.enable": "power servo on off 上电 下电 伺服",
    "window.resume": "recover restart release 恢复 解除 复位",
    "window.next_step": "fix help recover 怎么办",
    "window.speed": "velocity fast slow override 速度 倍率 快 慢",
    "window.joint_status": "temperature current voltage errors 温度 电流 电压 故障",
    "window.sessions": "logs history 日志 录制",
    "window.export": "csv mcap parquet rosbag 导出",
    "window.backup": "restore factory 恢复 出厂",
    "window.diagnosis": "doctor troubleshoot problem 排查 自检",
    "window.about_arm": "version firmware serial 版本 固件 序列号",
    "window.settings": "preferences options configuration 选项 首选项 配置",
    "window.theme": "dark light night 深色 浅色 夜间",
    "window.close": "quit exit 退出",
    "library.open": "program programs trajectories 程序 轨迹",
    "plots.open": "chart graph plot scope 图表 示波器",
    "events.open": "log messages alarms 日志 报警 消息",
    "bus.open": "can frames monitor sniffer 报文 帧",
    "replay.open": "playback play log 播放",
    "everywhere.slower": "override speed slow reduce 倍率 降速 减速 慢",
    "everywhere.faster": "override speed fast increase 倍率 提速 加速 快",
    "everywhere.guide": "manual help documentation 帮助 手册 说明书",
    "everywhere.shortcuts": "keys hotkeys 热键",
    "cartesian.open": "tcp pose linear xyz 位姿 直线",
    "joint_settings.open": "limits maximum minimum 限位 极限",
    "collision.open": "protection crash 碰撞",
}
"""What else operators call things, in both languages, by the name of the action."""

_MOTOR: Final = (
    ("enable", Text("ActButtons", "Enable"), operation_of(Motors.enable)),
    ("disable", Text("ActButtons", "Disable"), operation_of(Motors.disable)),
    ("zero", Text("ActButtons", "Set zero"), operation_of(Zeroing.set_zero)),
    ("clear", Text("ActButtons", "Clear error"), operation_of(JointErrors.clear)),
)
# fmt: on


@cache
def actions() -> tuple[Command, ...]:
    """All of them, in the order in which they are listed."""
    opened = (Command(f"{panel}.open", PLACES[panel], f"menu_{panel}") for panel in PANELS)
    in_panels = (command for panel in PANELS for command in _of_panel(panel))
    return (*_WINDOW, *opened, *in_panels, *page_commands.commands())


def synonyms(name: str) -> tuple[str, ...]:
    """Return what else an action is called, in either language."""
    return tuple(_SYNONYMS.get(name, "").split())


def _of_panel(panel: str) -> Iterator[Command]:
    yield from (each for each in (*_PANELS, *_of_joints_and_axes()) if each.place == panel)
    if panel == "motor":
        yield from _of_motors()
    if panel in _WITH_PARAMETERS:
        yield from _of_parameters(panel)


def _of_joints_and_axes() -> Iterator[Command]:
    """The fields there are of each joint or axis."""
    target, lamps = Text("Action", "Target of"), Text("Action", "Lamps of")
    for joint in JOINTS:
        field, button = f"target_field_{joint}", f"light_joint_{joint}"
        yield Command(f"motion.{field}", target._replace(suffix=f"J{joint}"), field)
        yield Command(f"light.{button}", lamps._replace(suffix=f"J{joint}"), button)
    for axis in AXES:
        field = f"pose_field_{axis}"
        yield Command(f"cartesian.{field}", target._replace(suffix=axis), field)


def _of_parameters(panel: str) -> Iterator[Command]:
    for act, title, does in _PARAMETERS:
        if act != "reset" or panel in _CAN_RESET:
            yield Command(f"{panel}.{act}", title, f"{panel}_{act}_button", does)


def _of_motors() -> Iterator[Command]:
    for joint in (ALL_JOINTS, *JOINTS):
        whose = "J1–J6" if joint == ALL_JOINTS else f"J{joint}"
        for act, title, does in _MOTOR:
            target = f"{act}_motor_{joint}"
            yield Command(f"motor.{act}_{joint}", title._replace(suffix=whose), target, does)
