"""Before the generation is known, only what both mean alike is known of an arm."""

from armui.arm.state import common_to_generations
from armui.arm.tracker import Tracker
from armui.protocol.codec import Codec
from armui.protocol.frame import Frame
from armui.protocol.generation import Generation

FRAMES = (
    Frame(0x2A1, bytes.fromhex("01 00 01 00 00 1E 03 01")),
    Frame(0x2A5, bytes.fromhex("00 00 2E E0 FF FF D1 20")),
    Frame(0x2A8, bytes.fromhex("00 00 C3 50 00 00 40 00")),
    Frame(0x251, bytes.fromhex("00 0A 00 05 00 00 00 00")),
    Frame(0x261, bytes.fromhex("00 F0 00 19 19 D0 00 00")),
    Frame(0x473, bytes.fromhex("01 05 DC FA 24 01 2C 00")),
)


def heard(generation):
    codec = Codec(generation)
    tracker = Tracker(codec, epoch=3)
    for frame in FRAMES:
        tracker.update(codec.decode(frame), 5.0)
    return tracker.snapshot()


def test_both_generations_give_the_same():
    one, two = (
        common_to_generations(heard(generation))._replace(invalid_frames={})
        for generation in Generation
    )
    assert one == two


def test_what_proves_that_the_arm_is_there_stays():
    state = common_to_generations(heard(Generation.TWO))
    assert (state.epoch, state.last_feedback_s, state.frames) == (3, 5.0, len(FRAMES))
    assert [angle.value for angle in state.joints_deg[:2]] == [12.0, -12.0]
    assert state.status.value.control_mode == 1
    assert state.status.value.communication_fault == (True, *(False,) * 5)
    assert state.status_heard_s[0] == 5.0


def test_what_they_mean_differently_is_not_known():
    state = common_to_generations(heard(Generation.TWO))
    assert state.status.value.trajectory_point is None
    assert not any(state.status.value.limit_exceeded)
    assert state.gripper is None
    unknown = (None,) * 6
    assert (state.drivers_slow, state.drivers_fast, state.limits) == (unknown,) * 3
