"""Which time is shown: zoom, pause, undo."""

import pytest
from hypothesis import given
from hypothesis import strategies as st
from hypothesis.stateful import RuleBasedStateMachine, invariant, rule

from armui.telemetry.series import KEPT_S
from armui.ui.watch.time_frame import FIRST_SPAN_S, SPANS_S, TimeFrame


def ends(frame):
    return frame.shown.begin_s, frame.shown.end_s


def test_it_begins_live():
    frame = TimeFrame()
    assert frame.live
    assert ends(frame) == (-FIRST_SPAN_S, 0.0)
    assert frame.edge_s(123.0) == 123.0
    assert not frame.can_undo


def test_a_pause_keeps_the_moment():
    frame = TimeFrame()
    frame.pause(100.0)
    assert frame.edge_s(150.0) == 100.0
    frame.pause(160.0)
    assert frame.edge_s(170.0) == 100.0
    frame.resume()
    assert frame.edge_s(170.0) == 170.0


def test_zooming_stands_still_and_is_undone_step_by_step():
    frame = TimeFrame()
    frame.zoom(100.0, -20.0, -10.0)
    frame.zoom(105.0, -12.0, -15.0, axis=(2, "A"), heights=(1.0, 2.0))
    assert ends(frame) == (-15.0, -12.0)
    assert frame.edge_s(200.0) == 100.0
    assert frame.shown.ranges == {(2, "A"): (1.0, 2.0)}
    frame.undo()
    assert ends(frame) == (-20.0, -10.0)
    assert frame.shown.ranges == {}
    frame.undo()
    assert frame.live
    assert ends(frame) == (-FIRST_SPAN_S, 0.0)
    frame.undo()
    assert frame.live


def test_too_small_a_frame_is_a_click():
    frame = TimeFrame()
    frame.zoom(100.0, -10.0, -9.999)
    assert frame.live


@pytest.mark.parametrize("span_s", SPANS_S)
def test_a_span_ends_where_it_ended(span_s):
    frame = TimeFrame()
    frame.set_span(span_s)
    assert frame.live
    assert ends(frame) == (-span_s, 0.0)
    frame.zoom(100.0, -4.0, -2.0)
    frame.set_span(span_s)
    assert ends(frame) == (-2.0 - span_s, -2.0)


def test_the_wheel_keeps_the_place_under_the_mouse_and_the_present():
    frame = TimeFrame()
    frame.wheel(2.0, -10.0)
    assert ends(frame) == (-2 * FIRST_SPAN_S, 0.0)
    frame.zoom(100.0, -20.0, -10.0)
    frame.wheel(0.5, -12.0)
    assert ends(frame) == (-16.0, -11.0)
    frame.wheel(0.5, -12.0)
    # one gesture is undone at once
    frame.undo()
    assert ends(frame) == (-20.0, -10.0)


def test_two_gestures_are_two_steps():
    frame = TimeFrame()
    frame.pause(100.0)
    frame.pan(100.0, -5.0)
    frame.pan(100.0, -5.0)
    frame.settle()
    frame.pan(100.0, -5.0)
    assert frame.shown.end_s == -15.0
    frame.undo()
    assert frame.shown.end_s == -10.0
    frame.undo()
    assert frame.shown.end_s == 0.0


def test_a_moment_comes_into_sight():
    frame = TimeFrame()
    frame.show_moment(1000.0, 990.0)
    assert frame.live
    frame.show_moment(1000.0, 500.0)
    assert frame.edge_s(2000.0) == 1000.0
    assert ends(frame) == (-515.0, -485.0)


class Gestures(RuleBasedStateMachine):
    """Whatever the operator does, a time within what is kept is shown, and undo leads back."""

    def __init__(self):
        super().__init__()
        self.frame = TimeFrame()
        self.now_s = 5000.0

    @rule(begin_s=st.floats(-2000, 10), end_s=st.floats(-2000, 10))
    def zoom(self, begin_s, end_s):
        self.frame.zoom(self.now_s, begin_s, end_s)

    @rule(factor=st.floats(0.1, 10), at_s=st.floats(-2000, 0))
    def wheel(self, factor, at_s):
        self.frame.wheel(factor, at_s)

    @rule(by_s=st.floats(-3000, 3000))
    def pan(self, by_s):
        self.frame.pan(self.now_s, by_s)

    @rule(span_s=st.sampled_from(SPANS_S))
    def span(self, span_s):
        self.frame.set_span(span_s)

    @rule(seconds=st.floats(0, 100))
    def pass_time(self, seconds):
        self.now_s += seconds

    @rule()
    def pause(self):
        self.frame.pause(self.now_s)

    @rule()
    def resume(self):
        self.frame.resume()

    @rule()
    def undo(self):
        self.frame.undo()

    @invariant()
    def it_shows_some_time_and_no_future(self):
        begin_s, end_s = ends(self.frame)
        assert begin_s < end_s <= 0.0
        assert end_s - begin_s >= 0.0199
        assert self.frame.edge_s(self.now_s) <= self.now_s

    def teardown(self):
        for _ in range(200):
            self.frame.undo()
        assert not self.frame.can_undo


TestGestures = Gestures.TestCase


@given(st.floats(0.001, 1e5))
def test_a_span_is_no_longer_than_what_is_kept(span_s):
    frame = TimeFrame()
    frame.set_span(span_s)
    assert frame.shown.span_s <= KEPT_S
