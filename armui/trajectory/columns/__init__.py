"""Import of an unknown table: guess its dialect, map its columns, convert its rows.

`sniff` looks at the text and guesses; the operator corrects the dialect (`Dialect`) and the meaning
of the columns, which gives a `ColumnMapping`; `apply` reads the whole text by it.
"""

from armui.trajectory.columns.apply import apply, check_mapping
from armui.trajectory.columns.guess import farthest, likely_unit, units_in_doubt
from armui.trajectory.columns.model import (
    UNITS,
    ColumnMapping,
    ColumnQuantity,
    Dialect,
    Guess,
    Sheet,
    TableColumn,
)
from armui.trajectory.columns.sniff import sniff
from armui.trajectory.columns.source import (
    LABELS,
    SPEED_PERCENT,
    Encoding,
    TableFile,
    look_closer,
    open_table,
    told_by_names,
)

__all__ = [
    "LABELS",
    "SPEED_PERCENT",
    "UNITS",
    "ColumnMapping",
    "ColumnQuantity",
    "Dialect",
    "Encoding",
    "Guess",
    "Sheet",
    "TableColumn",
    "TableFile",
    "apply",
    "check_mapping",
    "farthest",
    "likely_unit",
    "look_closer",
    "open_table",
    "sniff",
    "told_by_names",
    "units_in_doubt",
]
