"""The connection to armui: it is looked for until it is there, and again when it has gone."""

from __future__ import annotations

import contextlib
import threading
import time
from collections.abc import Callable
from typing import Final

import armui_client

ANSWER_S: Final = 3.0
"""armui answers within this time, where no operator is asked."""
FIELDS: Final = (
    "joints_deg",
    "joint_speeds_deg_s",
    "flange_pose_mm_deg",
    "gripper_mm",
    "enabled",
    "status",
)
_AGAIN_S: Final = 1.0


class Link:
    """Holds the connection, and hands on what is measured, in a thread of its own.

    Args:
        name: What the operator reads.
        socket: armui's socket; "": where it usually is.
        rate_hz: How often the arm is told.
        on_state: Is called with each state, in the thread.
        on_change: Is called when armui was found, "", or why it is not there; in the thread.
    """

    def __init__(
        self,
        name: str,
        socket: str,
        rate_hz: float,
        on_state: Callable[[armui_client.State], None],
        on_change: Callable[[str], None],
    ) -> None:
        self._name = name
        self._socket = socket or None
        self._rate_hz = rate_hz
        self._on_state = on_state
        self._on_change = on_change
        self._arm: armui_client.Arm | None = None
        self._problem = "armui has not been found yet."
        self._latest: tuple[float, armui_client.Six] | None = None
        self._over = threading.Event()
        self._thread = threading.Thread(target=self._run, name="armui-link", daemon=True)

    def start(self) -> None:
        """Begin to look for armui."""
        self._thread.start()

    def close(self) -> None:
        """Close the connection; a lease ends with it, and its motion is halted with power on."""
        self._over.set()
        with contextlib.suppress(armui_client.ArmuiError):
            self.arm().close()
        if self._thread.is_alive():
            self._thread.join()

    def arm(self) -> armui_client.Arm:
        """Return the arm.

        Raises:
            Disconnected: armui is not there.
        """
        if self._arm is None:
            raise armui_client.Disconnected(self._problem)
        return self._arm

    def angles_deg(self, max_age_s: float) -> tuple[armui_client.Six, float]:
        """Return the newest measured angles, and when they were measured, monotonic.

        Raises:
            Stale: They are older than this, or not known.
        """
        latest = self._latest
        age_s = None if latest is None else time.monotonic() - latest[0]
        if latest is None or age_s is None or age_s > max_age_s:
            told = "has not told its angles" if age_s is None else f"was silent for {age_s:.1f} s"
            raise armui_client.Stale(f"The arm {told}.")
        return latest[1], latest[0]

    def _run(self) -> None:
        while not self._over.is_set():
            try:
                with armui_client.connect(
                    self._name, path=self._socket, timeout_s=ANSWER_S
                ) as self._arm:
                    self._on_change("")
                    self._read(self._arm)
            except armui_client.ArmuiError as error:
                told = self._problem if self._arm is None else ""
                self._arm, self._latest, self._problem = None, None, str(error)
                if self._problem != told and not self._over.is_set():
                    self._on_change(self._problem)
            self._over.wait(_AGAIN_S)

    def _read(self, arm: armui_client.Arm) -> None:
        for state in arm.subscribe(self._rate_hz, FIELDS, timeout_s=ANSWER_S):
            joints = state.joints_deg
            if joints.value is not None and joints.age_s is not None:
                self._latest = time.monotonic() - joints.age_s, joints.value
            self._on_state(state)
