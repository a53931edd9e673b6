"""A driver that keeps what it is given, and one in which a frame hangs."""

import errno
import threading
import time

import can

from tests.bus.test_outbox import Wire

LIMIT_S = 5.0
FULL = can.CanTimeoutError("full")
GONE = can.CanOperationError("gone", error_code=errno.ENODEV)


class Driver(Wire):
    """Keeps what it is given, and how; the test decides what happens meanwhile."""

    def __init__(self):
        super().__init__()
        self.timeouts = []
        self.extended = []
        self.senders = []
        self.flushed = 0

    def send(self, message, timeout=None):
        self.timeouts.append(timeout)
        self.extended.append(message.is_extended_id)
        self.senders.append(threading.current_thread())
        super().send(message, timeout)

    def flush_tx_buffer(self):
        self.flushed += 1


def took_s(act):
    began_s = time.monotonic()
    act()
    return time.monotonic() - began_s


def quickest_s(act):
    """Of several times, so that a busy computer's other work tells nothing."""
    return min(took_s(act) for _ in range(10))


class InDriver:
    """A frame that hangs in the driver, sent by a thread of its own."""

    def __init__(self, outbox, driver):
        self.hangs, self.let_go = threading.Event(), threading.Event()

        def hang():
            driver.on_send = lambda: None
            self.hangs.set()
            self.let_go.wait(LIMIT_S)

        driver.on_send = hang
        self.thread = threading.Thread(target=outbox.send_waiting)

    def __enter__(self):
        self.thread.start()
        assert self.hangs.wait(LIMIT_S)
        return self

    def __exit__(self, *_args):
        self.let_go.set()
        self.thread.join(LIMIT_S)
