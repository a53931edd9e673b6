"""What each action does: the operator through the controller, the others through the bus."""

from __future__ import annotations

import math
from dataclasses import replace
from datetime import UTC, datetime
from typing import Any, Final

import numpy as np
from scipy.spatial.transform import Rotation

from armui.arm.parameters import Parameter
from armui.arm.refusal import Refusal
from armui.cell.cell import Cell, with_part
from armui.cell.user_frames import UserFrame
from armui.cell.work_area import Area, AreaBox
from armui.control.link.link_state import LinkState
from armui.control.motion.jog_path import JointJog, ToolJog
from armui.control.operating_state import StopState
from armui.control.operations.started import Started
from armui.control.run.progress import Run
from armui.control.run.replay import Replay
from armui.control.safety.recovery_steps import Action
from armui.interface.messages import Code
from armui.kinematics.axes import JogFrame
from armui.kinematics.poses import flange_pose
from armui.protocol.codes import EndLoad, LinkageRole, MoveMode, TeachingState, TrajectoryCommand
from armui.protocol.generation import Generation
from armui.sim.faults.schedule import fault
from armui.sim.firmware import Firmware
from armui.sim.parameters.flash import MemoryFlash
from armui.sim.parameters.settings import ArmSettingsRecord
from armui.trajectory.points.program import Waypoint
from armui.trajectory.samples.recording import Recording
from tests.safety.fuzz.asked import Asked, Kind
from tests.safety.fuzz.breakage import Breakage
from tests.safety.fuzz.oracle import Oracle
from tests.safety.fuzz.world import STEP_S, World
from tests.sim.talk import DISABLE, ENABLE, pose_target

_PULLED_DEG: Final = 20.0
_PATIENCE: Final = 25
_USER: Final = "turned"
_VOIDS: Final = frozenset({"motors.disable", "motors.resume", "joints.set_zero"})
"""Operations after which nothing that was asked for before counts."""
_OFF_LOAD: Final = (EndLoad.EMPTY, EndLoad.HALF, EndLoad.FULL)


class Actors:
    """Everybody who does something; each method is an action of `tests.safety.fuzz.script`."""

    def __init__(self, world: World, oracle: Oracle) -> None:
        self._world = world
        self._oracle = oracle
        self._pushed: int | None = None
        self._user_frame: UserFrame | None = None
        self._failing = 0

    @property
    def _controller(self) -> Any:
        return self._world.controller

    @property
    def _kinematics(self) -> Any:
        return self._world.firmware.kinematics

    def after(self) -> None:
        """What ends with an action's time."""
        self._failing -= 1
        if self._failing <= 0:
            self._world.breakage = None
        if self._pushed is not None:
            self._world.firmware.protection.push(self._pushed, 0.0)
            self._pushed = None

    # The operator ------------------------------------------------------------------------------

    def _ask(self, kind: Kind, answer: object, **asked: Any) -> None:
        """The operator has asked for something, and it was not refused."""
        if not isinstance(answer, Refusal):
            self._oracle.ask(Asked(kind, self._world.time_s, **asked))

    def step(self, joint: int, delta_deg: float) -> None:
        before = self._oracle.bases()
        self._ask(
            Kind.STEP,
            self._controller.motion.jog(joint, delta_deg),
            joint=joint,
            delta=delta_deg,
            bases=before,
        )

    def tool_step(self, axis: int, amount: float, frame: str) -> None:
        before = self._oracle.bases()
        answer = self._controller.cartesian.step(axis, amount, self._frame_named(frame))
        along = self._along(axis, frame)
        self._ask(Kind.TOOL_STEP, answer, delta=amount, bases=before, along=along)

    def _frame_named(self, frame: str) -> JogFrame | UserFrame:
        """A user frame is the one made last: it may be out of force."""
        if frame == "user":
            return self._user_frame or JogFrame.BASE
        return JogFrame(frame)

    def _along(self, axis: int, frame: str) -> tuple[float, ...] | None:
        """Which way in the base the tool goes; ``None`` if it turns, or along itself."""
        if axis > 2 or frame == "tool":
            return None
        turned = self._user_frame.pose[3:] if frame == "user" and self._user_frame else (0.0,) * 3
        return tuple(Rotation.from_euler("xyz", turned, degrees=True).as_matrix()[:, axis])

    def send_joints(self, joints_deg: tuple[float, ...]) -> None:
        answer = self._controller.motion.send_joints(joints_deg)
        self._ask(Kind.JOINTS, answer, goal_deg=joints_deg)

    def go_home(self) -> None:
        self._ask(Kind.JOINTS, self._controller.motion.go_home(), goal_deg=(0.0,) * 6)

    def move_tool(self, joints_deg: tuple[float, ...], move: int) -> None:
        pose = self._kinematics.forward(joints_deg)
        answer = self._controller.cartesian.move(pose, MoveMode(move))
        self._ask(Kind.POSE, answer, pose=flange_pose(pose, self._controller.cartesian.tool))

    def hold_joint(self, joint: int, direction: int) -> None:
        answer = self._controller.jogging.start(JointJog(joint, direction))
        self._ask(Kind.JOG, answer, joint=joint, delta=direction)
        self._world.still_timers()

    def hold_tool(self, axis: int, direction: int, frame: str) -> None:
        answer = self._controller.jogging.start(ToolJog(axis, direction, self._frame_named(frame)))
        self._ask(Kind.JOG, answer, joint=None, delta=direction)
        self._world.still_timers()

    def let_go(self) -> None:
        self._controller.jogging.stop()
        self._oracle.release()

    def speed(self, percent: int) -> None:
        self._oracle.lease.sped_s = self._world.time_s
        self._controller.motion.set_speed_percent(percent)

    def override(self, percent: int) -> None:
        self._oracle.lease.sped_s = self._world.time_s
        self._controller.motion.set_speed_percent(percent)

    def dip_override(self, percent: int) -> None:
        """Down to 0 % and up again with one drag of the slider."""
        self.override(0)
        self.override(percent)

    def step_speed(self, by_percent: int) -> None:
        self._oracle.lease.sped_s = self._world.time_s
        self._controller.speed_override.step(by_percent)

    def plan(self, command: int) -> None:
        if isinstance(self._controller.planned_motion.command(TrajectoryCommand(command)), Refusal):
            return
        if command == TrajectoryCommand.CONTINUE:
            self._oracle.ask(Asked(Kind.CONTINUE, self._world.time_s))
        elif command != TrajectoryCommand.PAUSE:
            self._oracle.cancel("终止")

    def enable(self, joint: int) -> None:
        self._controller.motors.enable(joint)

    def disable(self, joint: int) -> None:
        if isinstance(self._controller.motors.disable(joint), Started):
            self._oracle.cancel("disable")

    def stop(self) -> None:
        try:
            self._controller.emergency_stop()
        finally:  # it was pressed, whatever fails
            if self._controller.operating_state.link is not LinkState.NO_DEVICE:
                self._oracle.stop_pressed()
            self._oracle.cancel("stop")

    def resume(self) -> None:
        if isinstance(self._controller.motors.resume(), Started):
            self._oracle.stop_lifted()
            self._oracle.cancel("resume")

    def run(
        self,
        first: tuple[float, ...],
        second: tuple[float, ...],
        cycles: int,
        percent: int = 100,
        by_step: bool = False,
    ) -> None:
        points = [Waypoint(MoveMode.MOVE_J, each, speed_percent=50) for each in (first, second)]
        run = Run(
            "fuzz", points, [2.0, 2.0], cycles=cycles, speed_percent=percent, step_by_step=by_step
        )
        self._ask(Kind.RUN, self._controller.player.start(run))

    def replay(self, joints_deg: tuple[float, ...], cycles: int) -> None:
        times = np.arange(0.0, 2.0, 0.02)
        samples = np.zeros((len(times), 8))
        samples[:, 0] = times
        samples[:, 1:7] = joints_deg
        samples[:, 1] += 5.0 * np.sin(math.pi * times)
        samples[:, 7] = math.nan
        recording = Recording("fuzz", samples=samples, modified=datetime(2026, 1, 1, tzinfo=UTC))
        self._ask(Kind.RUN, self._controller.replayer.start(Replay(recording, cycles=cycles)))

    def pause_run(self) -> None:
        self._controller.player.pause()
        self._controller.replayer.pause()

    def go_on_run(self) -> None:
        self._ask(Kind.RUN, self._controller.player.go_on())
        self._ask(Kind.RUN, self._controller.replayer.go_on())

    def stop_run(self) -> None:
        self._controller.player.stop()
        self._controller.replayer.stop()

    def gripper(self, what: str) -> None:
        gripper = self._controller.gripper
        if what == "move":
            gripper.move(30.0, 1.0)
        elif what in ("open", "close"):
            gripper.move_to_end(opened=what == "open")
        elif what == "enable":
            gripper.enable(1.0)
        elif what == "disable":
            gripper.disable()
        elif what == "clear":
            gripper.clear_error()
        else:
            gripper.set_zero()

    def teach(self, command: int) -> None:
        if isinstance(self._controller.teaching.command(TeachingState(command)), Started):
            self._oracle.ask(Asked(Kind.TEACHING, self._world.time_s))

    def read_settings(self) -> None:
        batches = self._controller.settings.everything()
        if isinstance(batches, list):
            self._controller.settings.read(batches)

    def save_setting(self, joint: int, value: int) -> None:
        self._controller.settings.save({Parameter("collision_level", joint): float(value)})

    def tool(self, tool: tuple[float, ...]) -> None:
        self._controller.cartesian.tool = tool

    def user_frame(self, pose: tuple[float, ...]) -> None:
        """Make one and choose it, or move it; without a pose the base is chosen."""
        cells = self._controller.cell
        cell = cells.cell or Cell("fuzz")
        if pose:
            known = _USER if any(each.name == _USER for each in cell.frames) else ""
            made = with_part(cell, UserFrame(_USER, pose), instead_of=known)
            changed = replace(made, frame=_USER)
        else:
            changed = replace(cell, frame="")
        cells.take(changed) if cells.cell is None else cells.change(changed)
        if pose:
            self._user_frame = UserFrame(_USER, pose)

    def zone(self, middle: tuple[float, ...], edges: tuple[float, ...]) -> None:
        """Put a box in force that the arm stays out of, or none."""
        cells = self._controller.cell
        boxes = (AreaBox("box", (*middle, 0.0, 0.0, 0.0), edges),) if middle else ()
        changed = replace(cells.cell or Cell("fuzz"), area=Area(boxes=boxes))
        answer = cells.take(changed) if cells.cell is None else cells.change(changed)
        if not isinstance(answer, Refusal):
            self._oracle.zone = (middle, edges) if middle else None

    def set_limit(self, joint: int, max_deg: int) -> None:
        self._controller.settings.save({Parameter("max_angle_deg", joint): float(max_deg)})

    def zero(self, joint: int) -> None:
        if isinstance(self._controller.zeroing.set_zero(joint), Started):
            self._oracle.cancel("zero")

    def link_as(self, linked: tuple[str, int]) -> None:
        role, offset = linked
        output = LinkageRole.MOTION_OUTPUT
        self._controller.linkage.set(
            output if role == "output" else LinkageRole.TEACHING_INPUT,
            feedback_offset=offset,
            control_offset=offset,
        )

    def light(self, joint: int) -> None:
        self._controller.lights.set_light(min(joint, 6), 1, 255, 0, 0)

    def load(self, load: int) -> None:
        self._controller.end_reports.set_load(_OFF_LOAD[load])

    def end_reports(self, on: bool) -> None:
        self._controller.end_reports.switch(on=on)

    def next_step(self) -> None:
        step = self._controller.recovery.step
        if step.action in (None, Action.CONNECT, Action.CHECK_REFERENCE):
            return
        if self._controller.recovery.act(step) is not None:
            return
        if step.action in (Action.TAKE_OVER, Action.LEAVE_MODE):
            self._oracle.take_over()  # held until the other host was silent for 0.5 s
        elif step.action is Action.COME_INSIDE:
            self._oracle.ask(Asked(Kind.RUN, self._world.time_s))  # one target, then another
        elif step.action is Action.GO_ON:
            self._oracle.ask(Asked(Kind.CONTINUE, self._world.time_s))
        elif step.action is Action.STOP:
            self._oracle.stop_pressed()
            self._oracle.cancel("stop")
        else:
            self._oracle.recovered(step.action.value.id)

    def record(self) -> None:
        recorder = self._controller.recorder
        if recorder.recording:
            recorder.finish("fuzz")
        else:
            recorder.start()

    def disconnect(self) -> None:
        self._controller.disconnect_device()
        self._oracle.cancel("disconnect")
        self._oracle.stop_lifted()

    def connect(self) -> None:
        if self._controller.operating_state.link is LinkState.NO_DEVICE:
            self._controller.connect_device(self._world.device)
            self._world.still_timers()

    def get_ready(self) -> None:
        """What a patient operator does to have an arm that may move."""
        self.mend()
        self.plug_in()
        self.other_ends_streams()
        self.let_go()
        for _ in range(_PATIENCE):
            operating_state = self._controller.operating_state
            if operating_state.cannot_move is None:
                return
            if not operating_state.speed_percent:
                self.speed(30)
            self.connect()
            if operating_state.stop is StopState.STOPPED:
                self.resume()
            elif operating_state.cannot_enable is None and False in operating_state.enabled:
                self.enable(7)
            elif operating_state.holds:
                self.plan(TrajectoryCommand.ABORT)
            else:
                self.next_step()
            self._world.pass_time(0.1)

    def wait(self, seconds: float) -> None:
        self._world.pass_time(seconds)

    def take_over(self) -> None:
        if self._controller.take_over() is None:
            self._oracle.take_over()

    def halt_and_hold(self) -> None:
        if self._controller.halt_and_hold() is None:
            self._oracle.cancel("halt and hold")

    # A client of the local interface -------------------------------------------------------------

    def client_connects(self) -> None:
        self._world.client.connect()

    def client_asks(self, moves: bool, percent: int) -> None:
        params = {"purpose": "fuzz", "moves": moves, "max_speed_percent": percent}
        self._world.client.call("lease.request", self._on_lease, **params)

    def _on_lease(self, said: dict[str, Any], granted: bool) -> None:
        if granted:
            self._world.client.lease = said["lease"]

    def operator_grants(self, percent: int, for_session: bool) -> None:
        self._world.interface.grant(percent, for_session=for_session)

    def operator_declines(self) -> None:
        self._world.interface.decline()

    def operator_takes_back(self) -> None:
        if self._world.interface.view.lease is not None:
            self._oracle.lease_over("the operator took it back")
        self._world.interface.take_back()

    def operator_consents(self, given: bool) -> None:
        self._world.interface.consent(given=given)

    def interface_on(self, on: bool) -> None:
        if not on:
            self._oracle.lease_over("the interface was switched off")
        self._world.interface.switch(on=on)

    def client_gets_the_arm(self, percent: int) -> None:
        """What a script does, and an operator who wants it to have the arm."""
        self.interface_on(True)
        self.get_ready()
        self.client_connects()
        self.client_asks(True, percent)
        self._world.pass_time(STEP_S)
        self.operator_grants(percent, False)
        self._world.pass_time(STEP_S)

    def client_comes_streaming(self, percent: int, *stream: Any) -> None:
        self.client_gets_the_arm(percent)
        self.client_streams(*stream)

    def client_comes_sending(self, percent: int, joints_deg: tuple[float, ...]) -> None:
        self.client_gets_the_arm(percent)
        self.client_sends(joints_deg)

    def _client_moves(self, method: str, kind: Kind, params: dict[str, Any], **asked: Any) -> None:
        """The client has asked for a motion: from the answer on the arm may move by it."""
        client, world = self._world.client, self._world
        lease, bases = client.lease, self._oracle.bases()

        def then(_said: dict[str, Any], begun: bool) -> None:
            if begun:
                more = {**asked, "bases": bases, "lease": lease}
                self._oracle.ask(Asked(kind, world.time_s, **more))

        client.call(method, then, lease=lease, **params)

    def client_sends(self, joints_deg: tuple[float, ...]) -> None:
        params = {"angles_deg": list(joints_deg)}
        self._client_moves("motion.send", Kind.JOINTS, params, goal_deg=joints_deg)

    def client_steps(self, joint: int, delta_deg: float) -> None:
        params = {"joint": joint, "delta_deg": delta_deg}
        self._client_moves("motion.step", Kind.STEP, params, joint=joint, delta=delta_deg)

    def client_moves_tool(self, joints_deg: tuple[float, ...], move: str) -> None:
        pose = self._kinematics.forward(joints_deg)
        params = {"target": list(pose), "move_mode": move}
        flange = flange_pose(pose, self._controller.cartesian.tool)
        self._client_moves("tool.move", Kind.POSE, params, pose=flange)

    def client_speed(self, percent: int) -> None:
        self._world.client.call("motion.set_speed", lease=self._world.client.lease, percent=percent)

    def client_streams(
        self, joints_deg: tuple[float, ...], swing_deg: float, rate_hz: float
    ) -> None:
        """Targets that swing about a pose, or a pose far off at once."""

        def path(t_s: float) -> tuple[float, ...]:
            return tuple(each + swing_deg * math.sin(3.0 * t_s) for each in joints_deg)

        self._world.client.stream(path, rate_hz, self._on_target)

    def _on_target(self, _said: dict[str, Any], _followed: bool) -> None:
        if self._controller.jogging.streamed is not None:
            self._oracle.stream(self._world.client.lease)

    def client_rests(self) -> None:
        """It sends no more targets, and says nothing of it."""
        self._world.client.follow = None

    def client_ends_stream(self) -> None:
        def then(_said: dict[str, Any], ended: bool) -> None:
            if ended:
                self._oracle.stream_ended()

        client = self._world.client
        client.follow = None
        client.call("stream.end", then, lease=client.lease)

    def client_wants(self, method: str, params: dict[str, Any]) -> None:
        """What the operator is asked about each time, or what moves nothing."""
        client = self._world.client

        def then(said: dict[str, Any], begun: bool) -> None:
            if not begun and said["code"] != Code.INTERNAL:
                return
            if method == "motors.resume":
                self._oracle.stop_lifted()
            if method in _VOIDS:
                self._oracle.cancel(method)

        client.call(method, then, lease=client.lease, **params)

    def client_releases(self) -> None:
        client = self._world.client
        client.call("lease.release", lease=client.lease)

    def client_stops(self) -> None:
        def then(said: dict[str, Any], done: bool) -> None:
            if done or said["code"] == Code.INTERNAL:
                if self._controller.operating_state.link is not LinkState.NO_DEVICE:
                    self._oracle.stop_pressed()
                self._oracle.cancel("a client's stop")

        self._world.client.call("stop", then)

    def client_halts(self) -> None:
        self._world.client.call(
            "halt", lambda _, done: self._oracle.cancel("a client's halt") if done else None
        )

    def client_says(self, lines: tuple[str, ...]) -> None:
        """Anything at all."""
        for line in lines:
            self._world.client.say(line.encode(errors="surrogateescape") + b"\n")

    def client_is_silent(self) -> None:
        self._world.client.silent = True

    def client_dies(self) -> None:
        self._world.client.hang_up()

    # A second host -----------------------------------------------------------------------------

    def other_target(self, joints_deg: tuple[float, ...], percent: int) -> None:
        self._world.other.move_to(joints_deg, percent)

    def other_pose(self, joints_deg: tuple[float, ...], move: int) -> None:
        pose = self._kinematics.forward(joints_deg)
        self._world.other.say(*pose_target(*pose), f"151#01{move:02X}1E0000000000")

    def other_stream(self, joints_deg: tuple[float, ...], swing_deg: float, percent: int) -> None:
        def path(t_s: float) -> tuple[float, ...]:
            return (joints_deg[0] + swing_deg * math.sin(t_s), *joints_deg[1:])

        self._world.other.stream_targets(path, speed_percent=percent)

    def other_resumes_stream(self, rate_hz: float) -> None:
        self._world.other.stream(lambda _: ["150#0200000000000000"], rate_hz)

    def other_ends_streams(self) -> None:
        for stream in self._world.other.streams:
            stream.end()

    def other_stop(self) -> None:
        self._world.other.stop()

    def other_resume(self) -> None:
        self._world.other.resume()

    def other_enable(self) -> None:
        self._world.other.say(ENABLE)

    def other_disable(self) -> None:
        self._world.other.say(DISABLE)

    def other_mode(self, word: str) -> None:
        self._world.other.say(f"151#{word}1E0000000000")

    def other_mit(self) -> None:
        hold = [f"{0x15A + joint:03X}#7FFF7FF0519477FF" for joint in range(6)]
        self._world.other.say("151#010600AD00000000", *hold)

    def other_plan(self, command: int) -> None:
        self._world.other.say(f"150#00{command:02X}000000000000")

    def other_setting(self, line: str) -> None:
        self._world.other.say(line)

    def other_gripper(self) -> None:
        self._world.other.say("159#0000271003E80100")

    def other_question(self) -> None:
        self._world.other.say("4AF#0100000000000000")

    # A hand ------------------------------------------------------------------------------------

    def push(self, joint: int, torque_nm: float) -> None:
        """Push at a joint without power, until the action's time is over."""
        self._oracle.led()
        arm = self._world.firmware
        if not arm.enabled[joint - 1]:
            self._pushed = joint - 1
            arm.protection.push(self._pushed, torque_nm)

    def lead(self, joints_deg: tuple[float, ...]) -> None:
        self._oracle.led()
        self._world.firmware.hand_guiding.lead_to(joints_deg, speed_deg_s=_PULLED_DEG)

    # What nobody should say, and nobody says ---------------------------------------------------

    def strange_frame(self, said: str, times: int, pause_s: float) -> None:
        for _ in range(times):
            self._world.other.say(said)
            self._world.pass_time(pause_s)

    def hush(self, identifiers: tuple[int, ...], seconds: float) -> None:
        line = self._world.node.link
        fresh = set(identifiers) - line.mute_on
        line.mute_on |= fresh
        self._world.pass_time(seconds)
        line.mute_on -= fresh

    # What breaks -------------------------------------------------------------------------------

    def fail(self, share: float, times: int, actions: int) -> None:
        """A function of the program fails, now and over the next actions."""
        self._world.breakage = breakage = Breakage(share, times)
        self._world.pass_time(STEP_S)
        breakage.choose()
        self._failing = actions

    def exchange(
        self,
        other_generation: bool,
        version: str,
        joints_deg: tuple[float, ...],
        narrower_deg: int,
        silent_s: float,
    ) -> None:
        """Another arm in the place of this one: its angles, version and limits are its own."""
        generation = self._world.firmware.generation
        if other_generation:
            generation = Generation.ONE if generation is Generation.TWO else Generation.TWO
        named = version if generation is Generation.TWO else None
        kept, flash = ArmSettingsRecord(), MemoryFlash()
        kept.limits = [
            each._replace(max_deg=each.max_deg - 0.1 * narrower_deg) for each in kept.limits
        ]
        flash.save(kept)
        arm = Firmware(generation, joints_deg=joints_deg, version=named, flash=flash)
        first = self._world.firmware
        self._oracle.cancel("exchange")
        self._oracle.stop_lifted()
        self._world.exchange(arm, silent_s)
        self._oracle.exchanged(first, silent_s)

    def fault(self, name: str, value: float | None) -> None:
        self._world.node.faults.start(fault(name, value))

    def mend(self) -> None:
        if not self._world.firmware.is_on:  # it comes back without the stop
            self._oracle.cancel("power")
            self._oracle.stop_lifted()
        for each in list(self._world.node.faults.active):
            self._world.node.faults.end(each)
        line = self._world.node.link
        line.mute_on.clear()
        line.deaf_to.clear()

    def silence(self, identifiers: tuple[int, ...]) -> None:
        self._world.node.link.mute_on |= set(identifiers)

    def lose(self, identifier: int) -> None:
        line = self._world.node.link
        (line.lose_to_bus if identifier in (0x2A1, 0x476) else line.lose_to_arm)(identifier)

    def unplug(self) -> None:
        self._world.unplug_cable()

    def plug_in(self) -> None:
        self._world.plug_cable_in()

    def power_cycle(self, off_s: float) -> None:
        arm = self._world.firmware
        arm.switch_off()
        self._world.pass_time(off_s)
        arm.switch_on()
        self._oracle.cancel("power cycle")
        self._oracle.stop_lifted()

    def suspend(self, seconds: float) -> None:
        self._world.suspend(seconds)
        self._oracle.suspended()

    def hang(self, seconds: float) -> None:
        """The GUI thread is busy; the bus thread is not."""
        self._world.hang(seconds)
        self._oracle.suspended()

    def sleep(self, seconds: float) -> None:
        """The PC sleeps: its clock has jumped, and nothing was heard meanwhile."""
        self._world.time_s += seconds
        self._oracle.suspended()

    def sag(self, degrees: float) -> None:
        self._world.firmware.mechanics.sag_deg = (0.0, degrees, -degrees, 0.0, degrees, 0.0)
        self._oracle.lease.sped_s = self._world.time_s  # it gives way at once, whoever moves it
