"""The latest wins; the receiver sets the pace."""

import threading

import pytest

from armui.viewport.process_link import Mailbox

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
    assert box._item is None


def test_a_sleeping_reader_wakes_for_an_item(box):
    reader = Reader(box)
    box.put("a")
    assert reader.result() == "a"


def test_one_result_may_lie_unused_but_not_two(box):
    assert box.result_sent() == 1
    box.put("a")
    assert box.take() == "a"
    assert box.result_sent() == 2
    reader = Reader(box)
    box.put("b")
    assert not reader.taken
    box.acknowledge(1)
    assert reader.result() == "b"


def test_what_is_used_last_counts_for_those_before(box):
    for _ in range(4):
        box.result_sent()
    box.put("a")
    reader = Reader(box)
    box.acknowledge(4)
    assert reader.result() == "a"


def test_results_of_a_process_that_is_gone_do_not_count(box):
    box.result_sent()
    box.result_sent()
    box.reset_results()
    box.put("a")
    assert box.take() == "a"


def test_waiting_ends_when_time_is_up(box):
    assert box.take(timeout_s=0.0) is None
    assert not box.is_closed


def test_an_interrupted_reader_does_not_sleep_until_it_may(box):
    reader = Reader(box)
    box.interrupt()
    assert reader.result() is None
    box.put("a")
    assert box.take() is None
    assert box._item is not None
    box.resume()
    assert box.take() == "a"


def test_closing_wakes_the_reader_even_with_an_item_and_results_unused(box):
    box.result_sent()
    box.result_sent()
    box.put("a")
    reader = Reader(box)
    box.close()
    assert reader.result() is None
    assert box.is_closed
