"""The script of a user: it runs in a thread, and the rig's time goes on in this one."""

import threading
import time

from PySide6.QtCore import QCoreApplication

import armui_client.stream

WITHIN_S = 40.0
_HEARD_WITHIN_S = 0.5
_WAITS_S = 0.005


class RigTime:
    """What a script takes for the module `time`: the rig's."""

    def __init__(self, rig):
        self.rig = rig
        self.sleeping = False
        self.over = False

    def monotonic(self):
        return self.rig.time_s

    def sleep(self, duration_s):
        until_s = self.rig.time_s + duration_s - 1e-9
        self.sleeping = True
        while self.rig.time_s < until_s:
            assert not self.over, "the test has ended"
            time.sleep(0.0002)
        self.sleeping = False


class Script:
    """Runs what a user writes.

    Attributes:
        percent: What the operator grants of speed to who asks; ``None``: he is not there.
        consents: What he answers when asked for a single operation; ``None``: nothing.
        meanwhile: Is called between two steps of the rig's time.
    """

    def __init__(self, desk, monkeypatch):
        self.desk = desk
        self.rig = desk.rig
        self.time = RigTime(desk.rig)
        self.percent = 100
        self.consents = True
        self.meanwhile = lambda: None
        monkeypatch.setattr(armui_client.connection, "_BEAT_S", 0.02)
        monkeypatch.setattr(armui_client.stream, "time", self.time)
        monkeypatch.setenv("ARMUI_SOCKET", desk.view.path)

    def run(self, act):
        """Run a function in a thread to its end; return what it returns, raise what it raises."""
        found: list[tuple[object, BaseException | None]] = []

        def run():
            try:
                found.append((act(), None))
            except BaseException as error:  # noqa: BLE001 - raised below
                found.append((None, error))

        thread = threading.Thread(target=run, daemon=True)
        thread.start()
        until_s = time.monotonic() + WITHIN_S
        try:
            while thread.is_alive():
                assert time.monotonic() < until_s, "the script does not end"
                self.step()
        finally:
            self.time.over = True
            thread.join(5.0)
            self.time.over = False
        value, error = found[0]
        if error is not None:
            raise error
        return value

    def step(self):
        """Let the operator and the arm do what they do meanwhile, at the script's pace."""
        QCoreApplication.processEvents()
        desk = self.desk
        if desk.view.asked is not None and self.percent is not None:
            desk.grant(self.percent)
        if desk.view.consent is not None and self.consents is not None:
            desk.consent(given=self.consents)
        self.meanwhile()
        time.sleep(0.001)
        held = desk.view.lease is not None
        if held and self.rig.time_s - desk._lessor._heard_s > _HEARD_WITHIN_S:
            return  # the rig's time goes faster than the computer's
        began_s = time.monotonic()
        while desk._controller.jogging.streamed is not None and not self.time.sleeping:
            QCoreApplication.processEvents()  # the next target is on its way
            if time.monotonic() - began_s > _WAITS_S:
                break
            time.sleep(0.0002)
        self.rig.step()
