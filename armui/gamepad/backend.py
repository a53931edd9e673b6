"""What every library that reads devices is behind."""

from __future__ import annotations

from typing import Protocol

from armui.gamepad.device_state import DeviceState


class DeviceBackend(Protocol):
    """Reads the devices of one kind; made and used in one thread only.

    Attributes:
        package: What has to be installed for it.
        unusable: Names of what was found and cannot be used.
    """

    package: str
    unusable: tuple[str, ...]

    def open(self) -> None:
        """Load the library.

        Raises:
            ImportError: It is not installed.
            OSError: It is, and does not work here.
        """
        ...

    def look(self) -> None:
        """Look for devices that came; may take some tenths of a second."""
        ...

    def read(self, now_s: float) -> tuple[DeviceState, ...]:
        """The devices as they are now; one that went is missing. Never waits.

        Args:
            now_s: By the program's clock.
        """
        ...

    def close(self) -> None:
        """Let everything go."""
        ...
