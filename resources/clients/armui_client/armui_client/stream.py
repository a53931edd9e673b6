"""A stream of targets."""

from __future__ import annotations

import contextlib
import time
from collections import deque
from collections.abc import Sequence
from typing import TYPE_CHECKING

from armui_client.connection import ANSWER_S
from armui_client.errors import ArmuiError, Refused, Timeout
from armui_client.values import six

if TYPE_CHECKING:
    from armui_client.connection import Connection


class Stream:
    """Targets of the joints, or of the flange, at a steady rate; use it in a ``with``.

    armui's path follows the newest target smoothly, 80 ms behind an even motion. Without a target
    for 150 ms the arm rests.

    Attributes:
        followed: How many targets were followed, as far as answered.
        refused: How many targets were refused.
    """

    def __init__(self, connection: Connection, rate_hz: float, *, raises: bool) -> None:
        self._connection = connection
        self._period_s = 1.0 / rate_hz
        self._raises = raises
        self._due_s: float | None = None
        self._unanswered: deque[int] = deque()
        self.followed = self.refused = 0

    def target(self, joints_deg: Sequence[float]) -> Refused | None:
        """Wait until the next target is due, then send it.

        Args:
            joints_deg: Six angles, within the limits. A target is followed or refused, never
                changed.

        Returns:
            Why it is not followed, or an earlier one that was answered late; ``None``: it is. The
            arm rests until the next target that can be followed.

        Raises:
            Refused: The same, unless the stream returns refusals.
            LeaseLost: The lease has ended.
        """
        return self._send({"joints_deg": six(joints_deg)})

    def pose(self, flange_pose_mm_deg: Sequence[float]) -> Refused | None:
        """Do the same with a pose of the flange, without tool, in the base, as :meth:`Arm.fk` has.

        armui takes the angles nearest to where the stream is; a pose out of reach, or so far from
        there that a joint would turn by more than 30°, is refused.
        """
        return self._send({"flange_pose_mm_deg": six(flange_pose_mm_deg)})

    def _send(self, wanted: dict[str, list[float]]) -> Refused | None:
        lease = self._connection.lease()
        now_s = time.monotonic()
        due_s = now_s if self._due_s is None else self._due_s
        if due_s > now_s:
            time.sleep(due_s - now_s)
        self._due_s = max(due_s, now_s) + self._period_s
        number = self._connection.begin("stream.target", wanted, lease=lease)
        self._unanswered.append(number)
        return self._answers(self._period_s / 2)

    def hold(self, joints_deg: Sequence[float], duration_s: float) -> Refused | None:
        """Send one target again and again, so that the arm arrives; return the last refusal."""
        refusal = None
        for _ in range(max(1, round(duration_s / self._period_s))):
            refusal = self.target(joints_deg) or refusal
        return refusal

    def _answers(self, wait_s: float) -> Refused | None:
        """Take in what is answered, in order; raise or return the newest refusal."""
        refusal = None
        while self._unanswered:
            try:
                answer = self._connection.answer(self._unanswered[0], wait_s, again=True)
                self.followed += "superseded" not in answer
            except Timeout:
                break  # looked at with the next target
            except Refused as found:
                refusal, self.refused = found, self.refused + 1
            self._unanswered.popleft()
        if refusal is not None and self._raises:
            raise refusal
        return refusal

    def end(self) -> None:
        """End the stream: the arm comes to rest where it is."""
        for number in self._unanswered:
            self._connection.forget(number)
        self._unanswered.clear()
        with contextlib.suppress(ArmuiError):  # the lease has ended, and the stream with it
            self._connection.ask("stream.end", {}, ANSWER_S, lease=self._connection.lease())

    def __enter__(self) -> Stream:
        return self

    def __exit__(self, *_: object) -> None:
        self.end()
