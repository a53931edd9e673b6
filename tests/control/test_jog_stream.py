"""The promise of the pace, kept by any arm and any timing: rest within τ + v/a, never beyond."""

from hypothesis import given, settings
from hypothesis import strategies as st

from armui.arm.limits import JointLimits
from armui.arm.state import Reading
from armui.control.motion.jog_pace import REST_S, accelerations, pace
from armui.control.motion.jog_path import JointJog, JointJogPath
from armui.control.motion.jog_stream import JOG_NOT_FOLLOWING, JogStream
from armui.sim.mechanics.powered_joints import JointMotion
from tests.examples import examples
from tests.family import FACTORY_ACCELERATION_DEG_S2

BASE_DEG = (0.0, 90.0, -90.0, 0.0, 0.0, 0.0)


class Arm:
    """Joints that follow targets as fast as they may, and a host that sees them late."""

    def __init__(self, limits, acceleration, age):
        self.motion = JointMotion(BASE_DEG)
        self.limits = limits
        self.accelerations = (acceleration,) * 6
        self.seen: list[tuple[float, ...]] = [BASE_DEG] * (age + 1)

    @property
    def measured_deg(self):
        return self.seen[0]

    def hear(self, target_deg, percent):
        speeds = [percent / 100 * each.max_speed_deg_s for each in self.limits]
        self.motion.move_to(target_deg, speeds, self.accelerations)

    def pass_time(self, milliseconds):
        for _ in range(milliseconds):
            self.motion.step(0.001)
            self.seen = [*self.seen[1:], self.motion.positions_deg]

    def rest_ms(self):
        for count in range(300):
            if not self.motion.moving:
                return count
            self.motion.step(0.001)
        raise AssertionError("it never rests")


@settings(max_examples=examples(60), deadline=None)
@given(
    ticks_ms=st.lists(st.integers(4, 40), min_size=1, max_size=60),
    percent=st.integers(1, 100),
    acceleration=st.floats(20.0, 280.0),
    max_speed=st.floats(5.0, 180.0),
    age_ms=st.integers(0, 30),
    joint=st.integers(1, 6),
    direction=st.sampled_from((-1, 1)),
)
def test_an_arm_left_alone_rests_in_time(
    ticks_ms, percent, acceleration, max_speed, age_ms, joint, direction
):
    limits = (JointLimits(-100.0, 100.0, max_speed),) * 6
    arm = Arm(limits, acceleration, age_ms)
    way = JointJogPath(JointJog(joint, direction).rates, BASE_DEG, limits)
    stream = JogStream(way, BASE_DEG, BASE_DEG)
    now = pace(percent, limits, arm.accelerations)
    for tick_ms in ticks_ms:
        arm.pass_time(tick_ms)
        assert stream.advance_setpoint(arm.measured_deg, tick_ms / 1e3, now) is None
        arm.hear(stream.setpoint_deg, now.arm_percent)
    assert arm.rest_ms() <= 1e3 * REST_S + 1
    ahead = direction * (stream.setpoint_deg[joint - 1] - BASE_DEG[joint - 1])
    assert ahead > 0.0


def test_the_setpoint_waits_for_an_arm_that_stands():
    limits = (JointLimits(-100.0, 100.0, 170.0),) * 6
    now = pace(100, limits, (200.0,) * 6)
    stream = JogStream(JointJogPath(JointJog(1, 1).rates, BASE_DEG, limits), BASE_DEG, BASE_DEG)
    reasons = [stream.advance_setpoint(BASE_DEG, 0.01, now) for _ in range(70)]
    assert 0.9 * now.leads_deg[0] < stream.setpoint_deg[0] <= now.leads_deg[0]
    assert reasons[:40] == [None] * 40
    assert reasons[-1].reason == JOG_NOT_FOLLOWING


def test_a_joint_that_sags_under_load_is_not_pulled_back():
    limits = (JointLimits(-100.0, 100.0, 170.0),) * 6
    now = pace(10, limits, (200.0,) * 6)
    sagging_deg = (-0.3, *BASE_DEG[1:])
    stream = JogStream(JointJogPath(JointJog(1, 1).rates, BASE_DEG, limits), BASE_DEG, sagging_deg)
    assert stream.advance_setpoint(sagging_deg, 0.01, now) is None
    assert stream.setpoint_deg[0] > BASE_DEG[0]


def test_a_corrupt_acceleration_is_not_relied_on():
    heard = (None, Reading(65535.0, 1.0), Reading(0.0, 1.0), Reading(100.0, 1.0), None, None)
    factory = FACTORY_ACCELERATION_DEG_S2
    braking = accelerations(heard, (factory,) * 6)
    assert braking == (factory, factory, factory, 100.0, factory, factory)


def test_a_model_whose_joints_brake_harder_or_softer_is_jogged_by_its_own_table():
    of_model = (100.0, 200.0, 300.0, 400.0, 500.0, 600.0)
    assert accelerations((None,) * 6, of_model) == of_model
    heard = tuple(Reading(350.0, 1.0) for _ in range(6))
    assert accelerations(heard, of_model) == (100.0, 200.0, 300.0, 350.0, 350.0, 350.0)
