"""`armui sim --api-on`: controller, simulated arm and local interface, without a window.

For the tests and scripts of others. The arm is on a bus of its own, which no adapter reaches: so
the lease may be granted by a flag, where nobody is who could hold a button.
"""

from __future__ import annotations

import argparse
import signal
import sys
from collections.abc import Iterator
from contextlib import contextmanager
from dataclasses import replace
from functools import partial
from pathlib import Path
from typing import Final

from PySide6.QtCore import QCoreApplication, QSocketNotifier

from armui.control.arm_controller import ArmController
from armui.interface.interface import Interface, Shelf
from armui.interface.interface_view import InterfaceView
from armui.interface.messages import english
from armui.simulated_arms import SIMULATED, SimulatedArms
from armui.system import paths
from armui.system.clock import steady_s
from armui.system.helper_process import FileThread, HelperProcess
from armui.system.thread_priority import raise_in_background
from armui.ui.background import Background
from armui.ui.shell.trajectory_pages import open_library

SOCKET_NAME: Final = "api.sock"
_OF_A_BUS: Final = ("channel", "port", "bitrate", "offset", "fault", "bugs", "flash")
"""Options of `armui sim` that belong to an arm on a bus of others."""


def socket_path() -> Path:
    """Return where the local interface is served by default."""
    return paths.runtime() / SOCKET_NAME


def run(options: argparse.Namespace) -> int:
    """Serve the interface of a simulated arm until Ctrl-C; returns the exit code."""
    refused = [each for each in _OF_A_BUS if getattr(options, each, None)]
    if refused or options.interface != "udp_multicast":
        words = ", ".join(f"--{each}" for each in refused or ["interface"])
        sys.stderr.write(
            f"armui sim: leave out {words}: with --api-on the arm is on a private bus, where no "
            "real arm can be.\n"
        )
        return 2
    app = QCoreApplication.instance() or QCoreApplication(sys.argv[:1])
    arms = SimulatedArms(options.firmware, options.joints)
    controller = ArmController(arms.connected, SIMULATED)
    workers, files = HelperProcess(), FileThread()
    folder = Path(options.trajectories) if options.trajectories else paths.trajectories()
    interface = Interface(
        controller,
        Path(options.socket) if options.socket else socket_path(),
        steady_s,
        grants_itself=options.grant,
        shelf=Shelf(Background(workers, files), partial(open_library, folder, files)),
    )
    device = next(each for each in SIMULATED if each.generation == options.generation)
    controller.connect_device(replace(device, model=options.model))
    granted = "granted to whoever asks" if options.grant else "granted to nobody: see --grant"
    code = 0

    def serve(_now: object) -> None:
        """Serve the interface once the arm is known."""
        if controller.operating_state.generation is not None:
            controller.operating_state_changed.disconnect(serve)
            interface.switch(on=True)

    def on_changed(view: InterfaceView) -> None:
        """Say that it is served, or why it is not."""
        nonlocal code
        if view.problem is not None:
            problem = english(view.problem.reason.source, view.problem.params)
            sys.stderr.write(f"armui sim: {problem}\n")
            code = 2
            app.quit()
        elif view.on:
            interface.changed.disconnect(on_changed)
            raise_in_background()  # as the window's threads: a lease ends with an arm not heard
            sys.stdout.write(
                f"Simulated arm, interface on {view.path}. The lease is {granted}. Ctrl-C ends "
                "it.\n"
            )
            sys.stdout.flush()

    controller.operating_state_changed.connect(serve)
    interface.changed.connect(on_changed)
    with _ended_by_signals(app):
        app.exec()
    interface.end()
    controller.shutdown()
    files.shutdown()
    workers.shutdown()
    arms.end()
    return code


@contextmanager
def _ended_by_signals(app: QCoreApplication) -> Iterator[None]:
    """End Qt's loop at Ctrl-C and SIGTERM, which Python would not look at in it."""
    import socket  # noqa: PLC0415 - for this only

    ear, mouth = socket.socketpair()
    mouth.setblocking(False)
    before = {number: signal.getsignal(number) for number in (signal.SIGINT, signal.SIGTERM)}
    waker = signal.set_wakeup_fd(mouth.fileno())
    notifier = QSocketNotifier(ear.fileno(), QSocketNotifier.Type.Read)
    notifier.activated.connect(app.quit)
    for number in before:
        signal.signal(number, lambda *_: None)
    try:
        yield
    finally:
        notifier.setEnabled(False)
        signal.set_wakeup_fd(waker)
        for number, handler in before.items():
            signal.signal(number, handler)
        ear.close()
        mouth.close()
