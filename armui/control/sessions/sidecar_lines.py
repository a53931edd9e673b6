"""What a recording keeps of the arm beside its frames: who it is, and what was read from it."""

from __future__ import annotations

from typing import TYPE_CHECKING

from armui.arm.backup import parameter_row
from armui.arm.parameters import all_batches, heard

if TYPE_CHECKING:
    from armui.arm.state import ArmState
    from armui.control.context import Context
    from armui.session.recording.sidecar import Line


class SidecarLines:
    """Lines for the sidecar, whenever they would say something new.

    Args:
        context: What the parts of the controller share.
    """

    def __init__(self, context: Context) -> None:
        self._context = context
        self._told: dict[str, Line] = {}

    def reset(self) -> None:
        """A new recording begins: everything is new to it."""
        self._told = {}

    def news(self) -> list[Line]:
        """What is known now and was not told."""
        connection = self._context.connection
        state = self._context.state()
        lines: list[Line] = []
        if connection.device is not None:
            generation = connection.generation
            lines.append(
                {
                    "kind": "arm",
                    "device": connection.device.name,
                    "interface": connection.device.interface,
                    "serial": connection.device.serial,
                    "bitrate": connection.device.bitrate,
                    "model": connection.model.value,
                    "listen_only": connection.device.listen_only,
                    "generation": None if generation is None else int(generation),
                    "firmware": state.firmware,
                }
            )
        values = settings_read(state)
        if values:
            lines.append({"kind": "settings", "values": values})
        new = [line for line in lines if self._told.get(str(line["kind"])) != line]
        self._told.update({str(line["kind"]): line for line in new})
        return new


def settings_read(state: ArmState) -> list[dict[str, float | int | str]]:
    """The parameters that were read from the arm, as the file of a backup names them."""
    return [
        parameter_row(parameter, known.value)
        for batch in all_batches(teaching=True, drag_assistance=True)
        for parameter in batch.parameters()
        if (known := heard(state, parameter)) is not None
    ]
