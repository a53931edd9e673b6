"""S1, S10, S11: a lower speed or a pause that is to be told once more is not, after an end.

Both are told again after 0.1 s, since a frame may be lost. What ends the motion meanwhile drops it.
"""

import can
import numpy as np
import pytest

from armui.control.run.progress import Run
from armui.control.run.replay import Replay
from armui.protocol.codes import MoveMode, TrajectoryCommand
from armui.trajectory.points.program import Waypoint
from armui.trajectory.samples.recording import Recording
from tests.accepted import accepted

HERE = (0.0, 30.0, -30.0, 0.0, 0.0, 0.0)
FAR = (140.0, 30.0, -30.0, 0.0, 0.0, 0.0)
MEANWHILE_S = 0.05
TOLD_AGAIN_S = 0.1


def single_motion(rig):
    rig.controller.motion.set_speed_percent(60)
    accepted(rig.controller.motion.send_joints(FAR))


def run(rig):
    points = [Waypoint(MoveMode.MOVE_J, FAR, speed_percent=80)]
    accepted(rig.controller.player.start(Run("run", points, [2.0])))


def replay(rig):
    """It is on the way to its first sample, joint 1 at −90°."""
    times = np.arange(0.0, 10.0, 0.01)
    samples = np.zeros((len(times), 8))
    samples[:, 0] = times
    samples[:, 1:7] = HERE
    samples[:, 1] = -90.0 + times
    samples[:, 7] = np.nan
    accepted(rig.controller.replayer.start(Replay(Recording("turn", samples=samples))))


def speed(percent):
    return lambda rig: accepted(rig.controller.motion.set_speed_percent(percent))


def override(percent):
    return lambda rig: accepted(rig.controller.motion.set_speed_percent(percent))


def planned_pause(rig):
    accepted(rig.controller.planned_motion.command(TrajectoryCommand.PAUSE))


TOLD = {
    "single, lower": (single_motion, speed(20), 0x151),
    "single, 0 %": (single_motion, speed(0), 0x151),
    "single, pause": (single_motion, planned_pause, 0x150),
    "run, lower": (run, override(50), 0x151),
    "run, 0 %": (run, override(0), 0x150),
    "run, pause": (run, lambda rig: accepted(rig.controller.player.pause()), 0x150),
    "replay, lower": (replay, override(50), 0x151),
    "replay, 0 %": (replay, override(0), 0x150),
    "replay, pause": (replay, lambda rig: accepted(rig.controller.replayer.pause()), 0x150),
}


def stop(rig):
    """The arm hears it later: until then it goes on, and so it says."""
    rig.node.link.lose_to_arm(0x150, 20)
    rig.controller.emergency_stop()


def halt(rig):
    rig.node.link.lose_to_arm(0x150, 3)
    assert rig.controller.halt_and_hold() is None


def disable(rig):
    rig.node.link.lose_to_arm(0x471)
    accepted(rig.controller.motors.disable())


def disable_one(rig):
    accepted(rig.controller.motors.disable(6))


def lose(rig):
    """The adapter is gone, and opened again at once."""
    rig.unplug(can.CanOperationError("gone"))
    rig.step()
    assert "link_lost" in rig.codes()
    rig.plug_in()
    rig.controller.disconnect_device()
    rig.controller.connect_device(rig.device)


def leave(rig):
    rig.controller.disconnect_device()
    rig.controller.connect_device(rig.device)


ENDS = [stop, halt, disable, disable_one, lose, leave]


def told(rig):
    """The speeds and pauses that went out; a pause is 0x150 byte 1 = 1."""
    return [
        (frame.arbitration_id, frame.data[:3].hex())
        for frame in rig.heard()
        if frame.arbitration_id == 0x151 or (frame.arbitration_id == 0x150 and frame.data[1] == 1)
    ]


@pytest.fixture
def arm_repeats():
    """Only what is sent to the arm counts here."""
    return False


@pytest.fixture
def under_way(any_rig):
    """Begins a motion and lets it come to its speed."""
    rig = any_rig
    rig.ready()

    def begin(start):
        start(rig)
        rig.run(0.6)
        assert rig.firmware.mechanics.moving
        rig.heard()
        return rig

    return begin


@pytest.mark.each_value(full="each telling in both generations")
@pytest.mark.parametrize("what", TOLD)
def test_it_is_told_once_more_after_0_1_s(under_way, what):
    start, tell, identifier = TOLD[what]
    rig = under_way(start)
    tell(rig)
    rig.step()
    first = told(rig)
    assert [each[0] for each in first] == [identifier]
    rig.run(TOLD_AGAIN_S)
    assert told(rig) == first
    rig.run(1.0)
    assert told(rig) == []


@pytest.mark.each_pair(full="each end after each telling, both generations")
@pytest.mark.parametrize("what", TOLD)
@pytest.mark.parametrize("end", ENDS)
def test_nothing_is_told_again_after_an_end(under_way, what, end):
    start, tell, _ = TOLD[what]
    rig = under_way(start)
    tell(rig)
    rig.step(MEANWHILE_S)
    rig.heard()
    end(rig)
    for _ in range(10):
        rig.step()
        sent = told(rig)
        # at rest the operator's speed is given back
        assert not sent or rig.controller.operating_state.at_rest, sent
