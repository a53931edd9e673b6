"""The latest wins; the receiver sets the pace."""

import threading

import pytest

from armui.viewport.mailbox import Mailbox

LIMIT_S = 5.0


class Reader(threading.Thread):
    """Takes once in a thread of its own."""

    def __init__(self, box: Mailbox[str]) -> None:
        super().__init__(daemon=True)
        self._box = box
        self.taken: list[str | None] = []
        self.start()

    def run(self) -> None:
        self.taken.append(self._box.take())

    def result(self) -> str | None:
        self.join(LIMIT_S)
        assert not self.is_alive()
        return self.taken[0]


@pytest.fixture
def box():
    box: Mailbox[str] = Mailbox()
    yield box
    box.close()


def test_only_the_latest_is_kept(box):
    for item in ("a", "b", "c"):
        box.put(item)
    assert box.take() == "c"
    assert box.take_at_once() is None
    assert not box.has_item


def test_a_sleeping_reader_wakes_for_an_item(box):
    reader = Reader(box)
    box.put("a")
    assert reader.result() == "a"


def test_nothing_is_taken_while_a_result_is_pending(box):
    box.result_sent()
    box.put("a")
    assert box.is_result_pending
    assert box.take_at_once() is None
    reader = Reader(box)
    box.put("b")
    assert not reader.taken
    box.acknowledge()
    assert reader.result() == "b"


def test_waiting_ends_when_time_is_up(box):
    assert box.take(timeout_s=0.0) is None
    assert not box.is_closed


def test_time_does_not_run_while_a_result_is_pending(box):
    box.result_sent()
    woken = threading.Event()

    def wait() -> None:
        box.take(timeout_s=0.0)
        woken.set()

    threading.Thread(target=wait, daemon=True).start()
    assert not woken.wait(0.02)
    box.acknowledge()
    assert woken.wait(LIMIT_S)


def test_closing_wakes_the_reader_even_with_an_item_and_a_result_pending(box):
    box.result_sent()
    box.put("a")
    reader = Reader(box)
    box.close()
    assert reader.result() is None
    assert box.is_closed
