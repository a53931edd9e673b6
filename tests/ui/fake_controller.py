"""A controller without an arm: it records what it is asked and shows what a test makes it show."""

from __future__ import annotations

from collections.abc import Callable, Iterable, Mapping, Sequence
from dataclasses import replace
from datetime import UTC, datetime
from typing import TYPE_CHECKING, Any, cast

from PySide6.QtCore import QObject, Signal

from armui.arm.device import Device
from armui.arm.parameters import Batch, Parameter
from armui.arm.reference_record import ReferenceRecord
from armui.arm.refusal import Refusal
from armui.arm.state import ArmState, GripperState
from armui.control.devices.gripper_ranges import Figures, gripper_figures
from armui.control.events import Event, Level
from armui.control.link.arm_mark import ArmMark
from armui.control.motion.jog_pace import Pace
from armui.control.motion.jog_path import JointJog, ToolJog
from armui.control.motion.steered_path import SteeredJog
from armui.control.operating_state import OperatingState
from armui.control.parameters.setting_cell import SettingCellState
from armui.control.parameters.setting_checks import Changes
from armui.control.safety.recovery_steps import Action, Step, StepKind
from armui.control.sessions.progress import RingContent
from armui.protocol.codes import ALL_JOINTS, LinkageRole, Mounting, TeachingState, TrajectoryCommand
from armui.telemetry.events import Asker, EventEntry, EventKind, EventLog
from tests.ui.arm_states import arm_state, operating_state

if TYPE_CHECKING:
    from armui.control.arm_controller import ArmController


class FakeController(QObject):
    """Has the signals and methods of ``ArmController``; ``calls`` holds what was asked."""

    state_changed = Signal(object)
    operating_state_changed = Signal(object)
    step_changed = Signal(object)
    noticed = Signal(object)
    devices_found = Signal(object)
    searching_changed = Signal(bool)
    cell_changed = Signal(object)
    operation_begun = Signal(str)
    all_motion_ended = Signal()

    def __init__(self) -> None:
        super().__init__()
        self.state = ArmState()
        self.operating_state = OperatingState(speed_percent=30)
        self.calls: list[tuple[Any, ...]] = []
        self.answer: Refusal | None = None
        self.motion = FakeMotion(self)
        self.motors = FakeMotors(self)
        self.lights = FakeLights(self)
        self.jogging = FakeJogging(self)
        self.cartesian = FakeCartesian()
        self.cell = FakeCells()
        self.area_guard = FakeAreaGuard()
        self.joint_errors = FakeJointErrors(self)
        self.recovery = FakeRecovery(self)
        self.teaching = FakeTeaching(self)
        self.planned_motion = FakePlannedMotion(self)
        self.zeroing = FakeZeroing(self)
        self.settings = FakeSettings(self)
        self.gripper = FakeGripper(self)
        self.mounting = FakeMounting(self)
        self.linkage = FakeLinkage(self)
        self.reference = FakeReference()
        self.events = EventLog()
        self.event_collector = FakeHappenings(self.events)
        self.sessions = FakeSessions()
        self.episodes = FakeEpisodes()

    @property
    def as_real(self) -> ArmController:
        """For a window, which names the kind it asks; see `what_windows_ask.both_are`."""
        return cast("ArmController", self)

    mark = ArmMark()

    def report_withdrawn(self, question: str, reason: Refusal) -> None:
        self.calls.append(("report_withdrawn", question, reason.code))

    # what a test makes it show

    def hear(self, state: ArmState) -> None:
        self.state = state
        self.be(self.operating_state)
        self.state_changed.emit(state)

    def be(self, new: OperatingState) -> None:
        state, pending = self.state, self.teaching.pending
        told = replace(
            new,
            status=None if state.status is None else state.status.value,
            angles_known=state.angles_deg() is not None,
            pose_known=state.end_pose() is not None,
            gripper_heard=state.gripper is not None,
            pending=frozenset() if pending is None else frozenset({"teaching"}),
        )
        if told != self.operating_state:
            self.operating_state = told
            self.operating_state_changed.emit(told)

    def be_ready(self, angles_deg: Sequence[float] = (0.0,) * 6) -> None:
        self.be(operating_state())
        self.hear(arm_state(angles_deg))

    # what the windows ask

    @staticmethod
    def interfaces() -> list[str]:
        return ["gs_usb", "slcan", "socketcan", "udp_multicast", "virtual"]

    def search_devices(self) -> None:
        self.calls.append(("search_devices",))

    def connect_device(self, device: Device) -> None:
        self.calls.append(("connect_device", device))

    def disconnect_device(self) -> None:
        self.calls.append(("disconnect_device",))

    def end_motion(self, *, single: bool = False) -> None:
        self.calls.append(("end_motion", "single") if single else ("end_motion",))

    def emergency_stop(self) -> None:
        self.calls.append(("emergency_stop",))

    def withdraw_stop(self) -> None:
        self.calls.append(("withdraw_stop",))

    def halt_and_hold(self) -> Refusal | None:
        return self._asked("halt_and_hold")

    def _asked(self, *call: Any) -> Refusal | None:
        self.calls.append(call)
        return self.answer


class FakeHappenings:
    """The event log of a fake controller; nothing is written into it but problems."""

    def __init__(self, log: EventLog) -> None:
        self._log = log

    def number_of(self, event: Event) -> int | None:
        return None

    def on_problem(self, reason: Refusal) -> EventEntry:
        return self._log.add(
            at_s=0.0,
            wall=datetime(2026, 1, 15, 12, tzinfo=UTC),
            level=Level.WARNING,
            kind=EventKind.PROGRAM,
            who=Asker.PROGRAM,
            code="problem",
            params={"reason": reason},
        )


class FakeMotors:
    """The motors' power of a fake controller."""

    def __init__(self, controller: FakeController) -> None:
        self._controller = controller

    def enable(self, joint: int = ALL_JOINTS) -> Refusal | None:
        return self._controller._asked("enable", joint)

    def disable(self, joint: int = ALL_JOINTS) -> Refusal | None:
        return self._controller._asked("disable", joint)

    def resume(self) -> Refusal | None:
        return self._controller._asked("resume")


class FakeMotion:
    """The joint motions of a fake controller."""

    def __init__(self, controller: FakeController) -> None:
        self._controller = controller
        self.setpoint_deg: tuple[float, ...] | None = None
        self.lagging = False

    def set_speed_percent(self, percent: int) -> Refusal | None:
        controller = self._controller
        refusal = controller._asked("set_speed_percent", percent)
        if refusal is None:
            controller.be(replace(controller.operating_state, speed_percent=percent))
        return refusal

    def jog(self, joint: int, delta_deg: float) -> Refusal | None:
        refusal = self._controller._asked("jog", joint, delta_deg)
        if refusal is None:
            base = list(self.setpoint_deg or self._controller.state.angles_deg() or (0.0,) * 6)
            base[joint - 1] = round(base[joint - 1] + delta_deg, 3)
            self.setpoint_deg = tuple(base)
        return refusal

    def send_joints(self, angles_deg: Sequence[float], agreed_mm: float = 0.0) -> Refusal | None:
        return self._controller._asked("send_joints", tuple(angles_deg))

    def go_home(self, agreed_mm: float = 0.0) -> Refusal | None:
        return self._controller._asked("go_home")

    def jog_lagging(self, joint: int, step_deg: float) -> bool:
        return self.lagging


class FakeCells:
    """No cell is chosen."""

    cell = in_force = store = unconfirmed = candidate = None
    tool_name = ""
    arms = 0
    cells: Mapping[str, object] = {}
    broken: Mapping[str, object] = {}

    def use_own_tool(self, tool: tuple[float, ...]) -> None:
        """The tool of the settings holds."""

    def propose(self, _frame: object) -> None:
        """Nothing is shown before it is taken."""

    def why_not_capture(self) -> Refusal | None:
        """Return no reason: a point may be taken."""
        return None

    why_no_pose = why_not_capture


class FakeAreaGuard:
    """The arm may go anywhere."""

    area = None

    def nearest_entries(self, _state: ArmState) -> tuple[object, ...]:
        return ()

    def below(self) -> str:
        return ""


class FakeCartesian:
    """The tool of a fake controller, which is its flange."""

    def __init__(self) -> None:
        self.tool: tuple[float, ...] = (0.0,) * 6
        self.frame = None

    def in_frame(self, pose: Sequence[float]) -> tuple[float, ...]:
        return tuple(pose)

    in_base = in_frame

    def tool_pose(self, state: ArmState) -> tuple[float, ...] | None:
        return state.end_pose()


class FakeJogging:
    """The held motions of a fake controller."""

    def __init__(self, controller: FakeController) -> None:
        self._controller = controller
        self.active = False
        self.steered: SteeredJog | None = None

    def start(self, jog: JointJog | ToolJog | SteeredJog) -> Refusal | None:
        refusal = self._controller._asked("jog_start", jog)
        self.active = refusal is None
        return refusal

    def stop(self) -> None:
        if self.active:
            self._controller.calls.append(("jog_stop",))
        self.active = False

    def present_pace(self) -> Pace:
        return Pace(share=1.0, speeds_deg_s=(10.0,) * 6, leads_deg=(1.0,) * 6, arm_percent=10)


class FakeLights:
    """The lamps of a fake controller."""

    def __init__(self, controller: FakeController) -> None:
        self._controller = controller

    def set_light(self, joint: int, lamp: int, red: int, green: int, blue: int) -> Refusal | None:
        return self._controller._asked("set_light", joint, lamp, red, green, blue)


class FakeJointErrors:
    """The joints' errors of a fake controller."""

    def __init__(self, controller: FakeController) -> None:
        self._controller = controller

    def clear(self, joint: int) -> Refusal | None:
        return self._controller._asked("clear_joint_error", joint)


class FakeSettings(QObject):
    """The parameters of a fake controller's arm: none is ever read."""

    changed = Signal()
    finished = Signal()
    busy = False

    def __init__(self, controller: FakeController) -> None:
        super().__init__(controller)
        self._controller = controller

    def cell(self, parameter: Parameter) -> SettingCellState:
        return SettingCellState()

    def read(self, batches: Iterable[Batch]) -> Refusal | None:
        return self._controller._asked("read_settings", tuple(batches))

    def save(self, changes: Changes) -> Refusal | None:
        return self._controller._asked("save_settings", dict(changes))

    def settle(self, parameters: Iterable[Parameter]) -> None:
        pass


class FakeTeaching:
    """The drag teaching of a fake controller."""

    def __init__(self, controller: FakeController) -> None:
        self._controller = controller
        self.pending: TeachingState | None = None

    def command(self, command: TeachingState) -> Refusal | None:
        return self._controller._asked("teach", command)


class FakePlannedMotion:
    """The planned motions of a fake controller."""

    def __init__(self, controller: FakeController) -> None:
        self._controller = controller
        self.paused = False

    def command(self, command: TrajectoryCommand) -> Refusal | None:
        return self._controller._asked("plan", command)


class FakeRecovery:
    """The next step of a fake controller."""

    def __init__(self, controller: FakeController) -> None:
        self._controller = controller
        self.step = Step(StepKind.NO_DEVICE, Level.INFO, action=Action.CONNECT)

    def show(self, step: Step) -> None:
        self.step = step
        self._controller.step_changed.emit(step)

    def why_not(self, step: Step, action: Action | None = None) -> Refusal | None:
        return self._controller.operating_state.occupied

    def act(
        self, step: Step, action: Action | None = None, mark: ArmMark | None = None
    ) -> Refusal | None:
        return self._controller._asked("act", step, *(() if action is None else (action,)))


class FakeZeroing:
    """The zeros of a fake controller."""

    def __init__(self, controller: FakeController) -> None:
        self._controller = controller

    def stands_as(self, before: ArmState, joint: int = ALL_JOINTS) -> bool:
        return True

    def set_zero(self, joint: int = ALL_JOINTS) -> Refusal | None:
        return self._controller._asked("set_zero", joint)


class FakeReference:
    """The joints' reference of a fake controller: nothing is known of it."""

    known: ReferenceRecord | None = None


class FakeLinkage:
    """The linkage of a fake controller."""

    def __init__(self, controller: FakeController) -> None:
        self._controller = controller

    def set(
        self,
        role: LinkageRole,
        *,
        feedback_offset: int = 0,
        control_offset: int = 0,
        target_offset: int = 0,
    ) -> Refusal | None:
        offsets = (feedback_offset, control_offset, target_offset)
        return self._controller._asked("set_linkage", role, offsets)

    def release(self) -> Refusal | None:
        return self._controller._asked("release_linkage")


class FakeMounting:
    """How the arm of a fake controller is mounted."""

    def __init__(self, controller: FakeController) -> None:
        self._controller = controller

    def why_not(self, mounting: Mounting) -> Refusal | None:
        return self._controller.operating_state.cannot_enable

    def why_not_by_firmware(self, mounting: Mounting) -> Refusal | None:
        return None


class FakeGripper:
    """The gripper of a fake controller."""

    def __init__(self, controller: FakeController) -> None:
        self._controller = controller

    @property
    def figures(self) -> Figures:
        return gripper_figures(self._controller.operating_state.generation, self._controller.state)

    own_figures = figures
    is_calibrated = False

    def heading(self, unit: str) -> float | None:
        heard = self._controller.state.gripper
        return heard.value.travel if heard is not None and heard.value.unit == unit else None

    def shown(self, gripper: GripperState) -> float:
        return gripper.travel

    @property
    def reports_angle(self) -> bool:
        return False

    def why_no_angle(self) -> Refusal | None:
        return None

    def why_no_end(self, *, opened: bool) -> Refusal | None:
        return None

    def learn_stroke(self) -> None:
        pass

    def stands_as(self, before: ArmState) -> bool:
        return True

    def move(self, travel: float, effort: float) -> Refusal | None:
        return self._controller._asked("move_gripper", travel, effort)


class FakeEpisodes(QObject):
    """Marks nothing."""

    changed = Signal()
    under_way = None
    kept = 0
    task = ""

    def mark(self) -> None:
        return None

    def discard(self) -> None:
        return None


class FakeSessions(QObject):
    """Records nothing."""

    changed = Signal()
    recording = False
    content = RingContent()
    text = b""

    def progress(self) -> None:
        return None

    def ring(self) -> RingContent:
        return self.content

    def ring_as_text(self) -> Callable[[], bytes] | None:
        return (lambda: self.text) if self.content.frames else None
