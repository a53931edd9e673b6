"""The arm in the states an operator meets: online, moving, stopped, silent, and what leads out."""

from __future__ import annotations

import errno

import can

from armui.control.link.link_state import LinkState
from armui.control.operating_state import StopState
from armui.control.run.progress import Run, RunPhase
from armui.control.safety.recovery_steps import StepKind
from armui.protocol.codes import MoveMode
from armui.sim.faults.schedule import fault
from armui.trajectory.points.program import Waypoint
from armui.ui.shell.operation_area import OperationArea
from tests.accepted import accepted
from tests.app_driver import AppDriver
from tests.gallery_scenes.scene import settled

_PUSH = fault("collision", 2)

LOW_DEG = (10.0, 125.0, -60.0, 15.0, 40.0, 20.0)
REACH_OUT_DEG = (35.0, 95.0, -70.0, 20.0, 45.0, -30.0)


def no_device(_driver: AppDriver) -> None:
    """The window as it opens."""


def online(app_driver: AppDriver) -> None:
    """Connected, every motor off."""
    app_driver.connect()


def moving(app_driver: AppDriver) -> None:
    """On the way to a target, slowly; every panel has been shown, and what it reads is read."""
    app_driver.connect()
    area = app_driver.window.findChild(OperationArea, "operation_area")
    for place in range(area.count()):
        area.show_panel(place)
        app_driver.step()
        settled(app_driver)
    _set_off(app_driver)


def _set_off(app_driver: AppDriver) -> None:
    app_driver.click("menu_motion")
    app_driver.enable_by_hand()
    app_driver.controller.motion.set_speed_percent(20)
    for joint, angle_deg in enumerate(REACH_OUT_DEG, start=1):
        app_driver.type_into(f"target_field_{joint}", f"{angle_deg}")
    app_driver.click("send_button")
    app_driver.run_until(lambda: app_driver.controller.operating_state.moving)
    app_driver.run(1.2)


def reached_out(app_driver: AppDriver) -> None:
    """At rest, at the target of `moving`."""
    app_driver.connect()
    _set_off(app_driver)
    app_driver.run_until(lambda: not app_driver.controller.operating_state.moving, seconds=60.0)


def refused(app_driver: AppDriver) -> None:
    """A target beyond the limits of a joint."""
    reached_out(app_driver)
    app_driver.type_into("target_field_2", "200")
    app_driver.click("send_button")


def stopped(app_driver: AppDriver) -> None:
    """After the emergency stop."""
    reached_out(app_driver)
    app_driver.click("load_button")
    app_driver.click("stop_button")
    app_driver.run_until(lambda: app_driver.controller.operating_state.stop is StopState.STOPPED)
    app_driver.run(0.3)


def sinking(app_driver: AppDriver) -> None:
    """Three seconds after the emergency stop of a raised arm."""
    reached_out(app_driver)
    app_driver.click("stop_button")
    app_driver.run_until(lambda: app_driver.controller.operating_state.stop is StopState.STOPPED)
    app_driver.run(3.0)


def sinking_below_a_run(app_driver: AppDriver) -> None:
    """The same, in a run."""
    run(app_driver)
    app_driver.click("stop_button")
    app_driver.run(2.0)


def dropping(app_driver: AppDriver) -> None:
    """A moment after the motor of joint 2 was disabled."""
    reached_out(app_driver)
    app_driver.controller.motors.disable(2)
    app_driver.run_until(lambda: app_driver.controller.operating_state.enabled[1] is False)
    app_driver.run(0.2)


def lost_moving(app_driver: AppDriver) -> None:
    """The adapter has been pulled while the arm was on its way."""
    app_driver.connect()
    _set_off(app_driver)
    app_driver.unplug(can.CanOperationError("gone", error_code=errno.ENODEV))
    app_driver.wait(lambda: app_driver.controller.operating_state.link is LinkState.LOST)
    app_driver.run(1.0)


def stopped_in_another_theme(app_driver: AppDriver) -> None:
    """After the emergency stop, and then after another theme and back: still red."""
    stopped(app_driver)
    theme = app_driver.store.settings.theme
    app_driver.store.change(theme="light" if theme == "dark" else "dark")
    app_driver.run(0.5)
    app_driver.store.change(theme=theme)
    app_driver.run(0.5)


def low(app_driver: AppDriver) -> None:
    """Jogged to where the fingertip is below the plane that the arm stands on."""
    _enabled(app_driver)
    app_driver.controller.motion.send_joints(LOW_DEG, -1000.0)
    app_driver.run_until(lambda: app_driver.controller.operating_state.moving)
    _until(app_driver, StepKind.BELOW_BASE)
    app_driver.run_until(lambda: not app_driver.controller.operating_state.moving, seconds=60.0)


def run(app_driver: AppDriver) -> None:
    """A run dwells, and the panel of the motors says what it keeps from being done."""
    reached_out(app_driver)
    point = Waypoint(MoveMode.MOVE_J, tuple(app_driver.firmware.joints_deg), dwell_s=600.0)
    player = app_driver.controller.player
    accepted(player.start(Run("Pick up", (point,), (600.0,))))
    app_driver.run_until(lambda: player.progress.phase is RunPhase.DWELLING)
    app_driver.click("menu_motor")


def offline(app_driver: AppDriver) -> None:
    """The arm has fallen silent while the jog keys were switched on."""
    reached_out(app_driver)
    app_driver.click("jog_keys_button")
    app_driver.find("jog_step").setCurrentIndex(1)
    app_driver.powered = False
    app_driver.run_until(lambda: "offline" in app_driver.codes())


def lost(app_driver: AppDriver) -> None:
    """The adapter has been pulled."""
    reached_out(app_driver)
    app_driver.unplug(can.CanOperationError("gone", error_code=errno.ENODEV))
    app_driver.wait(lambda: app_driver.controller.operating_state.link is LinkState.LOST)


def collision(app_driver: AppDriver) -> None:
    """Something has been pushed against a joint."""
    _enabled(app_driver)
    app_driver.node.faults.start(_PUSH)
    _until(app_driver, StepKind.COLLISION)


def teaching(app_driver: AppDriver) -> None:
    """The arm is led by hand and recorded."""
    _enabled(app_driver)
    app_driver.click("menu_teaching")
    app_driver.click("teaching_start_recording")
    app_driver.confirm()
    _until(app_driver, StepKind.RECORDING)
    app_driver.firmware.hand_guiding.lead_to(REACH_OUT_DEG)
    app_driver.run(2.0)


def teaching_exit_steps(app_driver: AppDriver) -> None:
    """The recording has ended; the arm is still led by hand."""
    teaching(app_driver)
    app_driver.click("teaching_stop_recording")
    _until(app_driver, StepKind.DRAG_MODE)
    app_driver.run(0.2)


def _enabled(app_driver: AppDriver) -> None:
    app_driver.connect()
    app_driver.click("menu_motion")
    app_driver.enable_by_hand()


def _until(app_driver: AppDriver, kind: StepKind) -> None:
    app_driver.run_until(lambda: app_driver.controller.recovery.step.kind is kind)
