"""The joint inspection judges arms that are each another; `tests.inspected_arms` has more."""

from armui.arm.inspection_record import JointSign
from tests.inspected_arms import Arm, inspect, judged

HEALTHY = range(30)


def test_no_healthy_arm_is_called_conspicuous(monkeypatch):
    monkeypatch.setattr("tests.inspected_arms.AMPLITUDES_DEG", (10.0,))
    monkeypatch.setattr("tests.inspected_arms.PLACES", ((0, 70, -60, 0, 20, 0),))
    assert [number for number in HEALTHY if any(judged(Arm(number)))] == []
    stiff = [(1 + number % 6, judged(Arm(number, 1 + number % 6, 4.0))) for number in HEALTHY]
    for joint, (at_first, with_earlier) in stiff:
        assert {each.joint for each in at_first} == {joint}
        assert {(joint, JointSign.CURRENT, True)} <= {
            (f.joint, f.sign, f.earlier) for f in with_earlier
        }


def test_the_same_arm_on_another_day_is_nearly_the_same(monkeypatch):
    monkeypatch.setattr("tests.inspected_arms.AMPLITUDES_DEG", (10.0,))
    monkeypatch.setattr("tests.inspected_arms.PLACES", ((0, 70, -60, 0, 20, 0),))
    one, other = inspect(Arm(1)), inspect(Arm(1), day=1)
    assert one != other
    for here, there in zip(one.joints, other.joints, strict=True):
        assert here is not None
        assert there is not None
        assert abs(here.behind_deg - there.behind_deg) < 0.1
