"""The state of a gamepad or a SpaceMouse; pure data."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass, field
from enum import StrEnum


class DeviceKind(StrEnum):
    """The kind of device, which determines the names of its axes and buttons."""

    GAMEPAD = "gamepad"
    SPACE_MOUSE = "space_mouse"


@dataclass(frozen=True, slots=True)
class DeviceInfo:
    """A device that was found.

    Attributes:
        key: A key unique from plugging in to unplugging.
        name: The name it reports; two of a model share it.
    """

    key: str
    name: str
    kind: DeviceKind


@dataclass(frozen=True, slots=True)
class DeviceState:
    """The state of a device at one time.

    Attributes:
        axes: The axes by name, −1 to 1; a trigger 0 to 1. An axis that is missing is at 0.
        buttons: The names of the pressed buttons.
        silent: True if it reports nothing although it is off its centre, where a device of its kind
            reports all the time.
    """

    info: DeviceInfo
    axes: Mapping[str, float] = field(default_factory=dict)
    buttons: frozenset[str] = frozenset()
    silent: bool = False


@dataclass(frozen=True, slots=True)
class DeviceSnapshot:
    """The state of all devices at one time.

    Attributes:
        at_s: The time of reading, by the program's clock.
        devices: The devices in the order in which they came.
        unusable: The names of devices found without a known layout.
        missing: Names of the packages that are not installed.
        problems: The errors of the libraries.
    """

    at_s: float
    devices: tuple[DeviceState, ...] = ()
    unusable: tuple[str, ...] = ()
    missing: tuple[str, ...] = ()
    problems: tuple[str, ...] = ()
