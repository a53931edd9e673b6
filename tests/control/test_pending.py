"""The life of a part's one command: begun, replaced, dropped, done, too late, or answered."""

from __future__ import annotations

import pytest

from armui.control.events import Notice
from armui.control.link.link_state import LINK_LOST
from armui.control.operations.started import Ending, Started
from armui.control.requests.pending import EndNotices, PendingRequest, PendingTransaction
from armui.control.requests.request import Request
from armui.control.requests.transactions import Transaction
from armui.protocol import commands
from armui.protocol.codes import EndLoad, SettingIndex
from armui.telemetry.events import EventKind, Level

SENT = Notice("sent", "Sent", Level.INFO, EventKind.COMMAND)
DONE = Notice("done", "Done", Level.DONE, EventKind.RESULT)
FAILED = Notice("failed", "Failed", Level.FAULT, EventKind.RESULT)
ENDS = EndNotices((DONE, {}), lambda _reason: (FAILED, {}))


@pytest.fixture
def pending(rig):
    rig.ready()
    rig.events.clear()
    return PendingRequest(rig.controller._context)


def light(rig, seen, **how):
    frames = commands.set_light(rig.controller._context.connection.codec, 1, (1, 2, 3))
    return Request(rig.controller._context, frames, seen, **how)


def test_a_request_is_under_way_until_the_feedback_shows_it(rig, pending):
    started = Started("x.y")
    shown: list[bool] = []
    request = light(rig, lambda _state: bool(shown))
    pending.begin("lit", started, request, ENDS, sent=(SENT, {}))
    rig.step()
    assert [frame.arbitration_id for frame in rig.heard()].count(0x121) == 1
    pending.advance()
    assert (pending.kind, started.ending, rig.codes()) == ("lit", None, ["sent"])
    shown.append(True)
    pending.advance()
    assert (pending.kind, started.ending, rig.codes()) == (None, Ending.DONE, ["sent", "done"])
    pending.advance()
    assert rig.codes() == ["sent", "done"]


def test_a_request_that_nothing_shows_is_late(rig, pending):
    started = Started("x.y")
    pending.begin("lit", started, light(rig, lambda _state: False, attempts=1), ENDS)
    rig.run(0.6)
    pending.advance()
    assert (pending.kind, started.ending) == (None, Ending.FAILED)
    assert rig.codes() == ["failed"]


def test_a_new_request_replaces_the_one_before(rig, pending):
    first, second = Started("x.y"), Started("x.y")
    pending.begin("first", first, light(rig, lambda _state: False), ENDS)
    pending.begin("second", second, light(rig, lambda _state: False), ENDS)
    assert (first.ending, second.ending, pending.kind) == (Ending.CUT_OFF, None, "second")
    pending.drop()
    assert (second.ending, pending.kind, rig.codes()) == (Ending.CUT_OFF, None, [])


def test_a_drop_while_it_is_told_leaves_nothing_to_send(rig, pending):
    rig.heard()
    rig.controller.noticed.connect(lambda event: event.code == "sent" and pending.drop())
    started = Started("x.y")
    pending.begin("lit", started, light(rig, lambda _state: False), ENDS, sent=(SENT, {}))
    rig.step()
    assert 0x121 not in [frame.arbitration_id for frame in rig.heard()]
    assert started.ending is Ending.CUT_OFF


def test_a_record_released_is_left_to_whoever_asked(rig, pending):
    started = Started("x.y")
    pending.begin("lit", started, light(rig, lambda _state: False), None)
    assert pending.release() is started
    assert (pending.kind, pending.started, started.ending) == (None, None, None)


def load(rig):
    codec = rig.controller._context.connection.codec
    return Transaction(commands.set_load(codec, EndLoad.FULL), index=SettingIndex.PARAMETER_COMMAND)


def answered(rig, ends):
    rig.ready()
    rig.events.clear()
    controller, started = rig.controller, Started("x.y")
    pending = PendingTransaction(controller._context, controller.transactions)
    pending.begin(started, load(rig), (SENT, {}), ends)
    assert pending.busy
    return pending, started


def test_an_answered_command_ends_with_the_answer(rig):
    ends = EndNotices((DONE, {}), lambda _reason: None, Ending.ANSWERED)
    pending, started = answered(rig, ends)
    rig.run_until(lambda: not pending.busy)
    assert (started.ending, rig.codes()) == (Ending.ANSWERED, ["sent", "done"])
    assert started.answer is not None


def test_an_answer_may_be_an_interim_result(rig):
    ends = EndNotices((DONE, {}), lambda _reason: None, is_end=lambda: False)
    pending, started = answered(rig, ends)
    rig.run_until(lambda: not pending.busy)
    assert (started.ending, started.result.code) == (None, "done")
    pending.cut_off()
    assert started.ending is Ending.CUT_OFF


@pytest.mark.parametrize("tells", [True, False])
def test_the_loss_of_the_arm_ends_it_by_its_reason(rig, tells):
    reasons = []

    def failed(reason):
        reasons.append(reason)
        return (FAILED, {}) if tells else None

    pending, started = answered(rig, EndNotices((DONE, {}), failed))
    rig.controller.transactions.forget_arm()
    assert ([each.reason for each in reasons], pending.busy) == ([LINK_LOST], False)
    assert (started.ending, "failed" in rig.codes()) == (Ending.CUT_OFF, tells)
