"""The live stream for Foxglove, seen by a viewer that speaks its protocol."""

import multiprocessing
import os
import socket
import sys
import time
from collections import defaultdict
from contextlib import ExitStack
from dataclasses import replace
from typing import Any

import numpy as np
import pytest
from mcap.reader import make_reader
from mcap_ros2._dynamic import generate_dynamic
from PySide6.QtCore import QCoreApplication

from armui import app, cli
from armui.arm.models import all_models
from armui.live import server as served
from armui.live.live_stream import LiveFrames, LiveStream, own_address
from armui.live.messages import LiveArm
from armui.protocol.addressing import Addressing
from armui.protocol.codec import Codec
from armui.protocol.generation import Generation
from armui.session.exports.export import export_log
from armui.session.exports.request import ExportFormat, ExportRequest
from armui.session.recording.rows import rows_of
from armui.start import StartOptions
from armui.ui.dialogs.settings import SettingsDialog
from tests.accepted import accepted
from tests.live.viewer import Viewer
from tests.posix import stand_still
from tests.session.exports.logs import candump
from tests.session.recordings import frames, moving

MODEL = next(iter(all_models().values()))
ARM = LiveArm(MODEL.name, MODEL.geometry_of("S-V1.8-9"), MODEL.gripper.turned_deg)
WITHIN_S = 30.0


@pytest.fixture
def live_server():
    pytest.importorskip("foxglove")
    server = served.LiveServer("127.0.0.1", 0, ARM)
    yield server
    server.stop()


@pytest.fixture
def watch():
    """Makes viewers that are closed in the end."""
    with ExitStack() as stack:

        def connected(port, **more):
            viewer = Viewer(port, **more)
            stack.callback(viewer.close)
            viewer.watch()
            return viewer

        yield connected


KNOWN = replace(ARM, codec=(Generation.TWO, Addressing(), None))


def table_of(said):
    return rows_of([(None, at_s, frame, 0) for at_s, frame in said]).table


def free_port():
    with socket.socket() as probe:
        probe.bind(("127.0.0.1", 0))
        return probe.getsockname()[1]


def read(viewer, seen):
    """A message by the definition that the viewer was told."""
    (channel,) = (each for each in viewer.channels.values() if each["topic"] == seen.topic)
    name = channel["schemaName"]
    return generate_dynamic(name, channel["schema"])[name](seen.data)


# What is sent -------------------------------------------------------------------------------------


@pytest.mark.parametrize("generation", list(Generation))
def test_a_viewer_gets_what_the_export_writes(live_server, watch, tmp_path, generation):
    said = list(frames(2.5, generation, asked=moving(generation)))
    log = candump(tmp_path / "run.log", said)
    export_log(ExportRequest(log, tmp_path / "run.mcap", ExportFormat.MCAP))
    written, schemas = defaultdict(list), {}
    with (tmp_path / "run.mcap").open("rb") as stream:
        for schema, channel, message in make_reader(stream).iter_messages():
            written[channel.topic].append((message.log_time, message.data))
            schemas[channel.topic] = (schema.name, schema.data.decode(), channel.message_encoding)
    viewer = watch(live_server.port)
    while not live_server.state.watched:
        pass
    live_server.use_arm(replace(ARM, codec=(generation, Addressing(), None)))
    table = table_of([(round(at_s, 6), frame) for at_s, frame in said])
    for piece in np.array_split(table, 60):
        live_server.send_frames(piece)
    live_server.send_event(1, 30, "over")
    seen = defaultdict(list)
    while "/rosout" not in seen:
        if (each := viewer.read()) is not None:
            seen[each.topic].append((each.time_ns, each.data))
    del seen["/rosout"]
    advertised = {
        each["topic"]: (each["schemaName"], each["schema"], each["encoding"])
        for each in viewer.channels.values()
    }
    assert schemas.items() <= advertised.items()
    assert set(written) == set(seen)
    # told again each second, for viewers that come later; the arm's name tells of no firmware
    assert len(seen.pop("/tf_static")) == 3
    diagnostics, own = seen.pop("/diagnostics"), written.pop("/diagnostics")
    assert [at_ns for at_ns, _data in diagnostics] == [at_ns for at_ns, _data in own]
    written.pop("/tf_static")
    assert seen == written


def test_a_viewer_can_send_nothing_and_is_told_so(live_server, watch):
    viewer = watch(live_server.port)
    assert viewer.said[0]["capabilities"] == []
    for message in (
        {"op": "advertise", "channels": [{"id": 1, "topic": "/x", "encoding": "json",
                                          "schemaName": "x"}]},
        {"op": "setParameters", "parameters": [{"name": "speed", "value": 100}]},
        {"op": "subscribeConnectionGraph"},
    ):  # fmt: skip
        viewer.send(message)
        viewer.read()
        assert "does not support" in viewer.said[-1]["message"]


def test_an_event_is_a_log_of_ros(live_server, watch):
    viewer = watch(live_server.port)
    while not live_server.state.watched:
        pass
    live_server.send_event(1_790_000_000_123_456_000, 40, "关节 3: overcurrent")
    message = read(viewer, viewer.next_of("/rosout"))
    assert (message.stamp.sec, message.stamp.nanosec) == (1_790_000_000, 123_456_000)
    assert (message.level, message.name, message.msg) == (40, "armui", "关节 3: overcurrent")


def test_a_viewer_that_does_not_read_is_noticed_and_holds_nobody_up(live_server, watch):
    live_server.use_arm(KNOWN)
    watch(live_server.port, buffer=4096)
    while not live_server.state.watched:
        pass
    table = table_of(frames(10.0))
    began_s = time.thread_time()
    for piece in np.array_split(np.concatenate([table] * 3), 300):
        live_server.send_frames(piece)
    assert time.thread_time() - began_s < WITHIN_S
    assert live_server.state.behind >= 1


# In the program -----------------------------------------------------------------------------------


def settled(rig, live):
    """Let the rig's time pass until the stream is served, or says why it is not."""
    until(rig, lambda: live.view.state.on or live.view.state.problem is not None)


def until(rig, condition):
    until_s = time.monotonic() + WITHIN_S
    while not condition():
        assert time.monotonic() < until_s
        rig.step(0.01)
        QCoreApplication.processEvents()
        time.sleep(0.001)  # the process has a clock of its own


@pytest.fixture
def live(rig):
    live = LiveStream(rig.controller, lambda: rig.time_s)
    yield live
    assert live.end(WITHIN_S)
    assert not [each for each in multiprocessing.active_children() if each.name == "armui-live"]


def switch_on(rig, live, **more):
    live.switch(**{"on": True, "port": free_port(), "for_others": False, **more})
    settled(rig, live)


def watching(rig, live, watch):
    viewer = watch(live._wanted[1])
    until(rig, lambda: live.view.state.watched)
    return viewer


def test_it_tells_what_is_measured_and_nothing_of_an_arm_that_is_not_known(rig, live, watch):
    pytest.importorskip("foxglove")
    switch_on(rig, live)
    viewer = watching(rig, live, watch)
    rig.ready()
    to = (0.0, 40.0, -50.0, 10.0, 20.0, -30.0)
    accepted(rig.controller.motion.send_joints(to))
    rig.run_until(lambda: rig.firmware.joints_deg == pytest.approx(to, abs=0.01))
    rig.controller.disconnect_device()
    told, states = "", []
    while "Disconnected" not in told:
        seen = viewer.read()
        if seen is not None and seen.topic == "/rosout":
            told = read(viewer, seen).msg
        elif seen is not None and seen.topic == "/joint_states":
            states.append(read(viewer, seen))
        else:
            rig.step(0.01)
    assert np.degrees(states[-1].position) == pytest.approx(to, abs=0.02)
    assert live.view.lost == 0


@pytest.mark.skipif(sys.platform == "win32", reason="signals")
def test_a_process_that_stands_still_holds_up_nothing(rig, live, watch):
    pytest.importorskip("foxglove")
    rig.ready()
    switch_on(rig, live)
    watching(rig, live, watch)
    stand_still(live._sender._process.pid)
    until(rig, lambda: live._frames.dropped > 0)
    rig.controller.emergency_stop()
    rig.run_until(lambda: rig.firmware.condition.stopped)


def test_a_port_that_is_taken_is_said_and_another_one_works(rig, live):
    pytest.importorskip("foxglove")
    with socket.socket() as other:
        other.bind(("127.0.0.1", 0))
        other.listen()
        switch_on(rig, live, port=other.getsockname()[1])
        assert live.view.state.problem.code == "live_port_taken"
        assert rig.events[-1].code == "live_not_served"
    switch_on(rig, live)
    assert live.view.state.on


def test_without_the_package_it_says_what_to_install(monkeypatch):
    monkeypatch.setitem(sys.modules, "foxglove", None)
    monkeypatch.setattr(served, "end_with_the_program", lambda: None)
    monkeypatch.setattr(os, "nice", lambda _by: 0, raising=False)
    ours, theirs = multiprocessing.Pipe()
    served.serve(theirs, "127.0.0.1", 0, ARM)
    problem = ours.recv().problem
    assert problem.code == "live_not_installed"
    assert "pip install 'armui[foxglove]'" in problem.reason.source


def test_no_frame_is_ever_decoded_by_the_next_codec_and_the_lost_are_counted():
    lane = LiveFrames()
    one, two = Codec(Generation.TWO), Codec(Generation.ONE)
    lane.on_codec(one)
    heard: Any = [()]
    lane.on_heard(heard * 4000)
    lane.on_sent(heard * 200)
    assert lane.dropped == 200
    lane.on_codec(two)
    codec, frames_of_it = lane.newest
    assert (codec, frames_of_it.waiting, lane.dropped) == (two, 0, 200)


# For the operator ---------------------------------------------------------------------------------


def test_the_settings_switch_it_and_the_mark_shows_its_address(app_driver):
    driver, live = app_driver, app_driver.program.live
    driver.ready()
    mark = driver.find("live_mark")
    assert not mark.isVisible()
    driver.click("settings_button")
    dialog = driver.dialog(SettingsDialog)
    port = free_port()
    dialog.live_port_spin.setValue(port)
    driver.click(dialog.command_targets()["settings.live"])
    until(driver, lambda: live.view.state.on or live.view.state.problem is not None)
    assert driver.store.settings.live
    assert mark.isVisible()
    if live.view.state.problem is not None:  # the package is not installed
        assert mark.text() == "Live stream not served"
        assert "pip install" in mark.toolTip()
        return
    assert mark.text() == f"Live: 127.0.0.1:{port}"
    driver.click(dialog.command_targets()["settings.live_for_others"])
    until(driver, lambda: live.view.state.on)
    assert mark.text() == f"Live, open to the network: {own_address()}:{port}"
    driver.click(dialog.command_targets()["settings.live"])
    assert not mark.isVisible()


@pytest.mark.parametrize("words", [[], ["--live-on"]])
def test_the_command_line_switches_it_on_for_one_run(words, monkeypatch):
    begun: list[StartOptions] = []
    monkeypatch.setattr(app, "run", begun.append)
    monkeypatch.setattr(cli, "has_display", lambda: True)
    cli.main(words)
    assert [each.live_on for each in begun] == [bool(words)]
