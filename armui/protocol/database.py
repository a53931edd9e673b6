"""Opens the two DBC files that say what the bytes on the bus mean."""

from __future__ import annotations

from functools import cache
from typing import TYPE_CHECKING

import cantools

from armui.protocol.generation import Generation
from armui.system.paths import RESOURCES

if TYPE_CHECKING:
    from cantools.database.can import Database


@cache
def load_database(generation: Generation) -> Database:
    """The protocol of one generation, as cantools sees it.

    Args:
        generation: The protocol wanted.

    Returns:
        The database with messages, signals, units, ranges, value tables and cycle times. It is
        parsed once and shared: treat it as read-only.

    Raises:
        FileNotFoundError: The installation lacks the file.
        cantools.database.UnsupportedDatabaseFormatError: The file is damaged.
    """
    path = RESOURCES / "protocol" / f"agx_gen{int(generation)}.dbc"
    database = cantools.database.load_file(path, database_format="dbc", strict=True)
    if not isinstance(database, cantools.database.can.Database):
        raise TypeError(f"{path} does not describe a CAN bus")
    return database
