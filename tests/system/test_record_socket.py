"""Records between two processes: whole, in order, and nobody waits for longer than it asks for."""

import socket
import time

import pytest

from armui.system.record_socket import RecordSocket

SIZE = 4


@pytest.fixture
def pair():
    """Both ends of a line; the second as a bare socket."""
    ours, theirs = socket.socketpair()
    line = RecordSocket(ours, SIZE)
    yield line, theirs
    line.close()
    theirs.close()


def fill(line):
    """Send until the line takes no more; returns how many records it took."""
    for count in range(1_000_000):
        try:
            line.send(b"abcd")
        except TimeoutError:
            return count
    raise AssertionError("it takes anything")


def test_several_records_travel_in_one_message(pair):
    line, theirs = pair
    line.send(b"abcdefgh")
    assert theirs.recv(100) == b"abcdefgh"
    theirs.sendall(b"ijklmnop")
    assert line.receive(1.0) == b"ijklmnop"


def test_half_a_record_waits_for_its_rest(pair):
    line, theirs = pair
    theirs.sendall(b"abcdef")
    assert line.receive(1.0) == b"abcd"
    assert line.receive() == b""
    theirs.sendall(b"gh")
    assert line.receive(1.0) == b"efgh"


def test_nothing_has_arrived(pair):
    line, _theirs = pair
    assert line.receive() == b""
    began_s = time.monotonic()
    assert line.receive(0.05) == b""
    assert 0.04 < time.monotonic() - began_s < 5.0


def test_a_flood_is_read_in_parts(pair):
    line, theirs = pair
    theirs.sendall(b"abcd" * 2500)
    parts = [line.receive(1.0) for _ in range(3)]
    assert [len(part) for part in parts] == [4000, 4000, 2000]


def test_who_does_not_read_holds_nobody_up_and_gets_whole_records(pair):
    line, theirs = pair
    count = fill(line)
    assert count > 100
    began_s = time.monotonic()
    with pytest.raises(TimeoutError):
        line.send(b"efgh", 0.05)
    assert time.monotonic() - began_s < 5.0
    theirs.settimeout(1.0)
    got = b""
    while len(got) < SIZE * count:
        got += theirs.recv(1 << 20)
    assert got == b"abcd" * count
    line.send(b"ijkl")  # there is room again; what was refused is gone
    assert theirs.recv(100) == b"ijkl"


class Slow:
    """A socket that takes a few bytes at a time, then none."""

    def __init__(self, takes):
        self.takes, self.got, self.timeout = takes, b"", None

    def settimeout(self, timeout):
        self.timeout = timeout

    def send(self, data):
        if not self.takes:
            raise BlockingIOError
        taken = data[: self.takes.pop(0)]
        self.got += taken
        return len(taken)

    def close(self):
        pass


def test_a_record_that_was_begun_is_ended_before_another(pair):
    line, _theirs = pair
    line._sending.close()
    line._sending = slow = Slow([3])
    line.send(b"abcdefgh")
    with pytest.raises(TimeoutError):  # its rest is still in the way
        line.send(b"ijkl")
    slow.takes = [5, 4]
    line.send(b"mnop")
    assert slow.got == b"abcdefghmnop"


def test_the_other_end_is_closed(pair):
    line, theirs = pair
    theirs.sendall(b"abcd")
    theirs.close()
    assert line.receive(1.0) == b"abcd"
    with pytest.raises(ConnectionError):
        line.receive(1.0)
    with pytest.raises(ConnectionError):
        fill(line)


def test_closing_tells_the_other_end(pair):
    line, theirs = pair
    line.close()
    theirs.settimeout(1.0)
    assert theirs.recv(100) == b""
