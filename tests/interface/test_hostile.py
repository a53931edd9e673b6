"""What a client may send, or not read, holds neither the window nor the other clients (S31)."""

import json
import os
import random
import resource
import socket
import stat
import time
from pathlib import Path
from typing import Any

import pytest
from PySide6.QtCore import QCoreApplication

from armui.interface import server
from armui.interface.interface import Interface
from armui.interface.server import MOST_CLIENTS, MOST_UNREAD
from tests.interface.conftest import until_settled

HELLO = (
    b'{"jsonrpc": "2.0", "id": 1, "method": "hello", "params": {"client": "x", "protocol": 1}}\n'
)
METHODS = ("ping", "state.get", "lease.request", "stream.target", "motion.send", "stop.", "hello")


def raw(desk):
    one = socket.socket(socket.AF_UNIX)
    one.settimeout(5.0)
    until_s = time.monotonic() + 10.0
    while True:
        try:
            one.connect(desk.view.path)
        except BlockingIOError:  # as many wait already to be let in
            assert time.monotonic() < until_s
            serve(desk, 0.01)
        else:
            return one


def serve(desk, seconds=0.05):
    until_s = time.monotonic() + seconds
    while time.monotonic() < until_s:
        QCoreApplication.processEvents()
        desk.rig.step()


def junk(chance):
    """A line that no client should send, or that one should."""
    values: tuple[Any, ...] = (
        None,
        True,
        1,
        -1.5,
        1e308,
        "x",
        "",
        [],
        {},
        [1] * 6,
        [[1] * 6],
        ["a"] * 6,
        "\u0000",
    )
    params = {
        chance.choice(("lease", "joints_deg", "fields", "rate_hz", "percent", "", "moves")): (
            chance.choice(values)
        )
        for _ in range(chance.randrange(4))
    }
    call = {
        "jsonrpc": chance.choice(("2.0", "2.0", "2.0", "1.0", 2)),
        "id": chance.choice((1, "a", None, 1.5, [], True)),
        "method": chance.choice((*METHODS, None, 1, "", "x" * 500)),
        "params": chance.choice((params, params, params, [], None, 1)),
    }
    line = json.dumps(call).encode()
    match chance.randrange(8):
        case 0:
            return os.urandom(chance.randrange(200)) + b"\n"
        case 1:
            return line[: chance.randrange(len(line))]  # half a line, and the end
        case 2:
            return b"[" * chance.randrange(1, 20_000) + b"\n"
        case 3:
            return b"NaN\n" + line.replace(b"2.0", b"Infinity") + b"\n"
    return line + b"\n"


def test_a_thousand_hostile_sessions(desk, connect):
    good = connect("good")
    chance = random.Random(42)
    began_mb = resource.getrusage(resource.RUSAGE_SELF).ru_maxrss / 1024
    for number in range(1000):
        with raw(desk) as one:
            try:
                if chance.random() < 0.7:
                    one.sendall(HELLO)
                for _ in range(chance.randrange(6)):
                    one.sendall(junk(chance))
            except OSError:
                pass  # it was cut off
        if number % 20 == 0:
            serve(desk, 0.02)
    serve(desk, 0.3)
    assert good.ask("ping") == {}
    assert desk.view.lease is None
    assert desk.rig.firmware.joints_deg == pytest.approx((0.0,) * 6, abs=0.01)
    assert resource.getrusage(resource.RUSAGE_SELF).ru_maxrss / 1024 - began_mb < 100
    assert [each.name for each in desk.view.clients] == ["good"]


def test_a_line_of_ten_mebibytes_is_cut_off_and_said(desk):
    with raw(desk) as one:
        one.sendall(HELLO)
        serve(desk, 0.1)
        assert b'"result"' in one.recv(65536)
        sent = 0
        try:
            while sent < 10 * 2**20:
                sent += one.send(b"x" * 65536)
        except OSError:
            pass
        assert sent < 10 * 2**20, "all of it was taken in"
        assert b"A line has at most" in one.recv(4096)


def test_who_does_not_read_loses_states_and_holds_nobody(desk, connect):
    deaf = connect("deaf")
    good = connect("good")
    deaf.ask("state.subscribe", rate_hz=200)
    deaf.ask("events.subscribe")
    for _ in range(2000):
        desk.rig.controller.noticed.emit(desk.rig.events[-1])
    serve(desk, 1.0)
    assert good.ask("ping") == {}
    (session,) = (each for each in desk._server._sessions.values() if each.client.name == "deaf")
    assert session.writer.transport.get_write_buffer_size() <= 2 * MOST_UNREAD


def test_who_asks_and_never_reads_is_cut_off(desk, connect):
    deaf = connect("deaf")
    good = connect("good")
    line = b'{"jsonrpc": "2.0", "id": 2, "method": "state.get"}\n'
    deaf.socket.setblocking(True)
    deaf.socket.settimeout(0.5)
    try:
        for _ in range(4000):
            deaf.socket.sendall(line)
    except OSError:
        pass
    until_s = time.monotonic() + 10.0
    while len(desk.view.clients) > 1 and time.monotonic() < until_s:
        serve(desk, 0.1)
        assert good.ask("ping") == {}
    assert [each.name for each in desk.view.clients] == ["good"]


def test_a_flood_of_calls_leaves_the_window_alive(desk, connect):
    flood = connect("flood")
    line = b'{"jsonrpc": "2.0", "method": "operations.list"}\n'
    flood.socket.setblocking(True)
    flood.socket.settimeout(0.2)
    longest_s, sent = 0.0, 0
    until_s = time.monotonic() + 2.0
    while time.monotonic() < until_s:
        try:
            flood.socket.send(line * 200)
            sent += 200
        except OSError:
            pass
        began_s = time.thread_time()
        QCoreApplication.processEvents()
        longest_s = max(longest_s, time.thread_time() - began_s)
    assert sent > 500
    assert longest_s < 1.0, "one turn of the event loop took in more than the calls that may wait"


def test_more_clients_than_there_is_room_for_are_told(desk, connect):
    for number in range(MOST_CLIENTS):
        connect(f"{number}")
    with raw(desk) as one:
        assert b"At most 8 clients" in one.recv(4096)
        assert one.recv(4096) == b""


def test_another_user_is_refused(desk, monkeypatch):
    monkeypatch.setattr(server, "_peer", lambda _socket: (1, os.getuid() + 1))
    with raw(desk) as one:
        one.recv(4096)
        assert one.recv(4096) == b""
    serve(desk)
    assert desk.view.clients == ()


def test_the_socket_and_its_folder_are_closed_to_others(desk):
    path = Path(desk.view.path)
    assert stat.S_IMODE(path.stat().st_mode) == 0o600
    assert stat.S_IMODE(path.parent.stat().st_mode) == 0o700


def test_a_web_page_is_no_client(desk):
    """A request of HTTP, were it led to the socket, is answered by an error a line."""
    with raw(desk) as one:
        one.sendall(b"POST / HTTP/1.1\r\nHost: x\r\n\r\n" + HELLO.strip() + b"\n")
        serve(desk, 0.1)
        assert b"This line is no JSON" in one.recv(4096)


def test_a_second_program_leaves_the_socket_to_the_first(desk, rig):
    second = Interface(rig.controller, desk._path, lambda: rig.time_s)
    second.switch(on=True)
    until_settled(second)
    assert second.view.problem.code == "interface_taken"
    assert second.end()
    assert Path(desk.view.path).exists()


def test_a_socket_left_by_a_killed_program_is_taken_over(rig, tmp_path):
    path = tmp_path / "r" / "api.sock"
    path.parent.mkdir(mode=0o700)
    left = socket.socket(socket.AF_UNIX)
    left.bind(str(path))
    left.close()
    interface = Interface(rig.controller, path, lambda: rig.time_s)
    interface.switch(on=True)
    until_settled(interface)
    assert interface.view.problem is None
    assert interface.end()
    assert not path.exists()


def test_a_line_or_arc_to_the_moon_costs_the_window_nothing(leased, desk):
    far = [[0.0, 0.0, each, 0.0, 0.0, 0.0] for each in (1e6, -1e6)]
    here = list(desk.rig.controller.cartesian.kinematics().forward(desk.rig.firmware.joints_deg))
    beside = [here[0] + 100.0, *here[1:]]
    began_s = time.thread_time()
    for method, params in (
        ("tool.move", {"target": far[0], "move_mode": "move_l"}),
        ("tool.step", {"axis": 0, "amount": -1e6, "frame": "base"}),
        ("tool.arc", {"points": [here, far[1], beside]}),
    ):
        told = leased.refused(method, lease=leased.lease, **params)
        assert told["data"]["reason"].startswith(("path_", "pose_out_of_reach")), told
    assert time.thread_time() - began_s < 1.0, "of ten seconds and more"
    for points in ([], [here], [here] * 4):
        assert leased.refused("tool.arc", lease=leased.lease, points=points)["code"] == -32602
    assert leased.refused("tool.arc", lease=leased.lease)["code"] == -32602
    for figure in (1e7, 1e308, 10**400):
        leased.refused("kinematics.fk", joints_deg=[figure] * 6)
        leased.refused("tool.step", lease=leased.lease, axis=0, amount=figure, frame="base")
    assert desk.view.lease is not None
