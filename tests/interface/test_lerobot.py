"""LeRobot's robot and teleoperator before a simulated arm, and the contract that LeRobot publishes.

LeRobot itself is 5 GB: here stand the signatures of 0.6.1, and
`python -m tests.tools.lerobot_record` runs the real one.
"""

import abc
import inspect
import sys
from collections.abc import Mapping
from dataclasses import dataclass
from importlib import import_module
from types import ModuleType, SimpleNamespace
from typing import ClassVar

import pytest

import armui_client
from tests.interface.script import Script

KEYS = [*(f"joint_{n}.pos" for n in range(1, 7)), "gripper.pos"]
MID = (0.0, 40.0, -50.0, 0.0, 20.0, 0.0)


class Device(abc.ABC):
    """What a robot and a teleoperator share."""

    def __init__(self, config):
        self.id = config.id

    @property
    @abc.abstractmethod
    def is_connected(self): ...

    @property
    @abc.abstractmethod
    def is_calibrated(self): ...

    @property
    @abc.abstractmethod
    def action_features(self): ...

    @abc.abstractmethod
    def connect(self, calibrate=True): ...

    @abc.abstractmethod
    def calibrate(self): ...

    @abc.abstractmethod
    def configure(self): ...

    @abc.abstractmethod
    def disconnect(self): ...


class Robot(Device):
    @property
    @abc.abstractmethod
    def observation_features(self): ...

    @abc.abstractmethod
    def get_observation(self): ...

    @abc.abstractmethod
    def send_action(self, action): ...


class Teleoperator(Device):
    @property
    @abc.abstractmethod
    def feedback_features(self): ...

    @abc.abstractmethod
    def get_action(self): ...

    @abc.abstractmethod
    def send_feedback(self, feedback): ...


@dataclass(kw_only=True)
class Config:
    id: str | None = None
    calibration_dir: str | None = None
    known: ClassVar[dict[tuple[str, str], type]] = {}

    def __post_init__(self):
        pass

    @classmethod
    def register_subclass(cls, name):
        def register(subclass):
            Config.known[cls.__name__, name] = subclass
            return subclass

        return register


class NotConnectedError(ConnectionError):
    pass


class AlreadyConnectedError(ConnectionError):
    pass


@pytest.fixture
def lerobot(monkeypatch):
    """The two plug-ins, imported as LeRobot imports them."""
    robots = {"Robot": Robot, "RobotConfig": type("RobotConfig", (Config,), {})}
    leaders = {
        "Teleoperator": Teleoperator,
        "TeleoperatorConfig": type("TeleoperatorConfig", (Config,), {}),
    }
    cameras = {"CameraConfig": object, "make_cameras_from_configs": dict}
    errors = {
        "DeviceNotConnectedError": NotConnectedError,
        "DeviceAlreadyConnectedError": AlreadyConnectedError,
    }
    modules: dict[str, Mapping[str, object]] = {
        "lerobot": {},
        "lerobot.cameras": cameras,
        "lerobot.robots": robots,
        "lerobot.teleoperators": leaders,
        "lerobot.utils": {},
        "lerobot.utils.errors": errors,
    }
    for name, content in modules.items():
        module = ModuleType(name)
        vars(module).update(content)
        monkeypatch.setitem(sys.modules, name, module)
    ours = ("lerobot_robot_armui", "lerobot_teleoperator_armui")
    for name in [each for each in sys.modules if each.startswith(ours)]:
        monkeypatch.delitem(sys.modules, name)
    Config.known.clear()
    yield SimpleNamespace(robot=import_module(ours[0]), teleoperator=import_module(ours[1]))
    for name in [each for each in sys.modules if each.startswith(ours)]:
        monkeypatch.delitem(sys.modules, name)


@pytest.fixture
def script(desk, monkeypatch):
    return Script(desk, monkeypatch)


@pytest.fixture
def robot(lerobot):
    def made(**settings):
        return lerobot.robot.ArmuiRobot(lerobot.robot.ArmuiRobotConfig(id="one", **settings))

    return made


def action_of(joints_deg, opening_mm=20.0):
    return dict(zip(KEYS, (*joints_deg, opening_mm), strict=True))


def place(script):
    rig = script.rig
    rig.controller.begin("motion.send", list(MID))
    rig.run_until(lambda: rig.firmware.joints_deg == pytest.approx(MID, abs=0.05))
    rig.run(1.0)


def follow(script, robot, target, times=60):
    """Send one action again and again at 50 Hz."""
    for _ in range(times):
        robot.send_action(target)
        script.time.sleep(0.02)


def test_the_contract_is_kept(lerobot):
    """Each method takes what LeRobot gives, and the names by which it finds classes are right."""
    for contract, ours in (
        (Robot, lerobot.robot.ArmuiRobot),
        (Teleoperator, lerobot.teleoperator.ArmuiTeleoperator),
    ):
        assert not inspect.isabstract(ours)
        for name, published in inspect.getmembers(contract, inspect.isfunction):
            if getattr(published, "__isabstractmethod__", False):
                taken = inspect.signature(getattr(ours, name)).parameters
                assert list(taken) == list(inspect.signature(published).parameters), name
        assert ours.config_class.__name__ == f"{ours.__name__}Config"
        module = sys.modules[ours.config_class.__module__.rpartition(".")[0]]
        assert getattr(module, ours.__name__) is ours
    assert Config.known == {
        ("RobotConfig", "armui"): lerobot.robot.ArmuiRobotConfig,
        ("TeleoperatorConfig", "armui"): lerobot.teleoperator.ArmuiTeleoperatorConfig,
    }


def test_what_it_is_can_be_asked_unconnected(robot, lerobot):
    made = robot()
    assert list(made.observation_features) == list(made.action_features) == KEYS
    assert list(robot(gripper=False).action_features) == KEYS[:-1]
    assert not made.is_connected
    with pytest.raises(NotConnectedError):
        made.get_observation()
    with pytest.raises(NotConnectedError):
        made.send_action(action_of(MID))
    with pytest.raises(ValueError, match="max_speed_percent"):
        robot(max_speed_percent=0)


def test_it_asks_for_the_arm_follows_actions_and_leaves_it_powered(script, desk, robot):
    place(script)
    made, there = robot(purpose="a policy"), [angle + 8.0 for angle in MID]
    purposes = set()

    def look():
        if desk.view.lease is not None:
            purposes.add(desk.view.lease.ask.purpose)

    script.meanwhile = look

    def use():
        made.connect()
        before = made.get_observation()
        follow(script, made, action_of(there))
        after = made.get_observation()
        assert made.send_action(action_of(there)) == action_of(there)
        made.disconnect()
        return before, after

    before, after = script.run(use)
    assert purposes == {"a policy"}
    assert [before[key] for key in KEYS[:6]] == pytest.approx(MID, abs=0.1)
    assert [after[key] for key in KEYS[:6]] == pytest.approx(there, abs=0.3)
    assert after["gripper.pos"] == pytest.approx(20.0, abs=1.0)
    script.rig.run(0.5)
    assert desk.view.lease is None
    assert not desk.view.clients
    assert all(script.rig.controller.operating_state.enabled)
    assert script.rig.firmware.joints_deg == pytest.approx(there, abs=0.5), "it was driven away"


def test_what_is_refused_is_raised_once_nothing_was_followed_for_a_while(script, robot, caplog):
    place(script)
    made, beyond = robot(give_up_after_s=0.3), action_of([170.0, *MID[1:]])

    def use():
        made.connect()
        follow(script, made, action_of(MID), times=5)
        with pytest.raises(armui_client.Refused) as refused:
            follow(script, made, beyond, times=500)
        follow(script, made, action_of([3.0, *MID[1:]]))
        made.disconnect()
        return refused.value

    assert script.run(use).reason == "joint_out_of_limits"
    assert "joint_out_of_limits" in caplog.text
    assert script.rig.firmware.joints_deg[0] == pytest.approx(3.0, abs=0.3), "it was not to go on"


def test_the_way_home_after_the_operator_took_the_arm_is_refused_at_once(script, desk, robot):
    """`lerobot-rollout` sends 150 targets at its end, whatever has happened."""
    place(script)
    made, asked = robot(), []

    def use():
        made.connect()
        follow(script, made, action_of(MID), times=5)
        asked.append(True)
        while desk.view.lease is not None:
            script.time.sleep(0.02)
        with pytest.raises(armui_client.LeaseLost):
            follow(script, made, action_of([60.0, *MID[1:]]), times=150)
        assert made.get_observation()
        made.disconnect()

    def take_back():
        if asked and desk.view.lease is not None:
            desk.take_back()

    script.meanwhile = take_back
    script.run(use)
    assert script.rig.firmware.joints_deg[0] == pytest.approx(0.0, abs=0.2)


def test_a_silent_arm_gives_no_observation(script, robot):
    place(script)
    made = robot(moves=False)

    def use():
        made.connect()
        script.rig.powered = False
        script.time.sleep(0.4)
        with pytest.raises(armui_client.Stale):
            made.get_observation()
        made.disconnect()

    script.run(use)


def test_the_operator_who_declines_leaves_nothing_open(script, desk, robot):
    made = robot()
    script.percent = None
    script.meanwhile = lambda: desk.view.asked is not None and desk.decline()

    def use():
        with pytest.raises(armui_client.Refused):
            made.connect()
        assert not made.is_connected

    script.run(use)
    assert not desk.view.clients


def test_a_teleoperator_tells_where_an_arm_is_and_asks_for_nothing(script, desk, lerobot):
    place(script)
    config = lerobot.teleoperator.ArmuiTeleoperatorConfig()
    leader = lerobot.teleoperator.ArmuiTeleoperator(config)

    def use():
        leader.connect()
        with pytest.raises(AlreadyConnectedError):
            leader.connect()
        told = leader.get_action()
        leader.disconnect()
        return told

    told = script.run(use)
    assert list(told) == KEYS == list(leader.action_features)
    assert [told[key] for key in KEYS[:6]] == pytest.approx(MID, abs=0.1)
    assert desk.view.lease is None
