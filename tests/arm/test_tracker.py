"""Literal frames in, a snapshot of the arm out."""

import pytest

from armui.arm.state import FRESH_FOR_S, common_to_generations, is_fresh
from armui.arm.tracker import Tracker
from armui.protocol.codec import Codec
from armui.protocol.frame import Frame
from armui.protocol.generation import Generation


class Listener:
    """A tracker that is fed with bytes."""

    def __init__(self, generation):
        self.codec = Codec(generation)
        self.tracker = Tracker(self.codec)

    def hear(self, arbitration_id, payload, at_s=1.0):
        self.tracker.update(self.codec.decode(Frame(arbitration_id, bytes.fromhex(payload))), at_s)
        return self.tracker.snapshot()


@pytest.fixture(params=[Generation.ONE, Generation.TWO], ids=["gen1", "gen2"])
def listener(request):
    return Listener(request.param)


def test_nothing_heard_is_nothing_known(listener):
    snapshot = listener.tracker.snapshot()
    assert snapshot.status is None
    assert snapshot.angles_deg() is None
    assert snapshot.end_pose() is None
    assert snapshot.enabled() == (None,) * 6
    assert snapshot.last_feedback_s is None


def test_joint_angles_are_complete_only_when_all_three_frames_were_heard(listener):
    # 0x00002EE0 = 12000 -> 12 deg; 0xFFFFD120 = -12000 -> -12 deg
    listener.hear(0x2A5, "00002EE0 FFFFD120")
    assert listener.hear(0x2A6, "00000001 00000000").angles_deg() is None
    snapshot = listener.hear(0x2A7, "00000000 FFFFFFFF", at_s=3.0)
    assert snapshot.angles_deg() == (12.0, -12.0, 0.001, 0.0, 0.0, -0.001)
    assert [heard.at_s for heard in snapshot.joints_deg] == [1, 1, 1, 1, 3, 3]


def test_the_end_pose_comes_in_three_frames(listener):
    listener.hear(0x2A2, "0000DB40 00000000")  # 56128 -> 56.128 mm
    listener.hear(0x2A3, "00034112 00000000")  # 213266 -> 213.266 mm
    snapshot = listener.hear(0x2A4, "00014C08 00000000")  # 85000 -> 85 deg
    assert snapshot.end_pose() == (56.128, 0, 213.266, 0, 85, 0)


def test_a_driver_reports_its_motor_enabled(listener):
    # 24.0 V, 31 degC, 29 degC, bit 6 enabled
    snapshot = listener.hear(0x263, "00F0 001F 1D 40 0000")
    assert snapshot.enabled() == (None, None, True, None, None, None)
    driver = snapshot.drivers_slow[2].value
    assert (driver.voltage_v, driver.driver_temperature_c, driver.motor_temperature_c) == (
        24,
        31,
        29,
    )


def test_byte_5_of_the_status_is_the_speed_in_generation_1():
    status = Listener(Generation.ONE).hear(0x2A1, "01 00 01 00 01 1E 00 02").status.value
    assert (status.control_mode, status.arm_status, status.move_mode) == (1, 0, 1)
    assert not status.reached
    assert (status.speed_percent, status.trajectory_point) == (30, None)
    assert status.communication_fault == (False, True, False, False, False, False)


def test_byte_5_of_the_status_is_a_trajectory_point_in_generation_2():
    status = Listener(Generation.TWO).hear(0x2A1, "01 04 01 00 00 1E 21 00").status.value
    assert (status.speed_percent, status.trajectory_point) == (None, 30)
    assert status.reached
    assert status.limit_exceeded == (True, False, False, False, False, True)


@pytest.mark.parametrize(
    ("generation", "payload", "max_speed_deg_s"),
    [
        # joint 2: max 180.0, min 0.0; 28 rpm = 168 deg/s
        (Generation.ONE, "02 0708 0000 001C 00", 168.0),
        # 300 * 0.01 rad/s = 3 rad/s
        (Generation.TWO, "02 0708 0000 012C 00", 171.887338539),
    ],
)
def test_limits_are_degrees_whatever_is_on_the_wire(generation, payload, max_speed_deg_s):
    limits = Listener(generation).hear(0x473, payload).limits[1].value
    assert (limits.min_deg, limits.max_deg) == (0, 180)
    assert limits.max_speed_deg_s == pytest.approx(max_speed_deg_s)


def test_the_version_text_is_joined_from_several_frames():
    listener = Listener(Generation.TWO)
    assert listener.hear(0x4AF, "48 2D 56 31 0A 53 2D 56").firmware is None  # "H-V1\nS-V"
    assert listener.hear(0x4AF, "31 2E 38 2D 35 0A 00 00").firmware == "S-V1.8-5"  # "1.8-5\n"


def test_what_is_not_understood_is_counted_and_changes_nothing_else(listener):
    before = listener.hear(0x2A5, "00002EE0 00000000")
    listener.hear(0x2A5, "00 01")
    listener.hear(0x7FF, "00")
    snapshot = listener.hear(0x2A5, "", at_s=9.0)
    assert snapshot.invalid_frames == {"WRONG_LENGTH": 2, "UNKNOWN_ID": 1}
    assert snapshot.joints_deg == before.joints_deg
    assert snapshot.last_feedback_s == 1.0
    assert snapshot.frames == 4


def test_a_code_outside_the_table_is_counted_and_still_shown(listener):
    snapshot = listener.hear(0x2A1, "01 2F 01 00 00 00 00 00")
    assert snapshot.invalid_frames == {"VALUE_OUTSIDE_TABLE": 1}
    assert snapshot.status.value.arm_status == 0x2F


def test_a_snapshot_stays_the_same_object_until_something_is_heard(listener):
    first = listener.hear(0x2A5, "00002EE0 00000000")
    assert listener.tracker.snapshot() is first
    assert listener.hear(0x2A5, "00002EE0 00000000").sequence > first.sequence


def test_an_arm_is_online_for_half_a_second_after_its_last_frame(listener):
    snapshot = listener.hear(0x2A5, "00002EE0 00000000", at_s=10.0)
    assert is_fresh(snapshot.last_feedback_s, 10.0 + FRESH_FOR_S)
    assert not is_fresh(snapshot.last_feedback_s, 10.0 + FRESH_FOR_S + 0.001)


def test_the_programs_own_commands_do_not_make_an_arm_online(listener):
    # another host's joint target on the bus
    assert listener.hear(0x155, "00002EE0 00000000").last_feedback_s is None


TARGETS = (0x155, 0x156, 0x157)


@pytest.mark.parametrize("offset", [0x00, 0x10, 0x20])
def test_another_senders_joint_targets_are_noticed_whatever_their_offset(listener, offset):
    for at_s, target_id in enumerate(TARGETS, start=2):
        snapshot = listener.hear(target_id + offset, "00002EE0 00000000", at_s=float(at_s))
    assert snapshot.foreign_targets_s == 2.0
    assert snapshot.last_feedback_s is None


def test_a_stray_joint_target_makes_no_teaching_input(listener):
    listener.hear(0x155, "00002EE0 00000000")
    listener.hear(0x156, "00002EE0 00000000")
    assert listener.hear(0x155, "00002EE0 00000000", at_s=5.0).foreign_targets_s is None


def test_what_an_arm_keeps_is_read_in_the_operators_units(listener):
    # 500 -> 0.5 m/s, 1000 -> 1 rad/s, 1500 -> 1.5 m/s², 65535 -> 65.535 rad/s²
    limits = listener.hear(0x478, "01F4 03E8 05DC FFFF").end_limits.value
    assert (limits.max_linear_speed_m_s, limits.max_angular_speed_rad_s) == (0.5, 1.0)
    assert limits.max_linear_acceleration_m_s2 == 1.5
    assert limits.max_angular_acceleration_rad_s2 == 65.535
    assert listener.hear(0x47B, "01 02 03 08 00 01 00 00").collision_levels.value == (
        *(1, 2, 3),
        *(8, 0, 1),
    )


def test_generation_2_keeps_a_teaching_handle():
    listener = Listener(Generation.TWO)
    handle = listener.hear(0x47E, "96 46 05 00 00 00 00 00").teaching_handle.value
    assert (handle.range_percent, handle.stroke_limit_mm, handle.friction) == (150, 70, 5)


def test_a_corrupt_memory_is_shown_as_it_was_read(listener):
    snapshot = listener.hear(0x47B, "FF FF FF FF FF FF 00 00")
    assert snapshot.collision_levels.value == (255,) * 6


def test_the_motion_of_the_end_comes_a_joint_a_frame(listener):
    # 100 -> 0.1 m/s, 200 -> 0.2 rad/s, 300 -> 0.3 m/s², 400 -> 0.4 rad/s²
    motion = listener.hear(0x483, "0064 00C8 012C 0190").end_motion[2].value
    assert (motion.linear_speed_m_s, motion.angular_speed_rad_s) == (0.1, 0.2)
    assert (motion.linear_acceleration_m_s2, motion.angular_acceleration_rad_s2) == (0.3, 0.4)


def heard_around_a_pause(listener, after, pause_s, at_s=10.0):
    """Joint 1 at 12° before the pause, at `after` in 0.001° (hex) behind it."""
    listener.hear(0x2A5, "00002EE0 00000000", at_s=at_s)
    return listener.hear(0x2A5, f"{after} 00000000", at_s=at_s + pause_s)


def test_a_short_pause_is_counted_and_is_no_silence(listener):
    snapshot = heard_around_a_pause(listener, "00002EE0", 0.2)
    assert (snapshot.pauses, snapshot.silences) == (1, 0)
    assert heard_around_a_pause(listener, "00002EE0", 0.09, at_s=10.25).pauses == 1


def test_an_angle_that_no_joint_could_have_reached_is_another_arm(listener):
    # 0x0001D4C0 = 120.000°: 108° in 0.2 s; 300°/s and 5° would be 65°
    assert heard_around_a_pause(listener, "0001D4C0", 0.2).silences == 1


def test_a_joint_that_moved_in_a_pause_is_the_same_arms(listener):
    # 0x0000EA60 = 60.000°
    assert heard_around_a_pause(listener, "0000EA60", 0.2).silences == 0


def test_a_zero_that_was_set_in_a_pause_is_the_same_arms(listener):
    # from 0x0001D4C0 = 120° to 0°
    listener.hear(0x2A5, "0001D4C0 00000000", at_s=10.0)
    assert listener.hear(0x2A5, "00000000 00000000", at_s=10.2).silences == 0


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
