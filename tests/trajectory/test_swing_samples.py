"""The samples of a joint inspection: even, slow, each joint in its turn, back where it began."""

import numpy as np
import pytest

from armui.trajectory.samples.swing_samples import speed_at, swing_recording
from armui.ways.swings import Swing

BEGIN = (10.0, 70.0, -60.0, 0.0, 20.0, 5.0)
SWINGS = (Swing(1, 20.0, 20.0), Swing(4, 0.0, 15.0), Swing(6, 10.0, 5.0))


@pytest.mark.parametrize("share", [0.05, 0.3, 1.0])
def test_each_joint_swings_in_its_window_and_no_other_one_does(share):
    recording, windows, _speed = swing_recording("x", BEGIN, SWINGS, share)
    assert [each.joint for each in windows] == [1, 4, 6]
    for swing, window in zip(SWINGS, windows, strict=True):
        inside = (recording.times_s > window.begin_s) & (recording.times_s <= window.end_s)
        turned = recording.joints_deg[inside] - np.array(BEGIN)
        place = swing.joint - 1
        assert turned[:, place].min() == pytest.approx(-swing.below_deg)
        assert turned[:, place].max() == pytest.approx(swing.above_deg)
        assert not np.delete(turned, place, axis=1).any()
        assert turned[-1] == pytest.approx(np.zeros(6))
    assert windows[-1].end_s == pytest.approx(recording.duration_s)


@pytest.mark.parametrize("share", [0.05, 0.2, 0.3, 1.0])
def test_it_goes_at_10_deg_s_at_most_when_it_is_replayed_at_its_share(share):
    recording, _windows, speed = swing_recording("x", BEGIN, SWINGS, share)
    times_s = recording.times_s / share
    speeds = np.abs(np.diff(recording.joints_deg, axis=0)) / np.diff(times_s)[:, None]
    assert speeds.max() == pytest.approx(speed, rel=0.01)
    assert speed == speed_at(share) == pytest.approx(min(10.0, 50.0 * share))
    assert (np.diff(times_s) > 0.0).all()
