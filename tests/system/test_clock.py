"""The program's clock goes on while the computer sleeps."""

import sys
import time

import pytest

from armui.bus.outbox import Outbox
from armui.bus.worker import BusWorker
from armui.control.arm_controller import ArmController
from armui.system.clock import steady_s
from tests.posix import of_system


def test_it_never_goes_back():
    times = [steady_s() for _ in range(1000)]
    assert times == sorted(times)


@pytest.mark.skipif(sys.platform != "linux", reason="the clock of Linux")
def test_on_linux_it_counts_the_time_asleep(monkeypatch):
    asked = []

    def answer(clock):
        asked.append(clock)
        return 5.0

    monkeypatch.setattr(time, "clock_gettime", answer)
    assert steady_s() == 5.0
    assert asked == [of_system("CLOCK_BOOTTIME", time)]


@pytest.mark.parametrize("user", [ArmController, BusWorker, Outbox])
def test_all_that_speak_to_the_arm_go_by_it(user):
    names = user.__init__.__code__.co_varnames[1 : user.__init__.__code__.co_argcount]
    defaults = user.__init__.__defaults__
    assert dict(zip(names[-len(defaults) :], defaults, strict=True))["clock"] is steady_s
