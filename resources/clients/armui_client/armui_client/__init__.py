"""Moves an AgileX PiPER arm through armui, which checks each motion, keeps the stop and the record.

    import armui_client

    with armui_client.connect("my script") as arm:
        print(arm.state().joints_deg.value)
        with arm.lease("a first motion", max_speed_percent=30):
            arm.move_joints([0, 20, -30, 0, 20, 0])

Units are in the names: degrees, millimetres, seconds, percent. Poses are x, y, z in mm and rx, ry,
rz in degrees. Everything may be called from several threads; :meth:`Arm.stop` and :meth:`Arm.halt`
need no lease. Only the standard library is used.
"""

from armui_client.arm import Arm, connect
from armui_client.connection import PROTOCOL, socket_path
from armui_client.errors import (
    ArmuiError,
    Disconnected,
    Failed,
    Invalid,
    LeaseLost,
    Refused,
    Stale,
    Timeout,
)
from armui_client.lease import Lease
from armui_client.operation import Operation
from armui_client.stream import Stream
from armui_client.values import (
    Checked,
    Event,
    Finding,
    Listed,
    Measured,
    Offered,
    Plan,
    Six,
    State,
    Status,
)

__version__ = "0.1.0"

__all__ = [
    "PROTOCOL",
    "Arm",
    "ArmuiError",
    "Checked",
    "Disconnected",
    "Event",
    "Failed",
    "Finding",
    "Invalid",
    "Lease",
    "LeaseLost",
    "Listed",
    "Measured",
    "Offered",
    "Operation",
    "Plan",
    "Refused",
    "Six",
    "Stale",
    "State",
    "Status",
    "Stream",
    "Timeout",
    "connect",
    "socket_path",
]
