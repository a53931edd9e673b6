"""What a start of the window can be told on the command line."""

from __future__ import annotations

from dataclasses import dataclass
from pathlib import Path

from armui.setting_checks import Language


@dataclass(frozen=True, slots=True)
class StartOptions:
    """How to begin.

    Attributes:
        sim_generation: Connect to the simulated arm that speaks this generation.
        sim_firmware: The version it has, as ``S-V1.8-9``; today's with ``None``.
        interface, channel, bitrate: Connect to this device.
        model: Which arm of the family that is; by default the one chosen for it the last time.
        replay: Show this log in the window 回放.
        file: Open this trajectory in an editor.
        language: Instead of the one in the settings, for this run.
    """

    sim_generation: int | None = None
    sim_firmware: str | None = None
    interface: str | None = None
    channel: str | None = None
    bitrate: int | None = None
    model: str | None = None
    replay: Path | None = None
    file: Path | None = None
    language: Language | None = None
