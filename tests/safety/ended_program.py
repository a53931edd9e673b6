"""A program in a process of its own that moves an arm on a bus others hear, and is ended.

Called with a port, a group and a state; see `begin`.
"""

# ruff: noqa: C901, PLC0415 - the picture's process imports this file, too: all is loaded in `main`

import json
import sys
import time
from typing import Any


def main() -> None:
    from contextlib import contextmanager

    import can
    from PySide6.QtCore import QTimer
    from PySide6.QtWidgets import QDialog, QMenu

    from armui import app
    from armui.arm.device import Device
    from armui.control.operations.started import Started
    from armui.start import StartOptions

    port, group, state = int(sys.argv[1]), sys.argv[2], sys.argv[3]
    far = (60.0, 60.0, -60.0, 0.0, 0.0, 0.0)

    @contextmanager
    def without_echo(device, **_more):
        """python-can hands one's own frames back from this bus, as another host's."""
        with can.Bus(device.channel, device.interface, port=port) as bus:
            send, receive = bus.send, bus.recv
            sent: list[tuple[int, bytes]] = []

            def send_noted(message, timeout=None):
                sent.append((message.arbitration_id, bytes(message.data)))
                send(message, timeout)

            def receive_others(timeout=None):
                message = receive(timeout)
                while message is not None:
                    key = (message.arbitration_id, bytes(message.data))
                    if key not in sent:
                        break
                    sent.remove(key)
                    message = receive(timeout)
                return message

            bus.send, bus.recv = send_noted, receive_others
            yield bus
            if state == "closing":
                time.sleep(20.0)

    @contextmanager
    def slow(_device, **_more):
        tell()
        time.sleep(20.0)
        yield None

    setattr(app, "open_device", slow if state == "opening" else without_echo)  # noqa: B010 - a stand-in

    class Driven(app.Program):
        def __init__(self, *arguments, **more):
            super().__init__(*arguments, **more)
            self.timer = QTimer(interval=20)
            self.timer.timeout.connect(self.look)
            if state == "start":
                print(json.dumps({"picture": None}), flush=True)
                return
            device = Device("udp_multicast", group, None, options=(("port", port),))
            QTimer.singleShot(0, self.timer, lambda: self.controller.connect_device(device))
            self.enabling = False
            self.timer.start()

        def look(self):
            controller = self.controller
            now = controller.operating_state
            if now.cannot_enable is None and None not in now.enabled and not self.enabling:
                self.enabling = isinstance(controller.motors.enable(), Started)
            elif now.cannot_move is None and not now.moving and self.view.is_settled:
                controller.motion.set_speed_percent(20)
                controller.motion.send_joints(far)
            elif now.moving:
                self.timer.stop()
                begin(self)

    def begin(program):
        QTimer.singleShot(0, program.timer, tell)
        if state == "menu":
            menu = QMenu(program.window)
            menu.addAction("one")
            menu.exec()
        elif state == "dialog":
            QDialog(program.window).exec()
        elif state == "busy":
            tell()
            until_s = time.monotonic() + 20.0
            while time.monotonic() < until_s:
                pass
        elif state == "stuck":
            tell()
            time.sleep(20.0)
        elif state == "closing":
            tell()
            program.shutdown()
        elif state == "disk":
            program._files.submit(time.sleep, 20.0)

    told: list[bool] = []

    def tell():
        if not told:
            told.append(True)
            print(json.dumps({"picture": programs[0].view._client.pid}), flush=True)

    programs: list[Any] = []
    make = Driven.__init__

    def remember(self, *arguments, **more):
        programs.append(self)
        make(self, *arguments, **more)

    setattr(Driven, "__init__", remember)  # noqa: B010 - as above
    setattr(app, "Program", Driven)  # noqa: B010 - as above
    sys.exit(app.run(StartOptions()))


if __name__ == "__main__":
    main()
