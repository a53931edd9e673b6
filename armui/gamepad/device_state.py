"""What a gamepad or a SpaceMouse shows at a moment; pure data."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass, field
from enum import StrEnum


class DeviceKind(StrEnum):
    """What sort of device it is: its axes and buttons have their names from this."""

    GAMEPAD = "gamepad"
    SPACE_MOUSE = "space_mouse"


@dataclass(frozen=True, slots=True)
class DeviceInfo:
    """A device that was found.

    Attributes:
        key: Its own from plugging in to unplugging.
        name: As it says itself; two of a model share it.
    """

    key: str
    name: str
    kind: DeviceKind


@dataclass(frozen=True, slots=True)
class DeviceState:
    """A device at a moment.

    Attributes:
        axes: By name, −1 to 1; a trigger 0 to 1. An axis that is not named is at 0.
        buttons: The names of those that are down.
        silent: Nothing is heard of it although it is moved away from its centre, where a device of
            its kind tells all the time.
    """

    info: DeviceInfo
    axes: Mapping[str, float] = field(default_factory=dict)
    buttons: frozenset[str] = frozenset()
    silent: bool = False


@dataclass(frozen=True, slots=True)
class DeviceSnapshot:
    """All devices at a moment.

    Attributes:
        at_s: When they were read, by the program's clock.
        devices: In the order in which they came.
        unusable: Names of what was found and has no layout that is known.
        missing: Names of the packages that are not installed.
        problems: What the libraries say of what does not work.
    """

    at_s: float
    devices: tuple[DeviceState, ...] = ()
    unusable: tuple[str, ...] = ()
    missing: tuple[str, ...] = ()
    problems: tuple[str, ...] = ()
