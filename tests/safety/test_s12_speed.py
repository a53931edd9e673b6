"""S12: the arm is never faster than the window shows because of order or loss."""

import math
import subprocess
import sys
from dataclasses import replace

import pytest

from armui.control.motion.jog_path import JointJog
from armui.control.run.progress import Run
from armui.control.safety.overspeed import tool_pace
from armui.kinematics.axes import JogFrame
from armui.protocol import commands
from armui.protocol.codes import ControlMode, MoveMode
from armui.protocol.frame import Frame
from armui.protocol.generation import Generation, PiperModel
from armui.trajectory.planning.check import CheckRequest, check
from armui.trajectory.planning.findings import Severity
from armui.trajectory.points.program import Waypoint
from armui.ui.words import refusal
from tests.accepted import accepted
from tests.family import MODELS
from tests.safety.speeds import fastest_deg_s, ready_at
from tests.safety.ways import STREAM_S, Driver, Ways
from tests.trajectory.arms import ARM, pose_near
from tests.trajectory.arms import HERE as TOOL_HERE

HERE = (0.0, 30.0, -30.0, 0.0, 0.0, 0.0)
FAR = (140.0, 30.0, -30.0, 0.0, 0.0, 0.0)


@pytest.fixture
def ready(any_rig):
    return ready_at(any_rig, HERE)


def test_a_lower_percentage_goes_out_before_the_targets(ready):
    rig = ready
    rig.controller.motion.speed_percent = 5  # chosen while it could not be told
    accepted(rig.controller.motion.send_joints(FAR))
    rig.step()

    assert [frame.arbitration_id for frame in rig.heard()] == [0x151, 0x155, 0x156, 0x157, 0x151]


def test_a_higher_percentage_goes_out_after_the_targets(ready):
    rig = ready
    rig.controller.motion.set_speed_percent(5)
    rig.step()
    rig.heard()
    rig.controller.motion.speed_percent = 100
    accepted(rig.controller.motion.send_joints(FAR))
    rig.step()

    assert [frame.arbitration_id for frame in rig.heard()] == [0x155, 0x156, 0x157, 0x151]


def test_a_motion_whose_mode_word_is_lost_is_as_slow_as_shown(ready):
    rig = ready
    rig.controller.motion.speed_percent = 5
    rig.node.link.lose_to_arm(0x151)  # one of the two
    accepted(rig.controller.motion.send_joints(FAR))

    assert fastest_deg_s(rig, 3.0) < 1.5 * 0.05 * 172.0


def test_a_motion_that_is_measured_too_fast_is_ended_and_said(ready):
    rig = ready
    rig.controller.motion.speed_percent = 5
    rig.node.link.lose_to_arm(0x151, 2)  # both
    accepted(rig.controller.motion.send_joints(FAR))
    rig.run(2.0)

    assert "motion_too_fast" in rig.codes()
    assert not rig.firmware.mechanics.moving
    assert rig.firmware.mechanics.positions_deg[0] < 40.0


def test_a_motion_at_its_own_speed_is_left_alone(ready):
    rig = ready
    for percent, target in ((100, FAR), (30, HERE), (100, FAR), (5, HERE)):
        rig.controller.motion.set_speed_percent(percent)
        accepted(rig.controller.motion.send_joints(target))
        rig.run(1.2)  # the next motion replaces one under way

    assert "motion_too_fast" not in rig.codes()


@pytest.fixture
def gentle(any_rig):
    """J1, of 30 °/s², is on its way at 30 % of its highest speed: 52 °/s, since 0.1 s."""
    any_rig.firmware.settings.accelerations_deg_s2[0] = 30.0
    any_rig.ready()
    any_rig.controller.motion.set_speed_percent(30)
    accepted(any_rig.controller.motion.send_joints(FAR))
    any_rig.run(1.85)
    assert 51.0 < any_rig.firmware.mechanics.speeds_deg_s[0] < 53.0
    return any_rig


@pytest.mark.each_value(full="all percentages in both generations")
@pytest.mark.parametrize("percents", [(5,), (10,), (15, 5)])
def test_a_joint_of_low_acceleration_is_given_the_time_to_slow_down(gentle, percents):
    """From 52 °/s it takes 1.4 s to 5 % of its highest speed, 8.6 °/s."""
    rig = gentle
    for percent in percents:
        rig.controller.motion.set_speed_percent(percent)
        rig.run(0.5)
    assert rig.firmware.mechanics.speeds_deg_s[0] > 1.5 * 0.05 * 172.0
    rig.run(2.0)

    assert "motion_too_fast" not in rig.codes()
    assert 0.0 < rig.firmware.mechanics.speeds_deg_s[0] < percents[-1] / 100.0 * 172.0


def test_a_motion_that_takes_the_place_of_a_faster_one_is_given_it_too(gentle):
    rig = gentle
    rig.controller.motion.speed_percent = 5
    accepted(rig.controller.motion.send_joints(FAR))
    rig.run(2.5)

    assert "motion_too_fast" not in rig.codes()
    assert 0.0 < rig.firmware.mechanics.speeds_deg_s[0] < 0.05 * 172.0


def test_a_joint_of_low_acceleration_that_is_not_slowed_down_is_ended(gentle):
    rig = gentle
    rig.node.link.lose_to_arm(0x151, 9)
    rig.controller.motion.set_speed_percent(5)
    rig.run(1.0)

    assert "motion_too_fast" in rig.codes()


def test_after_a_jog_the_operators_speed_is_back_in_the_arm(ready):
    rig = ready
    accepted(rig.controller.jogging.start(JointJog(6, 1)))
    rig.run(0.5)
    assert rig.firmware.condition.speed_percent < 100
    rig.controller.jogging.stop()
    rig.run(1.2)

    assert rig.firmware.condition.speed_percent == 100


def test_it_is_not_given_back_while_another_host_has_set_its_own(rig, other_host):
    rig.ready()
    accepted(rig.controller.jogging.start(JointJog(6, 1)))
    rig.run(0.5)
    rig.controller.jogging.stop()
    other_host.speed(70)
    rig.run(0.1)
    rig.heard()
    rig.run(5.0)

    assert rig.firmware.condition.speed_percent == 70
    assert not [frame for frame in rig.heard() if frame.arbitration_id == 0x151]


def test_the_percentage_told_is_the_one_shown(ready):
    rig = ready
    rig.controller.motion.set_speed_percent(42)
    rig.step()

    assert rig.heard() == [Frame(0x151, bytes.fromhex("01 01 2A 00 00 00 00 00"))]


LINE_START = (0.0, 70.0, -60.0, 0.0, 30.0, 0.0)
DIRECTIONS = {"X": (120, 0, 0), "-X": (-120, 0, 0), "Y": (0, 150, 0), "Z": (0, 0, 120)}

MOST_FAST = 3
"""Looks at a motion that is too fast before it is ended, 20 ms apart: behind its start a tenth of a
second of readings must be there first, and they come a little off their time."""


def lost_mode_word(percent, by_mm, arc=False, generation=Generation.TWO, model=PiperModel.PIPER):
    """A line or an arc sent at this percentage to an arm that last heard of 100 %.

    Returns:
        The driver, what the percentage means for the tool in mm/s, and how fast it was in each
        tenth of a second until it came to its end or was ended.
    """
    driver = Driver(LINE_START, model, generation, STREAM_S)
    kinematics = driver.arm_model().kinematics
    start = kinematics.forward(LINE_START)
    end = tuple(round(a + b, 3) for a, b in zip(start, (*by_mm, 0, 0, 0), strict=True))
    aside = (by_mm[0] / 2 + 15, by_mm[1] / 2 + 15, by_mm[2] / 2 - 15)
    middle = tuple(round(a + b, 3) for a, b in zip(start, (*aside, 0, 0, 0), strict=True))
    move = MoveMode.MOVE_C if arc else MoveMode.MOVE_L
    point = Waypoint(move, end, middle=middle if arc else None, speed_percent=percent)
    driver.bus.send(
        commands.set_mode(
            driver.bus.codec,
            control_mode=ControlMode.CAN_CONTROL,
            move_mode=move,
            speed_percent=100,
        )
    )
    driver.step()
    driver.bus.lost = frozenset({0x151})
    accepted(driver.player.start(Run("line", (point,), (10.0,))))
    shown_mm_s = driver.authority.command.pace.linear_mm_s * percent / 100.0
    places = [start[:3]] * 5
    while driver.player.running:
        driver.step()
        angles_deg = driver.state().angles_deg()
        assert angles_deg is not None
        places.append(kinematics.forward(angles_deg)[:3])
    speeds = [math.dist(a, b) / 0.1 for a, b in zip(places, places[5:], strict=False)]
    return driver, shown_mm_s, speeds


def too_fast(speeds, shown_mm_s):
    """Those at which a motion is ended; 3 mm/s is what the last digit of six joints can tremble."""
    return [speed for speed in speeds if speed > 1.5 * shown_mm_s + 3.0]


@pytest.mark.each_value(full="lines and arcs in each direction at each percentage")
@pytest.mark.usefixtures("qapp")
@pytest.mark.parametrize("arc", [False, True], ids=["line", "arc"])
@pytest.mark.parametrize("direction", DIRECTIONS)
@pytest.mark.parametrize("percent", [5, 20, 50])
def test_a_line_or_an_arc_whose_mode_words_are_lost_is_ended(percent, direction, arc):
    """A line never comes near the joints' highest speeds: the tool's own tells.

    At 50 % it is ended only where the way is long enough to be too fast on it.
    """
    driver, shown_mm_s, speeds = lost_mode_word(percent, DIRECTIONS[direction], arc)
    reason = driver.player.progress.refusal
    fast = too_fast(speeds, shown_mm_s)
    assert len(fast) <= MOST_FAST
    if percent < 50 or fast:
        assert reason.code in {"tool_too_fast", "too_fast"}
    else:
        assert reason is None
    if fast and reason.code == "tool_too_fast":
        assert reason.params["maximum"] == pytest.approx(shown_mm_s, abs=0.1)
        assert reason.params["limit"] == pytest.approx(1.5 * shown_mm_s + 3.0, abs=0.1)
        assert reason.params["limit"] <= reason.params["value"] <= fast[-1] + 0.1
        told = f"{percent} % was told, that is {reason.params['maximum']:g} mm/s"
        assert told in refusal(reason)


@pytest.mark.usefixtures("qapp")
@pytest.mark.parametrize("arc", [False, True], ids=["line", "arc"])
@pytest.mark.parametrize("direction", DIRECTIONS)
def test_what_a_percentage_means_for_the_tool_is_what_the_arm_does(direction, arc):
    """A line of 120 mm may be too short to come to its speed; an arc is slower, and comes to it."""
    driver, shown_mm_s, speeds = lost_mode_word(100, DIRECTIONS[direction], arc)
    assert driver.player.progress.refusal is None
    assert max(speeds) <= 1.01 * shown_mm_s
    if arc or direction == "Y":
        assert max(speeds) >= 0.99 * shown_mm_s


@pytest.mark.usefixtures("qapp")
@pytest.mark.parametrize("model", MODELS)
@pytest.mark.parametrize("generation", Generation)
def test_so_it_is_with_each_arm(model, generation):
    driver, shown_mm_s, speeds = lost_mode_word(20, (0, 150, 0), False, generation, model)
    assert driver.player.progress.refusal.code in {"tool_too_fast", "too_fast"}
    assert 1 <= len(too_fast(speeds, shown_mm_s)) <= MOST_FAST


@pytest.mark.usefixtures("qapp")
@pytest.mark.parametrize("seed", [5000, 5009])
def test_a_way_at_its_own_speed_is_left_alone(seed):
    """Runs and replays at every percentage, looked at as often as the program does."""
    way = Ways(seed).way()
    driver = Driver(way.start_deg, way.model, way.generation, STREAM_S)
    request = CheckRequest(way.content, driver.arm_model(), way.start_deg, way.first, 1)
    checked = check(request)
    assert not [each for each in checked.findings if each.severity is Severity.ERROR]
    assert driver.run(replace(way, cycles=1), checked).refusal is None


def test_what_a_line_is_compared_with_is_how_the_arm_goes_there():
    """1 m/s at 100 % is the tool's limit; so short a line never reaches it."""
    way = pose_near(TOOL_HERE, (0, 150, 0))
    pace = tool_pace((way,), TOOL_HERE, ARM)
    assert 100.0 < pace.linear_mm_s < 1000.0
    assert pace.angular_deg_s < 0.1
    unknown = tool_pace((way,), None, ARM)
    assert (unknown.linear_mm_s, round(unknown.angular_deg_s, 1)) == (1000.0, 57.3)
    unheard = tool_pace((way,), None, replace(ARM, end_limits=None))
    assert (unheard.linear_mm_s, unheard.angular_deg_s) == (math.inf, math.inf)


@pytest.mark.usefixtures("qapp")
@pytest.mark.parametrize("slower", [(5,), (20,), (60, 5), (60, 50, 5)])
@pytest.mark.parametrize("known", [True, False], ids=["its pace known", "nothing known"])
def test_a_line_slowed_on_its_way_is_given_the_time_to_brake(known, slower, monkeypatch):
    """It brakes along its way, more gently than its joints can."""
    if not known:
        unknown = tool_pace((), None, replace(ARM, end_limits=None))
        monkeypatch.setattr("armui.control.context.tool_pace", lambda *_: unknown)
    driver = Driver(LINE_START, step_s=STREAM_S)
    end = driver.arm_model().kinematics.forward(LINE_START)
    point = Waypoint(MoveMode.MOVE_L, (end[0], end[1] + 250.0, *end[2:]), speed_percent=100)
    accepted(driver.player.start(Run("line", (point,), (10.0,))))
    for _ in range(40):
        driver.step()
    for percent in slower:
        driver.bus.send(
            commands.set_mode(
                driver.bus.codec,
                control_mode=ControlMode.CAN_CONTROL,
                move_mode=MoveMode.MOVE_L,
                speed_percent=percent,
            )
        )
        driver.authority.told_percent(percent)
        for _ in range(4):
            driver.step()
    for _ in range(100):
        driver.step()
    assert driver.player.progress.refusal is None
    assert driver.player.running


LOADED_BY_A_LINE = """
import sys
from unittest.mock import Mock
from armui.control.motion.cartesian import Cartesian
from armui.control.safety.overspeed import tool_pace
from tests.trajectory.arms import ARM, HERE, pose_near

Cartesian.prepare(Mock())
before = set(sys.modules)
assert tool_pace((pose_near(HERE, (0, 150, 0)),), HERE, ARM) is not None
assert tool_pace((HERE, pose_near(HERE, (0, 50, 20)), pose_near(HERE, (0, 99, 0))), HERE, ARM)
print(*sorted(set(sys.modules) - before))
"""


def test_the_first_line_finds_loaded_what_its_pace_is_found_with():
    """It is loaded before the device is opened: a quarter of a second, in the GUI thread."""
    told = subprocess.run(
        [sys.executable, "-c", LOADED_BY_A_LINE], capture_output=True, text=True, check=True
    )
    assert told.stdout.split() == []


def test_a_lower_speed_told_again_behind_an_adapter_that_was_held_up_keeps_the_line(rig):
    """The arm has not heard of the line yet and reports the mode of before."""
    controller = rig.controller
    rig.lie((0.0, 40.0, -40.0, 0.0, 20.0, 0.0))
    rig.ready()
    accepted(controller.motion.jog(1, 2.0))
    rig.run(1.5)
    rig.heard()
    rig.hold_driver()
    accepted(controller.cartesian.step(0, 30.0, JogFrame.BASE))
    accepted(controller.motion.set_speed_percent(10))
    rig.run(0.3)
    rig.free_driver()
    rig.run(0.1)
    words = [frame.data[1:3] for frame in rig.heard() if frame.arbitration_id == 0x151]
    assert words == [bytes((MoveMode.MOVE_L, percent)) for percent in (30, 10, 10)]
    assert rig.firmware.mechanics.moving
