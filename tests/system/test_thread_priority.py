"""Window, bus and stop go before other programs, where the system lets them."""

from __future__ import annotations

import json
import logging
import os
import subprocess
import sys
import threading
from typing import Any

import pytest
from jeepney import Message, new_error, new_method_return
from jeepney.io import blocking

from armui.system import thread_priority
from armui.system.thread_priority import NICE, RaisedBy, Rise, raise_threads

pytestmark = pytest.mark.skipif(sys.platform != "linux", reason="nice values of threads")

PROGRAM = """
import json, os, subprocess, sys, threading
from armui.system.thread_priority import raise_threads

def nice():
    return os.getpriority(os.PRIO_PROCESS, threading.get_native_id())

def older():
    begun.set()
    raised.wait()
    told["older"] = nice()

told, begun, raised = {}, threading.Event(), threading.Event()
before = threading.Thread(target=older)
before.start()
begun.wait()
rise = raise_threads()
raised.set()
before.join()
told |= {"by": rise.by.value, "reason": rise.reason, "first": nice()}
told["child"] = int(subprocess.run(["nice"], capture_output=True, check=True).stdout)
newer = threading.Thread(target=lambda: told.update(newer=nice()))
newer.start()
newer.join()
raise_threads()
told["again"] = nice()
print(json.dumps(told))
"""


def test_every_thread_there_is_and_nothing_that_it_begins():
    done = subprocess.run([sys.executable, "-c", PROGRAM], capture_output=True, check=True)
    told = json.loads(done.stdout)
    nice = 0 if told["by"] == RaisedBy.NOBODY.value else NICE
    assert (told["first"], told["older"], told["again"]) == (nice, nice, nice)
    assert told["child"] == 0
    assert told["newer"] == 0
    assert bool(told["reason"]) == (told["by"] == RaisedBy.NOBODY.value)


class FakeBus:
    """A D-Bus on which somebody answers for rtkit."""

    def __init__(self, refusal: str = "") -> None:
        self._refusal = refusal
        self.asked: list[Message] = []

    def __enter__(self) -> FakeBus:
        return self

    def __exit__(self, *_: object) -> None:
        pass

    def send_and_get_reply(self, call: Message, *, timeout: float) -> Message:
        assert timeout > 0
        call.header.serial = len(self.asked) + 1
        self.asked.append(call)
        if self._refusal:
            return new_error(call, "org.freedesktop.DBus.Error.AccessDenied", "s", (self._refusal,))
        return new_method_return(call)


@pytest.fixture
def no_right(monkeypatch: pytest.MonkeyPatch) -> None:
    def refuse(*_: Any) -> None:
        raise PermissionError(13, "Permission denied")

    monkeypatch.setattr(os, "setpriority", refuse)


@pytest.mark.usefixtures("no_right")
def test_without_the_right_rtkit_is_asked_for_each_thread(monkeypatch: pytest.MonkeyPatch):
    bus = FakeBus()
    monkeypatch.setattr(blocking, "open_dbus_connection", lambda **_: bus)
    waiting = threading.Event()
    thread = threading.Thread(target=waiting.wait)
    thread.start()
    try:
        assert raise_threads([thread.native_id or 0]) == Rise(RaisedBy.RTKIT)
    finally:
        waiting.set()
        thread.join()
    (call,) = bus.asked
    assert call.body == (os.getpid(), thread.native_id, NICE)
    fields = {name.name: value for name, value in call.header.fields.items()}
    assert fields["member"] == "MakeThreadHighPriorityWithPID"
    assert fields["signature"] == "tti"
    call.serialise()  # the numbers fit the signature


@pytest.mark.usefixtures("no_right")
def test_a_refusal_is_told_in_the_systems_words(monkeypatch: pytest.MonkeyPatch, caplog):
    bus = FakeBus(refusal="not at the seat")
    monkeypatch.setattr(blocking, "open_dbus_connection", lambda **_: bus)
    rise = raise_threads([threading.get_native_id()])
    assert rise.by is RaisedBy.NOBODY
    assert "not at the seat" in rise.reason
    with caplog.at_level(logging.INFO):
        thread_priority.raise_in_background()
        for thread in threading.enumerate():
            if thread.name == "armui-priority":
                thread.join()
    assert "not at the seat" in caplog.text


@pytest.mark.usefixtures("no_right")
def test_a_system_without_d_bus_keeps_the_program_as_it_is(monkeypatch: pytest.MonkeyPatch):
    monkeypatch.setenv("DBUS_SYSTEM_BUS_ADDRESS", "unix:path=/nowhere")
    rise = raise_threads([threading.get_native_id()])
    assert rise.by is RaisedBy.NOBODY
    assert rise.reason
