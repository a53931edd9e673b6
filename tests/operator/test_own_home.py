"""An operator who keeps a home pose of his own, and goes there."""

import json
import math

import pytest
from PySide6.QtGui import QAction

from armui.protocol.generation import Generation
from armui.settings import SettingsStore
from armui.ui.panels.jogging.motion_panel import MotionPanel
from armui.ui.panels.jogging.own_home import OwnHome
from tests.accepted import accepted

HERE = (10.0, 30.0, -40.0, 5.0, 20.0, 0.0)
AWAY = (-20.0, 50.0, -60.0, 0.0, 0.0, 30.0)


@pytest.fixture
def at_home(app_driver):
    app_driver.ready()
    move_to(app_driver, HERE)
    return app_driver


def move_to(driver, angles_deg):
    accepted(driver.controller.motion.send_joints(angles_deg))
    driver.run_until(lambda: math.dist(driver.firmware.joints_deg, angles_deg) < 0.01)
    driver.run(0.5)
    driver.heard()


def choose(driver, name):
    driver.window.findChild(MotionPanel).findChild(QAction, name).trigger()


def test_where_the_arm_is_measured_is_kept_and_reached_by_move_j(at_home):
    assert not at_home.find("own_home_button").isEnabled()
    assert "No park position is kept" in at_home.find("own_home_button").toolTip()
    choose(at_home, "set_own_home_measured")
    at_home.run(0.2)
    assert at_home.heard() == []
    assert "J3 -40.000°" in at_home.find("own_home_button").toolTip()
    assert at_home.read("motion_message").startswith("Park position set: J1 10.0")
    assert "J3 -40.000°" in at_home.read("motion_message")
    move_to(at_home, AWAY)
    at_home.click("own_home_button")
    at_home.step()
    assert at_home.read("motion_message") == ""
    assert [frame.arbitration_id for frame in at_home.heard()] == [0x155, 0x156, 0x157, 0x151]
    at_home.run_until(lambda: math.dist(at_home.firmware.joints_deg, HERE) < 0.01)


def test_what_is_typed_is_kept_within_the_limits(at_home):
    at_home.type_into("target_field_1", "33")
    choose(at_home, "set_own_home_typed")
    assert "J1 33.000°" in at_home.find("own_home_button").toolTip()
    at_home.type_into("target_field_1", "400")
    choose(at_home, "set_own_home_typed")
    assert "beyond its limits" in at_home.read("motion_message")
    assert "J1 33.000°" in at_home.find("own_home_button").toolTip()
    assert at_home.heard() == []


def test_beyond_limits_that_are_narrower_now_it_does_not_go(at_home):
    choose(at_home, "set_own_home_measured")
    (arm,) = at_home.store.settings.home_poses
    at_home.store.change(home_poses={arm: (179.0, *HERE[1:])})
    at_home.controller.motors.disable(6)
    at_home.run(0.5)
    at_home.controller.motors.enable()
    at_home.run(1.0)
    at_home.heard()
    assert not at_home.find("own_home_button").isEnabled()
    assert "beyond its limits" in at_home.find("own_home_button").toolTip()


def test_it_is_of_one_arm_and_waits_for_motors(at_home):
    choose(at_home, "set_own_home_measured")
    (arm,) = at_home.store.settings.home_poses
    kept = SettingsStore(at_home.store.path)
    assert kept.settings.home_poses[arm] == pytest.approx(HERE, abs=0.01)
    at_home.controller.motors.disable()
    at_home.run(1.0)
    assert "not enabled" in at_home.find("own_home_button").toolTip()
    at_home.store.change(home_poses={"another": HERE})
    at_home.controller.disconnect_device()
    assert not at_home.find("own_home_button").isEnabled()


def test_before_an_arm_has_named_itself_none_is_offered(app_driver):
    """What was kept for an arm without a number, at this adapter, is no other arm's."""
    app_driver.store.change(home_poses={app_driver.device.arm_key(): AWAY})
    app_driver.controller.connect_device(app_driver.device)
    for _ in range(60):
        app_driver.step()
        choose(app_driver, "set_own_home_measured")
        if app_driver.controller.state.identity is None:
            assert list(app_driver.store.settings.home_poses) == [app_driver.device.arm_key()]
        own = app_driver.window.findChild(OwnHome)
        assert own.angles_deg != AWAY
    assert app_driver.controller.state.identity is not None


def test_an_arm_that_cannot_be_told_from_another_says_so(any_driver):
    any_driver.ready()
    any_driver.run(0.5)
    choose(any_driver, "set_own_home_measured")
    numberless = any_driver.firmware.generation is Generation.ONE
    adapter = any_driver.device.arm_key()
    assert (list(any_driver.store.settings.home_poses) == [adapter]) is numberless
    for name in ("own_home_button", "set_own_home_button"):
        doubt = "no number of its own" in any_driver.find(name).toolTip()
        assert doubt is numberless


def test_without_an_arm_there_is_nothing_to_keep(app_driver):
    choose(app_driver, "set_own_home_measured")
    assert app_driver.store.settings.home_poses == {}
    assert "onnect" in app_driver.read("motion_message")


@pytest.mark.parametrize(
    "bad",
    [[], {"a": [1, 2]}, {"a": [0, 0, 0, 0, 0, "x"]}, {"a": [0, 0, 0, 0, 0, 1e9]}, {"a": None}],
)
def test_poses_in_a_file_that_cannot_be_are_left_out(tmp_path, bad):
    path = tmp_path / "settings.json"
    path.write_text(json.dumps({"home_poses": bad}))
    store = SettingsStore(path)
    assert store.settings.home_poses == {}
    assert [each.params["field"] for each in store.problems] == ["home_poses"]
