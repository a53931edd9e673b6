"""The options of the command line for the start of the window."""

from __future__ import annotations

from dataclasses import dataclass
from pathlib import Path

from armui.setting_checks import Language


@dataclass(frozen=True, slots=True)
class StartOptions:
    """The options of a start.

    Attributes:
        sim_generation: The generation of the simulated arm to connect to.
        sim_firmware: Its version, as ``S-V1.8-9``; ``None`` for today's.
        sim_joints_deg: The six angles at which it lies, joint 1 first; ``None`` for the rest pose.
        interface, channel, bitrate: The device to connect to.
        model: The model of the arm; by default the one chosen for it the last time.
        replay: The log to show in the window 回放.
        file: The trajectory to open in an editor.
        language: The language of this run, instead of the one in the settings.
        api_on: True to serve the local interface in this run, whatever the settings say.
        live_on: True to serve the live stream in this run, likewise.
    """

    sim_generation: int | None = None
    sim_firmware: str | None = None
    sim_joints_deg: tuple[float, ...] | None = None
    interface: str | None = None
    channel: str | None = None
    bitrate: int | None = None
    model: str | None = None
    replay: Path | None = None
    file: Path | None = None
    language: Language | None = None
    api_on: bool = False
    live_on: bool = False
