"""The HID reports of a SpaceMouse as axes and buttons; pure.

Report 1 carries the translation, report 2 the rotation, each as three signed figures of 16 bits,
low byte first; newer devices put all six into report 1. Report 3 carries one bit a button. The
device counts X to the right, Y towards the operator and Z downwards; here X leads away from the
operator, Y to the left and Z upwards, as the arm's own axes do for somebody who stands behind it.
"""

from __future__ import annotations

import struct
from dataclasses import dataclass
from typing import Final

_FULL: Final = 350.0
"""What the device tells at the end of its travel."""
_TRANSLATION, _ROTATION, _BUTTONS = 1, 2, 3
_BOTH_BYTES: Final = 13
_HALF_BYTES: Final = 7
_MOST_BUTTONS: Final = 32


@dataclass(frozen=True, slots=True)
class SpaceMouseState:
    """What was last told.

    Attributes:
        figures: X, Y, Z, RX, RY, RZ as the device counts them.
        buttons: Numbers from 1 on.
    """

    figures: tuple[int, ...] = (0,) * 6
    buttons: frozenset[str] = frozenset()

    def axes(self) -> dict[str, float]:
        """By the arm's axes, −1 to 1."""
        x, y, z, rx, ry, rz = (max(-1.0, min(1.0, each / _FULL)) for each in self.figures)
        return {"x": -y, "y": -x, "z": -z, "rx": -ry, "ry": -rx, "rz": -rz}

    @property
    def displaced(self) -> bool:
        """Whether the cap is away from its centre: such a device tells all the time."""
        return any(self.figures)


def after(state: SpaceMouseState, report: bytes) -> SpaceMouseState:
    """The state after a report; one that is of no known kind, or too short, changes nothing."""
    if not report:
        return state
    number, body = report[0], report[1:]
    if number == _TRANSLATION and len(report) >= _BOTH_BYTES:
        return SpaceMouseState(struct.unpack_from("<6h", body), state.buttons)
    if number in {_TRANSLATION, _ROTATION} and len(report) >= _HALF_BYTES:
        three = struct.unpack_from("<3h", body)
        first, second = state.figures[:3], state.figures[3:]
        six = (*three, *second) if number == _TRANSLATION else (*first, *three)
        return SpaceMouseState(six, state.buttons)
    if number == _BUTTONS and body:
        bits = int.from_bytes(body[:4], "little")
        down = frozenset(str(place + 1) for place in range(_MOST_BUTTONS) if bits >> place & 1)
        return SpaceMouseState(state.figures, down)
    return state
