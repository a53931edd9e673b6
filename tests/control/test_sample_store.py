"""What a recorder keeps can be saved, however the times of its samples came."""

from armui.bus.samples import Sample
from armui.control.run.sample_store import SampleStore
from armui.trajectory.samples.recording import check_recording


def test_samples_whose_time_goes_back_are_left_out():
    store = SampleStore()
    times_s = (7.0, 7.687, 7.581, 7.581, 7.687, 7.7)
    store.extend([Sample(at_s, (float(k),) * 6, None) for k, at_s in enumerate(times_s)])
    recording = store.recorded("busy").joined()
    assert check_recording(recording) is None
    assert recording.joints_deg[:, 0].tolist() == [0.0, 1.0, 4.0, 5.0]
    assert recording.times_s.tolist() == [each - 7.0 for each in (7.0, 7.687, 7.687, 7.7)]
    assert store.duration_s == recording.duration_s
