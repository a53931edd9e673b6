"""Everything the program can be doing to an arm, and every command that could disturb it."""

from __future__ import annotations

from collections.abc import Callable, Mapping

from armui.arm.parameters import Parameter
from armui.arm.refusal import Refusal
from armui.control.motion.jog_path import JointJog, ToolJog
from armui.control.operations.started import Started
from armui.control.run.progress import Run, RunPhase
from armui.control.run.replay import Replay
from armui.kinematics.axes import JogFrame
from armui.protocol.codes import EndLoad, LinkageRole, MoveMode, TeachingState, TrajectoryCommand
from armui.trajectory.points.program import Waypoint
from tests.accepted import accepted
from tests.arm_rig import ArmRig
from tests.control.jogger import bend
from tests.control.test_replayer import wave

OUT = (20.0, 40.0, -40.0, 10.0, 20.0, 15.0)
BACK = (-15.0, 30.0, -30.0, -10.0, 30.0, -20.0)
POSE = (200.0, 0.0, 300.0, 0.0, 85.0, 0.0)


def to(joints_deg, **more):
    """A waypoint at full speed."""
    return Waypoint(MoveMode.MOVE_J, joints_deg, speed_percent=100, **more)


def run_of(*points, **more):
    """A run of them."""
    return Run("test", points, [2.0 + point.dwell_s for point in points], **more)


def phase(rig: ArmRig) -> RunPhase:
    """What the run does."""
    return rig.controller.player.progress.phase


def run_moving(rig: ArmRig) -> None:
    accepted(rig.controller.player.start(run_of(to(OUT), to(BACK))))
    rig.run(0.4)
    assert phase(rig) is RunPhase.MOVING


def run_dwelling(rig: ArmRig) -> None:
    rig.controller.player.start(run_of(to(OUT, dwell_s=60.0), to(BACK)))
    rig.run_until(lambda: phase(rig) is RunPhase.DWELLING)
    rig.run(0.5)


def run_paused(rig: ArmRig) -> None:
    run_moving(rig)
    accepted(rig.controller.player.pause())
    rig.run(1.0)


def run_waiting(rig: ArmRig) -> None:
    rig.controller.player.start(run_of(to(OUT), to(BACK), step_by_step=True))
    rig.run_until(lambda: phase(rig) is RunPhase.WAITING)
    rig.run(0.5)


def replay_moving(rig: ArmRig) -> None:
    replayer = rig.controller.replayer
    accepted(replayer.start(Replay(wave())))
    rig.run_until(lambda: replayer.progress.done > 0.2)


def replay_paused(rig: ArmRig) -> None:
    replay_moving(rig)
    accepted(rig.controller.replayer.pause())
    rig.run(0.5)


RUNS: Mapping[str, Callable[[ArmRig], None]] = {
    each.__name__: each
    for each in (
        run_moving,
        run_dwelling,
        run_paused,
        run_waiting,
        replay_moving,
        replay_paused,
    )
}
"""A run or replay in each of its phases; the arm stands still in most of them."""


def joint_jog(rig: ArmRig) -> None:
    bend(rig)
    accepted(rig.controller.jogging.start(JointJog(1, 1)))
    rig.run(0.2)


def tool_jog(rig: ArmRig) -> None:
    bend(rig)
    accepted(rig.controller.jogging.start(ToolJog(2, 1, JogFrame.BASE)))
    rig.run(0.2)


def motion_paused(rig: ArmRig) -> None:
    """Not by a run, but from 示教: the arm keeps its target."""
    controller = rig.controller
    accepted(controller.motion.send_joints(OUT))
    rig.run_until(lambda: controller.operating_state.moving)
    accepted(controller.planned_motion.command(TrajectoryCommand.PAUSE))
    rig.run(1.0)


Command = Callable[[ArmRig], Started | Refusal | None]

SETTINGS: Mapping[str, Command] = {
    "enable all": lambda b: b.controller.motors.enable(),
    "enable one": lambda b: b.controller.motors.enable(3),
    "clear error": lambda b: b.controller.joint_errors.clear(2),
    "zero one": lambda b: b.controller.zeroing.set_zero(1),
    "zero all": lambda b: b.controller.zeroing.set_zero(),
    "limit": lambda b: b.controller.settings.save({Parameter("max_angle_deg", 2): 100.0}),
    "speed limit": lambda b: b.controller.settings.save({Parameter("max_speed_deg_s", 2): 90.0}),
    "acceleration": lambda b: b.controller.settings.save(
        {Parameter("max_acceleration_deg_s2", 2): 100.0}
    ),
    "collision": lambda b: b.controller.settings.save({Parameter("collision_level", 1): 3}),
    "end limit": lambda b: b.controller.settings.save({Parameter("max_linear_speed_m_s"): 0.3}),
    "factory end limits": lambda b: b.controller.settings.reset_end_limits(),
    "factory joint limits": lambda b: b.controller.settings.reset_joint_limits(),
    "load": lambda b: b.controller.end_reports.set_load(EndLoad.FULL),
    "linkage": lambda b: b.controller.linkage.set(LinkageRole.TEACHING_INPUT, feedback_offset=16),
    "no linkage": lambda b: b.controller.linkage.release(),
    "drag teaching": lambda b: b.controller.teaching.command(TeachingState.START_RECORDING),
    "run": lambda b: b.controller.player.start(run_of(to(BACK))),
    "replay": lambda b: b.controller.replayer.start(Replay(wave())),
}
"""What no motion is to meet that was planned without it."""

MOTIONS: Mapping[str, Command] = {
    "joints": lambda b: b.controller.motion.send_joints(BACK),
    "home": lambda b: b.controller.motion.go_home(),
    "step": lambda b: b.controller.motion.jog(1, 5.0),
    "pose": lambda b: b.controller.cartesian.move(POSE, MoveMode.MOVE_P),
    "line": lambda b: b.controller.cartesian.move(POSE, MoveMode.MOVE_L),
    "arc": lambda b: b.controller.cartesian.move_arc(POSE, POSE, POSE),
    "tool step": lambda b: b.controller.cartesian.step(0, 5.0, JogFrame.BASE),
    "joint jog": lambda b: b.controller.jogging.start(JointJog(1, 1)),
    "tool jog": lambda b: b.controller.jogging.start(ToolJog(0, 1, JogFrame.BASE)),
}

PLANS: Mapping[str, Command] = {
    "pause": lambda b: b.controller.planned_motion.command(TrajectoryCommand.PAUSE),
    "continue": lambda b: b.controller.planned_motion.command(TrajectoryCommand.CONTINUE),
}

BESIDE_A_RUN: Mapping[str, Command] = {
    "gripper": lambda b: b.controller.gripper.move(10.0, 1.0),
    "gripper on": lambda b: b.controller.gripper.enable(1.0),
    "gripper error": lambda b: b.controller.gripper.clear_error(),
    "gripper zero": lambda b: b.controller.gripper.set_zero(),
}
"""What a run would go on with, changed; a jog does not mind it."""
