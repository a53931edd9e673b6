"""The process that serves the live stream by Foxglove's WebSocket, with the export's messages.

It is a process of its own because threads of foxglove-sdk wait for Python's GIL while they hold
locks that a call of ours waits for: with a listener and its log at once the whole program has been
seen to deadlock. Here that would only end the stream.
"""

from __future__ import annotations

import errno
import logging
import math
import os
import re
import time
from typing import TYPE_CHECKING, Any, Final

import numpy as np

from armui.live.messages import (
    LIVE_NOT_INSTALLED,
    LIVE_NOT_OPENED,
    LIVE_PORT_TAKEN,
    LiveArm,
    LiveState,
)
from armui.protocol.codec import Codec
from armui.protocol.generation import Generation
from armui.protocol.signal_columns import payload_words
from armui.session.exports.history import ArmFrames, ExportFacts, History, TimeSpan
from armui.session.exports.ros.messages import RosMessages, definition, full_name, log_message
from armui.session.frames import NOT_OF_THE_ARM
from armui.system.helper_process import end_with_the_program

if TYPE_CHECKING:
    from multiprocessing.connection import Connection

    from numpy.typing import NDArray

EVENTS: Final = "/rosout"
EVENT_TYPE: Final = "rcl_interfaces/Log"
_ALWAYS: Final = TimeSpan(-math.inf, math.inf)
_LOOK_S: Final = 0.25
"""The interval at which a change of the server's state is passed on."""
_AGAIN_S: Final = 1.0
"""The transforms that never change are repeated for viewers that come later."""
_NICER_BY: Final = 5
_TAKEN: Final = frozenset({errno.EADDRINUSE, 10048})
"""The system's numbers for a port in use: this one's, and that of Windows."""
_LAGGING: Final = "foxglove.websocket.connected_client.send_lossy"
"""The logger of foxglove-sdk that reports viewers whose queue is full."""


class _Lagging(logging.Handler):
    """Counts the reports of :data:`_LAGGING` of viewers that do not keep up."""

    count = 0

    def emit(self, _record: logging.LogRecord) -> None:
        self.count += 1


class LiveServer:
    """Serves the messages of frames to any number of viewers, and takes nothing from them.

    Args:
        host: The address to listen at.
        port: The port; 0 for any.
        arm: The facts on the arm; see :meth:`use_arm`.

    Attributes:
        port: The port.

    Raises:
        ImportError: foxglove-sdk is not installed.
        RuntimeError: It cannot listen there.
    """

    def __init__(self, host: str, port: int, arm: LiveArm) -> None:
        self._lagging = _Lagging()
        logging.getLogger("foxglove").addHandler(logging.NullHandler())  # else it writes to stderr
        log = logging.getLogger(_LAGGING)
        log.setLevel(logging.INFO)
        log.addHandler(self._lagging)
        import foxglove  # noqa: PLC0415 - an extra

        self._sdk = foxglove
        self._context = foxglove.Context()
        self._channels: dict[str, Any] = {}
        self._frames = 0
        self.use_arm(arm)
        for stream in self._messages.streams:
            self._add_channel(stream.topic, stream.schema)
        self._add_channel(EVENTS, EVENT_TYPE)
        # Only after all channels exist: a viewer that subscribes at once is refused later ones.
        self._served = foxglove.start_server(
            name="armui", host=host, port=port, capabilities=[], context=self._context
        )
        self.port: int = self._served.port

    @property
    def state(self) -> LiveState:
        """The state of the server."""
        watched = any(each.has_sinks() for each in self._channels.values())
        return LiveState(on=True, watched=watched, behind=self._lagging.count)

    def stop(self) -> None:
        """Serve no more."""
        self._served.stop()

    def use_arm(self, arm: LiveArm) -> None:
        """Take the frames to come as this arm's; what was heard before counts no more."""
        self._known = arm.codec is not None
        codec = Codec(*(arm.codec or (Generation.TWO,)))
        words = f"{arm.name}, generation {int(codec.generation)}"
        notes = {"arm": f"{words}, {codec.firmware}" if codec.firmware else words}
        self._facts = ExportFacts(codec, arm.geometry, arm.gripper_turned_deg, 0.0, notes)
        self._history, self._messages = History(codec), RosMessages(self._facts)
        self._again_s = -math.inf

    def send_frames(self, table: NDArray[Any]) -> None:
        """Send the messages that some frames add, those of :data:`ROW`, times since 1970."""
        places = np.flatnonzero((table["flags"] & NOT_OF_THE_ARM) == 0)
        table = table[places]
        first, self._frames = self._frames, self._frames + len(table)
        if not self._known or not len(table):
            return
        self._history.add_frames(
            ArmFrames(
                np.arange(first, self._frames, dtype=np.int64),
                table["time_s"],
                table["id"],
                table["length"],
                payload_words(np.ascontiguousarray(table["data"])),
            )
        )
        now_s = float(table["time_s"][-1])
        if not 0.0 <= now_s - self._again_s < _AGAIN_S:
            self._again_s = now_s
            self._messages.repeat_fixed()
        for _row, stream, time_ns, data in self._messages.of_piece(self._history, _ALWAYS):
            self._channels[stream.topic].log(data, log_time=time_ns)

    def send_event(self, time_ns: int, level: int, text: str) -> None:
        """Send an event; the level is one of rcl_interfaces/Log."""
        self._channels[EVENTS].log(log_message(time_ns, level, text), log_time=time_ns)

    def _add_channel(self, topic: str, kind: str) -> None:
        schema = self._sdk.Schema(
            name=full_name(kind), encoding="ros2msg", data=definition(kind).encode()
        )
        self._channels[topic] = self._sdk.Channel(
            topic, schema=schema, message_encoding="cdr", context=self._context
        )


def serve(connection: Connection, host: str, port: int, arm: LiveArm) -> None:
    """Serve until the program ends; the entry of the process."""
    end_with_the_program()
    if hasattr(os, "nice"):
        os.nice(_NICER_BY)
    try:
        server = LiveServer(host, port, arm)
    except ImportError as error:
        connection.send(LiveState(problem=LIVE_NOT_INSTALLED(text=str(error))))
        return
    except RuntimeError as error:  # the only error class of foxglove-sdk
        number = re.search(r"os error (\d+)", str(error))
        taken = number is not None and int(number[1]) in _TAKEN
        why = LIVE_PORT_TAKEN(port=port) if taken else LIVE_NOT_OPENED(port=port, text=str(error))
        connection.send(LiveState(problem=why))
        return
    told, looked_s = LiveState(), -math.inf
    while True:
        now_s = time.monotonic()
        if now_s - looked_s >= _LOOK_S:
            looked_s = now_s
            if told != server.state:
                told = server.state
                connection.send(told)
        if not connection.poll(_LOOK_S):
            continue
        heard = connection.recv()
        if isinstance(heard, np.ndarray):
            server.send_frames(heard)
        elif isinstance(heard, LiveArm):
            server.use_arm(heard)
        else:
            server.send_event(*heard)
