"""Opens the DBC files that say what the bytes on the bus mean."""

from __future__ import annotations

from functools import cache
from typing import TYPE_CHECKING, Final

import cantools

from armui.protocol.firmware_version import MitLayout
from armui.protocol.generation import Generation
from armui.system.paths import RESOURCES

if TYPE_CHECKING:
    from pathlib import Path

    from cantools.database.can import Database


_FILES: Final = {
    (Generation.ONE, MitLayout.A): "agx_gen1.dbc",
    (Generation.ONE, MitLayout.B): "agx_gen1.dbc",
    (Generation.TWO, MitLayout.A): "agx_gen2_until_1.8-7.dbc",
    (Generation.TWO, MitLayout.B): "agx_gen2.dbc",
}
"""No bit on the wire tells the two layouts of a MIT frame apart, so each has a file that any CAN
tool opens; a test sees to it that they differ in nothing else."""


def database_path(generation: Generation, mit_layout: MitLayout = MitLayout.B) -> Path:
    """The DBC file of a generation, of generation 2 that with this layout of MIT frames."""
    return RESOURCES / "protocol" / _FILES[generation, mit_layout]


@cache
def load_database(generation: Generation, mit_layout: MitLayout = MitLayout.B) -> Database:
    """The protocol of one generation, as cantools sees it.

    Args:
        generation: The protocol wanted.
        mit_layout: How MIT frames carry their torque, generation 2.

    Returns:
        The database with messages, signals, units, ranges, value tables and cycle times. It is
        parsed once and shared: treat it as read-only.

    Raises:
        FileNotFoundError: The installation lacks the file.
        cantools.database.UnsupportedDatabaseFormatError: The file is damaged.
    """
    path = database_path(generation, mit_layout)
    database = cantools.database.load_file(path, database_format="dbc", strict=True)
    if not isinstance(database, cantools.database.can.Database):
        raise TypeError(f"{path} does not describe a CAN bus")
    return database
